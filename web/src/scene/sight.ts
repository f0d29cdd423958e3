import { BufferGeometry, DoubleSide, Float32BufferAttribute, Group, LineBasicMaterial, LineLoop, Mesh, MeshBasicMaterial } from 'three';
import type { SensorView } from '../wire';

const COLOURS: Record<string, number> = { camera: 0x2f6f9f, stripe: 0x9a4b63 };

/** What a sensor sees: a camera's rectangle on the work, a stripe sensor's in the plane of its laser. */
export function sight(sensor: SensorView): Group {
  const group = new Group();
  group.name = sensor.name;
  const [a, b, c, d] = sensor.field;
  if (!a || !b || !c || !d) return group;
  const color = COLOURS[sensor.kind] ?? 0x2f6f9f;
  const face = new BufferGeometry();
  face.setAttribute('position', new Float32BufferAttribute([a, b, c, a, c, d].flat(), 3));
  const edge = new BufferGeometry();
  edge.setAttribute('position', new Float32BufferAttribute([a, b, c, d].flat(), 3));
  const plane = new Mesh(face, new MeshBasicMaterial({ color, side: DoubleSide, transparent: true, opacity: 0.18, depthWrite: false }));
  const line = new LineLoop(edge, new LineBasicMaterial({ color, transparent: true, depthTest: false }));
  line.renderOrder = 2;
  group.add(plane, line);
  return group;
}
