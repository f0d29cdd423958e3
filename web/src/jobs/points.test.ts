import { expect, test } from 'vitest';
import type { PathPoint } from '../wire';
import { rowNear, sampleBefore } from './points';

test('rows and samples find each other by path length', () => {
  const path = Array.from({ length: 101 }, (_, i) => ({ s_mm: i * 2.5 })) as PathPoint[];
  const points = [0, 40, 80, 127.1, 157, 190, 220, 250];
  points.forEach((s, row) => {
    const sample = sampleBefore(path, s);
    const before = s - (path[sample]?.s_mm ?? NaN);
    expect(before).toBeGreaterThanOrEqual(0);
    expect(before).toBeLessThan(2.5);
    expect(rowNear(points, path[sample]?.s_mm ?? NaN)).toBe(row);
  });
  expect(sampleBefore(path, 1e9)).toBe(100);
  expect(sampleBefore([], 3)).toBe(0);
  expect(rowNear([], 3)).toBe(0);
});
