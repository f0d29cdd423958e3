import { readdirSync, readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { schemaOf } from './schema';
import { read, replaced, within, withKey, type Value } from './toml';

const examples = new URL('../../../examples/', import.meta.url);
const example = (name: string): string => readFileSync(new URL(`${name}.toml`, examples), 'utf8');
const job = await schemaOf(false);

/** All values of a text by their paths, in inline tables too. */
function values(text: string): Map<string, Value> {
  const found = new Map<string, Value>();
  const put = (path: string, value: Value): void => {
    found.set(path, value);
    if (value.kind === 'table') for (const inner of value.entries) put(`${path}.${inner.key}`, inner.value);
  };
  for (const { table, key, value } of read(text)) put(`${table}.${key}`.replace(/^\./, ''), value);
  return found;
}

test('the thickness of a shell can be added, under the keys that it has', () => {
  const text = example('hillside');
  const table = 'seam.nozzle.body.cylinder';
  const rows = read(text).filter((entry) => entry.table === table);
  const [thickness] = job.addable(table, rows.map(({ key }) => key)).filter(({ key }) => key === 'thickness_mm');
  expect(thickness?.help).toContain('Thickness of the wall');
  const changed = withKey(text, rows, 'thickness_mm', thickness?.value ?? '');
  expect(values(changed).get(`${table}.thickness_mm`)).toMatchObject({ kind: 'number', number: 1 });
  // Nothing else is another.
  expect(changed.replace(`thickness_mm = ${thickness?.value}\n`, '')).toBe(text);
});

test('the root bead, an inline table with another in it, has all its values, and can get more', () => {
  const text = example('hillside');
  const root = values(text).get('beads.root');
  expect(root?.kind).toBe('table');
  expect(values(text).get('beads.root.process.current_a')).toMatchObject({ number: 150 });
  if (root?.kind !== 'table') return;
  const more = job.addable('beads.root', root.entries.map(({ key }) => key));
  expect(more.map(({ key }) => key)).toContain('weave');
  const [weave] = more.filter(({ key }) => key === 'weave');
  const changed = replaced(text, within(root), `, weave = ${weave?.value}`);
  expect(values(changed).get('beads.root.weave')?.kind).toBe('table');
  expect(values(changed).get('beads.root.layer_mm')).toMatchObject({ number: 3 });
  const empty = 'root = {}\n';
  const [none] = read(empty);
  if (none?.value.kind === 'table') expect(replaced(empty, within(none.value), ' a = 1 ')).toBe('root = { a = 1 }\n');
});

test('a key goes into the table that is shown, also where its keys are dotted or it is the last line', () => {
  const add = (text: string, table: string): string => withKey(text, read(text).filter((entry) => entry.table === table), 'c', '3');
  expect(add('a = 1\n[t]\nb = 2\n', '')).toBe('a = 1\nc = 3\n[t]\nb = 2\n');
  expect(add('[t]\nx.b = 2 # why\n', 't.x')).toBe('[t]\nx.b = 2 # why\nx.c = 3\n');
  expect(add('[t]\nb = [\n 1,\n 2,\n]', 't')).toBe('[t]\nb = [\n 1,\n 2,\n]\nc = 3');
});

test('what a table has is not offered, nor a second kind of what has one, and every value is TOML', () => {
  for (const file of readdirSync(examples).filter((name) => name.endsWith('.toml'))) {
    const text = example(file.replace('.toml', ''));
    if (text.includes('[[passes]]')) continue;
    const entries = read(text);
    for (const table of new Set(entries.map((entry) => entry.table))) {
      const rows = entries.filter((entry) => entry.table === table);
      const inside = entries.filter((entry) => entry.table.startsWith(`${table}.`)).map((entry) => entry.table.slice(table.length + 1).split('.')[0] ?? '');
      const has = [...rows.map(({ key }) => key), ...inside];
      const more = job.addable(table, has);
      expect(more.filter(({ key }) => has.includes(key)), `${file} ${table}`).toEqual([]);
      for (const { key, value } of more) expect(read(withKey(text, rows, key, value)).some((entry) => entry.table === table && entry.key === key), `${file} ${table} ${key} = ${value}`).toBe(true);
    }
  }
  expect(job.addable('seam.nozzle.body', ['cylinder'])).toEqual([]);
  expect(job.addable('nowhere', [])).toEqual([]);
});
