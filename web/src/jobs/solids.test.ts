import { describe, expect, test } from 'vitest';
import { added, beside, changed, freshName, PRIMITIVES, removed, solidsOf, type Solid } from './solids';

const TEXT = `schema = 1
title = "x"

[[fixtures]]   # holds it
name = "clamp"   # left
shape.box = { size_mm = [40, 40, 120] }
at = { move_mm = [300, 0, 60] }

# the other one
[[fixtures]]
name = "post"
shape = { cylinder = { radius_mm = 5, length_mm = 90 } }

[weld]
speed_mm_s = 10
`;

describe('solids of a job', () => {
  test('new ones are put beside the seam, away from its middle', () => {
    const ring = [0, 1, 2, 3].map((i): [number, number, number] => [100 + 50 * Math.cos((i * Math.PI) / 2), 50 * Math.sin((i * Math.PI) / 2), 7.4]);
    expect(beside(ring)).toEqual([350, 0, 7]);
    expect(beside(ring.slice(1, 2))).toEqual([300, 50, 7]);
    expect(beside([])).toEqual([0, 0, 0]);
  });

  test('are read as they are written', () => {
    const [clamp, post] = solidsOf(TEXT);
    expect(clamp).toMatchObject({ name: 'clamp', list: 'fixtures', index: 0, move: [300, 0, 60], angle: 0, fixed: false });
    expect(clamp?.shape).toEqual({ kind: 'box', sizes: [{ key: 'size_mm', numbers: [40, 40, 120] }] });
    expect(post?.shape).toEqual({ kind: 'cylinder', sizes: [{ key: 'radius_mm', numbers: [5] }, { key: 'length_mm', numbers: [90] }] });
    expect(post?.move).toEqual([0, 0, 0]);
  });

  test('what only the text can change is said to be so', () => {
    const stl = '[[fixtures]]\nname = "a"\nshape.stl = { file = "a.stl" }\n';
    const within = '[[fixtures]]\nname = "a"\nshape.sphere = { radius_mm = 2 }\n[fixtures.at]\nmove_mm = [1, 2, 3]\n';
    expect([stl, within].map((text) => solidsOf(text)[0]?.fixed)).toEqual([true, true]);
    expect(solidsOf(within)[0]?.move).toEqual([1, 2, 3]);
    const [solid] = solidsOf(stl) as [Solid];
    expect(changed(stl, { ...solid, move: [1, 1, 1] })).toBe(stl);
  });

  test('one that is moved, turned, renamed or resized leaves everything else as it was', () => {
    const [clamp, post] = solidsOf(TEXT) as [Solid, Solid];
    expect(changed(TEXT, clamp)).toBe(TEXT);
    expect(changed(TEXT, { ...clamp, move: [1.5, -2, 0] })).toBe(TEXT.replace('[300, 0, 60]', '[1.5, -2, 0]'));
    const turned = changed(TEXT, { ...post, turn: [1, 0, 0], angle: 90 });
    expect(turned).toContain('[[fixtures]]\nat = { move_mm = [0, 0, 0], turn = [1, 0, 0], angle_deg = 90 }\nname = "post"');
    expect(solidsOf(turned)[1]).toMatchObject({ turn: [1, 0, 0], angle: 90 });
    const larger = changed(TEXT, { ...post, name: 'a "b"', shape: { kind: 'cylinder', sizes: [{ key: 'radius_mm', numbers: [7] }, { key: 'length_mm', numbers: [90] }] } });
    expect(larger).toBe(TEXT.replace('"post"', '"a \\"b\\""').replace('radius_mm = 5', 'radius_mm = 7'));
  });

  test('every primitive is added, reads back, and is gone again', () => {
    for (const list of ['fixtures', 'part.solids'] as const) {
      for (const kind of Object.keys(PRIMITIVES)) {
        const text = added(TEXT, list, kind, `${kind} 1`, [10, 20, -0]);
        const solid = solidsOf(text).at(-1) as Solid;
        expect(solid).toMatchObject({ list, name: `${kind} 1`, move: [10, 20, 0], fixed: false });
        expect(solid.shape.kind).toBe(kind);
        expect(removed(text, solid)).toBe(TEXT);
        expect(freshName(solidsOf(text), kind)).toBe(`${kind} 2`);
      }
    }
  });

  test('one that is removed takes its own lines along, not its neighbour’s comment', () => {
    const [clamp, post] = solidsOf(TEXT) as [Solid, Solid];
    const without = removed(TEXT, clamp);
    expect(without).toContain('# the other one\n[[fixtures]]\nname = "post"');
    expect(without).not.toContain('clamp');
    expect(solidsOf(without).length).toBe(1);
    expect(removed(TEXT, post)).toContain('[weld]\nspeed_mm_s = 10');
    expect(solidsOf(removed(TEXT, post)).map((solid) => solid.name)).toEqual(['clamp']);
  });
});
