import { expect, test } from 'vitest';
import type { BoundView, PassView, UseView } from '../wire';
import { limitText, sampleAt, strips, useText } from './certificate';

const bound = (from_mm: number, to_mm: number, more: Partial<BoundView> = {}): BoundView => ({
  from_mm, to_mm, least_speed_mm_s: 1, between: true, what: 'asked', axis: null, limit: null, unit: null, ...more,
});

test('limits are told with their units, and with three digits', () => {
  expect(limitText(bound(0, 1, { what: 'jerk', axis: 'x', limit: 1234.56, unit: 'mm/s^3' }))).toBe('1235 mm/s³');
  expect(limitText(bound(0, 1, { what: 'speed', axis: 'b', limit: 0.5, unit: 'deg/s' }))).toBe('0.500 °/s');
  expect(limitText(bound(0, 1))).toBe('');
});

test('use is told of each limit that there is', () => {
  const use: UseView = { axis: 'x', unit: 'deg', percent: [34.2, 3.14159, null], limit: [20, 150, null] };
  const text = (order: number): string => useText(use, order, (percent, of) => `${percent} % of ${of}`);
  expect([0, 1, 2].map(text)).toEqual(['34 % of 20.0 °/s', '3.1 % of 150 °/s²', '']);
});

test('stretches cover the length and are seen however short they are', () => {
  const made = strips([bound(0, 0.1), bound(0.1, 150), bound(150, 200)], 200);
  expect(made.map(({ left }) => left)).toEqual([0, 0.05, 75]);
  expect(made[0]?.width).toBe(0.4);
  expect(made[2]?.width).toBe(25);
});

test('the sample at a path length', () => {
  const pass = { path: [0, 10, 20].map((s_mm) => ({ s_mm })) } as PassView;
  expect([0, 0.1, 10, 20, 21].map((s) => sampleAt(pass, s))).toEqual([0, 1, 1, 2, 2]);
});
