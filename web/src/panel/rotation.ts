/** Rotations as robot people write them. A frame is 3 x 4, row by row, in mm. */

/** Unit quaternion: w, x, y, z. */
export type Quaternion = [number, number, number, number];

/**
 * How a rotation is written: angles about the fixed axes X, Y, Z (roll, pitch, yaw: Universal Robots' RPY, FANUC's W, P, R, Yaskawa's
 * Rx, Ry, Rz); angles A, B, C about Z, the turned Y and the turned X (KUKA); or a quaternion (ABB).
 */
export const conventions = ['xyz', 'abc', 'quaternion'] as const;
export type Convention = (typeof conventions)[number];

/** Names of the numbers of a convention. */
export const numbersOf: Record<Convention, readonly string[]> = {
  xyz: ['RX', 'RY', 'RZ'],
  abc: ['A', 'B', 'C'],
  quaternion: ['Q1', 'Q2', 'Q3', 'Q4'],
};

const DEG = Math.PI / 180;

const at = (frame: readonly number[], row: number, column: number): number => frame[4 * row + column] ?? 0;

/** Where a frame is, mm. */
export const originOf = (frame: readonly number[]): [number, number, number] => [at(frame, 0, 3), at(frame, 1, 3), at(frame, 2, 3)];

/** The product of two frames: the second one is given in the first. */
export function product(a: readonly number[], b: readonly number[]): number[] {
  const made: number[] = [];
  for (let row = 0; row < 3; row += 1) {
    for (let column = 0; column < 4; column += 1) {
      let sum = column === 3 ? at(a, row, 3) : 0;
      for (let k = 0; k < 3; k += 1) sum += at(a, row, k) * at(b, k, column);
      made.push(sum);
    }
  }
  return made;
}

/** The inverse of a frame. */
export function inverse(of: readonly number[]): number[] {
  const made: number[] = [];
  for (let row = 0; row < 3; row += 1) {
    const turned = [at(of, 0, row), at(of, 1, row), at(of, 2, row)];
    made.push(...turned, -turned.reduce((sum, v, k) => sum + v * at(of, k, 3), 0));
  }
  return made;
}

/** The quaternion of a frame's rotation, with w of at least 0. */
export function quaternionOf(frame: readonly number[]): Quaternion {
  const [xx, yy, zz] = [at(frame, 0, 0), at(frame, 1, 1), at(frame, 2, 2)];
  // From the largest component, so that none is divided by a small number.
  const squares = [1 + xx + yy + zz, 1 + xx - yy - zz, 1 - xx + yy - zz, 1 - xx - yy + zz];
  const largest = squares.indexOf(Math.max(...squares));
  const twice = Math.sqrt(Math.max(squares[largest] ?? 1, 1e-12));
  const [x, y, z] = [at(frame, 2, 1) - at(frame, 1, 2), at(frame, 0, 2) - at(frame, 2, 0), at(frame, 1, 0) - at(frame, 0, 1)];
  const [xy, xz, yz] = [at(frame, 0, 1) + at(frame, 1, 0), at(frame, 0, 2) + at(frame, 2, 0), at(frame, 1, 2) + at(frame, 2, 1)];
  const rows: Quaternion[] = [[twice * twice, x, y, z], [x, twice * twice, xy, xz], [y, xy, twice * twice, yz], [z, xz, yz, twice * twice]];
  const found = (rows[largest] ?? [1, 0, 0, 0]).map((v) => v / (2 * twice)) as Quaternion;
  return found[0] < 0 ? (found.map((v) => -v) as Quaternion) : found;
}

/** The frame of a rotation at a place. */
export function frameOf([w, x, y, z]: Quaternion, [px, py, pz]: readonly [number, number, number]): number[] {
  return [
    1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y), px,
    2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x), py,
    2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y), pz,
  ];
}

/** Angle of the rotation between two frames, degrees. */
export function angleBetween(a: readonly number[], b: readonly number[]): number {
  const [w, x, y, z] = quaternionOf(product(inverse(a), b));
  return (2 * Math.atan2(Math.hypot(x, y, z), w)) / DEG;
}

/** The angles of a rotation about the fixed axes X, Y and Z, degrees; Y within 90. Where Y is 90, X is 0. */
function xyz(frame: readonly number[]): [number, number, number] {
  const across = Math.hypot(at(frame, 0, 0), at(frame, 1, 0));
  const y = Math.atan2(-at(frame, 2, 0), across);
  if (across < 1e-9) return [0, y / DEG, Math.atan2(-at(frame, 0, 1), at(frame, 1, 1)) / DEG];
  return [Math.atan2(at(frame, 2, 1), at(frame, 2, 2)) / DEG, y / DEG, Math.atan2(at(frame, 1, 0), at(frame, 0, 0)) / DEG];
}

/** The numbers of a frame's rotation in a convention. */
export function written(frame: readonly number[], convention: Convention): number[] {
  if (convention === 'quaternion') return quaternionOf(frame);
  const [x, y, z] = xyz(frame);
  // About the turned axes in the other order: the same angles.
  return convention === 'xyz' ? [x, y, z] : [z, y, x];
}

/** The quaternion that the numbers of a convention mean; null if they mean none. */
export function read(numbers: readonly number[], convention: Convention): Quaternion | null {
  if (numbers.length !== numbersOf[convention].length || !numbers.every(Number.isFinite)) return null;
  if (convention === 'quaternion') {
    const length = Math.hypot(...numbers);
    // As far off as four rounded digits are.
    if (Math.abs(length - 1) > 0.01) return null;
    return numbers.map((v) => v / length) as Quaternion;
  }
  const [x = 0, y = 0, z = 0] = convention === 'xyz' ? numbers : [...numbers].reverse();
  const half = (deg: number): [number, number] => [Math.cos((deg * DEG) / 2), Math.sin((deg * DEG) / 2)];
  const [[cx, sx], [cy, sy], [cz, sz]] = [half(x), half(y), half(z)];
  return [cx * cy * cz + sx * sy * sz, sx * cy * cz - cx * sy * sz, cx * sy * cz + sx * cy * sz, cx * cy * sz - sx * sy * cz];
}
