import { axisUnit, valueName } from '../panel/numbers';
import type { AxisView } from '../wire';
import { named, t } from '../words/index.svelte';

/** A column in words, with its unit: of the tip, an axis, a process value, time or speed. */
export function columnTitle(column: string, axes: AxisView[]): string {
  const axis = axes.find((of) => of.name === column);
  if (axis) return `${column} ${axisUnit(axis.unit)}`;
  const { title, unit } = valueName(column);
  if (['x', 'y', 'z'].includes(title)) return `${title.toUpperCase()} ${unit}`;
  if (column === 'n') return t('column.n');
  const words = title === 'speed' || title === 'time' ? t(`column.${title}`) : named('value', title);
  return unit ? `${words} ${unit}` : words;
}

/** The speed of a column that says the place: of cubics. */
export const speedTitle = (column: string, axes: AxisView[]): string => `${columnTitle(column, axes)}/s`;
