import { describe, expect, test } from 'vitest';
import type { HeightView } from '../wire';
import { net, numbersOf, planeAt, withPlane } from './sensors';

const plane = (z_mm: number, scale = 0.1): HeightView => ({ z_mm, mm_per_px: [scale, scale], centre_px: null, rotation_deg: 0, shear: 0, barrel: 0 });

describe('planes of a camera', () => {
  test('a plane takes the place of that at its height, or stands where it belongs', () => {
    const planes = [plane(-20), plane(20)];
    expect(withPlane(planes, plane(20, 0.2))).toEqual([plane(-20), plane(20, 0.2)]);
    expect(withPlane(planes, plane(0, 0.2)).map((of) => of.z_mm)).toEqual([-20, 0, 20]);
    expect(withPlane(planes, plane(-30)).map((of) => of.z_mm)).toEqual([-30, -20, 20]);
    expect(planeAt(planes, 20 + 1e-9)).toBe(planes[1]);
    expect(planeAt(planes, 19)).toBeUndefined();
  });
});

test('numbers in a row, with comma or point', () => {
  expect(numbersOf(' 1  -2,5 3e1 ')).toEqual([1, -2.5, 30]);
  expect(numbersOf('')).toEqual([]);
  expect(numbersOf('1 x')).toBeNull();
});

test('the net joins neighbours, not diagonals', () => {
  const dots = [0, 1, 2].flatMap((i) => [0, 1, 2].map((k): [number, number, number, number] => [10 * i, 10 * k, 0.1, -0.1]));
  expect(net(dots).length).toBe(12);
  expect(net(dots)[0]?.[0]).toEqual([0.1, -0.1]);
  expect(net([])).toEqual([]);
});
