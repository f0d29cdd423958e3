import type { JudgedView } from '../wire';

/** Which of a value's figures are outside what is allowed. */
export type Outside = { least: boolean; mean: boolean; greatest: boolean };

const INSIDE: Outside = { least: false, mean: false, greatest: false };

/** A value is outside its window only where the torch went on while it was: in a hold or a ramp at rest nothing is welded. */
export function outside(value: JudgedView): Outside {
  const { allowed } = value;
  if (!allowed || !(value.outside_mm > 0)) return INSIDE;
  const beyond = (of: number): boolean => of < allowed[0] || of > allowed[1];
  return { least: beyond(value.least), mean: beyond(value.mean), greatest: beyond(value.greatest) };
}

export const isOutside = (value: JudgedView): boolean => Object.values(outside(value)).includes(true);
