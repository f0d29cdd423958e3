import type { LackView } from '../wire';
import { about, alarmTitle, named, said, t } from '../words/index.svelte';
import { en, type Key } from '../words/en';

/** A lack in the chosen language, with the names in it; keys without words keep those of the cell. */
export function lackText(lack: LackView): string {
  const key = `lack.${lack.key}`;
  if (!(key in en)) return said(lack.text);
  const names = lack.of.map((name, i) => {
    if (lack.key === 'mode') return named('mode', name.replaceAll(' ', '_'));
    // The alarm, and which condition or axis it is about.
    if (lack.key === 'alarm') return i === 0 ? alarmTitle(name) : about(name);
    if (lack.key === 'silent') return named('device', name);
    if (lack.key === 'condition') return named('interlock', name);
    return name;
  });
  // Words with several places take the names one by one, others all of them in one.
  return en[key as Key].includes('{1}') ? t(key as Key, ...names) : t(key as Key, names.join(', '));
}
