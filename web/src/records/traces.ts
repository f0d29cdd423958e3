/** Columns of a trace with their values. */
export type Trace = { columns: string[]; values: (number | null)[][] };

/** What tells most of a weld, first; a kind each. */
const FIRST = [
  /speed/,
  /path_error|seam_lateral/,
  /(current|beam)_(a|ma)(_measured)?$/,
  /(voltage_v|accelerating_kv|wire_feed_m_min|power_k?w)(_measured)?$/,
  /following_error/,
];
const MOST_AT_ONCE = 4;

/** What is shown before somebody chooses. */
export function preferred(names: string[]): string[] {
  const known = FIRST.flatMap((kind) => names.find((name) => kind.test(name)) ?? []);
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
