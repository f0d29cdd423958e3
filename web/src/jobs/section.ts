import type { SectionView } from '../wire';

export type Point = [number, number];

/** From mm to the drawing: x to the right, y down. */
export type Place = (point: Point) => Point;

/** The joint's sizes as its picture shows them, measured on the outlines themselves: mm and degrees. */
export type Sizes = { gap: number; opening: number; depth: number; angle: number };

const minus = (a: Point, b: Point): Point => [a[0] - b[0], a[1] - b[1]];
const length = (a: Point): number => Math.hypot(a[0], a[1]);

/** The last stretch of an edge, as a direction from the root side to the toe. */
function slope(edge: Point[]): Point {
  const to = edge.at(-1) ?? [0, 0];
  const from = edge.at(-2) ?? to;
  const way = minus(to, from);
  const far = length(way) || 1;
  return [way[0] / far, way[1] / far];
}

export function sizes({ edges }: SectionView): Sizes {
  const [first, second] = edges;
  const roots = minus(first[0] ?? [0, 0], second[0] ?? [0, 0]);
  const toes = minus(first.at(-1) ?? [0, 0], second.at(-1) ?? [0, 0]);
  const [a, b] = [slope(first), slope(second)];
  const cosine = Math.min(1, Math.max(-1, a[0] * b[0] + a[1] * b[1]));
  // The depth is that of the deeper root below the line from toe to toe.
  const wide = length(toes) || 1;
  const toe = second.at(-1) ?? [0, 0];
  const below = (point: Point): number => {
    const by = minus(point, toe);
    return Math.abs(by[0] * toes[1] - by[1] * toes[0]) / wide;
  };
  return {
    gap: length(roots),
    opening: length(toes),
    depth: Math.max(below(first[0] ?? toe), below(second[0] ?? toe)),
    angle: (Math.acos(cosine) * 180) / Math.PI,
  };
}

/** Fits a section into a drawing of this size (px), the groove in its middle; px a mm with it. */
export function fitted(section: SectionView, width: number, height: number): { place: Place; scale: number } {
  const points = [...section.edges.flat(), ...section.beads.flatMap((bead) => bead.outline)];
  const xs = points.map((point) => point[0]);
  const ys = points.map((point) => point[1]);
  const [left, right, low, high] = [Math.min(...xs), Math.max(...xs), Math.min(...ys), Math.max(...ys)];
  const more = 0.3 * Math.max(right - left, high - low, 1e-6);
  const scale = Math.min(width / (right - left + 2 * more), height / (high - low + 2 * more));
  const middle: Point = [(left + right) / 2, (low + high) / 2];
  return { scale, place: ([x, y]) => [width / 2 + scale * (x - middle[0]), height / 2 - scale * (y - middle[1])] };
}

/** A line in the drawing with its number beside it, px. */
export type Dimension = { a: Point; b: Point; at: Point; mm: number };

/** How far lines stand off what they measure, and numbers off their lines, px. */
const BESIDE = 22;
const OFF = 14;
/** Numbers are wider than high. */
const WIDE = 8;
/** Smaller gaps have no line. */
const LEAST_MM = 0.05;

/** Opening, depth and root gap as lines square to each other, whichever way the joint lies. */
export function measured(section: SectionView, place: Place): Dimension[] {
  const found = sizes(section);
  const [root1, root2, toe1, toe2] = [section.edges[0][0], section.edges[1][0], section.edges[0].at(-1), section.edges[1].at(-1)];
  if (!root1 || !root2 || !toe1 || !toe2) return [];
  const [a, b] = [place(toe2), place(toe1)];
  const wide = length(minus(b, a)) || 1;
  const along: Point = [(b[0] - a[0]) / wide, (b[1] - a[1]) / wide];
  // Away from the roots, in the drawing.
  let out: Point = [along[1], -along[0]];
  const below = minus(place(root1), b);
  if (below[0] * out[0] + below[1] * out[1] > 0) out = [-out[0], -out[1]];
  const moved = (point: Point, by: Point, far: number): Point => [point[0] + far * by[0], point[1] + far * by[1]];
  const line = (from: Point, to: Point, by: Point, mm: number): Dimension => ({ a: from, b: to, at: moved(moved(from, minus(to, from), 0.5), by, OFF + WIDE * Math.abs(by[0])), mm });
  const scale = length(minus(place([1, 0]), place([0, 0])));
  const side = moved(b, along, BESIDE);
  const list = [
    line(moved(a, out, BESIDE), moved(b, out, BESIDE), out, found.opening),
    line(side, moved(side, out, -found.depth * scale), along, found.depth),
  ];
  if (found.gap > LEAST_MM) list.push(line(moved(place(root2), out, -BESIDE / 2), moved(place(root1), out, -BESIDE / 2), [-out[0], -out[1]], found.gap));
  return list;
}

/** Corners as an SVG path. */
export function outline(points: Point[], place: Place): string {
  return points.length === 0 ? '' : `M${points.map((point) => place(point).map((v) => v.toFixed(1)).join(',')).join('L')}Z`;
}

/** The middle of an outline's area. */
export function centre(points: Point[]): Point {
  let [area, x, y] = [0, 0, 0];
  const from = points[0] ?? [0, 0];
  points.forEach((point, i) => {
    const [a, b] = [minus(point, from), minus(points[(i + 1) % points.length] ?? from, from)];
    const cross = a[0] * b[1] - a[1] * b[0];
    area += cross;
    x += (cross * (a[0] + b[0])) / 3;
    y += (cross * (a[1] + b[1])) / 3;
  });
  return Math.abs(area) < 1e-12 ? from : [from[0] + x / area, from[1] + y / area];
}

/** A round length for a scale bar of about a fifth of `width` (px), mm. */
export function barLength(width: number, scale: number): number {
  const wanted = (0.2 * width) / scale;
  const decade = 10 ** Math.floor(Math.log10(wanted));
  return decade * ([5, 2, 1].find((step) => step * decade <= wanted) ?? 1);
}
