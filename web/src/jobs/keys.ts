import { valueName } from '../panel/numbers';
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

/** A path in words, elements of lists counted from 1. */
export function pathTitle(path: string): string {
  const part = (of: string): string => of.replace(/^[^[]+/, keyTitle).replace(/\[(\d+)\]/g, (_, nth: string) => ` ${Number(nth) + 1}`);
  return path.split('.').map(part).join(' · ');
}
