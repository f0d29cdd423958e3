import { expect, test } from 'vitest';
import { reachedBy, waysOf, type Operation, type Way } from './point_ways';
import type { PointPass } from './points';

/** A pass with a way for each point, in spans of these. */
function pass(...spans: string[][]): PointPass {
  const rows = spans.flatMap((span, i) => span.map((along) => ({ along, span: i + 1 })));
  return {
    pass: 2,
    columns: ['x_mm', 'y_mm', 'z_mm', 'speed_mm_s'],
    arc: false,
    moving: [],
    rows: [{ along: '', span: 0 }, ...rows].map((row, i) => ({ ...row, speeds: [], numbers: [10 * i, i, 0, i === 0 || row.along === 'rapid' ? 0 : 7 + i] })),
  };
}

/** What the operations do, as the cell does them: the ways of the points that are left. */
function done(of: PointPass, operations: Operation[]): string[][] {
  const spans: string[][] = [];
  for (const row of of.rows.slice(1)) (spans[row.span - 1] ??= []).push(row.along);
  for (const operation of operations) {
    expect(operation['pass']).toBe(of.pass);
    const at = Number(operation['point'] ?? operation['from']);
    let before = 0;
    const index = spans.findIndex((span) => (before += span.length) >= at);
    const span = spans[index] ?? [];
    const within = at - (before - span.length);
    if (operation.op === 'split_span') {
      expect(within).toBeLessThan(span.length);
      spans.splice(index, 1, span.slice(0, within), span.slice(within));
    } else if (operation.op === 'delete_points') {
      span.splice(within - 1, 1);
      if (span.length === 0) spans.splice(index, 1);
    } else {
      const way = String(operation['along']);
      const changed = spans[Number(operation['span']) - 1] ?? [];
      if (way === 'arc') expect(changed.length).toBe(1);
      expect(operation['pace'] !== undefined).toBe(changed[0] === 'rapid');
      changed.fill(way);
    }
  }
  return spans;
}

const by = (of: PointPass, chosen: number[], way: Way): string[][] => {
  const made = reachedBy(of, chosen, way);
  if (typeof made === 'string') throw new Error(made);
  return done(of, made);
};

test('the chosen points, and no others, are reached in the new way, wherever spans begin', () => {
  const lines = pass(['line', 'line', 'line', 'line'], ['spline', 'spline'], ['line']);
  const count = lines.rows.length - 1;
  for (let from = 1; from <= count; from += 1) {
    for (let to = from; to <= count; to += 1) {
      const chosen = Array.from({ length: to - from + 1 }, (_, i) => from + i);
      const before = lines.rows.slice(1).map((row) => row.along);
      const wanted = before.map((along, i) => (chosen.includes(i + 1) ? 'spline' : along));
      expect(by(lines, chosen, 'spline').flat(), `${from}..${to}`).toEqual(wanted);
    }
  }
});

test('an arc goes through the first of two points, which is none any more, to the second', () => {
  const lines = pass(['line', 'line', 'line'], ['line', 'line']);
  expect(by(lines, [2, 3], 'arc')).toEqual([['line'], ['arc'], ['line', 'line']]);
  expect(by(lines, [1, 2], 'arc')).toEqual([['arc'], ['line'], ['line', 'line']]);
  // From one span to the next, and where the first is a span of its own.
  expect(by(lines, [3, 4], 'arc')).toEqual([['line', 'line'], ['arc'], ['line']]);
  expect(by(pass(['line'], ['line', 'line']), [1, 2], 'arc')).toEqual([['arc'], ['line']]);
  const made = reachedBy(lines, [2, 3], 'arc') as Operation[];
  expect(made.at(-1)?.['via_mm']).toEqual([20, 2, 0]);
});

test('a rapid move has no speed: that of the nearest point is taken', () => {
  const made = reachedBy(pass(['line'], ['rapid', 'rapid'], ['line']), [3], 'line') as Operation[];
  expect(made.at(-1)).toEqual({ op: 'interpolate', pass: 2, span: 3, along: 'line', pace: 11 });
});

test('what cannot be is said', () => {
  const lines = pass(['line', 'line', 'line']);
  expect(reachedBy(lines, [1, 3], 'spline')).toBe('row');
  expect(reachedBy(lines, [0], 'spline')).toBe('row');
  expect(reachedBy(lines, [1], 'arc')).toBe('two');
  expect(reachedBy({ ...lines, columns: ['theta', 's', 'h', 'speed_mm_s'] }, [1, 2], 'arc')).toBe('place');
  // Nothing to do; a cubic gets new speeds.
  expect(reachedBy(lines, [1, 2, 3], 'line')).toEqual([]);
  expect(reachedBy(pass(['cubic', 'cubic']), [1, 2], 'cubic')).toEqual([{ op: 'interpolate', pass: 2, span: 1, along: 'cubic' }]);
});

test('cubics are offered where there are times, rapid moves where nothing is welded', () => {
  const lines = pass(['line']);
  expect(waysOf(lines)).not.toContain('cubic');
  expect(waysOf({ ...lines, columns: ['x', 'time_s'] })).toContain('cubic');
  expect(waysOf(lines)).toContain('rapid');
  expect(waysOf({ ...lines, arc: true })).not.toContain('rapid');
});
