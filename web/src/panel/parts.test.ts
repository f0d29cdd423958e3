import { describe, expect, test } from 'vitest';
import { Layers } from './layers.svelte';
import { meant, type Meaning, type Spot } from './key_command';
import { dayAndTime, digitsFor, duration, limit, number, span, valueName } from './numbers';
import { programText } from './taught.svelte';
import type { MachineView } from '../wire';

describe('numbers', () => {
  test('a decimal point in every language, no sign of nothing, a dash for nothing', () => {
    expect(number(1234.5678, 2)).toBe('1234.57');
    expect(number(-1.5, 1)).toBe('\u22121.5');
    expect(number(-0.001, 2)).toBe('0.00');
    for (const nothing of [null, undefined, NaN, Infinity]) expect(number(nothing, 1)).toBe('–');
  });

  test('limits have the digits that they have, values those that tell them apart', () => {
    expect([0.65, 220, -1.25, 0.1 + 0.2].map(limit)).toEqual(['0.65', '220', '\u22121.25', '0.3']);
    for (const [values, digits] of [[[0.52, 0.56, null], 3], [[7, 10.1], 2], [[237.6, 242.4], 1], [[NaN], 3]] as const) expect(digitsFor(values)).toBe(digits);
  });

  test('names of process values', () => {
    expect(valueName('current_a')).toEqual({ title: 'current', unit: 'A' });
    expect(valueName('wire_feed_m_min')).toEqual({ title: 'wire feed', unit: 'm/min' });
    expect(valueName('beam_current_ma')).toEqual({ title: 'beam current', unit: 'mA' });
    expect(valueName('odd')).toEqual({ title: 'odd', unit: '' });
  });

  test('times', () => {
    expect(duration(61.4)).toBe('1:01');
    expect(duration(-3)).toBe('0:00');
    const at = (time: string): string => new Date(`2026-11-${time}`).toISOString();
    expect(dayAndTime(at('22T23:31:05'))).toBe('2026-11-22 23:31:05');
    expect(span(at('22T23:31:05'), at('22T23:31:58'))).toBe('2026-11-22 23:31:05 – 23:31:58');
    expect(span(at('22T23:59:58'), at('23T00:01:00'))).toBe('2026-11-22 23:59:58 – 2026-11-23 00:01:00');
    expect(span(at('22T23:59:58'), null)).toBe('2026-11-22 23:59:58 –');
  });
});

test('taught points become a program that reads back as they were', () => {
  const machine = { name: 'm', axes: [{ name: 'x' }, { name: 'b' }] } as unknown as MachineView;
  const tip: [number, number, number, number, number, number] = [0, 0, 0, 0, 0, 1];
  const points = [1, 2, 3].map((i) => ({ axes: [i, -i / 3], tip }));
  const text = programText('a "title"', machine, points, 7);
  expect(text).toContain('columns = ["x", "b", "speed_mm_s"]');
  expect([...text.matchAll(/\[(-?\d.*)\]/g)].map((row) => row[1]?.split(', ').map(Number))).toEqual([[1, -0.3333, 0], [2, -0.6667, 7], [3, -1, 7]]);
  expect(programText('t', machine, [], 7)).toBe('');
});

test('only Modal makes a dialog: it has STOP in it, which is out of reach behind any other', () => {
  const sources = import.meta.glob<string>('../**/*.svelte', { query: '?raw', import: 'default', eager: true });
  const makers = Object.entries(sources).flatMap(([path, text]) => (/<dialog|popover=/.test(text) ? path : []));
  expect(makers).toEqual(['./Modal.svelte']);
  expect(sources['./Modal.svelte']).toContain('<Stop />');
});

describe('layers', () => {
  const self = {} as Node;
  const at = (inside: boolean) => ({ contains: () => inside });

  test('the topmost is closed first, and only that', () => {
    const layers = new Layers();
    const closed: string[] = [];
    const add = (name: string): void => {
      const remove = layers.add(at(false), () => (closed.push(name), remove()));
    };
    add('menu');
    add('dialog');
    expect(layers.any).toBe(true);
    expect(layers.closeTop()).toBe(true);
    expect(closed).toEqual(['dialog']);
    layers.closeTop();
    expect(closed).toEqual(['dialog', 'menu']);
    expect([layers.any, layers.closeTop()]).toEqual([false, false]);
  });

  test('a press outside closes a menu; inside, on its own key, or with a dialog it closes nothing', () => {
    for (const [inside, onKey, dialog, closes] of [[false, false, false, true], [true, false, false, false], [false, true, false, false], [false, false, true, false]] as const) {
      const layers = new Layers();
      let closed = false;
      layers.add(at(inside), () => (closed = true), dialog ? null : at(onKey));
      layers.pressed(self);
      expect(closed).toBe(closes);
    }
  });

  test('who leaves the page leaves its menus', () => {
    const layers = new Layers();
    const closed: string[] = [];
    layers.add(at(false), () => closed.push('menu'), at(false));
    layers.add(at(false), () => closed.push('dialog'));
    layers.leave();
    expect(closed).toEqual(['menu']);
  });
});

describe('keys', () => {
  const weld: Spot = { tab: 'weld', writes: false, scrolls: false, open: false, dialog: false, armed: false };
  const heard = (spot: Partial<Spot>): (Meaning | null)[] => ['F1', 'Escape', 'p', 'F2', 'Home', 'r', 's', 'x'].map((key) => meant(key, { ...weld, ...spot }));

  test('all of them on the machine’s pages', () => {
    expect(heard({})).toEqual(['stop', 'stop', 'hold', 'switch_on', 'home', 'start_dry_run', 'resume', null]);
    expect(heard({ armed: true })[5]).toBe('start_weld');
    expect(heard({ tab: 'teach' })).toEqual(heard({}));
  });

  test('nothing moves by them elsewhere, and what stops is heard there too', () => {
    for (const tab of ['jobs', 'records', 'setup'] as const) {
      expect(heard({ tab, armed: true })).toEqual(['stop', 'stop', 'hold', 'switch_on', null, null, null, null]);
    }
  });

  test('a field takes letters and Esc, F1 stops there too; a slider or what scrolls takes Home alone', () => {
    expect(heard({ writes: true })).toEqual(['stop', null, null, null, null, null, null, null]);
    expect(heard({ scrolls: true })).toEqual(['stop', 'stop', 'hold', 'switch_on', null, 'start_dry_run', 'resume', null]);
  });

  test('Esc closes what is open and stops nothing by that, wherever it is open', () => {
    for (const tab of ['weld', 'teach', 'jobs', 'records', 'setup'] as const) {
      for (const writes of [false, true]) expect(meant('Escape', { ...weld, tab, writes, open: true })).toBe('close');
    }
    expect(heard({ open: true, dialog: true })).toEqual(['stop', 'close', null, null, null, null, null, null]);
    // Where STOP did not reach the cell, Esc is STOP once more.
    expect(heard({ dialog: true })).toEqual(['stop', 'stop', null, null, null, null, null, null]);
    // A menu is no dialog: whatever makes things safer is heard.
    expect(heard({ open: true })).toEqual(['stop', 'close', 'hold', 'switch_on', 'home', 'start_dry_run', 'resume', null]);
  });

  test('Esc is decided in one place, and every menu has a layer there', () => {
    const sources = import.meta.glob<string>(['../**/*.svelte', '../**/*.ts', '!../**/*.test.ts'], { query: '?raw', import: 'default', eager: true });
    const having = (what: RegExp): string[] => Object.entries(sources).flatMap(([path, text]) => (what.test(text) ? path : []));
    expect(having(/=== 'Escape'/)).toEqual(['./key_command.ts']);
    const menus = having(/class="(?:[\w ]* )?menu[" ]/);
    expect(menus.length).toBeGreaterThan(2);
    expect(having(/\{@attach layers\.menu\(/)).toEqual(menus);
  });
});
