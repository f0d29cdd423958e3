import { expect, test } from 'vitest';
import type { LatencyView } from '../wire';
import { bars, bytes, quantile, short } from './latency_histogram';

const view = (counts: number[], most_us: number): LatencyView => ({ limits_us: [1, 2, 5, 10], counts, sum_s: 0, most_us });

test('a histogram is drawn from the first to the last class with cycles', () => {
  const all = bars(view([0, 900, 0, 99, 1], 700));
  expect(all.map(({ from, to, count }) => [from, to, count])).toEqual([[1, 2, 900], [2, 5, 0], [5, 10, 99], [10, null, 1]]);
  expect(all.map(({ part }) => part)).toEqual([0.9, 0, 0.099, 0.001]);
  // One late cycle among a thousand is seen.
  expect(all[0]?.height).toBe(1);
  expect(all[1]?.height).toBe(0);
  expect(all[3]?.height).toBeGreaterThan(0.1);
  expect(bars(view([5, 0, 0, 0, 0], 1)).map(({ from, to }) => [from, to])).toEqual([[0, 1]]);
  expect(bars(view([0, 0, 0, 0, 0], 0))).toEqual([]);
});

test('a quantile is the limit of its class, and never more than the maximum', () => {
  const of = view([0, 900, 0, 99, 1], 700);
  expect([0.5, 0.9, 0.99, 0.999, 1].map((part) => quantile(of, part))).toEqual([2, 2, 10, 10, 700]);
  expect(quantile(view([10, 0, 0, 0, 0], 0.4), 0.5)).toBe(0.4);
  expect(quantile(view([0, 0, 0, 0, 0], 0), 0.5)).toBeNull();
});

test('times and bytes have few digits', () => {
  expect([0.4, 5, 54.25, 1000, 12_345, 2.5e6].map(short)).toEqual(['0.4 µs', '5 µs', '54.3 µs', '1 ms', '12.3 ms', '2.5 s']);
  expect([null, 0, 5.5 * 2 ** 20, 312 * 2 ** 20, 40 * 2 ** 30].map(bytes)).toEqual(['–', '0.0 MiB', '5.5 MiB', '312 MiB', '40.0 GiB']);
});
