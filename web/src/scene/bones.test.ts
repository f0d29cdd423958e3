import { expect, test } from 'vitest';
import type { MachineView } from '../wire';
import { bones, jointsOf } from './bones';

/** Two turning axes on a rail; the work is link 0, the base link 1. */
const machine = {
  arm: true,
  base: 1,
  torch: 4,
  axes: [{ name: 'rail', unit: 'mm' }, { name: 'j1', unit: 'deg' }, { name: 'j2', unit: 'deg' }, { name: 'table', unit: 'deg' }],
  frames: [{ name: 'torch', link: 4, frame: [1, 0, 0, 700, 0, 1, 0, 0, 0, 0, 1, 900] }],
  joints: [
    null,
    { on: 0, axis: 3, direction: [0, 0, 1], at: [0, 0, 0] },
    { on: 1, axis: 0, direction: [1, 0, 0], at: [0, 0, 0] },
    { on: 2, axis: 1, direction: [0, 0, 1], at: [0, 0, 100] },
    { on: 3, axis: 2, direction: [0, 1, 0], at: [0, 0, 500] },
  ],
} as unknown as MachineView;

test('the chain runs from the base to the torch, and each rod moves with its link', () => {
  expect(jointsOf(machine).map((joint) => joint.link)).toEqual([2, 3, 4]);
  const made = bones(machine, []);
  // Joint, rod and its end on j1; joint, rod and its end on j2: the rail has none.
  expect(made.map((bone) => bone.link)).toEqual([3, 3, 3, 4, 4, 4]);
  expect(bones({ ...machine, arm: false }, [])).toEqual([]);
});
