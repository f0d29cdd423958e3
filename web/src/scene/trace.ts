import { BufferAttribute, BufferGeometry, Line, LineBasicMaterial } from 'three';

const ROOM = 8192;
/** Nearer than this to the one before, a place adds nothing, mm. */
const STEP_MM = 0.2;

/**
 * Where the tip has been: a ring, each place written twice, so that the newest `ROOM` are always one run of the buffer and
 * drawing needs no copy.
 */
export class Trace {
  readonly line: Line;
  private readonly positions = new Float32Array(ROOM * 2 * 3);
  private readonly colours = new Float32Array(ROOM * 2 * 3);
  private count = 0;
  private last: [number, number, number] | null = null;

  constructor() {
    const made = new BufferGeometry();
    made.setAttribute('position', new BufferAttribute(this.positions, 3));
    made.setAttribute('color', new BufferAttribute(this.colours, 3));
    made.setDrawRange(0, 0);
    this.line = new Line(made, new LineBasicMaterial({ vertexColors: true, depthTest: false }));
    this.line.frustumCulled = false;
    this.line.renderOrder = 3;
  }

  clear(): void {
    this.count = 0;
    this.last = null;
    this.line.geometry.setDrawRange(0, 0);
  }

  add(x: number, y: number, z: number, burns: boolean): void {
    if (this.last && Math.hypot(x - this.last[0], y - this.last[1], z - this.last[2]) < STEP_MM) return;
    this.last = [x, y, z];
    const at = this.count % ROOM;
    for (const row of [at, at + ROOM]) {
      this.positions.set([x, y, z], row * 3);
      this.colours.set(burns ? [1, 0.45, 0] : [0.35, 0.38, 0.42], row * 3);
    }
    this.count += 1;
    const have = Math.min(this.count, ROOM);
    const from = this.count <= ROOM ? 0 : this.count % ROOM;
    this.line.geometry.setDrawRange(from, have);
    for (const name of ['position', 'color'] as const) {
      const attribute = this.line.geometry.getAttribute(name) as BufferAttribute;
      for (const row of [at, at + ROOM]) attribute.addUpdateRange(row * 3, 3);
      attribute.needsUpdate = true;
    }
  }
}
