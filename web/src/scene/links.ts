import { Group, Matrix4, Quaternion, Vector3 } from 'three';
import type { MachineView } from '../wire';
import { release } from './passes';
import { matrix } from './shapes';

const NO_MOVE = new Matrix4();

/** The links of a machine as they stand, with what is on them. */
export class Links {
  readonly root = new Group();
  private machine: MachineView | null = null;
  private groups: Group[] = [];
  /** How they have moved since all axes were at zero. */
  private moved: readonly Matrix4[] = [];

  /** Another machine: what was on the one before is gone. */
  set(machine: MachineView | null): void {
    release(this.root);
    this.groups = [];
    this.machine = machine;
  }

  add(index: number, group: Group): Group {
    this.at(index).add(group);
    return group;
  }

  /** The link that the work is on. */
  work(): Group {
    const frame = this.machine?.frames.find((f) => f.name === 'work');
    return this.at(frame?.link ?? this.machine?.base ?? 0);
  }

  /** How the base has moved against the work since all axes were at zero. */
  base(): Matrix4 {
    return this.groups[this.machine?.base ?? 0]?.matrix ?? this.moved[this.machine?.base ?? 0] ?? NO_MOVE;
  }

  /** Stands them so; how they stood before. */
  put(moved: readonly Matrix4[]): readonly Matrix4[] {
    const before = this.moved;
    this.moved = moved;
    this.groups.forEach((group, i) => group.matrix.copy(moved[i] ?? NO_MOVE));
    this.stand();
    return before;
  }

  /** Turns the root so that z is up and the base rests, whatever the links are counted from. */
  stand(): void {
    const machine = this.machine;
    const up = new Vector3(...(machine?.up ?? [0, 0, 1]));
    const base = machine?.frames.find((f) => f.name === 'base');
    if (base) up.transformDirection(matrix(base.frame));
    const turn = new Quaternion().setFromUnitVectors(up.normalize(), new Vector3(0, 0, 1));
    const rests = machine ? (this.groups[machine.base]?.matrix ?? NO_MOVE) : NO_MOVE;
    this.root.matrixAutoUpdate = false;
    this.root.matrix.makeRotationFromQuaternion(turn).multiply(rests.clone().invert());
    this.root.updateMatrixWorld(true);
  }

  /** The group of a link, made when it is first asked for. */
  private at(index: number): Group {
    let group = this.groups[index];
    if (!group) {
      group = new Group();
      group.matrixAutoUpdate = false;
      group.matrix.copy(this.moved[index] ?? NO_MOVE);
      this.groups[index] = group;
      this.root.add(group);
    }
    return group;
  }
}
