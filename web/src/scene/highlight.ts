import { Group } from 'three';
import { Line2 } from 'three/examples/jsm/lines/Line2.js';
import { LineGeometry } from 'three/examples/jsm/lines/LineGeometry.js';
import { LineMaterial } from 'three/examples/jsm/lines/LineMaterial.js';
import { release } from './passes';

/** A stretch of a pass that is chosen: a broad band behind its line, seen through everything. */
export class Highlight {
  readonly group = new Group();

  set(tips: [number, number, number][]): void {
    release(this.group);
    if (tips.length < 2) return;
    const geometry = new LineGeometry();
    geometry.setPositions(tips.flat());
    const line = new Line2(geometry, new LineMaterial({ color: 0x1e88e5, linewidth: 16, transparent: true, opacity: 0.45, depthTest: false }));
    line.renderOrder = 0;
    this.group.add(line);
  }
}
