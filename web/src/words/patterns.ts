import type { Language } from './index.svelte';

/** A sentence in English, with holes `{0}`, `{1}` .. for what stands in it, and in every other language. */
export type Row = readonly [en: string, uk: string, zh: string, de: string, ru: string];

/** An English sentence with holes, and what it is in a language. What stands in a hole `{0=}` is a name and stays as it is; only a number, perhaps with its key, stands in `{0#}`. */
export type Pattern = readonly [en: string, of: (language: Exclude<Language, 'en'>) => string];

const COLUMNS: Record<Language, 0 | 1 | 2 | 3 | 4> = { en: 0, uk: 1, zh: 2, de: 3, ru: 4 };
const HOLE = /\{(\d)([=#]?)\}/g;
const NUMBER = '((?:[a-z0-9_]+ = )?-?[\\d.]+(?:e-?\\d+)?)';

export const ofRow = (row: Row): Pattern => [row[0], (language) => row[COLUMNS[language]]];

const literal = (text: string): string => text.replace(/[.*+?^${}()|[\]\\]/g, '\\$&');

/**
 * Finds sentences again by their patterns and says them in a language; what no pattern fits stays as it came. `word` knows what is no
 * sentence: names of alarms, of modes, and gives anything else back.
 */
export function matcher(patterns: readonly Pattern[]): (text: string, language: Language, word?: (text: string) => string) => string {
  const whole = new Map(patterns.filter(([en]) => !/\{\d|\|/.test(en)));
  const compiled = patterns.filter(([en]) => !whole.has(en)).map(([en, of]) => {
    const text = en.replaceAll('|', '');
    const parts = text.split(/\{\d[=#]?\}/).map(literal);
    const holes = [...text.matchAll(HOLE)].map((hole) => ({ number: hole[1] ?? '', name: hole[2] !== '', is: hole[2] === '#' ? NUMBER : '(.*?)' }));
    const all = parts.map((part, i) => `${i > 0 ? (holes[i - 1]?.is ?? '') : ''}${part}`).join('');
    return { of, holes, said: parts.join('').length, pattern: new RegExp(`^${all}$`) };
  });
  // Those that say most come first: a pattern of few words fits much.
  compiled.sort((a, b) => b.said - a.said || a.holes.length - b.holes.length);

  return function sentence(text, language, word = (of) => of): string {
    if (language === 'en' || text === '') return text;
    // What is told in several lines is several sentences.
    if (text.includes('\n')) return text.split('\n').map((line) => line.replace(/\S.*/, (said) => sentence(said, language, word))).join('\n');
    const own = word(text);
    if (own !== text) return own;
    const same = whole.get(text);
    if (same) return same(language);
    for (const { of, holes, pattern } of compiled) {
      const found = pattern.exec(text);
      if (!found) continue;
      const filled = new Map(holes.map(({ number, name }, i) => [number, name ? (found[i + 1] ?? '') : sentence(found[i + 1] ?? '', language, word)]));
      return of(language).replace(HOLE, (_, number: string) => filled.get(number) ?? '');
    }
    // What a machine says of itself, or a sensor: its name or what is the matter, then why.
    const named = /^([^:;]{1,40}): (.+)$/.exec(text);
    return named ? `${sentence(named[1] ?? '', language, word)}: ${sentence(named[2] ?? '', language, word)}` : text;
  };
}
