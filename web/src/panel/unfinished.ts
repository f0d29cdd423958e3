import type { LeftView, WorkView } from '../wire';

/** A place in a weld: pass from 1, and path length in mm. */
export type Place = [number, number];

/** A longer way back than the pass asks for, as somebody chose it for one interruption. */
export type Overlap = { of: string; extra_mm: number };

/** Names an interruption: the next one of the same part is another. */
export const interruption = (left: LeftView): string => `${left.record ?? ''} ${left.pass} ${left.s_mm}`;

/** How many passes of what is in the cell are finished, from the first one on. */
export function finishedPasses(left: LeftView | null): number {
  return left?.here ? left.finished : 0;
}

/** How much of what is welded is welded over on purpose where the weld goes on, mm: loaded with it, the cell does not ask about it. */
export function chosenOverlap(left: LeftView | null, overlap: Overlap | null): number {
  return left?.here && overlap?.of === interruption(left) ? Math.min(left.s_mm, overlap.extra_mm) : 0;
}

/** The place with which to load so that the weld goes on: that of the newest interruption, never one that was loaded before. */
export function continueFrom(left: LeftView, overlap: Overlap | null): Place {
  return [left.pass, left.s_mm - chosenOverlap(left, overlap)];
}

/** The place with which to load the same program once more: where an unfinished weld goes on, else as it was loaded. */
export function reloadFrom(work: Pick<WorkView, 'from'>, left: LeftView | null, overlap: Overlap | null): Place | null {
  return left?.here ? continueFrom(left, overlap) : work.from;
}
