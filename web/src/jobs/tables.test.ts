import { readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { choicesOf } from './choices';
import { addable, ADDABLE, added, kindOf, PREPARATIONS, without, withKind } from './tables';
import { read } from './toml';

type Schema = { $defs: Record<string, Schema>; properties?: Record<string, unknown>; enum?: string[]; oneOf?: Schema[]; const?: string; required?: string[] };
const file = (name: string): string => readFileSync(new URL(`../../../${name}`, import.meta.url), 'utf8');
const schema = JSON.parse(file('docs/schema/job.json')) as Schema;
const program = JSON.parse(file('docs/schema/program.json')) as Schema;
const saddle = file('examples/saddle.toml');
const thick = file('examples/thick-saddle.toml');
const values = (name: string, of = schema): string[] => {
  const { enum: plain, oneOf } = of.$defs[name] as Schema;
  return plain ?? (oneOf ?? []).flatMap((one) => one.enum ?? (one.const === undefined ? [] : [one.const]));
};

describe('choices', () => {
  test.each([
    ['passes.0.role', 'Role'],
    ['start.direction', 'Direction'],
    ['seam.ellipse.joint', 'FilletOrButt'],
    ['seam.arc.wall_faces', 'WallFaces'],
    ['seam.t_joint.fillet', 'Side'],
    ['seam.nozzle.mount', 'Mount'],
    ['seam.nozzle.curve', 'NozzleCurve'],
    ['seam.nozzle.body.torispherical_head.standard', 'HeadStandard'],
    ['joint.preparation.bevel.prepared', 'Member'],
    ['beads.adapt', 'Adapt'],
    ['beads.order', 'Order'],
    ['weld.weave.figure', 'Figure'],
    ['spare_axes.position', 'Position'],
    ['sequence.at_hold', 'AtHold'],
    ['weld.on_limit', 'OnLimit'],
    ['passes.0.points.spans.2.along', 'Along'],
  ])('%s has those of the format', (path, name) => {
    const of = name in schema.$defs ? schema : program;
    expect([...choicesOf(path)].sort()).toEqual([...values(name, of)].sort());
  });

  test('other fields may be anything', () => {
    for (const path of ['title', 'passes.0.name', 'part.solids.0.name', 'weld.process.current_a']) expect(choicesOf(path)).toEqual([]);
  });
});

describe('joints', () => {
  test('kinds and their keys are those of the format', () => {
    const kinds = (schema.$defs['Preparation']?.oneOf ?? []).map((of) => Object.entries(of.properties ?? {})[0] as [string, { $ref: string }]);
    expect(Object.keys(PREPARATIONS).sort()).toEqual(kinds.map(([kind]) => kind).sort());
    for (const [kind, { $ref }] of kinds) {
      const of = schema.$defs[$ref.split('/').at(-1) ?? ''] as Schema;
      const keys = Object.keys(PREPARATIONS[kind] ?? {});
      expect(keys.filter((key) => !(key in (of.properties ?? {}))), kind).toEqual([]);
      expect((of.required ?? []).filter((key) => !keys.includes(key)), kind).toEqual([]);
    }
  });

  test('another kind keeps the sizes that both have, and everything around', () => {
    const made = withKind(thick, 'bevel', { thickness_mm: 12, root_gap_mm: 2, root_face_mm: 1, prepared: 'first' });
    expect(kindOf(made)).toBe('bevel');
    const table = '[joint.preparation.bevel]\nthickness_mm = 12\nangle_deg = 45\nroot_gap_mm = 2\nroot_face_mm = 1\nprepared = "first"\n';
    expect(made).toContain(`\n\n${table}\n[tacks]\n`);
    expect(made.replace(table, '')).toBe(thick.replace(/\[joint\.preparation\.t_bevel\][^]*?\n\n/, '\n'));
  });
});

describe('tables', () => {
  test('what is added is read back, once, and goes without a trace', () => {
    expect(addable(saddle)).toEqual(ADDABLE.filter((of) => !['procedure', 'start', 'placement', 'torch', 'sequence'].includes(of)));
    for (const what of addable(saddle)) {
      const made = added(saddle, what, '');
      expect(addable(made), what).not.toContain(what);
      expect(read(made).filter((entry) => entry.table.startsWith(what)).length, what).toBeGreaterThan(0);
      expect(without(made, what), what).toBe(saddle);
    }
  });

  test('a procedure is named beside the machine', () => {
    const bare = saddle.replace(/^procedure.*\n/m, '');
    expect(addable(bare)).toContain('procedure');
    const made = added(bare, 'procedure', 'my-wps.toml');
    expect(made.split('\n').findIndex((row) => row === 'procedure = "my-wps.toml"')).toBe(made.split('\n').findIndex((row) => row.startsWith('machine')) + 1);
    expect(addable(made)).not.toContain('procedure');
  });

  test('a program through points is given none', () => {
    expect(addable(file('examples/points.toml'))).toEqual([]);
  });

  test('what is within a table goes with it, comments of the next one stay', () => {
    const text = without(thick, 'joint');
    expect(text).not.toMatch(/joint/);
    expect(text).toContain('[tacks]');
    const commented = '[a]\nx = 1\n\n# of b\n[b]\ny = [\n  [1, 2],\n]\n';
    expect(without(commented, 'a')).toBe('# of b\n[b]\ny = [\n  [1, 2],\n]\n');
    expect(without(commented, 'b')).toBe('[a]\nx = 1\n\n# of b\n');
  });
});
