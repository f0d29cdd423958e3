import { readdirSync, readFileSync } from 'node:fs';
import { expect, test, vi } from 'vitest';
import { ADDABLE, PREPARATIONS } from './tables';
import { read } from './toml';

vi.stubGlobal('localStorage', { getItem: () => null, setItem: () => undefined });
vi.stubGlobal('navigator', { languages: ['en'] });

/** Names of axes and of process values beyond the usual are the file's own. */
const OWN = new Set(['a', 'b', 's', 'a_mm', 'b_mm', 's_mm']);

test('every key of the examples, of added tables and of those that the format allows has words in every language', async () => {
  const { words, languages } = await import('../words/index.svelte');
  const { keyTitle, tableTitle } = await import('./keys');
  const names = new Set([...ADDABLE, ...Object.entries(PREPARATIONS).flatMap(([kind, sizes]) => [kind, ...Object.keys(sizes)])]);
  for (const folder of ['examples/', 'examples/procedures/']) {
    const url = new URL(`../../../${folder}`, import.meta.url);
    for (const file of readdirSync(url).filter((name) => name.endsWith('.toml'))) {
      for (const { table, key, value } of read(readFileSync(new URL(file, url), 'utf8'))) {
        for (const name of [...table.split('.'), key, ...(value.kind === 'table' ? value.entries.map((of) => of.key) : [])]) names.add(name);
      }
    }
  }
  const schema = readFileSync(new URL('../../../docs/schema/job.json', import.meta.url), 'utf8');
  JSON.parse(schema, (key, value: unknown) => {
    if (key === 'properties' && typeof value === 'object' && value !== null) for (const name of Object.keys(value)) names.add(name);
    return value;
  });
  const wanted = [...names].filter((name) => /[a-z]/.test(name) && name !== 'schema' && !OWN.has(name));
  expect(wanted.length).toBeGreaterThan(100);
  for (const language of Object.keys(languages) as (keyof typeof languages)[]) {
    await words.choose(language);
    const script = { en: /[a-z]/, de: /[a-zß]/i, zh: /[\u4e00-\u9fff]/, uk: /[\u0400-\u04ff]/, ru: /[\u0400-\u04ff]/ }[language];
    expect(wanted.filter((name) => !script.test(keyTitle(name).replace(/\[.*\]/, ''))), language).toEqual([]);
  }
  await words.choose('de');
  expect(keyTitle('root_gap_mm')).toBe('Stegabstand [mm]');
  expect(keyTitle('single_v')).toBe('V-Naht');
  expect(tableTitle('passes.0.points.spans.2')).toBe('Lagen 1 · Punkte · Abschnitte 3');
  await words.choose('en');
  expect(keyTitle('root_gap_mm')).toBe('root gap [mm]');
  expect(keyTitle('wire_feed_m_min')).toBe('wire feed [m/min]');
  // Loading all words takes a while on a busy computer.
}, 60_000);
