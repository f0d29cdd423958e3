import { cell } from '../live/cell.svelte';
import { session } from '../live/session.svelte';
import { meant, type Spot } from './meant';
import { canAbort, hasMeaning, type Order } from './orders';
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
    writes: writes(target) && !of('input[type=range], input[type=checkbox], input[type=radio]'),
    scrolls: of('input') || (target instanceof HTMLElement && target.matches('[tabindex="0"]')),
    editor: of('.editor'),
    dialog: document.querySelector('dialog[open]') !== null,
    armed: cell.status?.armed ?? false,
  };
}

/** Sends a command if this panel may; stop needs nothing. */
export function order(of: Order): void {
  if (of !== 'stop' && of !== 'hold' && (!cell.control.mine || !session.may(of))) return;
  if (!hasMeaning(of, cell.mode, cell.powered)) return;
  void cell.ask({ do: of });
}

export function onKey(event: KeyboardEvent): void {
  if (event.repeat || event.ctrlKey || event.altKey || event.metaKey) return;
  const of = meant(event.key.length === 1 ? event.key.toLowerCase() : event.key, spot(event.target));
  if (!of) return;
  // A field's own Esc stays where there is nothing to stop.
  if (event.key === 'Escape' && writes(event.target) && !canAbort(cell.mode)) return;
  event.preventDefault();
  order(of);
}
