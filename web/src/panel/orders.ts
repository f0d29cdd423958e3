import type { AskView } from '../wire';

/** A command without numbers. */
export type Order = Exclude<AskView['do'], 'override'>;

/** The command that an operator most likely wants next, and which the checklist is about. */
const NEXT: Partial<Record<string, Order>> = { off: 'switch_on', idle: 'home', ready: 'start_weld', hold: 'resume', fault: 'reset' };

export const next = (mode: string | null): Order | null => NEXT[mode ?? ''] ?? null;

/** True where something runs or waits to go on. A mode that is not known is not one in which the cell stands. */
export function runs(mode: string | null): boolean {
  return mode !== null && !['off', 'idle', 'ready', 'fault'].includes(mode);
}
