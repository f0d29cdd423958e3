import {
  DoubleSide,
  EdgesGeometry,
  Group,
  LineBasicMaterial,
  LineSegments,
  Mesh,
  MeshLambertMaterial,
  type Plane,
} from 'three';
import type { SolidView } from '../wire';
import type { Caps } from './caps';
import { geometry, matrix } from './shapes';

/** What a solid is; it says how it is drawn. */
export type Kind = 'machine' | 'part' | 'fixture' | 'permitted' | 'forbidden';

const LOOKS: Record<Kind, { colour: number; opacity: number }> = {
  machine: { colour: 0x8d969e, opacity: 1 },
  part: { colour: 0xb7bfc7, opacity: 1 },
  fixture: { colour: 0x98907f, opacity: 1 },
  permitted: { colour: 0x4d7a5c, opacity: 0.1 },
  forbidden: { colour: 0xa05050, opacity: 0.16 },
};
const SHARP_DEG = 30;
/** Zones are seen on light as on dark: permitted, forbidden. */
const ZONES = { light: { permitted: 0x14532d, forbidden: 0x8a1f1f }, dark: { permitted: 0x8fd0a8, forbidden: 0xe09090 } };

/** A solid with its edges, in the frame of its link; what is cut open is closed by `caps`, if it is not to be looked through. */
export function solid(view: SolidView, kind: Kind, cuts: Plane[], caps: Caps, ghost: boolean): Group {
  const look = LOOKS[kind];
  const opacity = ghost && kind === 'machine' ? 0.22 : look.opacity;
  const zone = kind === 'permitted' || kind === 'forbidden';
  const made = geometry(view.shape);
  const surface = new Mesh(
    made,
    new MeshLambertMaterial({
      color: look.colour,
      transparent: opacity < 1,
      opacity,
      depthWrite: opacity === 1,
      side: DoubleSide,
      // A little behind: lines on the surface are to be seen whole.
      polygonOffset: true,
      polygonOffsetFactor: 2,
      polygonOffsetUnits: 8,
      clippingPlanes: zone ? [] : cuts,
    }),
  );
  const edges = new LineSegments(
    new EdgesGeometry(made, SHARP_DEG),
    new LineBasicMaterial({
      color: zone ? look.colour : 0x3d444b,
      transparent: true,
      opacity: zone ? 0.7 : ghost && kind === 'machine' ? 0.35 : 0.55,
      clippingPlanes: zone ? [] : cuts,
    }),
  );
  const group = new Group();
  group.add(surface, edges);
  if (opacity === 1 && view.shape.kind !== 'half_space') caps.add(group, surface, look.colour);
  group.name = view.name;
  group.userData['kind'] = kind;
  group.matrixAutoUpdate = false;
  group.matrix.copy(matrix(view.frame));
  // What is cut off, endless or to be looked through is nothing to be picked.
  surface.userData['pick'] = !zone && view.shape.kind !== 'half_space';
  return group;
}

/** Gives zones the colours that are seen on this ground. */
export function tint(zones: Group[], light: boolean): void {
  const colours = ZONES[light ? 'light' : 'dark'];
  for (const zone of zones) {
    const colour = zone.userData['kind'] === 'permitted' ? colours.permitted : colours.forbidden;
    for (const child of zone.children) {
      if (child instanceof Mesh || child instanceof LineSegments) (child.material as LineBasicMaterial).color.set(colour);
    }
  }
}
