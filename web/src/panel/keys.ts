import { cell } from '../live/cell.svelte';
import { session } from '../live/session.svelte';
import { layers } from './layers.svelte';
import { meant, type Spot } from './key_command';
import type { Order } from './orders';
import { starting } from './starting.svelte';
import { place } from './place.svelte';

/** True where keys are text, or choose something. */
export function writes(target: EventTarget | null): boolean {
  if (!(target instanceof HTMLElement)) return false;
  return target.isContentEditable || target.matches('input, select, textarea, [role=grid] *, [role=grid], .editor');
}

function spot(target: EventTarget | null): Spot {
  const of = (which: string): boolean => target instanceof HTMLElement && target.closest(which) !== null;
  return {
    tab: place.tab,
    writes: (writes(target) || of('.editor')) && !of('input[type=range], input[type=checkbox], input[type=radio]'),
    scrolls: of('input') || (target instanceof HTMLElement && target.matches('[tabindex="0"]')),
    open: layers.any,
    dialog: document.querySelector('dialog[open]') !== null,
    armed: cell.status?.armed ?? false,
  };
}

/** Sends a command if this panel may; stop needs nothing. */
export function order(of: Order): void {
  if (of === 'stop') {
    void cell.stopping.stop();
    return;
  }
  if (of !== 'hold' && (!cell.control.mine || !session.may(of) || !cell.can(of))) return;
  if (of === 'start_weld') void starting.start();
  else void cell.ask({ do: of });
}

/** Does what a key means; called before any field or dialog sees the key, so none of them can keep STOP to itself. */
export function onKey(event: KeyboardEvent): void {
  if (event.repeat || event.ctrlKey || event.altKey || event.metaKey) return;
  const of = meant(event.key.length === 1 ? event.key.toLowerCase() : event.key, spot(event.target));
  // Who is not logged in can stop and nothing else.
  if (!of || (!session.view && of !== 'stop' && of !== 'close')) return;
  event.preventDefault();
  if (of === 'close') layers.closeTop();
  else order(of);
}
