import { expect, test } from 'vitest';
import { words } from '../words/index.svelte';
import { caption } from './captions';
import { merged, nearest, preferred, rowAt } from './traces';

test('two traces over one path length, each with its own places', () => {
  const trace = (s: (number | null)[], v: number[]) => ({ columns: ['pass', 's_mm', 'v'], values: [s.map(() => 1), s, v] });
  const [places, first, second] = merged([trace([0, 2, 1, 4, null], [1, 2, 9, 3, 9]), trace([1, 3], [5, 6])], 'v', 1);
  expect(places).toEqual([0, 1, 2, 3, 4]);
  // The row that goes back from 2 to 1 is not drawn; what happens where the torch stands is.
  expect(merged([trace([0, 2, 2, 2], [1, 2, 9, 2])], 'v', 1)[1]).toEqual([1, 2, 9, 2]);
  expect(first).toEqual([1, null, 2, null, 3]);
  expect(second).toEqual([null, 5, null, 6, null]);
  expect(merged([trace([0], [1])], 'v', 2)).toEqual([[], []]);
});

test('the columns that matter come first, and none that says little', () => {
  expect(preferred(['theta_set_deg', 'path_error_mm', 'tip_speed_mm_s'])).toEqual(['tip_speed_mm_s', 'path_error_mm']);
  // Of a weld in the cell: what was measured, not what was set, nor whether the drives had power.
  expect(preferred(['speed_set_mm_s', 'tip_speed_mm_s'])).toEqual(['tip_speed_mm_s']);
  const cell = ['mode', 'speed_set_mm_s', 'power', 'theta_following_error_deg', 'theta_current_part', 'current_a_set', 'current_a_measured', 'voltage_v_set', 'voltage_v_measured'];
  expect(preferred(cell)).toEqual(['speed_set_mm_s', 'current_a_measured', 'voltage_v_measured', 'theta_following_error_deg']);
  expect(preferred(['speed_set_mm_s', 'beam_ma_measured', 'accelerating_kv_measured'])).toEqual(['speed_set_mm_s', 'beam_ma_measured', 'accelerating_kv_measured']);
  expect(preferred(['odd', 'other'])).toEqual(['odd', 'other']);
});

test('a weld that was tracked begins with its deviation and correction', () => {
  const tracked = ['speed_set_mm_s', 'tip_speed_mm_s', 'path_error_mm', 'theta_following_error_deg', 'deviation_lateral_mm', 'deviation_height_mm', 'correction_lateral_mm', 'correction_height_mm', 'sigma_mm', 'current_a_set', 'current_a'];
  expect(preferred(tracked)).toEqual(['deviation_lateral_mm', 'deviation_height_mm', 'correction_lateral_mm', 'correction_height_mm', 'tip_speed_mm_s', 'path_error_mm']);
  // Of several heads the first.
  expect(preferred(['tip_speed_mm_s', 'deviation_lateral_mm_left', 'deviation_lateral_mm_right'])).toEqual(['deviation_lateral_mm_left', 'tip_speed_mm_s']);
});

test('a place has the value of its row, or the nearest one that the trace has', () => {
  expect(rowAt([0, 1, 2.5, 4], 2)).toBe(2);
  expect(rowAt([], 2)).toBe(0);
  expect(nearest([5, null, null, 6], 1)).toBe(5);
  expect(nearest([5, null, null, 6], 2)).toBe(6);
  expect(nearest([null, 0], 1)).toBe(0);
  // A shorter weld has no value beyond its end.
  expect(nearest([null, 0, null], 2)).toBe(null);
  expect(nearest([null, 0, null], 0)).toBe(null);
  expect(nearest([null, null], 1)).toBe(null);
});

test('columns of traces have words and units', async () => {
  await words.choose('en');
  expect(caption('speed_set_mm_s', 'mm/s')).toBe('Path speed Set mm/s');
  expect(caption('theta_following_error_deg', 'deg')).toBe('theta: Following error °');
  expect(caption('b_2_current_part', '1')).toBe('b_2: Current (1 = 100 %)');
  expect(caption('deviation_lateral_mm', 'mm')).toBe('Seam deviation, lateral mm');
  expect(caption('correction_height_mm_q', 'mm')).toBe('q: Correction, height mm');
  expect(caption('wire_feed_m_min_set', '')).toBe('Wire feed Set m/min');
  expect(caption('wire_feed_m_min', '')).toBe('Wire feed Actual m/min');
  expect(caption('burning', '1')).toBe('Arc or beam is on');
});
