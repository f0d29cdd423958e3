import type { PassView, PathPoint } from '../wire';

/** Part of a pass: pass from 0, path lengths in mm. */
export type Stretch = { pass: number; from: number; to: number };

/** Path lengths nearer than this are one, mm. */
const NOTHING_MM = 1e-6;

/** The span of a pass in which a path length lies; the whole pass if it does not say. */
export function spanAt(pass: PassView, s: number): [number, number] {
  const found = pass.spans.find(([from, to]) => s >= from - NOTHING_MM && s <= to + NOTHING_MM);
  return found ?? [0, pass.length_mm];
}

/** The samples of a stretch, with its ends between samples. */
export function samples(path: PathPoint[], from: number, to: number): Pick<PathPoint, 's_mm' | 'tip' | 'speed_mm_s'>[] {
  const at = (s: number): Pick<PathPoint, 's_mm' | 'tip' | 'speed_mm_s'> | null => {
    const i = path.findIndex((point) => point.s_mm >= s - NOTHING_MM);
    const [a, b] = [path[Math.max(0, i - 1)], path[i < 0 ? path.length - 1 : i]];
    if (!a || !b) return null;
    const part = b.s_mm > a.s_mm ? Math.min(1, Math.max(0, (s - a.s_mm) / (b.s_mm - a.s_mm))) : 1;
    const mix = (x: number, y: number): number => x + part * (y - x);
    return {
      s_mm: mix(a.s_mm, b.s_mm),
      tip: [mix(a.tip[0], b.tip[0]), mix(a.tip[1], b.tip[1]), mix(a.tip[2], b.tip[2])],
      speed_mm_s: mix(a.speed_mm_s, b.speed_mm_s),
    };
  };
  const inside = path.filter((point) => point.s_mm > from + NOTHING_MM && point.s_mm < to - NOTHING_MM);
  return [at(from), ...inside, at(to)].filter((point) => point !== null);
}

/** How long a stretch takes at the planned speed, s: between samples the acceleration is taken as steady. */
export function timeOf(path: PathPoint[], from: number, to: number): number {
  const points = samples(path, from, to);
  let time = 0;
  points.slice(1).forEach((point, i) => {
    const before = points[i] ?? point;
    const speed = (before.speed_mm_s + point.speed_mm_s) / 2;
    if (speed > 0) time += (point.s_mm - before.s_mm) / speed;
  });
  return time;
}
