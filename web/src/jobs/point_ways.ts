import type { PointPass } from './points';

/** Ways between points that can be chosen. */
export const WAYS = ['line', 'arc', 'spline', 'cubic', 'taught', 'rapid'] as const;
export type Way = (typeof WAYS)[number];

/** Those of a pass: nothing is welded in a rapid move, and cubics go by time. */
export function waysOf(pass: PointPass): Way[] {
  return WAYS.filter((way) => (way !== 'rapid' || !pass.arc) && (way !== 'cubic' || pass.columns.at(-1) === 'time_s'));
}

export type Operation = Record<string, unknown> & { op: string };

/** Why a way cannot be chosen: the points are not in a row; an arc is made of two; the points say no place in x, y, z. */
export type Cannot = 'row' | 'two' | 'place';

/**
 * The operations that have the chosen points reached by `way`: spans are split where the choice begins and ends. An arc goes
 * through the first of two points to the second; a cubic that is chosen once more gets new speeds. Row 0 is the start, which
 * is not reached.
 */
export function reachedBy(pass: PointPass, chosen: number[], way: Way): Operation[] | Cannot {
  const rows = chosen.filter((row) => row > 0).sort((a, b) => a - b);
  const [first, last] = [rows[0], rows.at(-1)];
  if (first === undefined || last === undefined || last - first !== rows.length - 1) return 'row';
  if (way === 'arc' && rows.length !== 2) return 'two';
  const via = way === 'arc' ? at(pass, first) : null;
  if (way === 'arc' && !via) return 'place';
  const operations: Operation[] = [];
  // The last point of each span, and how it is reached.
  const spans: { last: number; along: string }[] = [];
  pass.rows.forEach((row, i) => {
    if (i === 0) return;
    if (row.span === spans.length) spans[spans.length - 1] = { last: i, along: row.along };
    else spans.push({ last: i, along: row.along });
  });
  for (const point of [first - 1, last]) {
    const span = spans.findIndex((of) => point <= of.last);
    if (point === 0 || span < 0 || spans[span]?.last === point) continue;
    operations.push({ op: 'split_span', pass: pass.pass, point });
    spans.splice(span, 0, { last: point, along: spans[span]?.along ?? '' });
  }
  if (via) {
    operations.push({ op: 'delete_points', pass: pass.pass, from: first });
    const span = spans.findIndex((of) => first <= of.last);
    // A span of that point alone goes with it.
    if (spans[span]?.last === first) spans.splice(span, 1);
    for (const of of spans) if (of.last > first) of.last -= 1;
  }
  const end = via ? last - 1 : last;
  spans.forEach((span, i) => {
    const begin = (spans[i - 1]?.last ?? 0) + 1;
    if (begin < first || span.last > end || (span.along === way && !via && way !== 'cubic')) return;
    const pace = span.along === 'rapid' && way !== 'rapid' ? { pace: paceNear(pass, first) } : {};
    operations.push({ op: 'interpolate', pass: pass.pass, span: i + 1, along: way, ...(via ? { via_mm: via } : {}), ...pace });
  });
  return operations;
}

/** A row's x, y, z, as tip or as axes; none if they are not all there. */
function at(pass: PointPass, row: number): number[] | null {
  const numbers = (names: string[]): number[] => names.map((name) => pass.rows[row]?.numbers[pass.columns.indexOf(name)] ?? NaN);
  const tip = numbers(['x_mm', 'y_mm', 'z_mm']);
  if (tip.every(Number.isFinite)) return tip;
  const axes = numbers(['x', 'y', 'z']).map((value, i) => (pass.columns.includes(['x', 'y', 'z'][i] ?? '') ? value : 0));
  const there = ['x', 'y', 'z'].filter((name) => pass.columns.includes(name)).length;
  return there >= 2 && axes.every(Number.isFinite) ? axes : null;
}

/** Time or speed of the nearest point that has one: a rapid move has none. */
function paceNear(pass: PointPass, row: number): number {
  const pace = (i: number): number => pass.rows[i]?.numbers.at(-1) ?? 0;
  const others = pass.rows.map((_, i) => i).filter((i) => pace(i) > 0);
  const nearest = others.sort((a, b) => Math.abs(a - row) - Math.abs(b - row))[0];
  return nearest === undefined ? 5 : pace(nearest);
}
