import { expect, test } from 'vitest';
import type { PassView, PathPoint } from '../wire';
import { samples, spanAt, timeOf } from './stretch';

/** 0 to 100 mm along x, from rest at 2 mm/s^2 for 2 s (4 mm), then at 4 mm/s. */
const path = Array.from({ length: 401 }, (_, i) => {
  const s_mm = i / 4;
  return { s_mm, tip: [s_mm, 0, 0], speed_mm_s: Math.min(4, Math.sqrt(4 * s_mm)) } as unknown as PathPoint;
});
const pass = { path, length_mm: 100, spans: [[0, 30.1], [30.1, 100]] } as unknown as PassView;

test('a stretch takes as long as its motion', () => {
  expect(timeOf(path, 0, 4)).toBeCloseTo(2, 2);
  expect(timeOf(path, 0, 100)).toBeCloseTo(2 + 96 / 4, 2);
  expect(timeOf(path, 30.1, 60.3)).toBeCloseTo(30.2 / 4, 9);
  // Pieces add up.
  expect(timeOf(path, 0, 17.3) + timeOf(path, 17.3, 100)).toBeCloseTo(timeOf(path, 0, 100), 6);
  expect(timeOf([], 0, 1)).toBe(0);
});

test('its samples begin and end where it does', () => {
  const made = samples(path, 30.1, 60.3);
  expect([made[0]?.s_mm, made.at(-1)?.s_mm]).toEqual([30.1, 60.3].map((s) => expect.closeTo(s, 9)));
  expect(made.every((point, i) => i === 0 || point.s_mm > (made[i - 1]?.s_mm ?? 0))).toBe(true);
  expect(made[0]?.tip[0]).toBeCloseTo(30.1, 9);
});

test('the span around a place', () => {
  expect(spanAt(pass, 0)).toEqual([0, 30.1]);
  expect(spanAt(pass, 30.1)).toEqual([0, 30.1]);
  expect(spanAt(pass, 31)).toEqual([30.1, 100]);
  expect(spanAt({ ...pass, spans: [] }, 31)).toEqual([0, 100]);
});
