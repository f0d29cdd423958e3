import { untrack } from 'svelte';

/** An area of the page, as far as a layer needs it. */
export type Area = { contains(other: Node): boolean };

type Layer = {
  area: Area;
  /** The key that opens and closes it; a press there does not count as a press outside. */
  opener: Area | null;
  close: () => void;
};

/**
 * Everything that lies over the page and can be closed: menus and dialogs, in the order of opening. It is the only place that decides
 * what Esc closes, so Esc never reaches STOP while something is open.
 */
export class Layers {
  private open = $state.raw<Layer[]>([]);

  /** True if something is open, so that Esc closes it. */
  get any(): boolean {
    return this.open.length > 0;
  }

  /** Adds a layer on top; returns the function that takes it away. */
  add(area: Area, close: () => void, opener: Area | null = null): () => void {
    const layer = { area, close, opener };
    // Attachments run as effects: what they change must not be what they depend on.
    this.open = [...untrack(() => this.open), layer];
    return () => (this.open = untrack(() => this.open).filter((of) => of !== layer));
  }

  /** Closes the topmost layer only; false if nothing is open. */
  closeTop(): boolean {
    const top = this.open.at(-1);
    top?.close();
    return top !== undefined;
  }

  /** Closes menus when something outside them is pressed. Dialogs have no outside: they are modal. */
  pressed(target: Node): void {
    for (const { area, opener, close } of this.open) {
      if (opener && !area.contains(target) && !opener.contains(target)) close();
    }
  }

  /** Closes all menus: their page is left. */
  leave(): void {
    for (const { opener, close } of this.open) if (opener) close();
  }

  /** Attaches a menu for as long as it is shown. `opener` is its key, which gets the focus back from inside the menu. */
  menu(opener: () => HTMLElement | undefined, close: () => void): (element: HTMLElement) => () => void {
    return (element) => {
      const key = opener() ?? element;
      return this.add(
        element,
        () => {
          const inside = element.contains(document.activeElement);
          close();
          if (inside) key.focus();
        },
        key,
      );
    };
  }

  /** Attaches a dialog: it is a layer whenever it is open. */
  readonly dialog = (element: HTMLDialogElement): (() => void) => {
    let remove: (() => void) | null = null;
    const follow = (): void => {
      if (element.open === (remove !== null)) return;
      remove?.();
      remove = element.open ? this.add(element, () => element.close()) : null;
    };
    const observer = new MutationObserver(follow);
    observer.observe(element, { attributeFilter: ['open'] });
    follow();
    return () => {
      observer.disconnect();
      remove?.();
    };
  };
}

export const layers = new Layers();
