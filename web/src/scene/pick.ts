import { Raycaster, Vector2, Vector3, type Camera, type Group, type Matrix4 } from 'three';
import type { WorkView } from '../wire';

/** Nearer than this on the screen is meant. */
const PICK_PX = 16;

/** A sample of a pass that was picked, and where it is in the world. */
export type Picked = { pass: number; point: number; place: Vector3 };

/** The sample of a pass nearest to a place on the screen, if it is near enough. */
export function nearest(work: WorkView | null, toWorld: Matrix4, camera: Camera, at: Vector2, area: DOMRect): Picked | null {
  let best: Picked | null = null;
  let least = PICK_PX;
  const place = new Vector3();
  const screen = new Vector3();
  work?.passes.forEach((pass, p) =>
    pass.path.forEach((sample, i) => {
      place.set(...sample.tip).applyMatrix4(toWorld);
      screen.copy(place).project(camera);
      const x = ((screen.x + 1) / 2) * area.width;
      const y = ((1 - screen.y) / 2) * area.height;
      const far = Math.hypot(x - at.x, y - at.y);
      if (screen.z < 1 && far < least) {
        least = far;
        best = { pass: p, point: i, place: place.clone() };
      }
    }),
  );
  return best;
}

/** The place on a solid under a place on the screen. */
export function surface(root: Group, camera: Camera, at: Vector2, area: DOMRect): Vector3 | null {
  const ray = new Raycaster();
  ray.setFromCamera(new Vector2((at.x / area.width) * 2 - 1, 1 - (at.y / area.height) * 2), camera);
  const hit = ray.intersectObject(root, true).find((h) => h.object.userData['pick'] === true);
  return hit?.point ?? null;
}
