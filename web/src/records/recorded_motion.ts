import type { MachineView, TraceView } from '../wire';

/** Where the axes were, row by row of a trace: pass, path length, positions in mm or degrees, and if it burned. */
export type Moves = { pass: (number | null)[]; s: (number | null)[]; burns: (number | null)[]; axes: (number | null)[][] };

/** Columns of a trace that tell where the axes were; null if they are not recorded. */
export function columnsOf(machine: MachineView, recorded: string[]): string[] | null {
  const axes = machine.axes.map((axis) => `${axis.name}_measured_${axis.unit}`);
  const all = ['pass', 's_mm', 'burning', ...axes];
  return all.every((name) => recorded.includes(name)) ? all : null;
}

export function moves(view: TraceView): Moves {
  const [pass = [], s = [], burns = [], ...axes] = view.values;
  return { pass, s, burns, axes };
}

/** Where the axes were at a place of a pass: of the rows in which the torch came further than before, the nearest. */
export function axesAt(of: Moves, pass: number, s: number): { axes: number[]; burns: boolean } | null {
  let [nearest, least, last] = [-1, Infinity, -Infinity];
  of.s.forEach((at, i) => {
    if (of.pass[i] !== pass || at === null || at <= last) return;
    last = at;
    if (Math.abs(at - s) < least) [nearest, least] = [i, Math.abs(at - s)];
  });
  if (nearest < 0) return null;
  const axes = of.axes.map((column) => column[nearest] ?? null);
  return axes.every((value) => value !== null) ? { axes, burns: (of.burns[nearest] ?? 0) > 0 } : null;
}
