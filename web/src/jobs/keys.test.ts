import { existsSync, readdirSync, readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { languages, words } from '../words/index.svelte';
import { keyTitle, pathTitle } from './keys';

/** Names of axes and of process values beyond the usual are the file's own. */
const OWN = new Set(['a', 'b', 's', 'a_mm', 'b_mm', 's_mm']);
const root = new URL('../../../', import.meta.url);
/** Written by `scripts/generate`. */
const schema = new URL('web/generated/job.json', root);

test.skipIf(!existsSync(schema))('every key of the examples, and every key and name that their formats allow, has words in every language', async () => {
  const names = new Set<string>();
  for (const folder of ['examples/', 'examples/procedures/']) {
    for (const file of readdirSync(new URL(folder, root)).filter((name) => name.endsWith('.toml'))) {
      const text = readFileSync(new URL(folder + file, root), 'utf8').replace(/"[^"\n]*"|#.*/g, '');
      for (const [, header, key] of text.matchAll(/^\[+([^\]]+)\]|([\w.]+) *=/gm)) for (const name of (header ?? key ?? '').split('.')) names.add(name);
    }
  }
  JSON.parse(readFileSync(schema, 'utf8'), (key, value: unknown) => {
    if (key === 'properties' && typeof value === 'object' && value !== null) for (const name of Object.keys(value)) names.add(name);
    if (key === 'enum' && Array.isArray(value)) for (const name of value) names.add(String(name));
    if (key === 'const' && typeof value === 'string') names.add(value);
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
  expect(pathTitle('passes[0].points.spans[2]')).toBe('Lagen 1 · Punkte · Abschnitte 3');
  await words.choose('en');
  expect(keyTitle('root_gap_mm')).toBe('root gap [mm]');
  expect(keyTitle('wire_feed_m_min')).toBe('wire feed [m/min]');
});
