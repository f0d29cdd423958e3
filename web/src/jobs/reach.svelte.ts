import { api } from '../live/api';
import type { ReachAnswer, ReachCell, ReachText } from '../wire';
import { edited } from './edited.svelte';

const LOOK_MS = 500;

/** What is searched: see `ReachText`. */
export type Searched = { moved: 'work' | 'base'; ranges: [number, number][]; cells: number[]; budget_s: number };

/** A search for the best placement of the open job, and what it found. It stays when another view is looked at. */
class Reach {
  answer = $state.raw<ReachAnswer | null>(null);
  searches = $state(false);
  /** Placements of the grid that were judged, and all of them; 0 of 0 before that is known. */
  done = $state(0);
  total = $state(0);
  elapsed_s = $state(0);
  /** The text that was searched, and that of the best placement once it was put into the job. */
  private asked = $state('');
  private asking: AbortController | null = null;
  private opened = '';

  /** What was found belongs to the job as it is now. */
  readonly current = $derived(this.answer !== null && edited.text === this.asked);
  /** The best placement is in the job. */
  readonly applied = $derived(this.answer?.best != null && edited.text === this.answer.best.text);

  /** Another job: what was found of the one before means nothing. */
  follow(name: string): void {
    if (name === this.opened) return;
    this.opened = name;
    this.cancel();
    this.answer = null;
  }

  async search(of: Searched): Promise<void> {
    this.cancel();
    const asking = new AbortController();
    this.asking = asking;
    const text = edited.text;
    this.searches = true;
    [this.answer, this.asked, this.done, this.total, this.elapsed_s] = [null, text, 0, 0, 0];
    const clock = setInterval(() => void this.look(), LOOK_MS);
    try {
      const asked: ReachText = { text, moved: of.moved, ranges: of.ranges as ReachText['ranges'], cells: of.cells as ReachText['cells'], budget_s: of.budget_s };
      const answer = await api.reach(asked, asking.signal);
      if (this.asking === asking) this.answer = answer;
    } catch (error) {
      if (!asking.signal.aborted) throw error;
    } finally {
      clearInterval(clock);
      if (this.asking === asking) this.searches = false;
    }
  }

  /** The server ends the search when nobody waits for it. */
  cancel(): void {
    this.asking?.abort();
    this.asking = null;
    this.searches = false;
  }

  /** Puts the best placement into the job, as one change. */
  apply(): void {
    const text = this.answer?.best?.text;
    if (text !== undefined && this.current) edited.change(text, `reach ${Date.now()}`);
  }

  private async look(): Promise<void> {
    const all = await api.planning().catch(() => []);
    const own = all.find((of) => of.kind === 'reach');
    if (!own || !this.searches) return;
    this.elapsed_s = own.elapsed_s;
    if (own.total) [this.done, this.total] = [own.done ?? 0, own.total];
  }
}

export const reach = new Reach();

/** The cells of one layer of the grid by column and row: at z and turn of these numbers. */
export function layer(answer: ReachAnswer, z: number, turn: number): Map<string, ReachCell> {
  const found = new Map<string, ReachCell>();
  for (const place of answer.places) {
    const at = place.cell;
    if (at && at[2] === z && at[3] === turn) found.set(`${at[0]} ${at[1]}`, place);
  }
  return found;
}

/** Part of the greatest margin on the map that a cell has, 0 to 1: how strongly it is shaded. */
export function shade(margin: number, most: number): number {
  return most > 0 ? Math.max(0, Math.min(1, margin / most)) : 0;
}
