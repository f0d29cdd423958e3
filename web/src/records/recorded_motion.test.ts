import { expect, test } from 'vitest';
import type { MachineView } from '../wire';
import { axesAt, columnsOf, moves } from './recorded_motion';

const machine = { axes: [{ name: 'theta', unit: 'deg' }, { name: 's', unit: 'mm' }] } as MachineView;

test('a trace has the axes of this machine, or says nothing of it', () => {
  const names = ['t_s', 'pass', 's_mm', 'burning', 'theta_measured_deg', 's_measured_mm', 'arc'];
  expect(columnsOf(machine, names)).toEqual(['pass', 's_mm', 'burning', 'theta_measured_deg', 's_measured_mm']);
  expect(columnsOf(machine, names.filter((name) => name !== 's_measured_mm'))).toBeNull();
});

test('the axes stand where they were when the torch first came there', () => {
  // It goes to 2, is taken back to 1 with other axes, and goes on to 3; then the second pass.
  const of = moves({
    columns: [],
    values: [[1, 1, 1, 1, 1, 2], [0, 1, 2, 1, 3, 1], [0, 1, 1, 0, 1, 1], [10, 11, 12, 99, 13, 21], [0, 0, 0, 0, null, 5]],
  });
  expect(axesAt(of, 1, 1.1)).toEqual({ axes: [11, 0], burns: true });
  expect(axesAt(of, 1, -5)).toEqual({ axes: [10, 0], burns: false });
  expect(axesAt(of, 2, 1)).toEqual({ axes: [21, 5], burns: true });
  expect(axesAt(of, 1, 3)).toBeNull();
  expect(axesAt(of, 3, 0)).toBeNull();
});
