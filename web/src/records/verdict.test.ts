import { expect, test } from 'vitest';
import type { JudgedView } from '../wire';
import { isOutside, outside } from './verdict';

const value = (of: Partial<JudgedView>): JudgedView => ({ pass: 1, name: 'current_a', least: 235, mean: 240, greatest: 245, allowed: [220, 260], outside_s: 0, outside_mm: 0, ...of });

test('a value that was outside over no length of the weld, as in a hold, is no violation', () => {
  expect(isOutside(value({ least: 0, outside_s: 4.2 }))).toBe(false);
  expect(isOutside(value({ allowed: null, outside_s: 4.2, outside_mm: 3 }))).toBe(false);
  expect(isOutside(value({}))).toBe(false);
});

test('only the figures that are outside are marked', () => {
  expect(outside(value({ least: 200, outside_s: 1, outside_mm: 9 }))).toEqual({ least: true, mean: false, greatest: false });
  expect(outside(value({ least: 262, mean: 265, greatest: 270, outside_s: 1, outside_mm: 9 }))).toEqual({ least: true, mean: true, greatest: true });
});
