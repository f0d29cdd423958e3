import { readdirSync, readFileSync } from 'node:fs';
import { beforeAll, describe, expect, test, vi } from 'vitest';

vi.stubGlobal('localStorage', { getItem: () => null, setItem: () => undefined });
vi.stubGlobal('navigator', { languages: ['en'] });
const { words } = await import('./index.svelte');
const { audited, rows } = await import('./audit');
const { ofWelds } = await import('./sentences');

const crate = (name: string): string => {
  const folder = new URL(`../../../crates/${name}/src/`, import.meta.url);
  const files = readdirSync(folder, { recursive: true, encoding: 'utf8' }).filter((file) => file.endsWith('.rs') && !/tests/.test(file));
  return files.map((file) => readFileSync(new URL(file, folder), 'utf8').split('#[cfg(test)]\nmod tests')[0]).join('\n');
};
/** Strings with holes for whatever stands in them; a line that ends in a backslash goes on. */
const sources = ['cell', 'server', 'cli'].map(crate).join('\n').replace(/\\\n\s*/g, '').replace(/\\"/g, '"').replace(/\{[^{}"\n]*\}/g, '{}');
const bare = (text: string): string => text.replace(/\{\d=?\}/g, '{}');
const holes = (text: string): string[] => [...new Set([...text.matchAll(/\{(\d)=?\}/g)].map((hole) => hole[1] ?? ''))].sort();

beforeAll(() => words.choose('de'));

describe('the audit log', () => {
  test('is written in these words', () => {
    const english = [...rows.said.map(([en]) => en), ...rows.keys.map(([en]) => en)];
    expect(english.length).toBeGreaterThan(80);
    const pieces = english.flatMap((text) => text.split('|')).map((piece) => bare(piece).trim()).filter((piece) => piece !== '{}');
    expect(pieces.filter((piece) => !sources.includes(piece))).toEqual([]);
    for (const [en, ...others] of rows.said) for (const text of others) expect(holes(text), en).toEqual(holes(en));
  });

  test('has words for everything that is written to it', () => {
    // What is said there in so many words, and by what follows from a condition on the same lines.
    const calls = [...sources.matchAll(/\baudit\(((?:[^;]|\n)*?)\);/g)].map((call) => (call[1] ?? '').replaceAll('""', ''));
    const texts = calls.flatMap((call) => [...call.matchAll(/"([^"\n]{3,})"/g)].map((text) => text[1] ?? ''));
    for (const name of ['said', 'result', 'command', 'text', 'what']) {
      for (const found of sources.matchAll(new RegExp(`let (?:\\(${name}, \\w+\\)|${name}) = ([^;]{1,300});[^}]{0,400}?\\baudit\\(`, 'g'))) {
        texts.push(...[...(found[1] ?? '').matchAll(/"([^"\n]{3,})"/g)].map((text) => text[1] ?? ''));
      }
    }
    expect(texts.length).toBeGreaterThan(25);
    // Keys of events.
    const known = new Set(['tool_changed', 'sensor_changed']);
    const filled = texts.map((text) => text.replaceAll('{}', '7')).filter((text) => !known.has(text) && /[a-z]{3}/.test(text));
    expect(filled.filter((text) => audited(text) === text)).toEqual([]);
  });

  test('has words for every order, every permission and every reason of the cell', () => {
    const names = [...crate('cell').matchAll(/Self::\w+(?:\([^)]*\))? => "([a-z ]+)",/g)].map((name) => name[1] ?? '');
    const orders = [...(/impl Ask \{[\s\S]*?\n\}/.exec(crate('cell'))?.[0] ?? '').matchAll(/=> "([^"]+)"/g)].map((order) => order[1] ?? '');
    expect(orders.length).toBeGreaterThan(15);
    expect(names).toEqual(expect.arrayContaining(orders));
    // Not written to it: jogging as it goes, questions.
    expect(orders.filter((order) => !['why'].includes(order) && audited(order) === order)).toEqual([]);
    const permissions = [...(/const NEEDS[^;]*;[\s\S]*?\];/.exec(crate('server'))?.[0] ?? '').matchAll(/\("([^"]+)"/g)].map((name) => name[1] ?? '');
    expect(permissions.length).toBeGreaterThan(30);
    expect(permissions.filter((name) => audited(name) === name)).toEqual([]);
    const reasons = /impl Missing \{[\s\S]*?\n\}/.exec(crate('cell'))?.[0] ?? '';
    const said = [...reasons.matchAll(/"([a-z`][^"]{15,})"/g)].map((reason) => (reason[1] ?? '').replace(/\{[^{}]*\}/g, '7'));
    expect(said.length).toBeGreaterThan(10);
    expect(said.filter((reason) => audited(reason) === reason)).toEqual([]);
  });

  test('has words for every order to the teaching by eye', () => {
    const orders = /pub enum TeachOrder \{[\s\S]*?\n\}/.exec(crate('server'))?.[0] ?? '';
    const names = [...orders.matchAll(/^ {4}(\w+) \{/gm)].map((name) => name[1] ?? '');
    const details = ['Open: step 5 mm, tacks up to 10 mm, seed 1', 'Open: step 5 mm, tacks up to 10 mm, seed 1, a tack from 20 to 30 mm', 'Here: pixel 120.0, 80.5', 'Here: X 1.00 Y -2.00 Z 3.00 mm', 'Here: where the eye looks'];
    const texts = [...names.filter((name) => name !== 'Open' && name !== 'Here'), ...details];
    expect([names.length, texts.length]).toEqual([6, 9]);
    for (const text of texts) expect(audited(`teach: ${text}`).includes(text.split(':')[0] ?? ''), text).toBe(false);
    expect(audited(`teach: ${details[1]}`)).toBe('Teachen: Kamera öffnen: Schritt 5 mm, Heftstellen bis 10 mm, Startwert 1, eine Heftstelle von 20 bis 30 mm');
  });

  test('is told with what stands in it, names as they are', async () => {
    expect(audited('save job stop.toml')).toBe('Auftrag stop.toml speichern');
    expect(audited('change user hold')).toBe('Benutzer hold ändern');
    expect(audited('acknowledge condition not met (shielding gas)')).toBe('quittieren: Bedingung nicht erfüllt (Schutzgas)');
    expect(audited('override 50 %')).toBe('Override 50 %');
    expect(audited('set axis x in saddle.toml')).toBe('Achse x in saddle.toml ändern');
    expect(audited('simulate: weld 3 of part "N-17"')).toBe('simulate: Schweißung 3, Werkstück "N-17"');
    expect(audited('Operator, disabled')).toBe('Bediener, gesperrt');
    expect(audited('`start weld` has no meaning in mode fault: allowed in ready, hold')).toBe('Nur erlaubt im Zustand: Bereit, Halt.');
    expect(audited('alarm `drive fault` (axis x): read the drive\'s own code, reset it, then acknowledge')).toBe('Alarm: Antriebsstörung (Achse x). Beheben, dann quittieren.');
    expect(audited('alarm `no arc or beam`: clean, check wire and earth, go on, then acknowledge')).toContain('Kein Bogen oder Strahl');
    expect(audited('panel at 127.0.0.1')).toBe('Panel auf 127.0.0.1');
    expect(['what nobody has said', '', 'tip_mm [0.0, 1.0, 2.0]', 'ab'.repeat(32)].map(audited)).toEqual(['what nobody has said', '', 'tip_mm [0.0, 1.0, 2.0]', 'ab'.repeat(32)]);
    await words.choose('en');
    expect(audited('log in')).toBe('log in');
    expect(ofWelds.length).toBeGreaterThan(20);
  });
});
