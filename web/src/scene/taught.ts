import { BufferGeometry, Float32BufferAttribute, Group, Line, LineBasicMaterial, Points, PointsMaterial, Vector3 } from 'three';
import type { TaughtPointView } from '../wire';
import { release } from './passes';

/** Taught points, from red (low confidence) to green (high), and the path of the program through them. */
export class TaughtLine {
  readonly group = new Group();

  constructor(private readonly draw: () => void) {}

  set(points: Pick<TaughtPointView, 'at' | 'confidence'>[], path: [number, number, number][] | null): void {
    release(this.group);
    if (points.length > 0) {
      const geometry = new BufferGeometry().setFromPoints(points.map((point) => new Vector3(...point.at)));
      geometry.setAttribute('color', new Float32BufferAttribute(points.flatMap((point) => sureness(point.confidence)), 3));
      const dots = new Points(geometry, new PointsMaterial({ size: 7, sizeAttenuation: false, vertexColors: true, depthTest: false }));
      dots.renderOrder = 3;
      this.group.add(dots);
    }
    if (path && path.length > 1) {
      const geometry = new BufferGeometry().setFromPoints(path.map((at) => new Vector3(...at)));
      const line = new Line(geometry, new LineBasicMaterial({ color: 0x000000, depthTest: false }));
      line.renderOrder = 4;
      this.group.add(line);
    }
    this.draw();
  }
}

/** As in the picture of the camera: red without confidence, yellow for the usual one, green for a high one. */
export function sureness(confidence: number): [number, number, number] {
  const part = (value: number): number => Math.min(1, Math.max(0, value));
  return [part(2 - confidence / 0.5), part(confidence / 0.5) * 0.8, 0];
}
