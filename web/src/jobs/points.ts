import type { PathPoint } from '../wire';
import { read, type Value } from './toml';

/** A point of a program and how it is reached; a number that is an expression is NaN. */
export type Row = { along: string; numbers: number[] };

/** A pass through points; row 0 is its start, as the edits of programs count. */
export type PointPass = { pass: number; columns: string[]; rows: Row[] };

export function pointPasses(text: string): PointPass[] {
  const passes = new Map<number, PointPass>();
  const along = new Map<string, string>();
  for (const { table, key, value } of read(text)) {
    const match = /^passes\.(\d+)\.points(\.spans\.\d+)?$/.exec(table);
    if (!match) continue;
    const index = Number(match[1]);
    const pass = passes.get(index) ?? { pass: index + 1, columns: [], rows: [] };
    passes.set(index, pass);
    if (!match[2] && key === 'columns') pass.columns = texts(value);
    if (!match[2] && key === 'start') pass.rows.unshift({ along: '', numbers: numbers(value) });
    if (match[2] && key === 'along' && value.kind === 'text') along.set(table, value.text);
    if (match[2] && key === 'points' && value.kind === 'list') {
      for (const item of value.items) pass.rows.push({ along: along.get(table) ?? '', numbers: numbers(item) });
    }
  }
  return [...passes.values()];
}

function texts(value: Value): string[] {
  return value.kind === 'list' ? value.items.map((item) => (item.kind === 'text' ? item.text : '')) : [];
}

function numbers(value: Value): number[] {
  return value.kind === 'list' ? value.items.map((item) => (item.kind === 'number' ? item.number : NaN)) : [];
}

/** How far a sample of the plan is from a row, in the numbers that both have: the tip, or the axes. */
function far(row: Row, columns: string[], axes: string[], sample: PathPoint): number {
  let sum = 0;
  columns.forEach((column, i) => {
    const tip = ['x_mm', 'y_mm', 'z_mm'].indexOf(column);
    const axis = axes.indexOf(column);
    const there = tip >= 0 ? sample.tip[tip] : axis >= 0 ? sample.axes[axis] : undefined;
    if (there !== undefined) sum += (there - (row.numbers[i] ?? 0)) ** 2;
  });
  return sum;
}

/** The sample of a pass nearest to a row. */
export function sampleOf(row: Row, columns: string[], axes: string[], path: PathPoint[]): number {
  return least(path.length, (i) => far(row, columns, axes, path[i] as PathPoint));
}

/** The row nearest to a sample. */
export function rowOf(sample: PathPoint, pass: PointPass, axes: string[]): number {
  return least(pass.rows.length, (i) => far(pass.rows[i] as Row, pass.columns, axes, sample));
}

function least(count: number, of: (index: number) => number): number {
  let best = 0;
  let value = Infinity;
  for (let i = 0; i < count; i += 1) {
    const here = of(i);
    if (here < value) [best, value] = [i, here];
  }
  return best;
}
