import { render } from 'svelte/server';
import { expect, test } from 'vitest';
import { words } from '../words/index.svelte';
import type { FormEntry, FormView } from '../wire';
import EntryFields from './EntryFields.svelte';
import { textAt, values, withChanges } from './form';
import { added, beside, solidsOf } from './solids';

const entry = (path: string, value: FormEntry['value'], more: Partial<FormEntry> = {}): FormEntry => ({
  key: path.split('.').at(-1) ?? '', path, value, line: 1, comment: '', help: '', choices: [], range: null, ...more,
});
const numbers = (...list: number[]): FormEntry['value'] => ({ kind: 'list', items: list.map((number) => ({ kind: 'number', number })) });
const form = (tables: Record<string, FormEntry[]>): FormView => ({
  tables: Object.entries(tables).map(([path, entries]) => ({ path, entries, addable: [], kinds: [], removable: false })),
  passes: [],
});

const FIXTURES = form({
  '': [entry('machine', { kind: 'text', text: 'm' })],
  'fixtures[0]': [
    entry('fixtures[0].name', { kind: 'text', text: 'clamp' }),
    entry('fixtures[0].at', { kind: 'table', entries: [entry('fixtures[0].at.move_mm', numbers(300, 0, 60))], addable: [] }),
  ],
  'fixtures[0].shape': [entry('fixtures[0].shape.box', { kind: 'table', entries: [entry('fixtures[0].shape.box.size_mm', numbers(40, 40, 120))], addable: [] })],
  'fixtures[1]': [entry('fixtures[1].shape', { kind: 'table', entries: [entry('fixtures[1].shape.stl', { kind: 'table', entries: [entry('fixtures[1].shape.stl.file', { kind: 'text', text: 'a.stl' })], addable: [] })], addable: [] })],
});

test('a key that the panel has never heard of has a field, with its unit, its range and its meaning', async () => {
  await words.choose('en');
  const ripple = entry('ripple.ripple_mm', { kind: 'number', number: 0.25 }, { help: 'Height of the ripples, mm.', range: { min: 0, open: true, max: 1e6 } });
  const shape = entry('ripple.form', { kind: 'text', text: 'sharp' }, { choices: ['round', 'sharp'] });
  const { body } = render(EntryFields, { props: { entries: [ripple, shape], edit: () => undefined } });
  expect(body).toMatch(/<input[^>]*aria-label="ripple \[mm\]"[^>]*value="0.25"/);
  expect(body).toContain('title="ripple_mm (> 0, ≤ 1000000): Height of the ripples, mm."');
  expect([...body.matchAll(/<option value="(\w+)"/g)].map((of) => of[1])).toEqual(['round', 'sharp']);
});

test('what is set stands in the form at once, and nothing else of it is another', () => {
  const now = withChanges(FIXTURES, [{ op: 'set', path: 'fixtures[0].at.move_mm[2]', value: 5 }, { op: 'set', path: 'machine', value: 'n' }, { op: 'remove', path: 'fixtures[1]' }]);
  expect(values(now).get('fixtures[0].at.move_mm')).toEqual(numbers(300, 0, 5));
  expect([textAt(now, 'machine'), textAt(FIXTURES, 'machine'), textAt(now, 'nowhere')]).toEqual(['n', 'm', '']);
  expect(now.tables[2]).toBe(FIXTURES.tables[2]);
});

test('solids are read as they are written, and added by the format', () => {
  const [clamp, part] = solidsOf(FIXTURES);
  expect(clamp).toEqual({ list: 'fixtures', path: 'fixtures[0]', name: 'clamp', shape: 'box', sizes: [{ key: 'size_mm', numbers: [40, 40, 120] }], move: [300, 0, 60], turn: [0, 0, 1], angle: 0, fixed: false });
  expect(part).toMatchObject({ shape: 'stl', fixed: true });
  expect(added(solidsOf(FIXTURES), 'fixtures', 'cone', [1, 2, 3])).toEqual([
    { op: 'insert', path: 'fixtures[2]', value: { name: 'cone 1' } },
    { op: 'add', path: 'fixtures[2].shape.cone' },
    { op: 'set', path: 'fixtures[2].at.move_mm', value: [1, 2, 3] },
  ]);
});

test('new solids are put beside the seam, away from its middle', () => {
  const ring = [0, 1, 2, 3].map((i): [number, number, number] => [100 + 50 * Math.cos((i * Math.PI) / 2), 50 * Math.sin((i * Math.PI) / 2), 7.4]);
  expect(beside(ring)).toEqual([350, 0, 7]);
  expect(beside(ring.slice(1, 2))).toEqual([300, 50, 7]);
  expect(beside([])).toEqual([0, 0, 0]);
});
