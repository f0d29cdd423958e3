import {
  BoxGeometry,
  BufferAttribute,
  BufferGeometry,
  CapsuleGeometry,
  CylinderGeometry,
  Matrix4,
  PlaneGeometry,
  SphereGeometry,
} from 'three';
import { toCreasedNormals } from 'three/examples/jsm/utils/BufferGeometryUtils.js';
import type { ShapeView } from '../wire';

const ROUND = 64;
/** Faces of a mesh that meet at a smaller angle are shaded as one smooth surface. */
const CREASE_RAD = (35 * Math.PI) / 180;
/** How much of an endless half space is drawn, mm. */
const PLANE_MM = 1200;

/** A 3 x 4 frame, row by row. */
export function matrix(frame: readonly number[]): Matrix4 {
  const f = (i: number): number => frame[i] ?? 0;
  return new Matrix4().set(f(0), f(1), f(2), f(3), f(4), f(5), f(6), f(7), f(8), f(9), f(10), f(11), 0, 0, 0, 1);
}

/** A shape in its own frame, mm. Three's round shapes stand along y about their middle; ours along z on the origin. */
export function geometry(shape: ShapeView): BufferGeometry {
  switch (shape.kind) {
    case 'box':
      return new BoxGeometry(...shape.size);
    case 'sphere':
      return new SphereGeometry(shape.radius, ROUND, ROUND / 2);
    case 'cone':
      return upright(new CylinderGeometry(shape.top_radius, shape.radius, shape.length, ROUND), shape.length);
    case 'capsule': {
      const middle = Math.max(0, shape.length - 2 * shape.radius);
      return upright(new CapsuleGeometry(shape.radius, middle, ROUND / 4, ROUND), shape.length);
    }
    case 'ellipsoid':
      return new SphereGeometry(1, ROUND, ROUND / 2).scale(...shape.semi_axes);
    case 'half_space':
      return new PlaneGeometry(PLANE_MM, PLANE_MM);
    case 'mesh': {
      const made = new BufferGeometry();
      made.setAttribute('position', new BufferAttribute(new Float32Array(shape.triangles), 3));
      return toCreasedNormals(made, CREASE_RAD);
    }
  }
}

function upright(of: BufferGeometry, length: number): BufferGeometry {
  return of.rotateX(Math.PI / 2).translate(0, 0, length / 2);
}
