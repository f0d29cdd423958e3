import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { api } from '../live/api';
import { session } from '../live/session.svelte';
import type { PlanAnswer, WrongView } from '../wire';
import { edited } from './edited.svelte';

beforeEach(() => vi.useFakeTimers());
afterEach(() => vi.useRealTimers());

test('undone and done again, a text has what is wrong with it', async () => {
  const fault = (text: string): WrongView | null => (text.includes('bad') ? ({ key: text.trim() } as WrongView) : null);
  vi.spyOn(api, 'form').mockImplementation(async (text) => ({ text, form: { tables: [], passes: [] }, wrong: fault(text) }));
  edited.begin('a.toml', 'bad = 1\n', false, '');
  await vi.advanceTimersByTimeAsync(500);
  for (const text of ['bad = 2\n', 'good = 3\n']) {
    edited.change(text, text);
    await vi.advanceTimersByTimeAsync(500);
  }
  expect(edited.wrong).toBe(null);
  for (const [move, key] of [['undo', 'bad = 2'], ['undo', 'bad = 1'], ['redo', 'bad = 2']] as const) {
    await edited[move]();
    expect(edited.wrong?.key, move).toBe(key);
  }
  edited.end();
});

test('a long plan tells its time, and cancelled it closes its request and is asked for again only when wanted', async () => {
  session.view = { user: 'ada', role: 'programmer', may: ['plan'], token: 't', first_run: false };
  const signals: AbortSignal[] = [];
  vi.spyOn(api, 'draft').mockResolvedValue({ kind: 'wrong', message: { code: 'text', text: '', arguments: [['text', { type: 'text', value: '' }]] } });
  vi.spyOn(api, 'form').mockImplementation(async (text) => ({ text, form: { tables: [], passes: [] }, wrong: null }));
  vi.spyOn(api, 'plan').mockImplementation((_, signal) => {
    if (signal) signals.push(signal);
    return new Promise<PlanAnswer>((_, fails) => signal?.addEventListener('abort', () => fails(new DOMException('', 'AbortError'))));
  });
  edited.begin('a.toml', 'schema = 1\n', false, 'schema = 1\n');
  await vi.advanceTimersByTimeAsync(5000);
  expect([edited.plans, edited.planned_s]).toEqual([true, 5]);
  edited.cancel();
  await vi.advanceTimersByTimeAsync(5000);
  expect([edited.plans, edited.cancelled, edited.planned_s, edited.trouble]).toEqual([false, true, 5, '']);
  expect(signals.map((signal) => signal.aborted)).toEqual([true]);
  edited.planAgain();
  await vi.advanceTimersByTimeAsync(100);
  expect([edited.plans, edited.cancelled, signals.length]).toEqual([true, false, 2]);
  edited.end();
});
