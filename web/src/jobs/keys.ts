import { valueName } from '../parts/numbers';
import { named, words } from '../words/index.svelte';

/** The words of a key without its unit, or of a word that stands in a file. */
function keyWords(name: string): string | null {
  return words.catalogue.words(`key-${name.replaceAll(/[_ ]/g, '-')}`, {});
}

/** A key of a file, or a word that stands there, in the chosen language, with the unit that it ends in; as it is where there is no word. */
export function keyTitle(name: string): string {
  // The end may only look like a unit: a `single_v` has no volts.
  const whole = keyWords(name);
  if (whole !== null) return whole;
  const { title, unit } = valueName(name);
  const word = keyWords(title) ?? (words.language === 'en' ? title : named('value', title));
  return unit ? `${word} [${unit}]` : word;
}

/** A table's path in words, lists counted from 1. */
export function tableTitle(table: string): string {
  const titles = table.split('.').map((part, i, all) => (/^\d+$/.test(part) ? '' : `${keyTitle(part)} ${/^\d+$/.test(all[i + 1] ?? '') ? Number(all[i + 1]) + 1 : ''}`.trim()));
  return titles.filter((title) => title !== '').join(' · ');
}
