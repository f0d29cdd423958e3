import type { MachineView, StandingView } from '../wire';

/** A place that was recorded by hand. */
export type TaughtPoint = StandingView;

/** Where they are kept until the tab is closed, over a reload too. */
const KEPT = 'seamwright.taught';

type Kept = { machine: string; points: TaughtPoint[] };

/** Which machine positions of axes belong to: its name and axes. */
export const machineOf = (machine: MachineView): string => [machine.name, ...machine.axes.map((axis) => axis.name)].join(' ');

function kept(): Kept {
  try {
    const of: unknown = JSON.parse(sessionStorage.getItem(KEPT) ?? 'null');
    if (of && typeof of === 'object' && 'machine' in of && 'points' in of && Array.isArray(of.points)) return of as Kept;
  } catch {
    // What cannot be read is as good as nothing.
  }
  return { machine: '', points: [] };
}

/** Places recorded in this panel, of one machine; they are kept when the tab is left, and when the page is loaded again. */
class Taught {
  private all = $state.raw<Kept>(kept());
  /** What was cleared last. */
  private before = $state.raw<Kept | null>(null);

  get points(): TaughtPoint[] {
    return this.all.points;
  }

  /** How many were cleared and can come back. */
  get cleared(): number {
    return this.points.length === 0 ? (this.before?.points.length ?? 0) : 0;
  }

  /** They were recorded on another machine: their positions are none of this one. */
  foreign(machine: MachineView): boolean {
    return this.points.length > 0 && this.all.machine !== machineOf(machine);
  }

  /** Name of the machine that they were recorded on. */
  get machine(): string {
    return this.all.machine.split(' ')[0] ?? '';
  }

  record(machine: MachineView, place: StandingView): void {
    if (this.foreign(machine)) return;
    this.take({ machine: machineOf(machine), points: [...this.points, place] });
  }

  remove(index: number): void {
    this.take({ ...this.all, points: this.points.filter((_, i) => i !== index) });
  }

  clear(): void {
    this.before = this.all;
    this.take({ machine: '', points: [] });
  }

  back(): void {
    if (this.cleared > 0 && this.before) this.take(this.before);
  }

  private take(all: Kept): void {
    this.all = all;
    try {
      sessionStorage.setItem(KEPT, JSON.stringify(all));
    } catch {
      // Without room they live as long as the page.
    }
  }
}

export const taught = new Taught();

/** A program through the points, the machine's axes as columns, so that each is reached as it was taught. */
export function programText(title: string, machine: MachineView, points: TaughtPoint[], speed: number): string {
  const columns = machine.axes.map((axis) => `"${axis.name}"`);
  const row = (point: TaughtPoint, pace: number): string =>
    `[${[...point.axes.map((value) => value.toFixed(4)), pace].join(', ')}]`;
  const [start, ...others] = points;
  if (!start) return '';
  return [
    'schema = 1',
    `title = ${JSON.stringify(title)}`,
    `machine = "${machine.name}"`,
    '',
    '[[passes]]',
    'name = "taught"',
    '',
    '[passes.points]',
    `columns = [${columns.join(', ')}, "speed_mm_s"]`,
    `start = ${row(start, 0)}`,
    '',
    '[[passes.points.spans]]',
    'along = "spline"',
    'points = [',
    ...others.map((point) => `    ${row(point, speed)},`),
    ']',
    '',
  ].join('\n');
}
