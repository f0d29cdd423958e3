import { canAbort } from '../parts/orders';
import type { Stopped } from '../wire';
import type { Answer } from './socket';

/** STOP goes over HTTP too if the socket has not answered by then, ms. */
const SECOND_WAY_MS = 250;
/** STOP without an answer for so long counts as not having reached the cell, ms. */
export const REACH_MS = 1000;

/** The ways to the cell. */
export type Ways = {
  /** Sends STOP over the connection; null without one. */
  socket: () => Promise<Answer> | null;
  /** Sends STOP as a request of its own, which needs neither connection nor session. */
  request: () => Promise<Stopped>;
};

/** How the last STOP fared. `late`: it reached the cell after it had been reported as failed. */
export type Fate = 'none' | 'sent' | 'reached' | 'failed' | 'late';

/** STOP, and whether it has reached the cell: a STOP that did not is never reported by less than the whole screen. */
export class Stopping {
  fate = $state<Fate>('none');
  /** State of the cell at its answer to a request; empty if it did not say. */
  mode = $state('');
  private number = 0;

  constructor(private readonly ways: Ways) {}

  /** Sends STOP over every way until one answers; the promise ends when its fate is known. */
  async stop(): Promise<void> {
    const number = ++this.number;
    // A failure stays on the screen until this attempt is known to have reached the cell.
    if (this.fate === 'none' || this.fate === 'reached') this.fate = 'sent';
    const answer = this.send();
    const inTime = await Promise.race([answer, after(REACH_MS)]);
    if (number !== this.number) return;
    if (inTime) {
      this.fate = this.fate === 'failed' ? 'late' : 'reached';
      return;
    }
    this.fate = 'failed';
    void answer.then((reached) => {
      if (reached && number === this.number && this.fate === 'failed') this.fate = 'late';
    });
  }

  /** Takes a status of the cell that has just come: one that stands confirms the STOP. */
  seen(mode: string): void {
    if ((this.fate === 'failed' || this.fate === 'late') && !canAbort(mode)) this.fate = 'none';
  }

  /** The operator has read that STOP did not reach the cell. */
  acknowledge(): void {
    this.number += 1;
    this.fate = 'none';
  }

  /** True as soon as one way has answered; false when all have failed. */
  private send(): Promise<boolean> {
    const first = this.ways.socket();
    if (!first) return this.request();
    const bySocket = first.then((answer) => answer.ok, () => false);
    return Promise.race([bySocket, after(SECOND_WAY_MS)]).then((answered) => {
      if (answered) return true;
      const byRequest = this.request();
      return either(bySocket, byRequest);
    });
  }

  private async request(): Promise<boolean> {
    try {
      this.mode = (await this.ways.request()).mode;
      return true;
    } catch {
      return false;
    }
  }
}

/** False after a time. */
const after = (ms: number): Promise<false> => new Promise((done) => setTimeout(() => done(false), ms));

/** True as soon as one of both is. */
const either = (a: Promise<boolean>, b: Promise<boolean>): Promise<boolean> =>
  Promise.race([a.then((of) => of || b), b.then((of) => of || a)]);
