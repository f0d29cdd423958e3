import { BackSide, Box3, DecrementWrapStencilOp, FrontSide, IncrementWrapStencilOp, type Mesh, type MeshBasicMaterial, Plane, Quaternion, Vector3, type Points } from 'three';
import { describe, expect, test } from 'vitest';
import type { NearView, PassView, PathPoint, ShapeView, SolidView } from '../wire';
import { Caps } from './caps';
import { heat, ramp, scale } from './colours';
import { nearness, worthShowing } from './near';
import { geometry, matrix } from './shapes';
import { solid } from './solids';
import { TaughtLine } from './taught';

function extent(shape: ShapeView): { least: number[]; most: number[] } {
  const made = geometry(shape);
  made.computeBoundingBox();
  const box = made.boundingBox ?? new Box3();
  const round = (v: Vector3): number[] => v.toArray().map((n) => Math.round(n * 1e3) / 1e3 + 0);
  return { least: round(box.min), most: round(box.max) };
}

describe('shapes stand as the wire says', () => {
  test.each<[ShapeView, number[], number[]]>([
    [{ kind: 'box', size: [2, 4, 6] }, [-1, -2, -3], [1, 2, 3]],
    [{ kind: 'sphere', radius: 2 }, [-2, -2, -2], [2, 2, 2]],
    [{ kind: 'cone', radius: 2, top_radius: 1, length: 5 }, [-2, -2, 0], [2, 2, 5]],
    [{ kind: 'cone', radius: 1, top_radius: 3, length: 5 }, [-3, -3, 0], [3, 3, 5]],
    [{ kind: 'capsule', radius: 1, length: 5 }, [-1, -1, 0], [1, 1, 5]],
    [{ kind: 'ellipsoid', semi_axes: [1, 2, 3] }, [-1, -2, -3], [1, 2, 3]],
    [{ kind: 'mesh', triangles: [0, 0, 0, 1, 0, 0, 0, 2, 3] }, [0, 0, 0], [1, 2, 3]],
  ])('%j', (shape, least, most) => {
    expect(extent(shape)).toEqual({ least, most });
  });

  test('the wide end of a cone is at 0', () => {
    const made = geometry({ kind: 'cone', radius: 2, top_radius: 1, length: 5 });
    const places = made.getAttribute('position');
    for (let i = 0; i < places.count; i += 1) {
      const far = Math.hypot(places.getX(i), places.getY(i));
      expect(far).toBeLessThanOrEqual(2 - places.getZ(i) / 5 + 1e-6);
    }
  });

  test('frames are row by row', () => {
    const moved = new Vector3(1, 0, 0).applyMatrix4(matrix([0, -1, 0, 10, 1, 0, 0, 20, 0, 0, 1, 30]));
    expect(moved.toArray()).toEqual([10, 21, 30]);
  });
});

describe('colours', () => {
  const point = (speed_mm_s: number, values: number[]): PathPoint =>
    ({ speed_mm_s, values, s_mm: 0, tip: [0, 0, 0], torch: [0, 0, 1], axes: [], used: [], clearance_mm: speed_mm_s + 1 }) as PathPoint;

  test('heat input is U I / v', () => {
    expect(heat(point(10, [240, 27]), ['current_a', 'voltage_v'])).toBeCloseTo(0.648);
    expect(heat(point(8, [40, 60]), ['current_ma', 'voltage_kv'])).toBeCloseTo(0.3);
    expect(heat(point(10, [1]), ['focus_mm'])).toBeNull();
    expect(heat(point(0, [240, 27]), ['current_a', 'voltage_v'])).toBeNull();
  });

  test('the scale spans what there is', () => {
    const pass = { speed_mm_s: 10, path: [point(0, [1]), point(10, [5]), point(9, [3])] } as unknown as PassView;
    expect(scale([pass], { kind: 'speed' }, [])).toMatchObject({ least: 0, most: 10 });
    expect(scale([pass], { kind: 'value', index: 0 }, ['a'])).toMatchObject({ least: 1, most: 5 });
    expect(scale([pass], { kind: 'pass' }, [])).toBeNull();
    expect(scale([pass], { kind: 'clearance' }, [])).toMatchObject({ least: 1, most: 11, unit: 'mm' });
    expect(scale([], { kind: 'speed' }, [])).toBeNull();
  });

  test('the ramp gets lighter all the way and stays within', () => {
    let last = -1;
    for (let i = -5; i <= 105; i += 1) {
      const [r, g, b] = ramp(i / 100);
      const light = 0.2126 * r + 0.7152 * g + 0.0722 * b;
      expect(light).toBeGreaterThanOrEqual(last);
      last = light;
      for (const part of [r, g, b]) expect(part >= 0 && part <= 1).toBe(true);
    }
  });
});

describe('what is near', () => {
  const pair = (distance_mm: number) => ({ distance_mm, least_mm: 2, between: ['a', 'b'], at: [[0, 0, 0], [0, 0, 1]] }) as NearView;

  test('by hand it is told before it is too near, on a checked way only when it is', () => {
    expect([60, 11.9, 2.4, 1].map((mm) => nearness(pair(mm), true))).toEqual(['far', 'near', 'touching', 'touching']);
    expect([60, 11.9, 2.4, 1].map((mm) => nearness(pair(mm), false))).toEqual(['far', 'far', 'far', 'touching']);
  });

  test('a line is drawn where it says something', () => {
    expect(worthShowing(null, true)).toBeNull();
    expect(worthShowing(pair(50), true)).toBeNull();
    expect(worthShowing(pair(30), true)).not.toBeNull();
    expect(worthShowing(pair(30), false)).toBeNull();
    expect(worthShowing(pair(1), false)).not.toBeNull();
  });
});

test('what is cut open is closed: its faces are counted, and a face lies in the plane', () => {
  const cuts: Plane[] = [];
  const caps = new Caps(cuts);
  const frame: SolidView['frame'] = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0];
  const body = solid({ name: 'b', link: 0, frame, shape: { kind: 'box', size: [10, 10, 10] } }, 'part', cuts, caps, false);
  const masks = body.children.filter((child) => child.userData['mask'] === true) as Mesh[];
  const [back, front] = masks.map((mask) => mask.material as MeshBasicMaterial);
  expect([back?.side, back?.stencilZPass, front?.side, front?.stencilZPass]).toEqual([BackSide, IncrementWrapStencilOp, FrontSide, DecrementWrapStencilOp]);
  // They count what is hidden too, and are seen nowhere.
  expect([back, front].every((of) => of && !of.depthTest && !of.depthWrite && !of.colorWrite && of.clippingPlanes === cuts)).toBe(true);
  const [face] = caps.group.children as Mesh[];
  expect(face?.visible).toBe(false);
  expect(face?.renderOrder).toBeGreaterThan(masks[0]?.renderOrder ?? Infinity);
  const plane = new Plane(new Vector3(0, 0, -1), 2);
  caps.set(plane, new Box3(new Vector3(-5, -5, -5), new Vector3(5, 5, 5)));
  expect([face?.visible, face?.position.toArray()]).toEqual([true, [0, 0, 2]]);
  expect(new Vector3(0, 0, 1).applyQuaternion(face?.quaternion ?? new Quaternion()).toArray().map(Math.abs)).toEqual([0, 0, 1]);
  caps.set(null, new Box3());
  expect(face?.visible).toBe(false);
  // Endless ones are not closed, nor what is to be looked through.
  const count = caps.group.children.length;
  solid({ name: 'h', link: 0, frame, shape: { kind: 'half_space' } }, 'fixture', cuts, caps, false);
  solid({ name: 'z', link: 0, frame, shape: { kind: 'sphere', radius: 1 } }, 'permitted', cuts, caps, false);
  expect(caps.group.children.length).toBe(count);
});

test('taught points are drawn, by hand or by camera, until there are none', () => {
  let drawn = 0;
  const line = new TaughtLine(() => (drawn += 1));
  line.set([{ at: [1, 2, 3], confidence: 1 }, { at: [4, 5, 6], confidence: 0 }], null);
  const [dots] = line.group.children;
  const places = (dots as Points).geometry.getAttribute('position');
  expect([...places.array]).toEqual([1, 2, 3, 4, 5, 6]);
  line.set([], null);
  expect(line.group.children).toHaveLength(0);
  expect(drawn).toBe(2);
});
