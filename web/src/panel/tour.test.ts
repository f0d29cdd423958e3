import { expect, test } from 'vitest';
import { lead, STEPS, type Seen } from './tour';

const before: Seen = {
  mine: false, powered: false, mode: 'off', armed: false, work: true, elsewhere: false, left: false, goesOn: false, burned: false, records: false,
};
const after = (...changes: Partial<Seen>[]): string => {
  const { key } = lead(Object.assign({}, before, ...changes) as Seen);
  return key.replace('tour.', '');
};
const ready: Partial<Seen> = { mine: true, powered: true, mode: 'ready' };

test('the straight way, step by step', () => {
  const way: Partial<Seen>[] = [
    {},
    { mine: true },
    { mine: true, powered: true, mode: 'idle' },
    ready,
    { ...ready, armed: true },
    { ...ready, mode: 'weld', armed: false, burned: true },
    { ...ready, burned: true },
  ];
  const led = way.map((seen) => lead({ ...before, ...seen }));
  expect(led.map(({ step }) => step)).toEqual([1, 2, 3, 4, 5, 6, STEPS]);
  expect(led.map(({ key }) => key.replace('tour.', ''))).toEqual(['control', 'on', 'home', 'arm', 'weld', 'watch', 'record']);
  expect(after(ready, { burned: true, records: true })).toBe('end');
});

test('beside the way it says what leads back to it', () => {
  expect(after(ready, { work: false })).toBe('load');
  // In a dry run nothing can be armed.
  expect(after(ready, { mode: 'dry_run' })).toBe('dry');
  expect(after(ready, { mode: 'jog' })).toBe('jog');
  expect(after(ready, { mode: 'hold', burned: true })).toBe('hold');
  expect(after(ready, { mode: 'fault' })).toBe('fault');
  expect(after(ready, { elsewhere: true })).toBe('again');
  // A weld that was stopped is not done, and is gone on with, also without power.
  expect(after(ready, { left: true })).toBe('left');
  expect(after(ready, { left: true, burned: true, records: true })).toBe('left');
  // Once the program goes on there, it is armed and started like any other.
  expect(after(ready, { left: true, goesOn: true })).toBe('arm');
  expect(after(ready, { left: true, goesOn: true, elsewhere: true })).toBe('again');
  expect(after({ mine: true, left: true })).toBe('on');
  // Control that was lost comes before what needs it, but not while something burns.
  expect(after(ready, { mine: false })).toBe('control');
  expect(after(ready, { mine: false, mode: 'hold', burned: true })).toBe('control');
  expect(after(ready, { mine: false, mode: 'weld', burned: true })).toBe('watch');
});
