import {
  ArrowHelper,
  BufferGeometry,
  CylinderGeometry,
  DoubleSide,
  Float32BufferAttribute,
  Group,
  Line,
  LineBasicMaterial,
  Mesh,
  MeshBasicMaterial,
  Quaternion,
  Raycaster,
  RingGeometry,
  SphereGeometry,
  Vector3,
  type Matrix4,
} from 'three';
import type { Off } from './spot';

const TORCH_MM = 70;
const UP = new Vector3(0, 0, 1);
const COLD = 0x333333;
const HOT = 0xffa800;
const OFF = 0xc2185b;
/** The beam is looked for this far behind where it should meet the work, mm. */
const BEHIND_MM = 60;

/** Torch or beam: the tip with its direction, or the beam from the gun to where it meets the part, and the way from there to the path. */
export class Torch {
  readonly group = new Group();
  private readonly arrow = new ArrowHelper(UP, new Vector3(), TORCH_MM, 0x222222, 14, 7);
  private readonly ball = new Mesh(new SphereGeometry(4, 24, 12), new MeshBasicMaterial({ color: COLD }));
  private readonly beam = new Mesh(
    new CylinderGeometry(1, 1, 1, 12, 1, true).translate(0, 0.5, 0).rotateX(Math.PI / 2),
    new MeshBasicMaterial({ color: COLD, transparent: true, opacity: 0.6 }),
  );
  private readonly ring = new Mesh(new RingGeometry(7, 10, 48), new MeshBasicMaterial({ color: COLD, side: DoubleSide, depthTest: false }));
  private readonly way = new Line(new BufferGeometry(), new LineBasicMaterial({ color: OFF, depthTest: false }));
  private readonly ray = new Raycaster();
  private beamMm: number | null = null;
  private burns = false;

  constructor() {
    this.way.geometry.setAttribute('position', new Float32BufferAttribute(6, 3));
    this.way.frustumCulled = false;
    this.way.renderOrder = 6;
    this.ring.renderOrder = 5;
    this.group.add(this.arrow, this.ball, this.beam, this.ring, this.way);
    this.setBeam(null);
  }

  /** From the work to where the beam comes from, mm; null: a torch. */
  setBeam(mm: number | null): void {
    this.beamMm = mm;
    this.arrow.visible = mm === null;
    this.beam.visible = this.ring.visible = mm !== null;
    this.way.visible = false;
  }

  /** Puts it where it is in the work frame; `toWorld`: of that frame; `parts`: what a beam may meet. */
  set(tip: Vector3, along: Vector3, burns: boolean, off: Off | null, toWorld: Matrix4, parts: Group[]): void {
    this.burns = burns;
    const spot = tip.clone();
    if (this.beamMm !== null) {
      const from = tip.clone().addScaledVector(along, this.beamMm);
      this.meets(from, along, spot, toWorld, parts);
      this.beam.position.copy(from);
      this.beam.quaternion.copy(new Quaternion().setFromUnitVectors(UP, along.clone().negate()));
      this.beam.scale.z = from.distanceTo(spot);
      this.ring.position.copy(spot);
      this.ring.quaternion.copy(new Quaternion().setFromUnitVectors(UP, along));
      const look = this.beam.material;
      look.opacity = burns ? 0.9 : 0.6;
      look.color.set(burns ? HOT : COLD);
      this.ring.material.color.set(burns ? HOT : COLD);
    }
    this.ball.position.copy(spot);
    this.ball.material.color.set(burns ? HOT : COLD);
    this.arrow.position.copy(tip);
    this.arrow.setDirection(along);
    this.way.visible = off !== null;
    if (off) {
      const places = this.way.geometry.getAttribute('position');
      places.setXYZ(0, ...off.spot).setXYZ(1, ...off.path);
      places.needsUpdate = true;
    }
  }

  /** Where the tip or the spot is in the world. */
  place(): Vector3 {
    return this.ball.getWorldPosition(new Vector3());
  }

  /** As large on the screen from everywhere. */
  size(scale: number): void {
    const beam = this.beamMm !== null;
    this.ball.scale.setScalar(scale * (beam ? 0.5 : this.burns ? 1.8 : 1));
    this.arrow.scale.setScalar(scale);
    this.ring.scale.setScalar(scale * (this.burns ? 1.4 : 1));
    this.beam.scale.x = this.beam.scale.y = scale * (this.burns ? 3 : 1.8);
  }

  /** Where the beam meets the part first; `spot` stays as it is if it meets none. */
  private meets(from: Vector3, along: Vector3, spot: Vector3, toWorld: Matrix4, parts: Group[]): void {
    this.ray.set(from.clone().applyMatrix4(toWorld), along.clone().negate().transformDirection(toWorld));
    this.ray.far = (this.beamMm ?? 0) + BEHIND_MM;
    const surfaces = parts.flatMap((part) => part.children.filter((child) => child.userData['pick'] === true));
    const [hit] = this.ray.intersectObjects(surfaces, false);
    if (hit) spot.copy(from).addScaledVector(along, -hit.distance);
  }
}
