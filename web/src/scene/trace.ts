import { InstancedInterleavedBuffer, InterleavedBufferAttribute } from 'three';
import { LineMaterial } from 'three/examples/jsm/lines/LineMaterial.js';
import { LineSegments2 } from 'three/examples/jsm/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/examples/jsm/lines/LineSegmentsGeometry.js';

const ROOM = 8192;
/** Nearer than this to the one before, a place adds nothing, mm. */
const STEP_MM = 0.4;
const BURNT = [1, 0.35, 0];
const DRY = [0.1, 0.1, 0.12];

/** Where the tip has been: a ring of pieces, the oldest written over; one piece goes to the graphics card at a time. */
export class Trace {
  readonly line: LineSegments2;
  private readonly places = new InstancedInterleavedBuffer(new Float32Array(ROOM * 6), 6, 1);
  private readonly colours = new InstancedInterleavedBuffer(new Float32Array(ROOM * 6), 6, 1);
  private readonly geometry = new LineSegmentsGeometry();
  private count = 0;
  private last: [number, number, number] | null = null;

  constructor() {
    const { geometry, places, colours } = this;
    geometry.setAttribute('instanceStart', new InterleavedBufferAttribute(places, 3, 0));
    geometry.setAttribute('instanceEnd', new InterleavedBufferAttribute(places, 3, 3));
    geometry.setAttribute('instanceColorStart', new InterleavedBufferAttribute(colours, 3, 0));
    geometry.setAttribute('instanceColorEnd', new InterleavedBufferAttribute(colours, 3, 3));
    geometry.instanceCount = 0;
    // A little before the pass that it lies on, and thinner: the colour of the pass is seen on both sides.
    const material = new LineMaterial({ linewidth: 2, vertexColors: true, polygonOffset: true, polygonOffsetFactor: -2, polygonOffsetUnits: -4 });
    this.line = new LineSegments2(geometry, material);
    this.line.frustumCulled = false;
    this.line.renderOrder = 2;
  }

  clear(): void {
    this.count = 0;
    this.last = null;
    this.geometry.instanceCount = 0;
  }

  add(x: number, y: number, z: number, burns: boolean): void {
    const from = this.last;
    if (from && Math.hypot(x - from[0], y - from[1], z - from[2]) < STEP_MM) return;
    this.last = [x, y, z];
    if (!from) return;
    const at = (this.count % ROOM) * 6;
    const colour = burns ? BURNT : DRY;
    write(this.places, at, [...from, x, y, z]);
    write(this.colours, at, [...colour, ...colour]);
    this.count += 1;
    this.geometry.instanceCount = Math.min(this.count, ROOM);
  }
}

function write(buffer: InstancedInterleavedBuffer, at: number, numbers: number[]): void {
  buffer.array.set(numbers, at);
  buffer.addUpdateRange(at, 6);
  buffer.needsUpdate = true;
}
