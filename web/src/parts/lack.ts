import type { LackView } from '../wire';
import { alarmWords, named, t } from '../words/index.svelte';
import { en, type Key } from '../words/en';

/** A lack in the chosen language, with the names in it; keys without words keep those of the cell. */
export function lackText(lack: LackView): string {
  const key = `lack.${lack.key}`;
  if (!(key in en)) return lack.text;
  const blank = { cause: '', consequence: '', action: '' };
  const names = lack.of.map((name) => {
    if (lack.key === 'mode') return named('mode', name.replaceAll(' ', '_'));
    if (lack.key === 'alarm') return alarmWords({ name, ...blank }).name;
    if (lack.key === 'silent') return named('device', name);
    return name;
  });
  return t(key as Key, names.join(', '));
}
