import { Box3, Vector3, type Matrix4 } from 'three';
import type { WorkView } from '../wire';

export type View = 'fit' | 'top' | 'front' | 'side' | 'torch';

/** A short seam is shown with this much about it, mm. */
const LEAST_MM = 150;
/** So far from the torch, mm. */
const AT_TORCH_MM = 320;
/** A torch this near to what is looked at is at the work, mm. */
const AT_WORK_MM = 20;
const UP = new Vector3(0, 0, 1);
/** Where each view looks from; from the torch it is the torch that says. */
const FROM: Record<View, [number, number, number]> = { fit: [0.55, -0.75, 0.6], top: [0, -0.001, 1], front: [0, -1, 0.02], side: [1, 0, 0.02], torch: [0.55, -0.75, 0.6] };

/** Which way the part's welded side turns at least to who looks: the cosine between the way out of it and the way to the eye. */
const FACES = 0.5;
/** Shorter than this the ways out of a seam have no side in common, as around a tube. */
const LEAST_SIDE = 0.2;

/** The side of the part that is welded: the mean way out of the work along all passes, as the work stands; null if it has none. */
export function weldedSide(work: WorkView | null, stands: Matrix4): Vector3 | null {
  const sum = new Vector3();
  let count = 0;
  for (const { path } of work?.passes ?? []) {
    for (const { torch } of path) sum.add(new Vector3(...torch));
    count += path.length;
  }
  const mean = sum.divideScalar(Math.max(1, count));
  return mean.length() < LEAST_SIDE ? null : mean.transformDirection(stands);
}

/** Where to look from so that a side is seen: `from`, turned about the vertical no further than it needs. */
export function seeing(from: Vector3, side: Vector3 | null): Vector3 {
  if (!side) return from;
  const turned = Array.from({ length: 24 }, (_, i) => from.clone().applyAxisAngle(UP, (Math.ceil(i / 2) * (i % 2 ? 1 : -1) * Math.PI) / 12));
  const faces = (of: Vector3): number => of.dot(side);
  return turned.find((of) => faces(of) >= FACES) ?? turned.reduce((best, of) => (faces(of) > faces(best) ? of : best));
}

/** What a view looks at, where from (a unit vector) and from how far, mm. */
export type Look = { at: Vector3; from: Vector3; away: number };

/**
 * How a view shows what is in `box` with this camera. `torch`: where its tip is and its unit vector out of the work, if known. The whole
 * is looked at from where the torch is if it is at the work, else from the side that is welded.
 */
export function look(view: View, box: Box3, camera: { fov: number; aspect: number }, torch: { at: Vector3; axis: Vector3 } | null, side: Vector3 | null): Look {
  if (view === 'torch' && torch) {
    // Over the torch's shoulder: a little off its axis, near enough to see the pool.
    return { at: torch.at, from: torch.axis.clone().add(new Vector3(0.5, -0.5, 0.1)).normalize(), away: AT_TORCH_MM };
  }
  const radius = Math.max(box.getSize(new Vector3()).length() / 2, LEAST_MM);
  const away = radius / Math.sin((camera.fov / 2) * (Math.PI / 180)) / Math.min(1, camera.aspect);
  const from = new Vector3(...FROM[view]).normalize();
  const seen = torch && box.distanceToPoint(torch.at) < AT_WORK_MM ? torch.axis : side;
  return { at: box.getCenter(new Vector3()), from: view === 'fit' ? seeing(from, seen) : from, away };
}
