import type { MachineView, Status } from '../wire';

/** A place that was recorded by hand. */
export type TaughtPoint = { axes: number[]; tip: Status['tip'] };

/** Places recorded in this panel; they are kept when the tab is left. */
class Taught {
  points = $state.raw<TaughtPoint[]>([]);

  record(status: Status): void {
    this.points = [...this.points, { axes: status.axes.map((axis) => axis.position), tip: status.tip }];
  }

  remove(index: number): void {
    this.points = this.points.filter((_, i) => i !== index);
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
