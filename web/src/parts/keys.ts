import { cell } from '../live/cell.svelte';
import { session } from '../live/session.svelte';
import { hasMeaning, type Order } from './orders';

/** Keys of the whole panel; arrows belong to the jog pad. */
const KEYS: Record<string, () => Order> = {
  F1: () => 'stop',
  F2: () => 'switch_on',
  Home: () => 'home',
  r: () => (cell.status?.armed ? 'start_weld' : 'start_dry_run'),
  p: () => 'hold',
  s: () => 'resume',
  Escape: () => 'stop',
};

/** True where keys are text, or choose something. */
export function writes(target: EventTarget | null): boolean {
  if (!(target instanceof HTMLElement)) return false;
  return target.isContentEditable || target.matches('input, select, textarea, [role=grid] *, [role=grid], .editor');
}

/** Sends a command if this panel may; stop needs nothing. */
export function order(of: Order): void {
  if (of !== 'stop' && of !== 'hold' && (!cell.control.mine || !session.may(of))) return;
  if (!hasMeaning(of, cell.mode, cell.powered)) return;
  void cell.ask({ do: of });
}

export function onKey(event: KeyboardEvent): void {
  if (event.repeat || event.ctrlKey || event.altKey || event.metaKey) return;
  const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
  const of = KEYS[key];
  if (!of) return;
  // F1 stops from everywhere; all other keys may be meant for a field or a dialog.
  if (key !== 'F1' && (writes(event.target) || document.querySelector('dialog[open]'))) return;
  event.preventDefault();
  order(of());
}
