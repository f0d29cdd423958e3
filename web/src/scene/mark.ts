import { ArrowHelper, Vector3 } from 'three';
import type { PathPoint } from '../wire';

const LONG_MM = 70;

/** The torch as it is programmed at a sample of a pass: an arrow with its head there. */
export class Mark {
  readonly arrow = new ArrowHelper(new Vector3(0, 0, 1), new Vector3(), LONG_MM, 0x0b4fa8, 14, 8);
  private readonly tip = new Vector3();
  private readonly along = new Vector3(0, 0, 1);

  constructor() {
    this.arrow.visible = false;
  }

  set(point: Pick<PathPoint, 'tip' | 'torch'> | null): void {
    this.arrow.visible = point !== null;
    if (!point) return;
    this.tip.set(...point.tip);
    this.along.set(...point.torch).normalize();
    this.arrow.setDirection(this.along.clone().negate());
  }

  /** As large on the screen from everywhere. */
  size(scale: number): void {
    this.arrow.scale.setScalar(scale);
    this.arrow.position.copy(this.tip).addScaledVector(this.along, LONG_MM * scale);
  }
}
