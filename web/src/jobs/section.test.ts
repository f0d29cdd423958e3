import { describe, expect, test } from 'vitest';
import type { SectionView } from '../wire';
import { barLength, centre, fitted, measured, outline, sizes } from './section';

/** A V of 60 degrees, 12 mm thick, with 3 mm of root gap and 2 mm of root face. */
const out = 10 * Math.tan(Math.PI / 6);
const v = {
  edges: [
    [[1.5, -12], [1.5, -10], [1.5 + out, 0]],
    [[-1.5, -12], [-1.5, -10], [-1.5 - out, 0]],
  ],
  beads: [{ outline: [[-1, -12], [1, -12], [1, -10], [-1, -10]] }],
} as unknown as SectionView;

describe('the picture of a joint', () => {
  test('sizes are those of the drawing', () => {
    const found = sizes(v);
    expect(found.gap).toBeCloseTo(3);
    expect(found.depth).toBeCloseTo(12);
    expect(found.angle).toBeCloseTo(60);
    expect(found.opening).toBeCloseTo(3 + 2 * out);
  });

  test('it fits, at one scale both ways, the right way up', () => {
    const { place, scale } = fitted(v, 400, 300);
    const [low, high, right] = [place([0, -12]), place([0, 0]), place([1, -12])];
    expect(low[1] - high[1]).toBeCloseTo(12 * scale);
    expect(right[0] - low[0]).toBeCloseTo(scale);
    for (const edge of v.edges) {
      for (const point of edge) {
        const [x, y] = place(point);
        expect(x > 0 && x < 400 && y > 0 && y < 300).toBe(true);
      }
    }
    expect(outline([[0, 0], [1, 0]], ([x, y]) => [x, y])).toBe('M0.0,0.0L1.0,0.0Z');
    expect(outline([], place)).toBe('');
  });

  test('lines are as long as what they measure, however the joint lies', () => {
    for (const turn of [0, 0.7, 2, 4]) {
      const [c, s] = [Math.cos(turn), Math.sin(turn)];
      const turned = { ...v, edges: v.edges.map((edge) => edge.map(([x, y]) => [c * x - s * y, s * x + c * y])) } as unknown as SectionView;
      const { place, scale } = fitted(turned, 400, 300);
      const lines = measured(turned, place);
      expect(lines.map((line) => line.mm.toFixed(3))).toEqual([(3 + 2 * out).toFixed(3), '12.000', '3.000']);
      for (const { a, b, mm } of lines) expect(Math.hypot(a[0] - b[0], a[1] - b[1])).toBeCloseTo(mm * scale);
      const [opening, depth] = lines.map(({ a, b }) => [b[0] - a[0], b[1] - a[1]] as const);
      if (opening && depth) expect(opening[0] * depth[0] + opening[1] * depth[1]).toBeCloseTo(0);
    }
  });

  test('numbers stand in the middle of beads', () => {
    expect(centre(v.beads[0]?.outline ?? [])).toEqual([0, -11]);
    expect(centre([[2, 3]])).toEqual([2, 3]);
  });

  test('scale bars are round and fit', () => {
    for (let scale = 0.5; scale < 200; scale *= 1.3) {
      const bar = barLength(400, scale);
      expect(bar * scale).toBeLessThanOrEqual(80);
      expect(bar * scale).toBeGreaterThan(30);
      expect([1, 2, 5]).toContain(Number(bar.toExponential()[0]));
    }
  });
});
