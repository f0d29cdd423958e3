import { Matrix4, Vector3 } from 'three';
import { describe, expect, test } from 'vitest';
import type { MachineView, PathPoint } from '../wire';
import { poseAt } from './kinematics';
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

/** A turn about z, two slides, and a swing about -y through (400, 0, 100); the tip is at (400, 0, 0). */
const machine = {
  axes: [{ unit: 'deg' }, { unit: 'mm' }, { unit: 'mm' }, { unit: 'deg' }],
  tool: [1, 0, 0, 400, 0, -1, 0, 0, 0, 0, -1, 0],
  torch: 4,
  joints: [
    null,
    { on: 0, axis: 0, direction: [0, 0, 1], at: [0, 0, 0] },
    { on: 1, axis: 1, direction: [1, 0, 0], at: [0, 0, 0] },
    { on: 2, axis: 2, direction: [0, 0, 1], at: [0, 0, 0] },
    { on: 3, axis: 3, direction: [0, -1, 0], at: [400, 0, 100] },
  ],
} as unknown as MachineView;

test('links stand where their axes place them', () => {
  for (let i = 0; i < 100; i += 1) {
    const [theta, s, h, beta] = [90 * Math.sin(i), 100 * Math.cos(2 * i), 80 * Math.sin(3 * i), 60 * Math.cos(5 * i)];
    const [a, b] = [(theta * Math.PI) / 180, (beta * Math.PI) / 180];
    const found = poseAt(machine, [theta, s, h, beta]);
    const slide = new Matrix4().makeRotationZ(a).multiply(new Matrix4().makeTranslation(s, 0, h));
    expect(found.links).toHaveLength(5);
    slide.elements.forEach((value, n) => expect(found.links[3]?.elements[n]).toBeCloseTo(value, 9));
    const out = 400 + s + 100 * Math.sin(b);
    const tip = new Vector3(Math.cos(a) * out, Math.sin(a) * out, 100 + h - 100 * Math.cos(b));
    const along = new Vector3(-Math.cos(a) * Math.sin(b), -Math.sin(a) * Math.sin(b), Math.cos(b));
    expect(new Vector3(...found.tip).distanceTo(tip)).toBeLessThan(1e-9);
    expect(new Vector3(...found.along).distanceTo(along)).toBeLessThan(1e-9);
  }
});
