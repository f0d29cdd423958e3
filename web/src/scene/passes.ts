import { BufferGeometry, Color, Group, Line, LineDashedMaterial, SRGBColorSpace, Vector3, type Material } from 'three';
import { Line2 } from 'three/examples/jsm/lines/Line2.js';
import { LineGeometry } from 'three/examples/jsm/lines/LineGeometry.js';
import { LineMaterial } from 'three/examples/jsm/lines/LineMaterial.js';
import type { WorkView } from '../wire';
import { numberOf, passColour, ramp, scale, type ColourBy, type Scale } from './colours';

/** The passes of a program as thick lines, and the ways through the air between them as thin ones. */
export class Passes {
  readonly group = new Group();
  readonly air = new Group();

  /** Draws the passes anew; gives the scale of their colours. */
  set(work: WorkView | null, by: ColourBy): Scale | null {
    release(this.group);
    release(this.air);
    if (!work) return null;
    const shown = scale(work.passes, by, work.values);
    work.passes.forEach((pass, i) => {
      if (pass.path.length < 2) return;
      const positions: number[] = [];
      const colours: number[] = [];
      for (const point of pass.path) {
        positions.push(...point.tip);
        const number = numberOf(point, by, work.values);
        const part = shown && number !== null ? (number - shown.least) / Math.max(shown.most - shown.least, 1e-9) : null;
        new Color().setRGB(...(part === null ? passColour(i) : ramp(part)), SRGBColorSpace).toArray(colours, colours.length);
      }
      const geometry = new LineGeometry();
      geometry.setPositions(positions);
      geometry.setColors(colours);
      const line = new Line2(geometry, new LineMaterial({ linewidth: 6, vertexColors: true }));
      line.renderOrder = 1;
      this.group.add(line);
    });
    for (const way of work.air) {
      if (way.length < 2) continue;
      const geometry = new BufferGeometry().setFromPoints(way.map((tip) => new Vector3(...tip)));
      const line = new Line(geometry, new LineDashedMaterial({ color: 0x6b747d, dashSize: 6, gapSize: 5 }));
      line.computeLineDistances();
      this.air.add(line);
    }
    return shown;
  }
}

/** Empties a group and gives back what it held on the graphics card. */
export function release(group: Group): void {
  for (const child of [...group.children]) {
    child.traverse((object) => {
      const owner = object as { geometry?: BufferGeometry; material?: Material | Material[] };
      owner.geometry?.dispose();
      for (const material of [owner.material].flat()) material?.dispose();
    });
    group.remove(child);
  }
}
