import { readdirSync, readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { pointPasses } from './points';
import { entryAt, itemAt, read, replaced } from './toml';

const examples = new URL('../../../examples/', import.meta.url);

describe('the reader of job texts', () => {
  test('finds tables, lists of tables, values and comments', () => {
    const text = 'a = 1 # one\n[t.u]\nb = "x\\"y"\n[[p]]\nc = [1,\n 2] # two\n[[p.s]]\nd = true\n[[p]]\n[[p.s]]\ne = { f = -1.5e2 }\n';
    const found = read(text).map((e) => [e.table, e.key, e.line, e.comment]);
    expect(found).toEqual([
      ['', 'a', 1, 'one'],
      ['t.u', 'b', 3, ''],
      ['p.0', 'c', 5, 'two'],
      ['p.0.s.0', 'd', 8, ''],
      ['p.1.s.0', 'e', 11, ''],
    ]);
  });

  test('every key of every example is found, with the text that stands there', () => {
    const names = readdirSync(examples).filter((name) => name.endsWith('.toml'));
    expect(names.length).toBeGreaterThan(10);
    for (const name of names) {
      const text = readFileSync(new URL(name, examples), 'utf8');
      const keys = text.split('\n').filter((row) => /^[a-z_.]+ *=/.test(row)).length;
      const found = read(text);
      expect(found.length, name).toBe(keys);
      for (const { value } of found) {
        if (value.kind === 'number') expect(Number(text.slice(value.from, value.to))).toBe(value.number);
      }
    }
  });

  test('a change of one number leaves the rest of the text as it was', () => {
    const text = readFileSync(new URL('saddle.toml', examples), 'utf8');
    const radius = read(text).find((e) => e.table === 'seam.nozzle' && e.key === 'radius_mm');
    if (!radius) throw new Error('no radius');
    const changed = replaced(text, radius.value, '123.5');
    expect(changed.length - text.length).toBe(2);
    expect(read(changed).find((e) => e.key === 'radius_mm')?.value).toMatchObject({ number: 123.5 });
    expect(replaced(changed, { from: radius.value.from, to: radius.value.from + 5 }, '250')).toBe(text);
  });

  test('broken text does not stop it', () => {
    for (const text of ['a =', '[', '[[x', 'a = [1, ', 'a = "x', '= 3', 'a = {b', '\u0000', 'a = 1 2 3\nb = 4']) {
      expect(Array.isArray(read(text))).toBe(true);
    }
    expect(read('a = \nb = 4').map((e) => e.key)).toContain('b');
  });

  test('points of a program', () => {
    const text = `[[passes]]
[passes.points]
columns = ["x_mm", "y_mm", "speed_mm_s"]
start = [0, 0, 0]
[[passes.points.spans]]
along = "line"
points = [
  [1, 2, 3], # a
  [4, 5, 6],
]
[[passes.points.spans]]
along = "rapid"
points = [[7, 8, 0]]
`;
    expect(pointPasses(text)).toEqual([
      {
        pass: 1,
        columns: ['x_mm', 'y_mm', 'speed_mm_s'],
        rows: [
          { along: '', span: 0, numbers: [0, 0, 0], speeds: [] },
          { along: 'line', span: 1, numbers: [1, 2, 3], speeds: [] },
          { along: 'line', span: 1, numbers: [4, 5, 6], speeds: [] },
          { along: 'rapid', span: 2, numbers: [7, 8, 0], speeds: [] },
        ],
        arc: true,
        moving: [],
      },
    ]);
  });

  test('are found by the paths that the cell writes', () => {
    const entries = read('a = 1\n[weld]\nspeed = 2\nspeed_max = 3\n[[passes]]\nname = "x"\n[[passes]]\n[[passes.spans]]\nmove = [1, 2]\nprocess = { current = 3 }\n');
    const at = (path: string): string | undefined => entryAt(entries, path)?.key;
    expect(at('a')).toBe('a');
    expect(at('weld.speed')).toBe('speed');
    expect(at('weld.speed_max')).toBe('speed_max');
    expect(at('passes[0].name')).toBe('name');
    expect(at('passes[1].spans[0].move[1]')).toBe('move');
    expect(at('passes[1].spans[0].process.current')).toBe('process');
    expect(at('passes[1].name')).toBeUndefined();
    expect(at('weld')).toBeUndefined();
    expect(at('')).toBeUndefined();
    const item = (path: string): string | null | undefined => { const entry = entryAt(entries, path); return entry && itemAt(entry, path); };
    expect(item('a')).toBeNull();
    expect(item('passes[1].spans[0].move')).toBeNull();
    expect(item('passes[1].spans[0].move[1]')).toBe('1');
    expect(item('passes[1].spans[0].process.current')).toBe('current');
  });
});
