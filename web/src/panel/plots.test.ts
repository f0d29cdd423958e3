import { expect, test } from 'vitest';
import { ends } from '../charts/axis_range';
import { Strip } from '../live/status_strip';
import type { AxisView, Status } from '../wire';
import { chosen, plots, usual } from './plots';

const axes = [{ name: 'theta', unit: 'deg' }, { name: 's', unit: 'mm' }] as AxisView[];
const all = plots(axes, ['current_a', 'voltage_v']);

function status(t: number, theta: number, s: number, errors: [number, number]): Status {
  return {
    t, speed_mm_s: 8, override_part: 0.5, tip: [s, 0, 0, 0, 0, 1], tracking: [],
    axes: [{ position: theta, error: errors[0] }, { position: s, error: errors[1] }],
    process: { set: [240, null], measured: [238, 27] },
  } as unknown as Status;
}

test('every axis has its position, speed and error with its unit, every value its set and actual', () => {
  const of = (key: string) => all.find((plot) => plot.key === key);
  expect(of('position theta')).toMatchObject({ unit: '°', lines: [{ column: 'position 0' }] });
  expect(of('speed theta')?.unit).toBe('°/s');
  expect(of('speed s')?.unit).toBe('mm/s');
  expect(of('error s')?.unit).toBe('mm');
  expect(of('value voltage_v')?.lines.map((line) => line.column)).toEqual(['set 1', 'value 1']);
  expect(new Set(all.map((plot) => plot.key)).size).toBe(all.length);
});

test('what was chosen is drawn; what is not here is left out; nothing chosen is what is usual', () => {
  const keys = (own: string[] | null, tracked = false) => chosen(all, own, tracked).map((plot) => plot.key);
  expect(keys(['error s', 'path', 'position gone'])).toEqual(['path', 'error s']);
  expect(keys(null)).toEqual(usual(all, false));
  expect(keys(['position gone'], true)).toContain('correction');
  // Another machine has an axis of another name at the same place.
  expect(chosen(plots([{ name: 'x', unit: 'mm' } as AxisView], []), ['position theta'], false).map((of) => of.key)).toEqual(['path', 'greatest']);
});

test('the strip knows speeds, and the greatest error of each unit with its axis', () => {
  const strip = new Strip();
  strip.units = ['deg', 'mm'];
  for (let i = 0; i < 40; i += 1) strip.add(status(i / 30, (-6 * i) / 30, (3 * i) / 30, [-0.2, 0.1]));
  expect(strip.newest('speed 0')).toBeCloseTo(-6);
  expect(strip.newest('tip speed')).toBeCloseTo(3);
  expect(strip.newest('speed')).toBe(8);
  expect([strip.newest('error deg'), strip.newest('whose deg')]).toEqual([0.2, 0]);
  expect([strip.newest('error mm'), strip.newest('whose mm')]).toEqual([0.1, 1]);
  const [times, set] = strip.last(0.5, ['set 1']);
  expect(times).toHaveLength(16);
  expect(set?.every((value) => value === null)).toBe(true);
});

test('a scale from zero begins there, also at rest', () => {
  expect(ends(0, 0, 1, true)).toEqual([0, 1]);
  expect(ends(2, 10, 1, true)).toEqual([0, 11]);
  expect(ends(-3, 10, 1, true)[0]).toBeLessThan(-3);
  expect(ends(0, 0, 1)[0]).toBeLessThan(0);
});
