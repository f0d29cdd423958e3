import type { JogOf } from '../wire';

/** The hand's sign of life: the cell stops the axes when it has not come for 200 ms. */
export const REPEAT_MS = 50;

/**
 * Hold-to-run: sends speeds every 50 ms from `press` to `release`, and zeros at once on release. Whoever lets go first ends
 * it; it begins only by a new press. Anything that is pressed while another thing runs is not taken.
 */
export class HoldToRun {
  private timer: ReturnType<typeof setInterval> | undefined;
  private of: JogOf = 'joints';
  private count = 0;

  constructor(private readonly send: (of: JogOf, speeds: number[]) => void) {}

  get running(): boolean {
    return this.timer !== undefined;
  }

  /** `repeat`: what is sent instead of the speeds while it is held. */
  press(of: JogOf, speeds: number[], repeat = (): void => this.send(of, speeds)): boolean {
    if (this.running) return false;
    this.of = of;
    this.count = speeds.length;
    this.timer = setInterval(repeat, REPEAT_MS);
    repeat();
    return true;
  }

  release(): void {
    if (!this.running) return;
    clearInterval(this.timer);
    this.timer = undefined;
    this.send(this.of, new Array<number>(this.count).fill(0));
  }
}
