import { Matrix4, Vector3 } from 'three';
import { describe, expect, test } from 'vitest';
import type { MachineView, PathPoint } from '../wire';
// @ts-expect-error: the mock is plain JavaScript.
import { machine, pose } from '../../mock/weld.mjs';
import { poseAt } from './kinematics';
import { matrix } from './shapes';
import { off } from './spot';

describe('how far the tip is from its pass', () => {
  const R = 100;
  /** A turn about z, a sample every 3 mm. */
  const circle = Array.from({ length: 210 }, (_, i) => {
    const a = (i * 3) / R;
    return { s_mm: i * 3, tip: [R * Math.cos(a), R * Math.sin(a), 0] } as unknown as PathPoint;
  });
  const on = (s: number, out: number, up: number): [number, number, number] => [(R + out) * Math.cos(s / R), (R + out) * Math.sin(s / R), up];

  test('of a circle it is what it is beside it, to a micrometre', () => {
    for (let i = 0; i < 200; i += 1) {
      const s = 20 + 590 * ((i * 0.618) % 1);
      const [out, up] = [2 * Math.sin(i), Math.cos(3 * i)];
      expect(off(circle, s + 5 * Math.sin(7 * i), on(s, out, up), null)?.distance).toBeCloseTo(Math.hypot(out, up), 3);
    }
    expect(off(circle, 300, on(300, 0, 0), null)?.distance).toBeLessThan(1e-3);
  });

  test('a beam is as far as its line, however deep', () => {
    for (const deep of [-30, 0, 12]) {
      const found = off(circle, 150, on(150, 0.25, deep), [0, 0, 1]);
      expect(found?.distance).toBeCloseTo(0.25, 3);
      expect(found?.spot[2]).toBeCloseTo(0);
    }
  });

  test('another turn of the same pass is not taken, and nothing is far from no path', () => {
    const eight = [0, 100, 200].map((s) => ({ s_mm: s, tip: [s === 100 ? 50 : 0, 0, s / 200] }) as unknown as PathPoint);
    expect(off(eight, 0, [0, 0, 0], null)?.distance).toBeCloseTo(0);
    expect(off([], 0, [0, 0, 0], null)).toBeNull();
    expect(off(circle, 5000, [0, 0, 0], null)).toBeNull();
  });
});

test('links stand where the cell says that they are at these axes', () => {
  for (let i = 0; i < 100; i += 1) {
    const axes = [90 * Math.sin(i), 100 * Math.cos(2 * i), 80 * Math.sin(3 * i), 60 * Math.cos(5 * i)];
    const wanted = pose(axes) as { links: number[][]; tip: number[] };
    const found = poseAt(machine as unknown as MachineView, axes);
    expect(found.links).toHaveLength(wanted.links.length);
    wanted.links.forEach((link, k) => {
      const by = (found.links[k] ?? new Matrix4()).elements.map((value, n) => value - (matrix(link).elements[n] ?? 0));
      expect(Math.max(...by.map(Math.abs))).toBeLessThan(1e-9);
    });
    expect(new Vector3(...found.tip).distanceTo(new Vector3(...wanted.tip.slice(0, 3)))).toBeLessThan(1e-9);
    expect(new Vector3(...found.along).distanceTo(new Vector3(...wanted.tip.slice(3)))).toBeLessThan(1e-9);
  }
});
