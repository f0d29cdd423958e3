import { axisUnit, number } from '../panel/numbers';
import type { BoundView, PassView, UseView } from '../wire';

/** The limits of an axis, in the order of the wire. */
export const LIMITS = ['speed', 'acceleration', 'jerk'] as const;

/** A number of any size with three digits that count. */
function three(value: number): string {
  return number(value, Math.max(0, 2 - Math.floor(Math.log10(Math.max(Math.abs(value), 1e-3)))));
}

/** `mm/s²` and the like. */
export function limitUnit(unit: string, order: number): string {
  return `${axisUnit(unit)}/s${['', '²', '³'][order] ?? ''}`;
}

/** The limit that bounds a stretch, with its unit; nothing where it is as fast as asked. */
export function limitText(bound: BoundView): string {
  if (bound.limit === null) return '';
  return `${three(bound.limit)} ${(bound.unit ?? '').replace('deg', '°').replace('^2', '²').replace('^3', '³')}`;
}

/** `34 % of 50 mm/s`: how much of one limit is used at most; nothing without such a limit. */
export function useText(use: UseView, order: number, of: (percent: string, limit: string) => string): string {
  const [percent, limit] = [use.percent[order], use.limit[order]];
  if (percent == null || limit == null) return '';
  return of(number(percent, percent < 9.95 ? 1 : 0), `${three(limit)} ${limitUnit(use.unit, order)}`);
}

/** Stretches to be drawn, with the acceleration and deceleration phase, as parts of the length; each is wide enough to be pressed. */
export function strips(bounds: BoundView[], length: number): { bound: BoundView; left: number; width: number }[] {
  return bounds.map((bound) => ({ bound, left: (100 * bound.from_mm) / length, width: Math.max(0.4, (100 * (bound.to_mm - bound.from_mm)) / length) }));
}

/** The sample at or behind a path length. */
export function sampleAt(pass: PassView, s: number): number {
  const found = pass.path.findIndex((point) => point.s_mm >= s - 1e-9);
  return found < 0 ? pass.path.length - 1 : found;
}
