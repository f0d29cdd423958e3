import type { Status } from '../wire';

const SECONDS = 60;
const RATE = 30;
/** Speeds are taken over this many statuses: one alone would be noise of the encoder. */
const OVER = 3;

/**
 * The last minute of the status, a ring of columns that charts read without anything being made anew. A column is a
 * number per status; what is not there is NaN.
 */
export class Strip {
  readonly room = SECONDS * RATE;
  /** Rows in all since the cell's time began; the newest is at `(count - 1) % room`. */
  count = 0;
  readonly t = new Float64Array(this.room);
  /** Units of the axes, `mm` or `deg`. */
  units: string[] = [];
  private readonly columns = new Map<string, Float64Array>();

  add(status: Status): void {
    // Another machine's cell counts its time anew: what was before has no place beside it.
    if (this.count > 0 && status.t < (this.t[(this.count - 1) % this.room] ?? 0)) this.count = 0;
    const at = this.count % this.room;
    this.t[at] = status.t;
    this.put('speed', at, status.speed_mm_s);
    const worst: Record<string, [number, number]> = { mm: [NaN, NaN], deg: [NaN, NaN] };
    status.axes.forEach((axis, i) => {
      this.put(`position ${i}`, at, axis.position);
      this.put(`error ${i}`, at, axis.error);
      this.put(`speed ${i}`, at, this.change(`position ${i}`, at));
      const of = worst[this.units[i] ?? 'mm'];
      if (of && !(Math.abs(axis.error) <= of[0])) of.splice(0, 2, Math.abs(axis.error), i);
    });
    for (const [unit, [error, axis]] of Object.entries(worst)) {
      this.put(`error ${unit}`, at, error);
      this.put(`whose ${unit}`, at, axis);
    }
    status.tip.slice(0, 3).forEach((value, i) => this.put(`tip ${i}`, at, value));
    this.put('tip speed', at, Math.hypot(...[0, 1, 2].map((i) => this.change(`tip ${i}`, at))));
    const tracking = status.tracking[0];
    this.put('deviation', at, tracking?.deviation_mm[0] ?? NaN);
    this.put('correction', at, tracking?.correction_mm[0] ?? NaN);
    this.put('height deviation', at, tracking?.deviation_mm[1] ?? NaN);
    this.put('height correction', at, tracking?.correction_mm[1] ?? NaN);
    status.process.measured.forEach((value, i) => this.put(`value ${i}`, at, value ?? NaN));
    status.process.set.forEach((value, i) => this.put(`set ${i}`, at, value ?? NaN));
    this.count += 1;
  }

  /** The newest number of a column; NaN if there is none. */
  newest(name: string): number {
    return this.count === 0 ? NaN : (this.columns.get(name)?.[(this.count - 1) % this.room] ?? NaN);
  }

  /** Times before the newest one (s, negative) and the columns of the last `seconds`, the oldest first. */
  last(seconds: number, names: string[]): [number[], ...(number | null)[][]] {
    const have = Math.min(this.count, this.room);
    const rows: number[] = [];
    const newest = this.t[(this.count - 1) % this.room] ?? 0;
    for (let i = this.count - have; i < this.count; i += 1) {
      if (newest - (this.t[i % this.room] ?? 0) <= seconds) rows.push(i % this.room);
    }
    const times = rows.map((at) => (this.t[at] ?? 0) - newest);
    const columns = names.map((name) => {
      const column = this.columns.get(name);
      return rows.map((at) => {
        const value = column?.[at];
        return value === undefined || Number.isNaN(value) ? null : value;
      });
    });
    return [times, ...columns];
  }

  /** How fast a column changes at the newest row, whose number is there already, per s. */
  private change(name: string, at: number): number {
    if (this.count < OVER) return NaN;
    const from = (this.count - OVER) % this.room;
    const column = this.columns.get(name);
    const time = (this.t[at] ?? NaN) - (this.t[from] ?? NaN);
    return time > 0 ? ((column?.[at] ?? NaN) - (column?.[from] ?? NaN)) / time : NaN;
  }

  private put(name: string, at: number, value: number): void {
    let column = this.columns.get(name);
    if (!column) {
      column = new Float64Array(this.room).fill(NaN);
      this.columns.set(name, column);
    }
    column[at] = value;
  }
}
