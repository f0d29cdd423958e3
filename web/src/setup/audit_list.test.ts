import { expect, test } from 'vitest';
import type { AuditRow } from '../wire';
import { begun, further, renewed } from './audit_list';

const said = { code: 'text', text: '', arguments: [] };
const page = (from: number, to: number): AuditRow[] => Array.from({ length: from - to + 1 }, (_, i) => ({ id: from - i, at: '', user: '', station: said, command: said, old: '', new: '', result: said }));
const ids = (of: { rows: AuditRow[] }): number[] => of.rows.map((row) => row.id);

test('a page that is full says that there are older ones', () => {
  expect(begun(page(9, 7), 3).older).toBe(true);
  const more = further(begun(page(9, 7), 3), page(6, 4), 3);
  expect(ids(more)).toEqual([9, 8, 7, 6, 5, 4]);
  expect(more.older).toBe(true);
  expect(further(more, page(3, 2), 3).older).toBe(false);
  expect(begun([], 3)).toEqual({ rows: [], older: false });
});

test('what is new stands before the rest, once, and never with a gap', () => {
  const list = begun(page(9, 7), 3);
  expect(renewed(list, [], 3)).toEqual(list);
  expect(ids(renewed(list, page(10, 9), 3))).toEqual([10, 9, 8, 7]);
  // More than a page came: what is between is not known.
  expect(renewed(list, page(30, 28), 3)).toEqual({ rows: page(30, 28), older: true });
});
