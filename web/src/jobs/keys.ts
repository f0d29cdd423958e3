import { valueName } from '../parts/numbers';
import { named, words } from '../words/index.svelte';
import { keys } from '../words/keys';

/** A key of a file, or a word that stands there, in the chosen language, with the unit that it ends in; as it is where there is no word. */
export function keyTitle(name: string): string {
  const { language } = words;
  // What looks like a unit may be none: a `single_v` has no volts.
  const whole = keys[name];
  if (whole) return whole[language] ?? name.replaceAll('_', ' ');
  const { title, unit } = valueName(name);
  const known = keys[title.replaceAll(' ', '_')];
  const word = known?.[language] ?? (language === 'en' ? title : named('value', title));
  return unit ? `${word} [${unit}]` : word;
}

/** A table's path in words, lists counted from 1. */
export function tableTitle(table: string): string {
  const titles = table.split('.').map((part, i, all) => (/^\d+$/.test(part) ? '' : `${keyTitle(part)} ${/^\d+$/.test(all[i + 1] ?? '') ? Number(all[i + 1]) + 1 : ''}`.trim()));
  return titles.filter((title) => title !== '').join(' · ');
}
