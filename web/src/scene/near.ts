import {
  BufferGeometry,
  CanvasTexture,
  Color,
  type Group,
  Group as Holder,
  Line,
  LineBasicMaterial,
  Mesh,
  MeshBasicMaterial,
  MeshLambertMaterial,
  SphereGeometry,
  Sprite,
  SpriteMaterial,
  SRGBColorSpace,
  Vector3,
} from 'three';
import type { NearView } from '../wire';

/** How near: as it should be, nearly too near, too near or about to be. */
export type Nearness = 'far' | 'near' | 'touching';

/** Nearer to what is allowed than this, by hand, is nearly too near, and as near as the hand is let, mm. */
const BY_HAND_MM = 10;
const TOUCHING_MM = 0.5;
/** By hand a pair farther apart than this is not worth a line, mm. */
const SHOWN_MM = 40;
const COLOURS: Record<Nearness, number> = { far: 0x0b4fa8, near: 0xc77700, touching: 0xd0121d };
const GLOWS: Record<Nearness, number> = { far: 0, near: 0x7a4a00, touching: 0x8a0a10 };
/** Height of the number on the screen, a part of the scene's. */
const TALL = 0.05;

/** How near a pair is to what is allowed. By hand it is told early; a planned way has been checked, and is as near as it must be. */
export function nearness(of: NearView, byHand: boolean): Nearness {
  const left = of.distance_mm - of.least_mm;
  if (left < (byHand ? TOUCHING_MM : 0)) return 'touching';
  return byHand && left < BY_HAND_MM ? 'near' : 'far';
}

/** What is shown of what is near, of one pair: nothing if it is far and nobody asked for it. */
export function worthShowing(of: NearView | null, byHand: boolean): NearView | null {
  if (!of) return null;
  return nearness(of, byHand) !== 'far' || (byHand && of.distance_mm < SHOWN_MM) ? of : null;
}

/** The nearest pair: a line from one to the other with its length, and the two bodies glowing where it is too short. */
export class Near {
  readonly group = new Holder();
  private readonly line: Line;
  private readonly ends: Mesh[];
  private readonly label = new Sprite(new SpriteMaterial({ depthTest: false, sizeAttenuation: false, transparent: true }));
  private readonly canvas = document.createElement('canvas');
  private readonly glowing = new Set<Group>();
  private said = '';
  private has = false;
  private hidden = false;

  constructor() {
    this.line = new Line(new BufferGeometry(), new LineBasicMaterial({ depthTest: false }));
    this.ends = [0, 1].map(() => new Mesh(new SphereGeometry(2.5, 16, 8), new MeshBasicMaterial({ depthTest: false })));
    this.group.add(this.line, ...this.ends, this.label);
    this.group.visible = false;
    for (const child of this.group.children) child.renderOrder = 5;
    this.label.center.set(-0.06, 0.5);
  }

  /** Shows a pair, or none; `solids` are those of the scene by their names. True if something is to be drawn. */
  set(of: NearView | null, level: Nearness, solids: Group[]): boolean {
    if (!of && !this.has) return false;
    this.has = of !== null;
    this.group.visible = this.has && !this.hidden;
    this.glow(of && level !== 'far' ? of.between : [], GLOWS[level], solids);
    if (!of) return true;
    const [a, b] = of.at.map((at) => new Vector3(...at)) as [Vector3, Vector3];
    this.line.geometry.setFromPoints([a, b]);
    const colour = COLOURS[level];
    (this.line.material as LineBasicMaterial).color.set(colour);
    this.ends.forEach((end, i) => {
      end.position.copy(i === 0 ? a : b);
      (end.material as MeshBasicMaterial).color.set(colour);
    });
    this.label.position.copy(a).add(b).multiplyScalar(0.5);
    this.write(`${of.distance_mm.toFixed(1).replace('-', '\u2212')} mm`, colour);
    return true;
  }

  hide(hidden: boolean): void {
    this.hidden = hidden;
    this.group.visible = this.has && !hidden;
  }

  /** Balls are as large on the screen from everywhere. */
  size(scale: number): void {
    for (const end of this.ends) end.scale.setScalar(scale);
  }

  end(): void {
    this.label.material.map?.dispose();
    this.label.material.dispose();
  }

  private glow(names: readonly string[], colour: number, solids: Group[]): void {
    for (const solid of this.glowing) emit(solid, 0);
    this.glowing.clear();
    if (names.length === 0) return;
    for (const solid of solids) {
      if (!names.includes(solid.name)) continue;
      emit(solid, colour);
      this.glowing.add(solid);
    }
  }

  private write(text: string, colour: number): void {
    const said = `${text} ${colour}`;
    if (said === this.said) return;
    this.said = said;
    const { canvas } = this;
    canvas.width = 224;
    canvas.height = 64;
    const pen = canvas.getContext('2d');
    if (!pen) return;
    pen.clearRect(0, 0, canvas.width, canvas.height);
    pen.fillStyle = `#${new Color(colour).getHexString(SRGBColorSpace)}`;
    pen.beginPath();
    pen.roundRect(2, 6, 220, 52, 12);
    pen.fill();
    pen.fillStyle = '#ffffff';
    pen.font = '600 34px system-ui, sans-serif';
    pen.textAlign = 'center';
    pen.textBaseline = 'middle';
    pen.fillText(text, 112, 33);
    this.label.material.map?.dispose();
    const texture = new CanvasTexture(canvas);
    texture.colorSpace = SRGBColorSpace;
    this.label.material.map = texture;
    this.label.material.needsUpdate = true;
    this.label.scale.set((TALL * canvas.width) / canvas.height, TALL, 1);
  }
}

function emit(solid: Group, colour: number): void {
  solid.traverse((object) => {
    const { material } = object as Mesh;
    if (material instanceof MeshLambertMaterial) material.emissive.set(colour);
  });
}
