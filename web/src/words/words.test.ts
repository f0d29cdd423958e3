import { FluentResource } from '@fluent/bundle';
import { readdirSync, readFileSync } from 'node:fs';
import { describe, expect, test, vi } from 'vitest';
import type { MessageView } from '../wire';
import { accented, Catalogue, languages, load, type Language } from './catalogue';
import { message, named, shipped, t, words } from './index.svelte';

const root = new URL('../../../', import.meta.url);
const file = (path: string): string => readFileSync(new URL(path, root), 'utf8');
const ftl = (language: string, area: string): string => file(`messages/${language}/${area}.ftl`);
const code = (key: string): string => `panel-${key.replace(/[._ ]/g, '-')}`;

/** Words of an area by their codes; several lines in one. */
function rows(text: string): Map<string, string> {
  const found = [...text.matchAll(/^([\w-]+) = (.*(?:\n[ \t]+.*)*)/gm)];
  return new Map(found.map(([, id = '', words = '']) => [id, words]));
}
const english = rows(ftl('en', 'panel'));
const shared = rows(ftl('en', 'words'));
/** The English words of a key: the panel's own, or those that reports have too. */
const wordsOf = (key: string): string | undefined => english.get(code(key)) ?? shared.get(code(key).slice('panel-'.length));
const names = (words: string): string[] => [...new Set([...words.matchAll(/\$(\w+)/g)].map((of) => of[1] ?? ''))].sort();

const sources = (folder: string, name: RegExp): string[] =>
  readdirSync(new URL(folder, root), { recursive: true, encoding: 'utf8' }).flatMap((path) => (name.test(path) ? file(folder + path) : []));
const panel = sources('web/src/', /(?<!\.test)\.(ts|svelte)$/);

test('every key that the panel gives has words, with the arguments that they need', () => {
  const calls = panel.flatMap((text) => [...text.matchAll(/\bt\(([^()`{}]*?)(?:, (\{.*?\}|which))?\)(?=[^'])/g)]);
  const given = calls.flatMap(([, keys = '', of = '']) => [...keys.matchAll(/(?<!=== )'([a-z][\w.]*)'/g)].map(([, key = '']) => ({ key, of })));
  expect(given.length).toBeGreaterThan(600);
  expect(given.filter(({ key }) => wordsOf(key) === undefined)).toEqual([]);
  const lacks = given.filter(({ key, of }) => !of.includes('which') && !names(wordsOf(key) ?? '').every((name) => new RegExp(`\\b${name}\\b`).test(of)));
  expect(lacks).toEqual([]);
});

test('every key in a table has words', () => {
  const isGroup = (key: string): boolean => [...english.keys()].some((id) => id.startsWith(`${code(key.split('.')[0] ?? '')}-`));
  const given = panel.flatMap((text) => [...text.matchAll(/(?<!named\()'([a-z_]+\.[a-z_.]+)'/g)].map(([, key = '']) => key));
  // Permissions have words by the name of their action.
  expect(given.filter((key) => isGroup(key) && wordsOf(key) === undefined && !english.has(code(`action.${key}`)))).toEqual([]);
});

test('the panel or the cell uses all words of the panel', () => {
  const literals = [...panel, ...sources('crates/', /\.rs$/)].flatMap((text) => [...text.matchAll(/(['"`])([a-z][\w. -]*)\1/g)].map((of) => of[2] ?? ''));
  const used = new Set(literals.flatMap((text) => [code(text), text]));
  // Groups whose last part is a name of the cell or of a page.
  const groups = ['panel-action-', ...panel.flatMap((text) => [...text.matchAll(/\bt\(`([\w.]+)[._]\$|named\('([\w.]+)'/g)].map(([, of, by]) => `${code(of ?? by ?? '')}-`))];
  expect([...english.keys()].filter((id) => !used.has(id) && !groups.some((group) => id.startsWith(group)))).toEqual([]);
});

describe.each(Object.keys(languages))('%s', (language) => {
  const own = rows(ftl(language, 'panel'));
  /** What is left without its arguments. */
  const bare = (words: string): string => words.replace(/\{[^{}]*\}/g, '');

  test('every area is valid', () => {
    for (const area of readdirSync(new URL(`messages/${language}/`, root)).filter((name) => name.endsWith('.ftl'))) {
      const text = file(`messages/${language}/${area}`);
      expect(new FluentResource(text).body.length, area).toBe([...text.matchAll(/^[\w-]+ =/gm)].length);
    }
  });

  test('nothing is left in English', () => {
    if (language === 'en') return;
    // Names that are the same there.
    const same = new Set(['panel-role-admin', 'panel-points-way', 'panel-clearance-least']);
    const left = [...own].filter(([id, words]) => words === english.get(id) && bare(words).trim().length > 8 && !same.has(id) && /\p{L}/u.test(bare(words)));
    expect(left).toEqual([]);
    if (language === 'de') return;
    const script = language === 'zh' ? /[\u4e00-\u9fff]/ : /[\u0400-\u04ff]/;
    const foreign = [...own].filter(([id, words]) => !script.test(words) && id !== 'panel-record-no' && /\p{L}/u.test(bare(english.get(id) ?? '')));
    expect(foreign).toEqual([]);
  });

  test('no sentence is more than 2.4 times as long as the English one has room for', () => {
    for (const [id, words] of own) if (!words.includes('->')) expect(words.length, id).toBeLessThan((english.get(id) ?? '').length * 2.4 + 20);
  });
});

describe('messages', () => {
  // Written by a test of crates/server (wire/message.rs): a message as it crosses the wire, and its text in every language.
  const cases = JSON.parse(file('web/src/words/formatted.json')) as { message: MessageView; text: Record<Language | 'pseudo', string> }[];

  test.each([...Object.keys(languages), 'pseudo'] as (Language | 'pseudo')[])('are formatted as the cell formats them: %s', async (tongue) => {
    const language = tongue === 'pseudo' ? 'en' : tongue;
    const catalogue = new Catalogue(tongue, [...(await load(language, 'first')), ...(await load(language, 'rest'))]);
    expect(cases.length).toBeGreaterThan(8);
    for (const { message, text } of cases) expect(catalogue.text(message)).toBe(text[tongue]);
  });

  test('without words or without an argument are shown in the English of the cell', async () => {
    const catalogue = new Catalogue('de', await load('de', 'first'));
    expect(catalogue.text({ code: 'no-such-code', text: 'as the cell says', arguments: [] })).toBe('as the cell says');
    expect(catalogue.text({ code: 'quantity', text: 'as the cell says', arguments: [] })).toBe('as the cell says');
  });

  test('round as in Rust, without a negative zero', () => {
    const catalogue = new Catalogue('en', ['quantity = { $value }']);
    const text = (value: number, decimals: number): string => catalogue.text({ code: 'quantity', text: '', arguments: [['value', { type: 'quantity', value: { value, unit: '', decimals } }]] });
    const pairs = [[0.5, 0, '0'], [1.5, 0, '2'], [2.5, 0, '2'], [-2.5, 0, '-2'], [0.125, 2, '0.12'], [0.375, 2, '0.38'], [1.45, 1, '1.4'], [-1e-9, 2, '0.00'], [1234567.5, 1, '1234567.5']] as const;
    for (const [value, decimals, expected] of pairs) expect(text(value, decimals), `${value}`).toBe(expected);
  });
});

test('the panel speaks the language that is chosen', async () => {
  await words.begin();
  expect([words.language, t('audit.whole', { n: 1 }), t('audit.whole', { n: 1234 }), t('link.stale', { age: '2.5' })]).toEqual(['en', '1 entry', '1234 entries', 'Data 2.5 s old']);
  expect(message('as it stands')).toBe('as it stands');
  await words.choose('de');
  expect([words.language, t('audit.whole', { n: 2 }), named('mode', 'dry run'), named('mode', 'unheard of')]).toEqual(['de', '2 Einträge', 'Probelauf', 'unheard of']);
  // Words of messages and of supplied files come later.
  await vi.waitFor(() => expect(shipped('a beam is thin')).toBe('ein Strahl ist dünn'), { timeout: 30_000 });
  expect([shipped('First weld: 60 degrees of the saddle'), shipped('mine')]).toEqual(['Erste Naht: 60 Grad des Sattels', 'mine']);
  await words.choose('en');
});

test('the pseudo-language is asked for in the address', async () => {
  vi.stubGlobal('location', { search: '?language=pseudo' });
  await words.begin();
  expect([words.language, t('all'), t('recording', { weld: 7 })]).toEqual(['en', accented('All'), accented('Record ') + '7']);
  vi.stubGlobal('location', { search: '' });
});

test('every condition of the supplied machines has words', () => {
  const files = readdirSync(new URL('machines/', root)).filter((name) => name.endsWith('.toml'));
  const conditions = files.flatMap((name) => [...file(`machines/${name}`).matchAll(/\[\[interlocks\]\]\nname = "([^"]+)"/g)].map((m) => m[1] ?? ''));
  expect(new Set(conditions).size).toBeGreaterThan(8);
  expect(conditions.filter((name) => english.get(code(`interlock.${name}`)) !== name)).toEqual([]);
});

test('titles of supplied files and comments on their keys have words in every language, and no other text has', () => {
  const folders = ['examples/', 'examples/procedures/', 'machines/'];
  const files = folders.flatMap((folder) => readdirSync(new URL(folder, root)).filter((name) => name.endsWith('.toml')).map((name) => folder + name));
  const titles = files.map((path) => /^title = "(.*)"$/m.exec(file(path))?.[1] ?? '');
  // The panel shows the comments of jobs and procedures, not those of machines.
  const comments = files.filter((path) => !path.startsWith('machines/')).flatMap((path) => [...file(path).matchAll(/^((?:[a-z_.]+ *=|\])(?:[^"#\n]|"[^"\n]*")*)# *(.*)$/gm)].filter((row) => !row[1]?.trimEnd().endsWith('[')).map((row) => row[2] ?? ''));
  const shown = [...new Set([...titles, ...comments])].filter((text) => text !== '').sort();
  expect(shown.length).toBeGreaterThan(100);
  for (const language of Object.keys(languages).filter((code) => code !== 'en')) {
    const own = JSON.parse(file(`messages/${language}/shipped.json`)) as Record<string, string>;
    expect(Object.keys(own).sort(), language).toEqual(shown);
    expect(Object.entries(own).filter(([, words]) => words === ''), language).toEqual([]);
  }
});

test('every kind of finding that a plan can have has a name', () => {
  const crates = ['motion', 'weld', 'program'].map((crate) => new URL(`crates/${crate}/src/`, root));
  const files = crates.flatMap((crate) => readdirSync(crate, { recursive: true, encoding: 'utf8' }).filter((name) => name.endsWith('.rs')).map((name) => new URL(name, crate)));
  const texts = files.map((of) => readFileSync(of, 'utf8')).filter((text) => text.includes('Finding'));
  // As they are written: in the finding itself, by a helper, or in a choice of two.
  const kinds = texts.flatMap((text) => [...text.matchAll(/(?:kind: |finding\(|Finding::error\(\s*|stretches\(\()"(\w+)"|kind: if [^{]*\{ "(\w+)" \} else \{ "(\w+)" \}/g)].flatMap((m) => m.slice(1).filter(Boolean)));
  expect(new Set(kinds).size).toBeGreaterThan(15);
  expect([...new Set(kinds)].filter((kind) => !english.has(code(`finding.${kind}`)))).toEqual([]);
});
