import type { AskView } from '../wire';

/** A command without numbers. */
export type Order = Exclude<AskView['do'], 'override'>;

/** Modes in which a command has a meaning: for greying only, the cell decides. Hold and stop have one in all. */
const MODES: Partial<Record<Order, string[]>> = {
  switch_on: ['off'],
  switch_off: ['idle', 'ready'],
  home: ['idle', 'ready'],
  start_jog: ['ready'],
  start_teach: ['ready'],
  start_dry_run: ['ready'],
  arm: ['ready', 'hold'],
  start_weld: ['ready'],
  resume: ['hold'],
  reverse: ['hold'],
  reset: ['fault'],
};

/** Commands that need the drives' power, which takes a moment after switching on. */
const ON_POWER: Order[] = ['home', 'start_jog', 'start_teach', 'start_dry_run', 'start_weld'];

export function hasMeaning(order: Order, mode: string | null, powered = true): boolean {
  const modes = MODES[order];
  return mode !== null && (modes === undefined || modes.includes(mode)) && (powered || !ON_POWER.includes(order));
}

/** Switched on, but the drives do not have power yet. */
export function powerComes(mode: string | null, powered: boolean): boolean {
  return !powered && (mode === 'idle' || mode === 'ready');
}

/** It goes back in a hold. */
export function movesHeld(mode: string | null, status: { speed_mm_s: number } | null): boolean {
  return mode === 'hold' && Math.abs(status?.speed_mm_s ?? 0) > 0.001;
}

/** True where something moves, so that there is something to hold. */
export function canHold(mode: string | null): boolean {
  return mode !== null && ['homing', 'jog', 'teach', 'dry_run', 'weld'].includes(mode);
}

/** True where something runs or waits to go on, so that it can be left where it is. */
export function canAbort(mode: string | null): boolean {
  return canHold(mode) || mode === 'hold';
}

/** The command that an operator most likely wants next, and which the checklist is about. */
export function next(mode: string | null): Order | null {
  switch (mode) {
    case 'off':
      return 'switch_on';
    case 'idle':
      return 'home';
    case 'ready':
      return 'start_weld';
    case 'hold':
      return 'resume';
    case 'fault':
      return 'reset';
    default:
      return null;
  }
}
