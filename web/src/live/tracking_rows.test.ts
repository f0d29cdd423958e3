import { expect, test } from 'vitest';
import type { Status, TrackingStatus } from '../wire';
import { Track } from './tracking_rows';

const LENGTH = 100;
const seen = (lateral: number): TrackingStatus => ({ head: 1, state: 'seen', deviation_mm: [lateral, 0], correction_mm: [lateral, 0], confidence: 1 }) as unknown as TrackingStatus;
const status = (mode: string, s_mm: number, tracking: TrackingStatus[] = [], pass = 1): Status => ({ mode, pass, s_mm, tracking }) as unknown as Status;
const drawn = (of: Track): [number, number | null][] => {
  const { s, seen: rows } = of.rows(1, 0);
  return s.map((at, i) => [at, rows[i] ?? null]);
};

/** Welds up to so far, with a deviation. */
function weld(of: Track, to: number, lateral: number): void {
  of.add(status('ready', 0), LENGTH);
  for (let s = 0; s <= to; s += 10) of.add(status('weld', s, [seen(lateral)]), LENGTH);
}

test('each weld begins anew: nothing of the one before is drawn ahead of it', () => {
  const track = new Track();
  weld(track, 100, 1);
  expect(drawn(track).length).toBe(11);
  // What was welded stays to be looked at until the next weld begins.
  track.add(status('ready', 100), LENGTH);
  expect(drawn(track).length).toBe(11);
  weld(track, 20, 2);
  expect(drawn(track)).toEqual([[0, 2], [10, 2], [20, 2]]);
});

test('a weld that is held goes on with what it has; another pass has its own', () => {
  const track = new Track();
  weld(track, 30, 1);
  track.add(status('hold', 30, [seen(1)]), LENGTH);
  track.add(status('weld', 40, [seen(3)]), LENGTH);
  expect(drawn(track).map(([s]) => s)).toEqual([0, 10, 20, 30, 40]);
  expect(track.add(status('weld', 0, [seen(5)], 2), LENGTH)).toBe(true);
  expect(drawn(track)).toEqual([[0, 5]]);
});
