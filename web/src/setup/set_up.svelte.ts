import { cell } from '../live/cell.svelte';
import type { Convention } from '../panel/rotation';
import { machineOf } from '../panel/taught.svelte';

/** Touches of one point with the tool, positions of all axes each; kept when the page is left, not when the machine is another. */
class Touches {
  private all = $state.raw<{ machine: string; list: number[][] }>({ machine: '', list: [] });
  private readonly machine = $derived(cell.machine ? machineOf(cell.machine) : '');

  get list(): number[][] {
    return this.all.machine === this.machine ? this.all.list : [];
  }

  set list(list: number[][]) {
    this.all = { machine: this.machine, list };
  }

  /** What was cleared last. */
  private before = $state.raw<{ machine: string; list: number[][] } | null>(null);

  /** How many were cleared and can come back. */
  get cleared(): number {
    return this.list.length === 0 && this.before?.machine === this.machine ? this.before.list.length : 0;
  }

  clear(): void {
    this.before = this.all;
    this.list = [];
  }

  back(): void {
    if (this.cleared > 0 && this.before) this.all = this.before;
  }
}

export const touches = new Touches();

/** Numbers of axes that were typed and not kept, by axis and key; they stay when the page is left, not when the machine is another. */
class Typed {
  private all = $state.raw<{ machine: string; of: Record<string, Record<string, string>> }>({ machine: '', of: {} });
  private readonly machine = $derived(cell.machine ? machineOf(cell.machine) : '');

  of(axis: string): Record<string, string> {
    return (this.all.machine === this.machine ? this.all.of[axis] : undefined) ?? {};
  }

  set(axis: string, typed: Record<string, string>): void {
    const others = this.all.machine === this.machine ? this.all.of : {};
    this.all = { machine: this.machine, of: { ...others, [axis]: typed } };
  }
}

export const typed = new Typed();

/** A frame that is being changed: it stays while points are touched on the page of jogging. */
class FrameDraft {
  /** Its identifier; empty: none is changed. */
  id = $state('');
  name = $state('');
  /** Position, and orientation in this convention. */
  fields = $state.raw<string[]>([]);
  convention = $state<Convention>('xyz');
  /** Positions of all axes at the three points. */
  touches = $state.raw<(number[] | null)[]>([null, null, null]);
  taught = $state('');

  begin(id: string, fields: string[], convention: Convention): void {
    [this.id, this.name, this.taught] = [id, '', ''];
    [this.fields, this.convention, this.touches] = [fields, convention, [null, null, null]];
  }
}

export const draft = new FrameDraft();

/** The job of the cell anew, so that what was kept of its machine is in force. */
export async function loadAnew(): Promise<void> {
  await cell.reload(null);
  await cell.askMachine();
}
