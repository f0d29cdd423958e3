import { expect, test } from 'vitest';
import type { SeamRow } from '../wire';
import { columns, counts, filtered, sorted, type Column } from './rows';

const row = (number: number, of: Partial<SeamRow> = {}): SeamRow => ({
  number, name: `N${number}`, template: 'hillside', machines: [], count: 1, setup_min: 0, status: 'waiting', machine: '', passes: 0, length_mm: 0,
  total_s: 0, arc_s: 0, wire_kg: null, gas_l: null, energy_kj: null, cost: null, clearance_mm: null, blocking: 0, findings: [], error: null, ...of,
});

const rows = [
  row(1, { name: 'N10', status: 'weldable', machine: 'ur10e', passes: 2, total_s: 300, wire_kg: 0.2 }),
  row(2, { name: 'N2', status: 'not_weldable', machine: 'kr-16', findings: [['motion-axis-beyond', 3]] }),
  row(3, { name: 'N1', status: 'weldable', machine: 'kr-16', passes: 1, total_s: 90 }),
  row(4, { name: 'N3' }),
];
const names = (of: SeamRow[]): string => of.map((one) => one.name).join(' ');

test('rows are sorted as people count, and what is missing comes last', () => {
  expect(names(sorted(rows, 'name', false))).toBe('N1 N2 N3 N10');
  expect(names(sorted(rows, 'name', true))).toBe('N10 N3 N2 N1');
  expect(names(sorted(rows, 'time', false))).toBe('N1 N10 N2 N3');
  expect(names(sorted(rows, 'time', true))).toBe('N10 N1 N2 N3');
  expect(names(sorted(rows, 'wire', true))).toBe('N10 N2 N1 N3');
  // Equal ones stay in the order of the table, and nothing is lost or added by any column.
  for (const by of Object.keys(columns) as Column[]) {
    for (const down of [true, false]) expect(sorted(rows, by, down).map((one) => one.number).sort()).toEqual([1, 2, 3, 4]);
  }
});

test('rows are filtered by result and by any text of theirs', () => {
  expect(names(filtered(rows, 'weldable', ''))).toBe('N10 N1');
  expect(names(filtered(rows, '', 'KR-16'))).toBe('N2 N1');
  expect(names(filtered(rows, 'weldable', 'kr-16'))).toBe('N1');
  expect(names(filtered(rows, '', 'axis-beyond'))).toBe('N2');
  expect(filtered(rows, '', '')).toHaveLength(4);
  expect(counts(rows)).toEqual([['weldable', 2], ['not_weldable', 1], ['waiting', 1]]);
});
