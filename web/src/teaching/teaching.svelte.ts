import { api } from '../live/api';
import { cell } from '../live/cell.svelte';
import { refusalText } from '../panel/refusal';
import type { TaughtProgram, TaughtView, TeachOrder } from '../wire';

const NOTHING: TaughtView = { points: [], looks: [] };

/** State of teaching by camera; it is kept when the tab is left. */
class Teaching {
  /** Taught points and frames. */
  taught = $state.raw<TaughtView>(NOTHING);
  /** What became of it, if a program was made. */
  made = $state.raw<TaughtProgram | null>(null);
  /** What was refused, in words. */
  trouble = $state('');
  private asked = '';

  /** Fetches what was taught when there is more of it. */
  async follow(): Promise<void> {
    const view = cell.teach;
    const name = `${view.phase === 'ended'} ${view.job} ${view.frames}`;
    if (name === this.asked) return;
    this.asked = name;
    if (view.frames === 0) {
      this.taught = NOTHING;
      this.made = null;
      return;
    }
    const taught = await api.taught().catch(() => this.taught);
    // Something newer may have come meanwhile.
    if (name === this.asked) this.taught = taught;
  }

  async order(order: TeachOrder): Promise<boolean> {
    const answer = await cell.teaches(order);
    this.trouble = answer.ok ? '' : (answer.why?.text ?? '');
    return answer.ok;
  }

  /** What is wrong before anything is sent. */
  refuse(why: string): void {
    this.trouble = why;
  }

  async make(tolerance_mm: number, method: string): Promise<void> {
    try {
      this.made = await api.taughtProgram({ tolerance_mm, attitude_deg: 0.5, method });
      this.trouble = '';
    } catch (error) {
      this.made = null;
      this.trouble = refusalText(error);
    }
  }
}

export const teaching = new Teaching();
