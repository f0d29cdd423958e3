import type { Order } from './orders';
import type { Tab } from './place.svelte';

/** Where a key was pressed. */
export type Spot = {
  tab: Tab;
  /** What a text is written into, or a list that letters choose from. */
  writes: boolean;
  /** Home is its own: a slider, or what scrolls. */
  scrolls: boolean;
  /** Menus or dialogs are open. */
  open: boolean;
  dialog: boolean;
  armed: boolean;
};

/** What a key does: a command, or `close` for the topmost menu or dialog. */
export type Meaning = Order | 'close';

/**
 * Returns the meaning of a key; arrows belong to the jog pad. F1 stops from everywhere. Esc closes what is open, one at a time; it stops
 * only if nothing is open and nothing is being written, so closing something never stops a weld. What moves is heard only on the pages
 * of the machine: in a table of points or a list a slip of the hand moves nothing.
 */
export function meant(key: string, at: Spot): Meaning | null {
  if (key === 'F1') return 'stop';
  if (key === 'Escape') return at.open ? 'close' : at.writes ? null : 'stop';
  if (at.dialog || at.writes) return null;
  if (key === 'p') return 'hold';
  if (key === 'F2') return 'switch_on';
  if (at.tab !== 'weld' && at.tab !== 'teach') return null;
  if (key === 'Home') return at.scrolls ? null : 'home';
  if (key === 'r') return at.armed ? 'start_weld' : 'start_dry_run';
  return key === 's' ? 'resume' : null;
}
