/** Columns of a trace with their values. */
export type Trace = { columns: string[]; values: (number | null)[][] };

/** What tells most of a weld, first; a kind each. */
const FIRST = [
  /^tip_speed/,
  /path_error|seam_lateral/,
  /(current|beam)_(a|ma)(_measured)?$/,
  /(voltage_v|accelerating_kv|wire_feed_m_min|power_k?w)(_measured)?$/,
  /following_error/,
];
const MOST_AT_ONCE = 4;

/** What is shown before somebody chooses. */
export function preferred(names: string[]): string[] {
  // What was driven tells more than what was asked.
  const driven = names.some((name) => name.startsWith('tip_speed'));
  const known = FIRST.flatMap((kind, i) => names.find((name) => (i === 0 && !driven ? /speed/ : kind).test(name)) ?? []);
  return (known.length > 0 ? known : names).slice(0, MOST_AT_ONCE);
}

/**
 * A column of several traces over one path length: rows of a pass, where the path length grows (a torch that was taken back
 * does not draw over itself), each trace with values only at its own places.
 */
export function merged(traces: Trace[], name: string, pass: number): (number | null)[][] {
  const rows: { s: number; of: number; value: number | null }[] = [];
  traces.forEach((trace, of) => {
    const column = (key: string): (number | null)[] => trace.values[trace.columns.indexOf(key)] ?? [];
    const [passes, places, values] = [column('pass'), column('s_mm'), column(name)];
    let last = -Infinity;
    places.forEach((s, i) => {
      if (passes[i] !== pass || s === null || s <= last) return;
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
