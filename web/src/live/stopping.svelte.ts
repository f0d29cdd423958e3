import { runs } from '../panel/orders';
import type { Stopped } from '../wire';
import type { Answer } from './socket';

/** STOP goes over HTTP too if the socket has not answered by then, ms. */
const SECOND_WAY_MS = 250;
/** STOP without an answer for so long counts as not having reached the cell, ms. */
export const REACH_MS = 1000;
/** So long after STOP the cell must be seen to stand, whatever was answered, ms: a server answers for a cycle that hangs, too. */
export const STAND_MS = 2000;
/** A request asks again after this time, until the cell is seen to stand, ms. */
const AGAIN_MS = 300;
/** An answer for a cycle that has not been heard of for longer says nothing of the cell, s. */
const FRESH_S = 0.5;

/** The ways to the cell. */
export type Ways = {
  /** Sends STOP over the connection; null without one. */
  socket: () => Promise<Answer> | null;
  /** Sends STOP as a request of its own, which needs neither connection nor session. */
  request: () => Promise<Stopped>;
};

/**
 * How STOP fared. `reached`: the cell was seen to stand after it. `failed`: it was not, in time. `late`: it reached the cell after it had
 * been reported as failed.
 */
export type Fate = 'none' | 'sent' | 'reached' | 'failed' | 'late';

/** All presses from one after which the cell was not seen to stand yet: the deadlines of the first one hold. */
type Round = { heard: boolean; known: Promise<void>; end: () => void };

/** STOP, and whether the cell stands after it: a STOP that did not reach it is never reported by less than the whole screen. */
export class Stopping {
  fate = $state<Fate>('none');
  /** State of the cell when it was last heard of after STOP; empty if it did not say. */
  mode = $state('');
  private round: Round | null = null;

  constructor(private readonly ways: Ways) {}

  /** Sends STOP over every way until the cell stands; the promise ends when its fate is known. */
  stop(): Promise<void> {
    this.round ??= this.begin();
    void this.send(this.round);
    return this.round.known;
  }

  /** Takes a status of the cell that has just come: one that stands confirms the STOP. */
  seen(mode: string): void {
    if (!this.round || runs(mode) || (this.fate === 'sent' && !this.round.heard)) return;
    this.confirm(this.round, mode);
  }

  /** The operator has read that STOP did not reach the cell. */
  acknowledge(): void {
    this.over('none');
  }

  private begin(): Round {
    let end: () => void = () => undefined;
    const known = new Promise<void>((done) => (end = done));
    const round: Round = { heard: false, known, end };
    this.fate = 'sent';
    setTimeout(() => !round.heard && this.fail(round), REACH_MS);
    setTimeout(() => this.fail(round), STAND_MS);
    return round;
  }

  private async send(round: Round): Promise<void> {
    const answer = this.ways.socket();
    if (answer) {
      const bySocket = answer.then(({ ok }) => ok, () => false);
      void bySocket.then((ok) => ok && this.hear(round));
      // Statuses over the same connection show then whether it stands.
      if (await Promise.race([bySocket, after(SECOND_WAY_MS)])) return;
    }
    await this.request(round);
    while (this.waits(round)) {
      await after(AGAIN_MS);
      if (this.waits(round)) await this.request(round);
    }
  }

  private async request(round: Round): Promise<void> {
    try {
      const { mode, cycle_age_s } = await this.ways.request();
      if (cycle_age_s === null || cycle_age_s > FRESH_S) return;
      this.hear(round);
      if (this.round !== round) return;
      this.mode = mode;
      if (!runs(mode)) this.confirm(round, mode);
    } catch {
      // This way is closed.
    }
  }

  private waits(round: Round): boolean {
    return this.round === round && this.fate === 'sent';
  }

  /** The cell has answered. */
  private hear(round: Round): void {
    if (this.round === round && this.fate === 'failed' && !round.heard) this.fate = 'late';
    round.heard = true;
  }

  /** The cell was seen to stand. */
  private confirm(round: Round, mode: string): void {
    if (this.round !== round) return;
    this.mode = mode;
    this.over(this.fate === 'sent' ? 'reached' : 'none');
  }

  private fail(round: Round): void {
    if (!this.waits(round)) return;
    this.fate = 'failed';
    round.end();
  }

  private over(fate: Fate): void {
    this.fate = fate;
    this.round?.end();
    this.round = null;
  }
}

/** False after a time. */
const after = (ms: number): Promise<false> => new Promise((done) => setTimeout(() => done(false), ms));
