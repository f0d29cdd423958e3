import type { SeamRow } from '../wire';

/** Columns by which rows are sorted: their names and values. */
export const columns = {
  number: (row: SeamRow) => row.number,
  name: (row: SeamRow) => row.name,
  status: (row: SeamRow) => row.status,
  machine: (row: SeamRow) => row.machine || row.machines.join(' '),
  count: (row: SeamRow) => row.count,
  passes: (row: SeamRow) => (row.passes > 0 ? row.passes : null),
  time: (row: SeamRow) => (row.passes > 0 ? row.total_s : null),
  arc: (row: SeamRow) => (row.passes > 0 ? row.arc_s : null),
  wire: (row: SeamRow) => row.wire_kg,
  clearance: (row: SeamRow) => row.clearance_mm,
  reason: (row: SeamRow) => row.error ?? row.findings.map(([code]) => code).join(' '),
} as const;

export type Column = keyof typeof columns;

/** Rows in the order of a column; what is not there comes last, whichever way. */
export function sorted(rows: readonly SeamRow[], by: Column, down: boolean): SeamRow[] {
  const value = columns[by];
  const sign = down ? -1 : 1;
  return [...rows].sort((one, other) => {
    const [a, b] = [value(one), value(other)];
    if (a === null || b === null) return a === b ? one.number - other.number : a === null ? 1 : -1;
    const order = typeof a === 'number' && typeof b === 'number' ? a - b : String(a).localeCompare(String(b), undefined, { numeric: true });
    return sign * order || one.number - other.number;
  });
}

/** Rows with this result and this text in them; empty: all. */
export function filtered(rows: readonly SeamRow[], status: string, text: string): SeamRow[] {
  const wanted = text.trim().toLowerCase();
  return rows.filter((row) => {
    if (status !== '' && row.status !== status) return false;
    const all = [row.name, row.template, row.machine, ...row.machines, row.error ?? '', ...row.findings.map(([code]) => code)];
    return wanted === '' || all.join(' ').toLowerCase().includes(wanted);
  });
}

/** How many rows have each result, in the order in which they are shown. */
export function counts(rows: readonly SeamRow[]): [string, number][] {
  const order = ['weldable', 'not_weldable', 'out_of_time', 'invalid', 'failed', 'waiting'];
  const found = order.map((status): [string, number] => [status, rows.filter((row) => row.status === status).length]);
  return found.filter(([, n]) => n > 0);
}
