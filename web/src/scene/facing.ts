import { Mesh, Raycaster, Vector3, type Matrix4, type Object3D } from 'three';
import type { PathPoint, WorkView } from '../wire';

/** A place where it is welded: the tip, and the unit vector out of the work, in its frame. */
export type Spot = Pick<PathPoint, 'tip' | 'torch'>;
/** Spots that are to be seen while the machine stands so: at positions of its axes, or as it stands now. */
export type Standing = { axes: number[] | null; spots: Spot[] };

/** Places of the work that stand for all of it. */
const SPOTS = 8;
/** The picture is turned about the vertical by steps of so many degrees. */
const STEP_DEG = 30;
/** From here on a face is well seen: the cosine between the way out of it and the way to the eye. */
const FACES = 0.5;
/** How far out of the work a spot is looked at from, mm: nearer, its own surface would hide it. */
const OUT_MM = 3;
/** Bodies of more corners than this take too long to be looked through. */
const MOST_CORNERS = 60_000;
/** So much of what could be seen is not worth turning the picture further for. */
const AS_GOOD = 0.25;
const UP = new Vector3(0, 0, 1);

/** How the work is to be seen: as it stands now, and as it is turned while it is welded. */
export function standings(work: WorkView | null): Standing[] {
  const all = (work?.passes ?? []).flatMap((pass) => pass.path);
  const spots = all.filter((_, i) => i % Math.ceil(all.length / SPOTS) === 0);
  return [{ axes: null, spots }, ...spots.map((spot) => ({ axes: spot.axes, spots: [spot] }))];
}

/** Directions to look from, the least turned first. */
function turned(from: Vector3): Vector3[] {
  const turns = Array.from({ length: 360 / STEP_DEG }, (_, i) => Math.ceil(i / 2) * (i % 2 ? 1 : -1));
  return turns.map((turn) => from.clone().applyAxisAngle(UP, (turn * STEP_DEG * Math.PI) / 180));
}

/** How well a spot is seen, 0 to 1: turned away, or with a body before it, not at all. */
function seen(spot: Vector3, out: Vector3, from: Vector3, bodies: Object3D[]): number {
  const faces = out.dot(from);
  if (faces <= 0) return 0;
  const before = new Raycaster(spot, from).intersectObjects(bodies, false);
  return before.length > 0 ? 0 : Math.min(1, faces / FACES);
}

/**
 * Where to look from so that what is welded is seen: `from`, turned about the vertical no further than it needs. `stand` has the
 * machine stand so and tells where the work is then.
 */
export function facing(from: Vector3, standings: Standing[], stand: (of: Standing) => Matrix4, groups: Object3D[]): Vector3 {
  const bodies: Object3D[] = [];
  for (const group of groups) {
    group.traverse((of) => {
      if (of instanceof Mesh && of.userData['pick'] === true && of.geometry.getAttribute('position').count < MOST_CORNERS) bodies.push(of);
    });
  }
  const ways = turned(from);
  const sums = ways.map(() => 0);
  for (const standing of standings) {
    const work = stand(standing);
    for (const { tip, torch } of standing.spots) {
      const out = new Vector3(...torch).transformDirection(work);
      const at = new Vector3(...tip).applyMatrix4(work).addScaledVector(out, OUT_MM);
      ways.forEach((way, i) => (sums[i] = (sums[i] ?? 0) + seen(at, out, way, bodies)));
    }
  }
  const enough = (1 - AS_GOOD) * Math.max(...sums);
  return ways[sums.findIndex((sum) => sum >= enough)] ?? from;
}
