import { describe, expect, test } from 'vitest';
import type { LeftView } from '../wire';
import { chosenOverlap, continueFrom, finishedPasses, interruption, reloadFrom } from './unfinished';

const left = (pass: number, s_mm: number, more: Partial<LeftView> = {}): LeftView => ({ pass, s_mm, finished: pass - 1, record: 7, title: 'Nozzle', part: 'N1-001', here: true, ...more });

describe('an unfinished weld', () => {
  test('goes on at its newest interruption, whatever place was loaded before', () => {
    // Continued in pass 1 from 135.2 mm, then stopped in pass 2.
    const work = { from: [1, 135.2] as [number, number] };
    expect(reloadFrom(work, left(2, 6), null)).toEqual([2, 6]);
    expect(continueFrom(left(2, 6), null)).toEqual([2, 6]);
  });

  test('keeps a longer overlap for the interruption that it was chosen for, and for no other', () => {
    const first = left(1, 152);
    const overlap = { of: interruption(first), extra_mm: 20 };
    expect(continueFrom(first, overlap)).toEqual([1, 132]);
    expect(reloadFrom({ from: [1, 132] }, first, overlap)).toEqual([1, 132]);
    expect(continueFrom(left(1, 170), overlap)).toEqual([1, 170]);
    expect(continueFrom(left(1, 152, { record: 8 }), overlap)).toEqual([1, 152]);
    expect(continueFrom(left(1, 5), { of: interruption(left(1, 5)), extra_mm: 20 })).toEqual([1, 0]);
  });

  test('is loaded with the overlap that was chosen, so that the cell does not ask about it', () => {
    const first = left(1, 152);
    expect(chosenOverlap(first, { of: interruption(first), extra_mm: 10 })).toBe(10);
    expect(chosenOverlap(left(1, 170), { of: interruption(first), extra_mm: 10 })).toBe(0);
    // No further back than the pass goes.
    expect(chosenOverlap(left(1, 5), { of: interruption(left(1, 5)), extra_mm: 10 })).toBe(5);
    expect(chosenOverlap(first, null)).toBe(0);
    expect(chosenOverlap(null, { of: interruption(first), extra_mm: 10 })).toBe(0);
  });

  test('is loaded as before where nothing of it was left here', () => {
    expect(reloadFrom({ from: null }, null, null)).toBeNull();
    expect(reloadFrom({ from: [3, 4] }, left(2, 6, { here: false }), null)).toEqual([3, 4]);
  });

  test('has its finished passes, as the cell counts them', () => {
    expect(finishedPasses({ ...left(3, 10), finished: 1 })).toBe(1);
    expect(finishedPasses(left(3, 10, { here: false }))).toBe(0);
    expect(finishedPasses(null)).toBe(0);
  });
});
