import { cell } from '../live/cell.svelte';
import type { AskView, LackView } from '../wire';
import type { Overlap } from './unfinished';

/** The cell refuses a start that would weld again what is finished, until somebody has been asked. */
const FINISHED = ['finished_pass', 'finished_part'];

/** Starting a weld: what is finished is never welded again before somebody has been asked. */
class Starting {
  /** What is finished and would be welded again; none: nothing is asked. */
  asked = $state.raw<LackView | null>(null);
  /** The overlap that was chosen for the newest interruption. */
  overlap = $state.raw<Overlap | null>(null);

  async start(): Promise<void> {
    const { why } = await cell.ask({ do: 'start_weld' });
    if (!why || !FINISHED.includes(why.key)) return;
    // The question says it.
    cell.refused = null;
    this.asked = why;
  }

  /** Somebody wants it to be welded again. */
  async again(): Promise<void> {
    this.asked = null;
    await cell.ask({ do: 'start_weld', reweld: true } as AskView);
  }
}

export const starting = new Starting();
