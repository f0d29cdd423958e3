import { CylinderGeometry, Group, Mesh, MeshLambertMaterial, Quaternion, SphereGeometry, Vector3, type Plane } from 'three';
import type { MachineView } from '../wire';

/** Radius of what stands for a link, and of what stands for a joint, mm: thinner than any arm, so that nothing of its shapes is hidden. */
const ROD_MM = 14;
const JOINT_MM = 26;
const JOINT_LONG_MM = 90;
const COLOUR = 0x9aa3ab;

/** A rod or joint on a link. */
export type Bone = { link: number; group: Group };

/** Places of the joints of the first torch's chain from the base on, with their links, and the tool at its end. */
export function jointsOf(machine: MachineView): { link: number; at: Vector3; along: Vector3; turns: boolean }[] {
  const chain: { link: number; at: Vector3; along: Vector3; turns: boolean }[] = [];
  for (let link = machine.torch; link !== machine.base; ) {
    const joint = machine.joints[link];
    if (!joint) break;
    chain.unshift({ link, at: new Vector3(...joint.at), along: new Vector3(...joint.direction), turns: machine.axes[joint.axis]?.unit === 'deg' });
    link = joint.on;
  }
  return chain;
}

/**
 * The skeleton of an arm: rods from joint to joint and a short cylinder along each axis, where the machine file has few shapes or none.
 * It is drawn only; what the cell keeps clear of are the shapes.
 */
export function bones(machine: MachineView, cuts: Plane[]): Bone[] {
  if (!machine.arm) return [];
  const joints = jointsOf(machine).filter((joint) => joint.turns);
  const material = (): MeshLambertMaterial => new MeshLambertMaterial({ color: COLOUR, clippingPlanes: cuts });
  const made: Bone[] = [];
  const add = (link: number, mesh: Mesh): void => {
    const group = new Group();
    mesh.userData['pick'] = false;
    mesh.raycast = () => undefined;
    group.add(mesh);
    made.push({ link, group });
  };
  const rod = (link: number, from: Vector3, to: Vector3): void => {
    const along = to.clone().sub(from);
    if (along.length() < 1) return;
    const mesh = new Mesh(new CylinderGeometry(ROD_MM, ROD_MM, along.length(), 20), material());
    mesh.position.copy(from).addScaledVector(along, 0.5);
    mesh.quaternion.copy(new Quaternion().setFromUnitVectors(new Vector3(0, 1, 0), along.clone().normalize()));
    add(link, mesh);
    const end = new Mesh(new SphereGeometry(ROD_MM, 20, 12), material());
    end.position.copy(to);
    add(link, end);
  };
  joints.forEach((joint, i) => {
    const mesh = new Mesh(new CylinderGeometry(JOINT_MM, JOINT_MM, JOINT_LONG_MM, 28), material());
    mesh.position.copy(joint.at);
    mesh.quaternion.copy(new Quaternion().setFromUnitVectors(new Vector3(0, 1, 0), joint.along));
    add(joint.link, mesh);
    const next = joints[i + 1];
    if (next) rod(joint.link, joint.at, next.at);
  });
  const last = joints.at(-1);
  const torch = machine.frames.find((of) => of.link === machine.torch && of.name !== machine.axes.at(-1)?.name && !machine.axes.some((axis) => axis.name === of.name));
  if (last && torch) {
    // Towards the tool, as far as its own shapes do not show the way.
    const at = new Vector3(torch.frame[3], torch.frame[7], torch.frame[11]);
    rod(last.link, last.at, last.at.clone().lerp(at, 0.6));
  }
  return made;
}
