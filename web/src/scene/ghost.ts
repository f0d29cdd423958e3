import { Group, Matrix4, Mesh, MeshLambertMaterial } from 'three';
import type { MachineView } from '../wire';
import type { Pose } from './kinematics';
import type { Links } from './links';
import { release } from './passes';
import { geometry, matrix } from './shapes';

const COLOUR = 0x1e88e5;
const OPACITY = 0.28;

/** A second picture of the machine, as it would stand somewhere else: in one colour, to be looked through, nothing to be picked. */
export class Ghost {
  private readonly group = new Group();
  private base = new Matrix4();

  constructor() {
    this.group.matrixAutoUpdate = false;
  }

  clear(): void {
    release(this.group);
    this.group.removeFromParent();
  }

  set(machine: MachineView | null, pose: Pose | null, links: Links): void {
    this.clear();
    if (!machine || !pose) return;
    const material = new MeshLambertMaterial({ color: COLOUR, transparent: true, opacity: OPACITY, depthWrite: false });
    for (const view of machine.solids) {
      const mesh = new Mesh(geometry(view.shape), material);
      mesh.matrixAutoUpdate = false;
      mesh.matrix.copy(pose.links[view.link] ?? new Matrix4()).multiply(matrix(view.frame));
      mesh.raycast = () => undefined;
      this.group.add(mesh);
    }
    this.base = pose.links[machine.base] ?? new Matrix4();
    links.root.add(this.group);
    this.stand(links);
  }

  /** The base of the machine is where it is, however the work lies on it. */
  stand(links: Links): void {
    this.group.matrix.copy(links.base()).multiply(this.base.clone().invert());
    this.group.matrixWorldNeedsUpdate = true;
  }
}
