import { Matrix4, Quaternion, Vector3 } from 'three';
import type { MachineView } from '../wire';
import { matrix } from './shapes';

/** Where the machine is: how its links have moved since all axes were at zero, and its tip with the unit vector out of the work. */
export type Pose = { links: Matrix4[]; tip: [number, number, number]; along: [number, number, number] };

/** The pose at positions of the axes, mm or degrees. */
export function poseAt(machine: MachineView, axes: number[]): Pose {
  const links: Matrix4[] = [];
  for (const joint of machine.joints) {
    const moved = new Matrix4();
    if (joint) {
      const by = axes[joint.axis] ?? 0;
      const along = new Vector3(...joint.direction);
      if (machine.axes[joint.axis]?.unit === 'deg') {
        const turn = new Quaternion().setFromAxisAngle(along, (by * Math.PI) / 180);
        const at = new Vector3(...joint.at);
        moved.compose(at.clone().sub(at.clone().applyQuaternion(turn)), turn, new Vector3(1, 1, 1));
      } else {
        moved.makeTranslation(along.multiplyScalar(by));
      }
      moved.premultiply(links[joint.on] ?? new Matrix4());
    }
    links.push(moved);
  }
  const tool = matrix(machine.tool).premultiply(links[machine.torch] ?? new Matrix4());
  const tip = new Vector3().setFromMatrixPosition(tool);
  const along = new Vector3(0, 0, -1).transformDirection(tool);
  return { links, tip: [tip.x, tip.y, tip.z], along: [along.x, along.y, along.z] };
}
