import { expect, test } from 'vitest';
import { merged, preferred } from './traces';

test('two traces over one path length, each with its own places', () => {
  const trace = (s: (number | null)[], v: number[]) => ({ columns: ['pass', 's_mm', 'v'], values: [s.map(() => 1), s, v] });
  const [places, first, second] = merged([trace([0, 2, 1, 4, null], [1, 2, 9, 3, 9]), trace([1, 3], [5, 6])], 'v', 1);
  expect(places).toEqual([0, 1, 2, 3, 4]);
  // The row that goes back from 2 to 1 is not drawn.
  expect(first).toEqual([1, null, 2, null, 3]);
  expect(second).toEqual([null, 5, null, 6, null]);
  expect(merged([trace([0], [1])], 'v', 2)).toEqual([[], []]);
});

test('the columns that matter come first, and none that says little', () => {
  expect(preferred(['theta_set_deg', 'path_error_mm', 'tip_speed_mm_s'])).toEqual(['tip_speed_mm_s', 'path_error_mm']);
  // Of a weld in the cell: what was measured, not what was set, nor whether the drives had power.
  const cell = ['mode', 'speed_set_mm_s', 'power', 'theta_following_error_deg', 'theta_current_part', 'current_a_set', 'current_a_measured', 'voltage_v_set', 'voltage_v_measured'];
  expect(preferred(cell)).toEqual(['speed_set_mm_s', 'current_a_measured', 'voltage_v_measured', 'theta_following_error_deg']);
  expect(preferred(['speed_set_mm_s', 'beam_ma_measured', 'accelerating_kv_measured'])).toEqual(['speed_set_mm_s', 'beam_ma_measured', 'accelerating_kv_measured']);
  expect(preferred(['odd', 'other'])).toEqual(['odd', 'other']);
});
