import { afterEach, beforeEach, describe, expect, test, vi } from 'vitest';
import type { FromCell, Status, Stopped } from '../wire';
import { refusal } from './api';
import { HoldToRun, REPEAT_MS } from './hold_to_run';
import { Link, type LinkState } from './socket';
import { Stopping } from './stopping.svelte';
import { Strip } from './status_strip';

class FakeSocket {
  readyState = 0;
  sent: unknown[] = [];
  onopen: () => void = () => undefined;
  onmessage: (event: { data: string }) => void = () => undefined;
  onclose: () => void = () => undefined;
  send(text: string): void {
    this.sent.push(JSON.parse(text));
  }
  close(): void {
    this.readyState = 3;
    this.onclose();
  }
  opens(): void {
    this.readyState = 1;
    this.onopen();
  }
}

beforeEach(() => vi.useFakeTimers());
afterEach(() => vi.useRealTimers());

describe('the socket', () => {
  function linked() {
    const sockets: FakeSocket[] = [];
    const states: LinkState[] = [];
    const messages: FromCell[] = [];
    const link = new Link('ws://cell', { state: (s) => states.push(s), message: (m) => messages.push(m) }, () => {
      const socket = new FakeSocket();
      sockets.push(socket);
      return socket as unknown as WebSocket;
    });
    link.open();
    return { link, sockets, states, messages };
  }

  test('answers come to the command with their number, in any order', async () => {
    const { link, sockets } = linked();
    sockets[0]?.opens();
    const [first, second] = [link.ask({ do: 'home' }), link.ask({ do: 'arm' })];
    const answer = (seq: number, ok: boolean): void =>
      sockets[0]?.onmessage({ data: JSON.stringify({ kind: 'answer', seq, ok, why: null }) });
    answer(2, false);
    answer(1, true);
    expect((await first).ok).toBe(true);
    expect((await second).ok).toBe(false);
  });

  test('a reconnect sends nothing by itself and begins its numbers anew', async () => {
    const { link, sockets, states } = linked();
    sockets[0]?.opens();
    const open = link.ask({ do: 'start_weld' });
    link.move({ kind: 'jog', of: 'joints', speeds: [1] });
    sockets[0]?.close();
    expect(await open).toMatchObject({ ok: false, why: { key: 'lost' } });
    // While it is closed nothing is kept for later.
    expect(await link.ask({ do: 'resume' })).toMatchObject({ ok: false, why: { key: 'lost' } });
    link.move({ kind: 'jog', of: 'joints', speeds: [1] });
    await vi.advanceTimersByTimeAsync(5000);
    expect(sockets.length).toBe(2);
    sockets[1]?.opens();
    await vi.advanceTimersByTimeAsync(5000);
    expect(sockets[1]?.sent).toEqual([]);
    void link.ask({ do: 'home' });
    link.move({ kind: 'jog', of: 'tip', speeds: [0] });
    expect(sockets[1]?.sent).toMatchObject([{ seq: 1, ask: { do: 'home' } }, { seq: 1, of: 'tip' }]);
    expect(states).toEqual(['opening', 'open', 'closed', 'opening', 'open']);
  });

  test('closed for good it does not come again', async () => {
    const { link, sockets } = linked();
    sockets[0]?.opens();
    link.close();
    await vi.advanceTimersByTimeAsync(60_000);
    expect(sockets.length).toBe(1);
  });
});

describe('hold to run', () => {
  test('speeds every 50 ms while held, zeros at once on release, then silence', () => {
    const sent: number[][] = [];
    const hand = new HoldToRun((_, speeds) => sent.push(speeds));
    expect(hand.press('joints', [0, 0.5])).toBe(true);
    vi.advanceTimersByTime(REPEAT_MS * 4);
    expect(sent).toEqual(Array.from({ length: 5 }, () => [0, 0.5]));
    hand.release();
    hand.release();
    vi.advanceTimersByTime(1000);
    expect(sent.length).toBe(6);
    expect(sent.at(-1)).toEqual([0, 0]);
  });

  test('a tap, released at once, ends with zeros', () => {
    const sent: number[][] = [];
    const hand = new HoldToRun((_, speeds) => sent.push(speeds));
    hand.press('tip', [1, 0, 0]);
    hand.release();
    expect(sent).toEqual([[1, 0, 0], [0, 0, 0]]);
  });

  test('a step is said as long as it is held, and ends with zeros', () => {
    const sent: number[][] = [];
    let steps = 0;
    const hand = new HoldToRun((_, speeds) => sent.push(speeds));
    hand.press('joints', [0, 0.1], () => (steps += 1));
    vi.advanceTimersByTime(REPEAT_MS * 3);
    expect([steps, sent]).toEqual([4, []]);
    hand.release();
    vi.advanceTimersByTime(1000);
    expect([steps, sent]).toEqual([4, [[0, 0]]]);
  });

  test('a second press while one is held is not taken', () => {
    const sent: number[][] = [];
    const hand = new HoldToRun((_, speeds) => sent.push(speeds));
    hand.press('joints', [1, 0]);
    expect(hand.press('joints', [0, 1])).toBe(false);
    vi.advanceTimersByTime(REPEAT_MS);
    expect(sent).toEqual([[1, 0], [1, 0]]);
  });
});

describe('the strip of the last minute', () => {
  const status = (t: number): Status =>
    ({ t, speed_mm_s: t, override_part: 1, axes: [{ position: 0, error: -t, current: 0 }], tip: [0, 0, 0, 0, 0, 1], tracking: [], process: { set: [], measured: [t] } }) as unknown as Status;

  test('keeps the newest rows in order, however often it has gone round', () => {
    const strip = new Strip();
    for (let i = 0; i < strip.room * 2.5; i += 1) strip.add(status(i / 30));
    const [times, speed, error, missing] = strip.last(10, ['speed', 'error mm', 'deviation']);
    expect(times.length).toBe(301);
    expect(times[0]).toBeCloseTo(-10);
    expect(times.at(-1)).toBe(0);
    for (let i = 1; i < times.length; i += 1) expect(times[i]).toBeGreaterThan(times[i - 1] as number);
    expect(speed?.at(-1)).toBeCloseTo((strip.count - 1) / 30);
    expect(error?.at(-1)).toBeCloseTo((strip.count - 1) / 30);
    expect(missing?.every((value) => value === null)).toBe(true);
    expect(strip.last(1000, ['speed'])[0].length).toBe(strip.room);
  });

  test('when the cell begins to count anew, nothing of before stands in its way', () => {
    const strip = new Strip();
    for (let i = 0; i < strip.room; i += 1) strip.add(status(900 + i / 30));
    for (let i = 0; i < 90; i += 1) strip.add(status(i / 30));
    const [times, speed] = strip.last(30, ['speed']);
    expect(times.length).toBe(90);
    expect(times[0]).toBeCloseTo(-89 / 30);
    expect(speed?.[0]).toBe(0);
  });

  test('nothing yet is nothing', () => {
    expect(new Strip().last(10, ['speed'])).toEqual([[], []]);
  });
});

test('a refusal speaks by key and text, or plainly where no handler was reached', () => {
  const of = (status: number, said: string): string[] => {
    const { key, message } = refusal(status, said);
    return [key, message];
  };
  expect(of(409, '{"key":"other","code":"text","text":"another","arguments":[]}')).toEqual(['other', 'another']);
  expect(of(422, 'Failed to deserialize the JSON body: tolerance_mm')).toEqual(['input', 'Failed to deserialize the JSON body: tolerance_mm']);
  expect(of(502, '<html>')).toEqual(['server', '<html>']);
  for (const odd of ['', 'null', '[]', '{"key":1}']) expect(of(500, odd)[0]).toBe('server');
});

describe('STOP', () => {
  const never = new Promise<never>(() => undefined);
  const ok = { ok: true, why: null };
  const lost = Promise.resolve({ ok: false, why: null });
  const refused = (): Promise<never> => Promise.reject(new Error('no connection'));
  const stopped = (mode: string, cycle_age_s: number | null = 0.01): Promise<Stopped> => Promise.resolve({ mode, cycle_age_s, cycle: 1 });

  test('after which the cell is seen to stand is reached, and needs no second way', async () => {
    const request = vi.fn(() => never);
    const stopping = new Stopping({ socket: () => Promise.resolve(ok), request });
    const known = stopping.stop();
    await vi.advanceTimersByTimeAsync(10);
    stopping.seen('weld');
    expect(stopping.fate).toBe('sent');
    stopping.seen('ready');
    await known;
    await vi.advanceTimersByTimeAsync(5000);
    expect([stopping.fate, stopping.mode]).toEqual(['reached', 'ready']);
    expect(request).not.toHaveBeenCalled();
  });

  test('goes as a request at once where there is no connection, and soon where the connection is silent', async () => {
    for (const [socket, after] of [[() => null, 0], [() => lost, 0], [() => never, 250]] as const) {
      const request = vi.fn(() => stopped('ready'));
      const stopping = new Stopping({ socket, request });
      const known = stopping.stop();
      await vi.advanceTimersByTimeAsync(after);
      expect(request).toHaveBeenCalledTimes(1);
      await known;
      expect([stopping.fate, stopping.mode]).toEqual(['reached', 'ready']);
    }
  });

  test('as a request asks until the cell stands, and no longer', async () => {
    let mode = 'weld';
    const request = vi.fn(() => stopped(mode));
    const stopping = new Stopping({ socket: () => null, request });
    const known = stopping.stop();
    await vi.advanceTimersByTimeAsync(400);
    expect([stopping.fate, stopping.mode]).toEqual(['sent', 'weld']);
    mode = 'ready';
    await vi.advanceTimersByTimeAsync(400);
    await known;
    expect(stopping.fate).toBe('reached');
    const asked = request.mock.calls.length;
    await vi.advanceTimersByTimeAsync(5000);
    expect(request.mock.calls.length).toBe(asked);
  });

  test('that reaches nobody has failed after a second at most, whichever way is silent', async () => {
    for (const socket of [() => null, () => lost, () => never]) {
      for (const request of [refused, () => never]) {
        const stopping = new Stopping({ socket, request });
        void stopping.stop();
        await vi.advanceTimersByTimeAsync(1000);
        expect(stopping.fate).toBe('failed');
      }
    }
  });

  test('pressed again and again has failed a second after the first press', async () => {
    const stopping = new Stopping({ socket: () => never, request: () => never });
    for (let pressed = 0; pressed < 2; pressed += 1) {
      void stopping.stop();
      await vi.advanceTimersByTimeAsync(600);
    }
    expect(stopping.fate).toBe('failed');
  });

  test('that a server answers for a cycle that hangs or has ended has failed', async () => {
    const silent = Promise.resolve({ ok: false, why: { key: 'silent_cycle', code: 'text', text: '', arguments: [] } });
    for (const [socket, age] of [[() => null, 3], [() => silent, 3], [() => null, null]] as const) {
      const stopping = new Stopping({ socket, request: () => stopped('ready', age) });
      void stopping.stop();
      await vi.advanceTimersByTimeAsync(1000);
      expect(stopping.fate).toBe('failed');
    }
  });

  test('that is answered has failed after two seconds if the cell is not seen to stand', async () => {
    for (const socket of [() => Promise.resolve(ok), () => null]) {
      const stopping = new Stopping({ socket, request: () => stopped('weld') });
      void stopping.stop();
      await vi.advanceTimersByTimeAsync(1900);
      stopping.seen('weld');
      expect(stopping.fate).toBe('sent');
      await vi.advanceTimersByTimeAsync(100);
      expect(stopping.fate).toBe('failed');
      // Answered once more it has not reached the cell late: it goes on.
      void stopping.stop();
      await vi.advanceTimersByTimeAsync(100);
      expect(stopping.fate).toBe('failed');
    }
  });

  test('stays failed until the cell is seen to stand, or somebody has read it', async () => {
    const failed = async (): Promise<Stopping> => {
      const stopping = new Stopping({ socket: () => null, request: refused });
      void stopping.stop();
      await vi.advanceTimersByTimeAsync(1000);
      return stopping;
    };
    const seen = await failed();
    for (const mode of ['weld', 'hold', 'jog', 'teach', 'dry_run', 'homing']) seen.seen(mode);
    expect(seen.fate).toBe('failed');
    seen.seen('ready');
    expect(seen.fate).toBe('none');
    const read = await failed();
    read.acknowledge();
    expect(read.fate).toBe('none');
    // The next one has its own second.
    void read.stop();
    await vi.advanceTimersByTimeAsync(999);
    expect(read.fate).toBe('sent');
    await vi.advanceTimersByTimeAsync(1);
    expect(read.fate).toBe('failed');
  });

  test('that arrives late is said to be late, and a second press does not hide that the first failed', async () => {
    let arrive: (answer: Stopped) => void = () => undefined;
    const stopping = new Stopping({ socket: () => null, request: () => new Promise((done) => (arrive = done)) });
    void stopping.stop();
    await vi.advanceTimersByTimeAsync(1000);
    void stopping.stop();
    expect(stopping.fate).toBe('failed');
    await vi.advanceTimersByTimeAsync(1500);
    expect(stopping.fate).toBe('failed');
    arrive({ mode: 'weld', cycle_age_s: 0.01, cycle: 1 });
    await vi.advanceTimersByTimeAsync(0);
    expect(stopping.fate).toBe('late');
    stopping.seen('ready');
    expect(stopping.fate).toBe('none');
  });
});
