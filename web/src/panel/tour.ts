/** Input of the tour: the state of the cell, not clicks. Users who know the steps can take them directly. */
export type Seen = {
  mine: boolean;
  powered: boolean;
  mode: string | null;
  armed: boolean;
  /** A program is loaded. */
  work: boolean;
  /** Its start was refused, since the axes stand elsewhere. */
  elsewhere: boolean;
  /** A weld was left on its way. */
  left: boolean;
  /** What is loaded goes on with it. */
  goesOn: boolean;
  /** Arc or beam has burned in this tour. */
  burned: boolean;
  /** Records are looked at. */
  records: boolean;
};

/** Steps in all. */
export const STEPS = 7;

/** The step, from 1, and what is to be done now; off the way (dry run, hold, fault ..) that is something else than usual. */
export function lead(seen: Seen): { step: number; key: string } {
  const { mode } = seen;
  if (mode === 'weld') return { step: 6, key: 'tour.watch' };
  if (mode === 'hold') return { step: 6, key: seen.mine ? 'tour.hold' : 'tour.control' };
  if (seen.burned && !seen.left && (mode === 'ready' || seen.records)) {
    return seen.records ? { step: STEPS, key: 'tour.end' } : { step: STEPS, key: 'tour.record' };
  }
  if (mode === 'fault') return { step: 3, key: 'tour.fault' };
  if (!seen.mine) return { step: 1, key: 'tour.control' };
  if (!seen.powered) return { step: 2, key: 'tour.on' };
  if (mode === 'dry_run') return { step: 4, key: 'tour.dry' };
  if (mode === 'jog' || mode === 'teach') return { step: 4, key: 'tour.jog' };
  if (mode !== 'ready') return { step: 3, key: 'tour.home' };
  if (seen.left && !seen.goesOn) return { step: 4, key: 'tour.left' };
  if (!seen.work) return { step: 4, key: 'tour.load' };
  if (seen.elsewhere) return { step: 4, key: 'tour.again' };
  return seen.armed ? { step: 5, key: 'tour.weld' } : { step: 4, key: 'tour.arm' };
}
