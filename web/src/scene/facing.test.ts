import { BoxGeometry, Group, Matrix4, Mesh, MeshBasicMaterial, Vector3 } from 'three';
import { expect, test } from 'vitest';
import type { WorkView } from '../wire';
import { facing, standings, type Spot, type Standing } from './facing';

const USUAL = new Vector3(0.55, -0.75, 0.6).normalize();
const AS_IT_IS = (): Matrix4 => new Matrix4();

function body(size: [number, number, number], at: [number, number, number]): Group {
  const mesh = new Mesh(new BoxGeometry(...size), new MeshBasicMaterial());
  mesh.position.set(...at);
  mesh.userData['pick'] = true;
  const group = new Group();
  group.add(mesh);
  group.updateMatrixWorld(true);
  return group;
}

const part = body([100, 100, 100], [0, 0, 50]);
const on = (side: [number, number, number]): Spot => ({ tip: [50 * side[0], 50 * side[1], 50 + 50 * side[2]], torch: side });
const now = (...spots: Spot[]): Standing[] => [{ axes: null, spots }];

test('whatever side is welded is seen, with the picture turned no more than it needs', () => {
  // From above, from the front and from the right nothing is turned.
  for (const side of [[0, 0, 1], [0, -1, 0]] as [number, number, number][]) {
    expect(facing(USUAL, now(on(side)), AS_IT_IS, [part]).distanceTo(USUAL)).toBeLessThan(1e-9);
  }
  for (const side of [[1, 0, 0], [-1, 0, 0], [0, 1, 0]] as [number, number, number][]) {
    const from = facing(USUAL, now(on(side)), AS_IT_IS, [part]);
    expect(from.dot(new Vector3(...side)), `${side}`).toBeGreaterThan(0.45);
    expect(from.z).toBeCloseTo(USUAL.z);
  }
  // Nothing to be seen: as ever.
  expect(facing(USUAL, now(), AS_IT_IS, [part]).distanceTo(USUAL)).toBeLessThan(1e-9);
  expect(facing(USUAL, now(on([0, 0, -1])), AS_IT_IS, [part]).distanceTo(USUAL)).toBeLessThan(1e-9);
});

test('a body before the spot is looked past', () => {
  // A plate to the right and in front, higher than the part, as a table that is tilted.
  const plate = body([10, 600, 600], [150, -100, 100]);
  const from = facing(USUAL, now(on([0, 0, 1])), AS_IT_IS, [part, plate]);
  expect(from.x).toBeLessThan(0.1);
});

test('the work is seen as it will stand while it is welded, not only as it stands now', () => {
  // Now the spot is at the left; while it is welded it is at the back.
  const spot = on([-1, 0, 0]);
  const turns = (of: Standing): Matrix4 => new Matrix4().makeRotationZ(of.axes ? -Math.PI / 2 : 0);
  const welded = Array.from({ length: 3 }, () => ({ axes: [1], spots: [spot] }));
  const from = facing(USUAL, [...now(spot), ...welded], turns, []);
  expect(from.y).toBeGreaterThan(0.4);
  const path = Array.from({ length: 401 }, (_, i) => ({ ...spot, axes: [i] }));
  const all = standings({ passes: [{ path }] } as unknown as WorkView);
  expect(all[0]?.axes).toBeNull();
  expect(all.length).toBeLessThanOrEqual(9);
  expect(all[1]?.axes).toEqual([0]);
});
