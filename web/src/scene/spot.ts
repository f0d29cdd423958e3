import type { PathPoint } from '../wire';

type Vec = [number, number, number];

/** Where a torch or beam is against its program, mm in the work frame: `spot` of it is nearest to `path`, a place of the pass. */
export type Off = { distance: number; spot: Vec; path: Vec };

/** So far along the pass from where it is said to be a nearer place is looked for, mm: a pass may come near to itself. */
const AROUND_MM = 60;
/** A curve between samples is taken in this many pieces. */
const PIECES = 8;

/**
 * How far the tip is from the pass near the path length `s_mm`. A beam is as far as its line, whatever the depth: `along` is its
 * unit vector, null for a torch.
 */
export function off(path: PathPoint[], s_mm: number, tip: Vec, along: Vec | null): Off | null {
  let best: Off | null = null;
  const take = (a: Vec, b: Vec): void => {
    const found = onPiece(a, b, tip, along);
    if (!best || found.distance < best.distance) best = found;
  };
  let nearest = -1;
  for (let i = 0; i + 1 < path.length; i += 1) {
    const [a, b] = [path[i], path[i + 1]];
    if (!a || !b || b.s_mm < s_mm - AROUND_MM || a.s_mm > s_mm + AROUND_MM) continue;
    const before: Off | null = best;
    take(a.tip, b.tip);
    if (best !== before) nearest = i;
  }
  if (nearest < 0) return null;
  // Chords are off a curve by more than what is to be seen.
  best = null;
  for (let i = Math.max(0, nearest - 1); i <= Math.min(path.length - 2, nearest + 1); i += 1) {
    let from = between(path, i, 0);
    for (let k = 1; k <= PIECES; k += 1) {
      const to = between(path, i, k / PIECES);
      take(from, to);
      from = to;
    }
  }
  return best;
}

/** A place between samples `i` and `i + 1`, on the cubic with the slopes that their neighbours give (Catmull and Rom 1974). */
function between(path: PathPoint[], i: number, u: number): Vec {
  const at = (k: number): PathPoint => path[Math.min(path.length - 1, Math.max(0, k))] as PathPoint;
  const [a, b, c, d] = [at(i - 1), at(i), at(i + 1), at(i + 2)];
  const slope = (from: PathPoint, to: PathPoint, x: 0 | 1 | 2): number =>
    ((to.tip[x] - from.tip[x]) / Math.max(to.s_mm - from.s_mm, 1e-9)) * (c.s_mm - b.s_mm);
  const [u2, u3] = [u * u, u * u * u];
  return ([0, 1, 2] as const).map(
    (x) => (2 * u3 - 3 * u2 + 1) * b.tip[x] + (u3 - 2 * u2 + u) * slope(a, c, x) + (3 * u2 - 2 * u3) * c.tip[x] + (u3 - u2) * slope(b, d, x),
  ) as Vec;
}

/** The nearest of a straight piece, to the tip or to the line through it. */
function onPiece(a: Vec, b: Vec, tip: Vec, along: Vec | null): Off {
  const flat = (p: Vec): Vec => {
    const by: Vec = [p[0] - tip[0], p[1] - tip[1], p[2] - tip[2]];
    const deep = along ? dot(by, along) : 0;
    return along ? [by[0] - deep * along[0], by[1] - deep * along[1], by[2] - deep * along[2]] : by;
  };
  const from = flat(a);
  const to = flat(b);
  const way: Vec = [to[0] - from[0], to[1] - from[1], to[2] - from[2]];
  const part = Math.min(1, Math.max(0, -dot(from, way) / Math.max(dot(way, way), 1e-12)));
  const path = [0, 1, 2].map((i) => (a[i] ?? 0) + ((b[i] ?? 0) - (a[i] ?? 0)) * part) as Vec;
  const by: Vec = [path[0] - tip[0], path[1] - tip[1], path[2] - tip[2]];
  const deep = along ? dot(by, along) : 0;
  const spot: Vec = along ? [tip[0] + deep * along[0], tip[1] + deep * along[1], tip[2] + deep * along[2]] : tip;
  return { distance: Math.hypot(path[0] - spot[0], path[1] - spot[1], path[2] - spot[2]), spot, path };
}

function dot(a: Vec, b: Vec): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}
