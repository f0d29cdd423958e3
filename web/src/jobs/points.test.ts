import { expect, test } from 'vitest';
import type { PathPoint } from '../wire';
import { rowNear, sampleNear } from './points';

test('rows and samples find each other by path length', () => {
  const path = Array.from({ length: 101 }, (_, i) => ({ s_mm: i * 2.5 })) as PathPoint[];
  const points = [0, 40, 80, 127.1, 157, 190, 220, 250];
  points.forEach((s, row) => {
    const sample = sampleNear(path, s);
    expect(Math.abs((path[sample]?.s_mm ?? NaN) - s)).toBeLessThanOrEqual(1.25);
    expect(rowNear(points, path[sample]?.s_mm ?? NaN)).toBe(row);
  });
  expect(sampleNear(path, 1e9)).toBe(100);
  expect(rowNear([], 3)).toBe(0);
});
