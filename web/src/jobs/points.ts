import type { FormView, PathPoint } from '../wire';

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

export function pointPasses(form: FormView | null): PointPass[] {
  const numbers = (of: (number | null)[]): number[] => of.map((value) => value ?? NaN);
  return (form?.passes ?? []).map((pass) => ({ ...pass, rows: pass.rows.map((row) => ({ ...row, numbers: numbers(row.numbers), speeds: numbers(row.speeds) })) }));
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
