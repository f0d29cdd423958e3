import type { AxisView } from '../wire';
import { axisUnit, valueName } from './numbers';

/** A line of a plot: a column of the strip; `whose`: a column with the number of the axis that it is of. */
export type PlotLine = { column: string; name: string; unit: string; whose?: string; dashed?: boolean };

/** What can be drawn over time. */
export type Plot = {
  /** Kept in the browser: names, not numbers, so that another machine's axes are not taken for this one's. */
  key: string;
  kind: 'path' | 'tip' | 'greatest' | 'position' | 'speed' | 'error' | 'correction' | 'value';
  /** Name of the axis, or of the value with its unit. */
  of: string;
  unit: string;
  lines: PlotLine[];
  /** The least height of its scale. */
  least: number;
  /** Its scale begins at 0. */
  zero: boolean;
  digits: number;
};

const KEPT = 'seamwright.plots';

/** Everything that this machine with this program can show. */
export function plots(axes: AxisView[], values: string[]): Plot[] {
  const one = (kind: Plot['kind'], of: string, column: string, unit: string, rest: Partial<Plot>): Plot => ({
    key: of === '' ? kind : `${kind} ${of}`, kind, of, unit, lines: [{ column, name: '', unit }], least: 1, zero: false, digits: 2, ...rest,
  });
  const errors = ['mm', 'deg'].filter((unit) => axes.some((axis) => axis.unit === unit));
  return [
    one('path', '', 'speed', 'mm/s', { zero: true }),
    one('tip', '', 'tip speed', 'mm/s', { zero: true }),
    one('greatest', '', '', '', {
      lines: errors.map((unit) => ({ column: `error ${unit}`, name: '', unit: axisUnit(unit), whose: `whose ${unit}` })),
      least: 0.01, zero: true, digits: 3,
    }),
    one('correction', '', '', 'mm', {
      lines: [{ column: 'deviation', name: 'plot.seen', unit: 'mm' }, { column: 'correction', name: 'plot.done', unit: 'mm' }],
      least: 0.2,
    }),
    ...values.map((name, i) => {
      const { unit } = valueName(name);
      const lines: PlotLine[] = [{ column: `set ${i}`, name: 'set', unit, dashed: true }, { column: `value ${i}`, name: 'actual', unit }];
      return one('value', name, '', unit, { lines, least: 2, zero: true, digits: 1 });
    }),
    ...axes.flatMap((axis, i) => {
      const unit = axisUnit(axis.unit);
      return [
        one('position', axis.name, `position ${i}`, unit, {}),
        one('speed', axis.name, `speed ${i}`, `${unit}/s`, {}),
        one('error', axis.name, `error ${i}`, unit, { least: 0.01, digits: 3 }),
      ];
    }),
  ];
}

/** What is drawn before somebody chooses. */
export function usual(all: Plot[], tracked: boolean): string[] {
  const values = all.filter((plot) => plot.kind === 'value').slice(0, 2);
  return ['path', 'greatest', ...(tracked ? ['correction'] : []), ...values.map((plot) => plot.key)];
}

/** What is drawn, in the order of the list: of what was chosen, what there is here; what is usual if that is nothing. */
export function chosen(all: Plot[], own: string[] | null, tracked: boolean): Plot[] {
  const of = (keys: string[]): Plot[] => all.filter((plot) => keys.includes(plot.key));
  const mine = of(own ?? []);
  return mine.length > 0 ? mine : of(usual(all, tracked));
}

/** What was chosen in this browser; null: nothing yet. */
export function kept(): string[] | null {
  try {
    const list: unknown = JSON.parse(localStorage.getItem(KEPT) ?? 'null');
    return Array.isArray(list) ? list.filter((of) => typeof of === 'string') : null;
  } catch {
    return null;
  }
}

export function keep(own: string[]): void {
  localStorage.setItem(KEPT, JSON.stringify(own));
}
