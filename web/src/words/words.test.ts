import { readdirSync, readFileSync } from 'node:fs';
import { describe, expect, test } from 'vitest';
import { alarms as deAlarms, de } from './de';
import { en, type Key } from './en';
import { alarms as ruAlarms, ru } from './ru';
import { alarms as ukAlarms, uk } from './uk';
import { alarms as zhAlarms, zh } from './zh';

const tables = { uk, zh, de, ru };
/** What is only parameters and marks is the same everywhere. */
const bare = (text: string): boolean => !/\p{L}/u.test(text.replace(/\{\d\}/g, ''));
const holes = (text: string): string => [...text.matchAll(/\{\d\}/g)].map((m) => m[0]).sort().join();

describe.each(Object.entries(tables))('%s', (code, table) => {
  test('has the same holes in its sentences', () => {
    for (const key of Object.keys(en) as Key[]) expect(holes(table[key]), key).toBe(holes(en[key]));
  });

  test('nothing is left in English or empty', () => {
    // Names that are the same there.
    const same = new Set<Key>(['role.admin']);
    const left = (Object.keys(en) as Key[]).filter((key) => table[key] === '' || (table[key] === en[key] && en[key].length > 8 && !same.has(key) && !bare(en[key])));
    expect(left).toEqual([]);
    if (code === 'de') return;
    const script = code === 'zh' ? /[\u4e00-\u9fff]/ : /[\u0400-\u04ff]/;
    expect((Object.keys(en) as Key[]).filter((key) => !script.test(table[key]) && !['record.no'].includes(key) && !bare(en[key]))).toEqual([]);
  });

  test('no sentence is more than 2.4 times as long as the English one has room for', () => {
    for (const key of Object.keys(en) as Key[]) expect(table[key].length, key).toBeLessThan(en[key].length * 2.4 + 20);
  });
});

test.each(Object.entries({ uk: ukAlarms, zh: zhAlarms, de: deAlarms, ru: ruAlarms }))('the alarms are those of the cell: %s', (_, alarms) => {
  const rust = readFileSync(new URL('../../../crates/cell/src/executive/alarm.rs', import.meta.url), 'utf8');
  expect(Object.keys(alarms).length).toBe(Number(/const ALL: \[Self; (\d+)\]/.exec(rust)?.[1]));
  for (const [name, row] of Object.entries(alarms)) {
    expect(rust).toContain(`"${name}"`);
    for (const text of Object.values(row)) expect(rust, name).not.toContain(`"${text}"`);
  }
});

test('events are those of the cell, in its words', () => {
  const rust = readFileSync(new URL('../../../crates/server/src/cell/happening.rs', import.meta.url), 'utf8');
  const rows = [...rust.matchAll(/^ +\("(\w+)", "\w+", "([^"]*)"\),$/gm)].map((row) => [`said.${row[1]}`, row[2]]);
  // A long row is broken over lines.
  const broken = [...rust.matchAll(/^ +"(\w+)",\n +"\w+",\n +"([^"]*)",$/gm)].map((row) => [`said.${row[1]}`, row[2]]);
  const all = Object.fromEntries([...rows, ...broken]) as Record<string, string>;
  expect(Object.keys(all).length).toBe(Number(/const HAPPENINGS: .*; (\d+)\]/.exec(rust)?.[1]));
  expect(Object.fromEntries(Object.entries(en).filter(([key]) => key.startsWith('said.')))).toEqual(all);
});

test('every condition of the machines that ship has words', () => {
  const folder = new URL('../../../machines/', import.meta.url);
  const texts = readdirSync(folder).filter((name) => name.endsWith('.toml')).map((name) => readFileSync(new URL(name, folder), 'utf8'));
  const names = texts.flatMap((text) => [...text.matchAll(/\[\[interlocks\]\]\nname = "([^"]+)"/g)].map((m) => m[1] ?? ''));
  expect(new Set(names).size).toBeGreaterThan(8);
  expect(names.filter((name) => en[`interlock.${name.replaceAll(' ', '_')}` as Key] !== name)).toEqual([]);
});

test('every template has its title in every language', () => {
  const folder = new URL('../../../examples/', import.meta.url);
  const titles = readdirSync(folder).filter((name) => name.endsWith('.toml')).map((name) => [`example.${name.replace('.toml', '')}`, /^title = "(.*)"$/m.exec(readFileSync(new URL(name, folder), 'utf8'))?.[1]]);
  expect(titles.length).toBeGreaterThan(15);
  expect(Object.fromEntries(Object.entries(en).filter(([key]) => key.startsWith('example.')))).toEqual(Object.fromEntries(titles));
});

test('every kind of finding that a plan can have has a name', () => {
  const crates = ['motion', 'weld', 'program'].map((crate) => new URL(`../../../crates/${crate}/src/`, import.meta.url));
  const files = crates.flatMap((crate) => readdirSync(crate, { recursive: true, encoding: 'utf8' }).filter((name) => name.endsWith('.rs')).map((name) => new URL(name, crate)));
  const texts = files.map((file) => readFileSync(file, 'utf8')).filter((text) => text.includes('Finding'));
  // As they are written: in the finding itself, by a helper, or in a choice of two.
  const kinds = texts.flatMap((text) => [...text.matchAll(/(?:kind: |finding\(|stretches\(\()"(\w+)"|kind: if [^{]*\{ "(\w+)" \} else \{ "(\w+)" \}/g)].flatMap((m) => m.slice(1).filter(Boolean)));
  expect(new Set(kinds).size).toBeGreaterThan(15);
  expect([...new Set(kinds)].filter((kind) => !(`finding.${kind}` in en))).toEqual([]);
});
