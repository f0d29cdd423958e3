import { expect, test } from 'vitest';
import type { PathPoint } from '../wire';
import { pointPasses, rowNear, sampleBefore } from './points';

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

test('points of cubics have the speeds at which they are reached, or left', () => {
  const text = `
[[passes]]
[passes.points]
columns = ["x", "b", "n", "current_a", "time_s"]
start = [0, 0, 0, 50, 0]
[[passes.points.spans]]
along = "cubic"
speeds = [[1, 2], [3, "= v"], [5, 6]]
points = [[1, 0, 10, 50, 1], [2, 0, 20, 50, 1]]
[[passes.points.spans]]
along = "line"
points = [[3, 0, 30, 50, 1]]
[[passes.points.spans]]
along = "cubic"
points = [[4, 0, 40, 50, 1]]
speeds = [[7, 8], [9, 0]]
`;
  const [pass] = pointPasses(text);
  expect(pass?.moving).toEqual(['x', 'b']);
  expect(pass?.rows.map((row) => row.speeds)).toEqual([[1, 2], [3, NaN], [5, 6], [7, 8], [9, 0]]);
  expect(pointPasses(text.replaceAll('cubic', 'spline').replaceAll(/speeds = .*/g, ''))[0]?.moving).toEqual([]);
});
