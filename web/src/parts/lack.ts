import type { LackView } from '../wire';
import { about, alarmTitle, isKey, named, t } from '../words/index.svelte';
import { ARGUMENTS } from '../words/panel';

/** A lack in the chosen language, with the names in it; keys without words keep those of the cell. */
export function lackText(lack: LackView): string {
  const key = `lack.${lack.key}`;
  if (!isKey(key)) return lack.text;
  const names = lack.of.map((name, i) => {
    if (lack.key === 'mode') return named('mode', name.replaceAll(' ', '_'));
    // The alarm, and which condition or axis it is about.
    if (lack.key === 'alarm') return i === 0 ? alarmTitle(name) : about(name);
    if (lack.key === 'silent') return named('device', name);
    if (lack.key === 'condition') return named('interlock', name);
    return name;
  });
  // Words with several places take the names one by one, others all of them in one.
  return (ARGUMENTS[key as keyof typeof ARGUMENTS] ?? []).length > 1 ? t(key, ...names) : t(key, names.join(', '));
}
