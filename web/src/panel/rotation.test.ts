import { Euler, Matrix4, Quaternion as Turn, Vector3 } from 'three';
import { expect, test } from 'vitest';
import { angleBetween, conventions, frameOf, inverse, originOf, product, quaternionOf, read, written, type Quaternion } from './rotation';

/** Random rotations, with those that conventions find hard. */
function rotations(): Turn[] {
  let state = 7;
  const random = (): number => (state = (state * 16807) % 2147483647) / 2147483647 - 0.5;
  const some = Array.from({ length: 500 }, () => new Turn(random(), random(), random(), random()).normalize());
  const hard = [[0, 90, 0], [0, -90, 30], [180, 0, 0], [0, 180, 0], [0, 0, 180], [90, 90, 0], [0, 0, 0]].map(
    ([x, y, z]) => new Turn().setFromEuler(new Euler((x! * Math.PI) / 180, (y! * Math.PI) / 180, (z! * Math.PI) / 180, 'ZYX')),
  );
  return [...some, ...hard];
}

const rows = (matrix: Matrix4): number[] => {
  const e = matrix.elements;
  return [0, 1, 2].flatMap((row) => [0, 1, 2, 3].map((column) => e[4 * column + row]!));
};
const frame = (turn: Turn): number[] => rows(new Matrix4().compose(new Vector3(1, -2, 3), turn, new Vector3(1, 1, 1)));
const near = (a: readonly number[], b: readonly number[]): number => Math.max(...a.map((v, i) => Math.abs(v - b[i]!)));

test('numbers of every convention mean the rotation that they were written from', () => {
  for (const turn of rotations()) {
    for (const convention of conventions) {
      const numbers = written(frame(turn), convention);
      const quaternion = read(numbers, convention) as Quaternion;
      expect(near(frameOf(quaternion, [1, -2, 3]), frame(turn)), `${convention} ${numbers}`).toBeLessThan(1e-6);
    }
  }
});

test('the conventions are those of three: ABC about Z, Y, X of the turned frame, XYZ about the fixed axes', () => {
  for (const turn of rotations().slice(0, 500)) {
    const euler = new Euler().setFromQuaternion(turn, 'ZYX');
    const deg = [euler.x, euler.y, euler.z].map((angle) => (angle * 180) / Math.PI);
    expect(near(written(frame(turn), 'xyz'), deg)).toBeLessThan(1e-6);
    expect(near(written(frame(turn), 'abc'), [...deg].reverse())).toBeLessThan(1e-6);
    // About fixed axes: first X, then Y, then Z.
    const fixed = new Turn();
    [new Vector3(1, 0, 0), new Vector3(0, 1, 0), new Vector3(0, 0, 1)].forEach((axis, i) =>
      fixed.premultiply(new Turn().setFromAxisAngle(axis, (deg[i]! * Math.PI) / 180)),
    );
    expect(near(frame(fixed), frame(turn))).toBeLessThan(1e-6);
    const [w, x, y, z] = quaternionOf(frame(turn));
    expect(Math.abs(w * turn.w + x * turn.x + y * turn.y + z * turn.z)).toBeCloseTo(1, 9);
  }
});

test('frames multiply and invert as matrices do', () => {
  const all = rotations();
  for (let i = 1; i < 100; i += 1) {
    const [a, b] = [frame(all[i - 1]!), frame(all[i]!)];
    const made = (of: number[]): Matrix4 => new Matrix4().set(...(of as [number, number, number, number, number, number, number, number, number, number, number, number]), 0, 0, 0, 1);
    expect(near(product(a, b), rows(made(a).multiply(made(b))))).toBeLessThan(1e-9);
    expect(near(inverse(a), rows(made(a).invert()))).toBeLessThan(1e-9);
    expect(originOf(a)).toEqual([1, -2, 3]);
    expect(angleBetween(a, b)).toBeCloseTo((all[i - 1]!.angleTo(all[i]!) * 180) / Math.PI, 6);
  }
});

test('what is no rotation is none', () => {
  expect(read([1, 2], 'xyz')).toBeNull();
  expect(read([Number.NaN, 0, 0], 'abc')).toBeNull();
  expect(read([1, 1, 0, 0], 'quaternion')).toBeNull();
  expect(read([0.7071, 0.7071, 0, 0], 'quaternion')).not.toBeNull();
});
