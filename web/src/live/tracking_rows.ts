import type { Status, TrackingStatus } from '../wire';

/** Places kept of a pass: what comes again at a place takes the place of what was there. */
const PLACES = 1000;

/** Columns that a chart draws over the path length, mm; null where nothing is known. */
export type TrackRows = { s: number[]; seen: (number | null)[]; guessed: (number | null)[]; corrected: (number | null)[] };

/** True where the joint itself was seen, not only what it did before. */
export function isSeen(state: string): boolean {
  return state === 'seen' || state === 'bridged';
}

/**
 * What tracking found and did in the newest pass that is tracked, by path length: after a hold, and while going back, what is
 * new takes the place of what is old. With each weld it begins anew. It holds what this panel has seen since it was opened.
 */
export class Track {
  /** From 1; 0: nothing has been tracked. */
  pass = 0;
  length = 0;
  /** Counts up when something was added. */
  count = 0;
  private mode = '';
  private readonly heads = new Map<number, (TrackingStatus | undefined)[]>();

  get numbers(): number[] {
    return [...this.heads.keys()].sort((a, b) => a - b);
  }

  clear(): void {
    this.pass = this.length = 0;
    this.heads.clear();
    this.count += 1;
  }

  /** Takes a status of a pass of this length (mm); true if it is tracked. */
  add(status: Status, length: number): boolean {
    // The next part of the same program: what the last one was like says nothing of it. What is held goes on.
    if (status.mode === 'weld' && this.mode === 'ready') this.clear();
    this.mode = status.mode;
    if (status.tracking.length === 0) return false;
    if (status.pass < 1 || !(length > 0)) return true;
    if (status.pass !== this.pass) {
      this.clear();
      this.pass = status.pass;
      this.length = length;
    }
    const at = Math.round((status.s_mm / length) * PLACES);
    if (at < 0 || at > PLACES) return true;
    for (const head of status.tracking) {
      let rows = this.heads.get(head.head);
      if (!rows) this.heads.set(head.head, (rows = new Array<TrackingStatus | undefined>(PLACES + 1)));
      rows[at] = head;
    }
    this.count += 1;
    return true;
  }

  /** Lateral (0) or height (1) deviations and corrections of a head. */
  rows(head: number, of: 0 | 1): TrackRows {
    const rows: TrackRows = { s: [], seen: [], guessed: [], corrected: [] };
    this.heads.get(head)?.forEach((status, i) => {
      if (!status) return;
      const seen = isSeen(status.state);
      const known = status.confidence > 0 || seen;
      rows.s.push((i / PLACES) * this.length);
      rows.seen.push(seen ? status.deviation_mm[of] : null);
      rows.guessed.push(!seen && known ? status.deviation_mm[of] : null);
      rows.corrected.push(status.correction_mm[of]);
    });
    return rows;
  }
}
