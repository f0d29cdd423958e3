import { readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { isWild, meaning } from './parameters';

const catalogue = readFileSync(new URL('../../../messages/en/panel.ftl', import.meta.url), 'utf8');
const hasWords = (key: string): boolean => catalogue.includes(`\npanel-${key.replace(/[._ ]/g, '-')} = `);

test('every parameter of an axis has a word and the unit that its key ends in', () => {
  const rust = readFileSync(new URL('../../../crates/server/src/view/parameters.rs', import.meta.url), 'utf8');
  const rows = [...rust.matchAll(/^ {4}\("(\w+)", "(\w+)", (Some|None)/gm)];
  expect(rows.length).toBe(Number(/PARAMETERS: .*; (\d+)\]/.exec(rust)?.[1]));
  for (const [, key = '', group = ''] of rows) {
    const { word, unit } = meaning(key);
    expect(hasWords(`par.${word}`), key).toBe(true);
    expect(hasWords(`par.group.${group}`), group).toBe(true);
    const bare = ['kd', 'kvff', 'load_ratio'].includes(key);
    expect(unit === '', key).toBe(bare);
  }
  // What differs by the kind of axis differs by its unit only.
  expect(meaning('max_speed_mm_s')).toEqual({ word: 'max speed', unit: 'mm/s' });
  expect(meaning('max_speed_deg_s')).toEqual({ word: 'max speed', unit: '°/s' });
  expect(meaning('torque_limit_n_m')).toEqual({ word: 'limit', unit: 'N m' });
  expect(meaning('force_limit_n')).toEqual({ word: 'limit', unit: 'N' });
  expect(meaning('inertia_kg_m2')).toEqual({ word: 'inertia', unit: 'kg m²' });
  expect(meaning('viscous_n_m_s_rad').unit).toBe('N m s/rad');
});

test('a key too many is asked about, a usual change is not', () => {
  for (const [was, now, wild] of [[80, 800, true], [80, 8, true], [80, -80, true], [80, 1e9, true], [80, 240, false], [80, 79, false], [0, 5, false], [5, 0, false], [NaN, 5, false], [5, NaN, false]] as const) {
    expect(isWild(was, now), `${was} ${now}`).toBe(wild);
  }
});

test('what tuning measures has a word and a unit', () => {
  const rust = readFileSync(new URL('../../../crates/server/src/view/tuning.rs', import.meta.url), 'utf8');
  const values = rust.slice(rust.indexOf('\nfn values('));
  const keys = [...values.matchAll(/"([a-z_{}]+)"/g)].map(([, key = '']) => key.replace('{unit}', 'mm'));
  expect(keys).toContain('load_error_mm');
  for (const key of keys) {
    const { word, unit } = meaning(key);
    expect(hasWords(`par.${word}`), key).toBe(true);
    expect(unit === '', key).toBe(['kvff', 'following_error_counts'].includes(key));
  }
});
