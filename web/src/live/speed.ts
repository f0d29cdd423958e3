import type { Status } from '../wire';

/** Below this a tip rests: it is the noise of encoders, mm/s. */
const RESTS_MM_S = 0.1;

/** The speed that is shown, mm/s: that along the path, and beside passes how fast the tip moves (`tip`, measured) in the work. */
export type Shown = { mm_s: number; of: 'path' | 'tip' };

export function shownSpeed(status: Status, tip: number): Shown {
  const path = status.speed_mm_s;
  return path > 0 || !(tip > RESTS_MM_S) ? { mm_s: path, of: 'path' } : { mm_s: tip, of: 'tip' };
}
