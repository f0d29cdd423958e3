/** Columns of a trace with their values. */
export type Trace = { columns: string[]; values: (number | null)[][] };

/** What is shown before somebody chooses, in this order: of each kind the first column that there is. */
const FIRST = [
  // Of a weld that was tracked: where the joint lay, and what was made of it.
  /^deviation_lateral_mm/,
  /^deviation_height_mm/,
  /^correction_lateral_mm/,
  /^correction_height_mm/,
  // What was driven; where that is not kept, what was asked.
  /^tip_speed/,
  /^speed_set/,
  /path_error|seam_lateral/,
  /(current|beam)_(a|ma)(_measured)?$/,
  /(voltage_v|accelerating_kv|wire_feed_m_min|power_k?w)(_measured)?$/,
  /following_error/,
];
const MOST_AT_ONCE = 6;

export function preferred(names: string[]): string[] {
  const known = FIRST.flatMap((kind) => names.find((name) => kind.test(name)) ?? []);
  const driven = known.some((name) => name.startsWith('tip_speed'));
  const told = known.filter((name) => !(driven && name.startsWith('speed_set')));
  return (told.length > 0 ? told : names).slice(0, MOST_AT_ONCE);
}

/**
 * A column of several traces over one path length: rows of a pass, where the path length does not shrink (a torch that was
 * taken back does not draw over itself, one that stands draws all that happens there), each trace with values only at its own places.
 */
export function merged(traces: Trace[], name: string, pass: number): (number | null)[][] {
  const rows: { s: number; of: number; value: number | null }[] = [];
  traces.forEach((trace, of) => {
    const column = (key: string): (number | null)[] => trace.values[trace.columns.indexOf(key)] ?? [];
    const [passes, places, values] = [column('pass'), column('s_mm'), column(name)];
    let last = -Infinity;
    places.forEach((s, i) => {
      if (passes[i] !== pass || s === null || s < last) return;
      last = s;
      rows.push({ s, of, value: values[i] ?? null });
    });
  });
  rows.sort((a, b) => a.s - b.s);
  const lines = traces.map((_, of) => rows.map((row) => (row.of === of ? row.value : null)));
  return [rows.map((row) => row.s), ...lines];
}

/** The value of a column at a row or, between two rows of its trace, the nearest; nothing where the trace does not reach. */
export function nearest(column: readonly (number | null)[], row: number): number | null {
  const find = (by: 1 | -1): number => {
    for (let i = row; i >= 0 && i < column.length; i += by) if (column[i] != null) return i;
    return -1;
  };
  const [before, after] = [find(-1), find(1)];
  if (before < 0 || after < 0) return null;
  return column[row - before <= after - row ? before : after] ?? null;
}

/** The row whose place is nearest to this one. */
export function rowAt(places: readonly (number | null)[], s: number): number {
  const far = (i: number): number => Math.abs((places[i] ?? Infinity) - s);
  return places.reduce<number>((best, _, i) => (far(i) < far(best) ? i : best), 0);
}
