import { Box3, Matrix4, Vector3 } from 'three';
import { expect, test } from 'vitest';
import type { WorkView } from '../wire';
import { look, seeing, weldedSide } from './views';

const CAMERA = { fov: 35, aspect: 1.5 };
const box = new Box3(new Vector3(-150, -150, 0), new Vector3(150, 150, 200));
const work = (torches: [number, number, number][]): WorkView => ({ passes: [{ path: torches.map((torch) => ({ torch })) }] }) as unknown as WorkView;
const usual = look('fit', box, CAMERA, null, null).from;

test('the side that is welded is the mean way out of it, as the work stands', () => {
  const ring = work([[1, 0, 0], [0, 1, 0], [-1, 0, 0]]);
  expect(weldedSide(ring, new Matrix4())?.toArray()).toEqual([0, 1, 0]);
  const turned = weldedSide(ring, new Matrix4().makeRotationX(Math.PI / 2));
  expect(turned?.z).toBeCloseTo(1);
  // All around a tube there is none.
  expect(weldedSide(work([[1, 0, 0], [0, 1, 0], [-1, 0, 0], [0, -1, 0]]), new Matrix4())).toBeNull();
  expect(weldedSide(null, new Matrix4())).toBeNull();
});

test('whatever side is welded faces who looks, with the picture turned no more than it needs', () => {
  for (let angle = 0; angle < 2 * Math.PI; angle += 0.1) {
    const side = new Vector3(Math.cos(angle), Math.sin(angle), 0);
    const { from } = look('fit', box, CAMERA, null, side);
    expect(from.dot(side), `${angle}`).toBeGreaterThanOrEqual(0.5);
    expect(from.z).toBeCloseTo(usual.z);
    expect(from.length()).toBeCloseTo(1);
  }
  // From above, or from the front, nothing is turned.
  expect(seeing(usual, new Vector3(0, 0, 1)).distanceTo(usual)).toBeLessThan(1e-9);
  expect(seeing(usual, new Vector3(0, -1, 0)).distanceTo(usual)).toBeLessThan(1e-9);
  // From below there is no such place: it stays where it was.
  expect(seeing(usual, new Vector3(0, 0, -1)).distanceTo(usual)).toBeLessThan(1e-9);
});

test('a torch that is at the work faces who looks; one that is away does not count', () => {
  const [torch, side] = [new Vector3(-1, 0, 0), new Vector3(0, 1, 0)];
  expect(look('fit', box, CAMERA, { at: new Vector3(-150, 0, 100), axis: torch }, side).from.dot(torch)).toBeGreaterThanOrEqual(0.5);
  expect(look('fit', box, CAMERA, { at: new Vector3(-600, 0, 900), axis: torch }, side).from.dot(side)).toBeGreaterThanOrEqual(0.5);
  // Views with names look from where they say.
  expect(look('front', box, CAMERA, null, side).from.y).toBeCloseTo(-1, 2);
});
