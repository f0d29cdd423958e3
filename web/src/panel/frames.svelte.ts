import type { JogOf, MachineView, Status } from '../wire';
import { inverse, product, type Convention, conventions } from './rotation';

const KEPT = 'seamwright.rotation';

const isConvention = (of: string | null): of is Convention => conventions.some((one) => one === of);

/** How frames are shown on this computer, and in which the tip is jogged. Nothing of it changes what the cell does. */
class Frames {
  /** Frame of the directions of the tip: `work`, `base`, `tool` or a user frame. */
  frame = $state('work');
  /** What jog keys move: axes, the tip, or the torch about it. It stays when another page is looked at. */
  by = $state<JogOf>('joints');
  private written = $state<Convention>(first());

  get convention(): Convention {
    return this.written;
  }

  set convention(of: Convention) {
    this.written = of;
    localStorage.setItem(KEPT, of);
  }
}

function first(): Convention {
  const kept = localStorage.getItem(KEPT);
  return isConvention(kept) ? kept : 'xyz';
}

export const frames = new Frames();

/** Names of frames that a target or a read-out can be given in, those of the user last. */
export const framesOf = (machine: MachineView | null): string[] => ['work', 'base', 'tool', ...(machine?.user_frames.map((of) => of.name) ?? [])];

/** A frame in the work frame, as the machine stands; null if it is not known. */
export function inWork(machine: MachineView, status: Pick<Status, 'links' | 'tool'>, name: string): number[] | null {
  if (name === 'work') return [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0];
  if (name === 'tool') return status.tool;
  const base = machine.frames.find((of) => of.name === 'base');
  const moved = status.links[machine.base];
  if (!base || !moved) return null;
  const there = product(moved, base.frame);
  if (name === 'base') return there;
  const own = machine.user_frames.find((of) => of.name === name);
  return own ? product(there, own.frame) : null;
}

/** The tool frame as it stands in another frame; in the work frame if that is not known, or is itself. */
export function toolIn(machine: MachineView, status: Pick<Status, 'links' | 'tool'>, name: string): number[] {
  const frame = name === 'tool' ? null : inWork(machine, status, name);
  return frame ? product(inverse(frame), status.tool) : status.tool;
}
