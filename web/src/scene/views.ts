import { Box3, Vector3 } from 'three';

export type View = 'fit' | 'top' | 'front' | 'side' | 'torch';

/** A short seam is shown with this much about it, mm. */
const LEAST_MM = 150;
/** So far from the torch, mm. */
const AT_TORCH_MM = 320;
/** Where each view looks from; from the torch it is the torch that says. */
const FROM: Record<View, [number, number, number]> = { fit: [0.55, -0.75, 0.6], top: [0, -0.001, 1], front: [0, -1, 0.02], side: [1, 0, 0.02], torch: [0.55, -0.75, 0.6] };

/** What a view looks at, where from (a unit vector) and from how far, mm. */
export type Look = { at: Vector3; from: Vector3; away: number };

/**
 * How a view shows what is in `box` with this camera. `torch`: where its tip is and its unit vector out of the work, if known. `turned`:
 * from where the whole is looked at, so that what is welded is seen.
 */
export function look(view: View, box: Box3, camera: { fov: number; aspect: number }, torch: { at: Vector3; axis: Vector3 } | null, turned: (from: Vector3) => Vector3): Look {
  if (view === 'torch' && torch) {
    // Over the torch's shoulder: a little off its axis, near enough to see the pool.
    return { at: torch.at, from: torch.axis.clone().add(new Vector3(0.5, -0.5, 0.1)).normalize(), away: AT_TORCH_MM };
  }
  const radius = Math.max(box.getSize(new Vector3()).length() / 2, LEAST_MM);
  const away = radius / Math.sin((camera.fov / 2) * (Math.PI / 180)) / Math.min(1, camera.aspect);
  const from = new Vector3(...FROM[view]).normalize();
  return { at: box.getCenter(new Vector3()), from: view === 'fit' ? turned(from) : from, away };
}
