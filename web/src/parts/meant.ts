import type { Order } from './orders';
import type { Tab } from './place.svelte';

/** Where a key was pressed. */
export type Spot = {
  tab: Tab;
  /** What a text is written into, or a list that letters choose from. */
  writes: boolean;
  /** Home is its own: a slider, or what scrolls. */
  scrolls: boolean;
  /** The editor of texts, which has a use for Esc. */
  editor: boolean;
  dialog: boolean;
  armed: boolean;
};

/**
 * The command of a key; arrows belong to the jog pad. What stops is heard everywhere but where the key has another use at once (Esc closes
 * a dialog; F1 has none), and no slider or field that was touched before is in its way. What moves is heard only on the pages of
 * the machine: in a table of points or a list a slip of the hand moves nothing.
 */
export function meant(key: string, at: Spot): Order | null {
  if (key === 'F1') return 'stop';
  if (at.dialog) return null;
  if (key === 'Escape') return at.editor ? null : 'stop';
  if (at.writes) return null;
  if (key === 'p') return 'hold';
  if (key === 'F2') return 'switch_on';
  if (at.tab !== 'weld' && at.tab !== 'teach') return null;
  if (key === 'Home') return at.scrolls ? null : 'home';
  if (key === 'r') return at.armed ? 'start_weld' : 'start_dry_run';
  return key === 's' ? 'resume' : null;
}
