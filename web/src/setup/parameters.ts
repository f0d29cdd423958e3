import { valueName } from '../panel/numbers';

/** Words of keys that are not those of their name without its unit. */
const WORDS: Record<string, string> = {
  'force limit': 'limit',
  'torque limit': 'limit',
  'peak force': 'peak',
  'peak torque': 'peak',
  mass: 'inertia',
  'backlash compensation ms': 'backlash time',
  'following error counts': 'following counts',
  notch: 'notch at',
};

/** A key of a machine file as what it means and its unit: `max_speed_mm_s` is the highest speed in mm/s. */
export function meaning(key: string): { word: string; unit: string } {
  const { title, unit } = valueName(key);
  return { word: WORDS[`${title} ${unit}`] ?? WORDS[title] ?? title, unit };
}

/** So many times more or less than it was, a number is asked about: a key too many is ten times. */
const MUCH = 4;

/** A number is several times more or less than it was, or has another sign. */
export function isWild(was: number, now: number): boolean {
  if (!Number.isFinite(was) || !Number.isFinite(now) || was === 0 || now === 0) return false;
  return now / was > MUCH || now / was < 1 / MUCH;
}
