import type { PathPoint } from '../wire';
import { read, type Value } from './toml';

/** A point of a program and how it is reached; a number that is an expression is NaN. */
export type Row = {
  along: string;
  /** From 1; 0 of the start. */
  span: number;
  numbers: number[];
  /** Of the cubic that ends there, or else begins there: speeds of `moving`. */
  speeds: number[];
};

/** A pass through points; row 0 is its start, as the edits of programs count. */
export type PointPass = { pass: number; columns: string[]; rows: Row[]; /** Arc or beam is on. */ arc: boolean; /** Columns that cubics have speeds of; none without cubics. */ moving: string[] };

export function pointPasses(text: string): PointPass[] {
  const passes = new Map<number, PointPass>();
  const along = new Map<string, string>();
  const speeds = new Map<string, number[][]>();
  for (const { table, key, value } of read(text)) {
    const match = /^passes\.(\d+)\.points(\.spans\.\d+)?$/.exec(table);
    if (!match) continue;
    const index = Number(match[1]);
    const pass = passes.get(index) ?? { pass: index + 1, columns: [], rows: [], arc: true, moving: [] };
    passes.set(index, pass);
    if (!match[2] && key === 'columns') pass.columns = texts(value);
    if (!match[2] && key === 'arc' && value.kind === 'truth') pass.arc = value.truth;
    if (!match[2] && key === 'start') pass.rows.unshift({ along: '', span: 0, numbers: numbers(value), speeds: [] });
    if (match[2] && key === 'along' && value.kind === 'text') along.set(table, value.text);
    if (match[2] && key === 'points' && value.kind === 'list') {
      const span = Number(match[2].slice('.spans.'.length)) + 1;
      for (const item of value.items) pass.rows.push({ along: along.get(table) ?? '', span, numbers: numbers(item), speeds: [] });
    }
    if (match[2] && key === 'speeds' && value.kind === 'list') speeds.set(table, value.items.map(numbers));
  }
  for (const [index, pass] of passes) setSpeeds(pass, (span) => speeds.get(`passes.${index}.points.spans.${span - 1}`) ?? []);
  return [...passes.values()];
}

/** Gives rows the speeds of cubics: `of` says those of a span, the first of them where it begins. */
function setSpeeds(pass: PointPass, of: (span: number) => number[][]): void {
  let first = 0;
  pass.rows.forEach((row, i) => {
    if (i === 0) return;
    if (row.span !== pass.rows[i - 1]?.span) first = i;
    const all = of(row.span);
    row.speeds = all[i - first + 1] ?? [];
    const before = pass.rows[i - 1];
    if (i === first && before && before.speeds.length === 0) before.speeds = all[0] ?? [];
  });
  const place = (name: string): boolean => /^([xyz]_mm|a[xyz])$/.test(name) || (!name.includes('_') && name !== 'n');
  if (pass.rows.some((row) => row.speeds.length > 0)) pass.moving = pass.columns.filter(place);
}

function texts(value: Value): string[] {
  return value.kind === 'list' ? value.items.map((item) => (item.kind === 'text' ? item.text : '')) : [];
}

function numbers(value: Value): number[] {
  return value.kind === 'list' ? value.items.map((item) => (item.kind === 'number' ? item.number : NaN)) : [];
}

/** The last sample of a pass at or before a path length, mm: in the span that leads there. */
export function sampleBefore(path: PathPoint[], s_mm: number): number {
  return Math.max(0, path.findLastIndex((point) => point.s_mm <= s_mm + 1e-9));
}

/** The row of the point that is reached nearest to a path length; `points_mm` are those of the plan. */
export function rowNear(points_mm: number[], s_mm: number): number {
  let best = 0;
  points_mm.forEach((of, i) => {
    if (Math.abs(of - s_mm) < Math.abs((points_mm[best] ?? Infinity) - s_mm)) best = i;
  });
  return best;
}
