// Prints how fast the panel is: first paint, time to usable, size, long tasks, CPU time per frame, edit latency. See scripts/panel-speed.
import { loadavg } from 'node:os';
import { gzipSync } from 'node:zlib';
import { launch, page } from './browser.mjs';
import { startCell } from './cell.mjs';
import { control, keep, load, open, press, ready, SHORT, sleep, tab } from './operator.mjs';

const LOADS = 5;
const WATCHED_MS = 6000;
const EDITS = 9;

const middle = (values) => [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)];
const ms = (value) => `${value.toFixed(value < 10 ? 1 : 0)} ms`;
const say = (what, value) => console.log(`${`${what}:`.padEnd(44)} ${value}`);

/** In the page before anything else: long tasks, frames, and how long of a frame the renderer has. */
function watches() {
  globalThis.long = [];
  new PerformanceObserver((list) => globalThis.long.push(...list.getEntries().map((entry) => entry.duration))).observe({ type: 'longtask', buffered: true });
  const frames = (globalThis.frames_ = { count: 0, renderer: 0 });
  let drawn = null;
  for (const name of ['clear', 'drawElements', 'drawArrays', 'drawElementsInstanced', 'useProgram', 'bindFramebuffer']) {
    const own = WebGL2RenderingContext.prototype[name];
    WebGL2RenderingContext.prototype[name] = function (...of) {
      const from = performance.now();
      drawn ??= [from, from];
      const result = own.apply(this, of);
      drawn[1] = performance.now();
      return result;
    };
  }
  const ask = globalThis.requestAnimationFrame.bind(globalThis);
  globalThis.requestAnimationFrame = (work) =>
    ask((t) => {
      drawn = null;
      work(t);
      if (!drawn) return;
      frames.count += 1;
      frames.renderer += drawn[1] - drawn[0];
    });
}

/** From the address to a panel that shows the cell's state: a new context, nothing kept. */
async function loaded(browser, address) {
  const one = await page(browser);
  await one.addInitScript(watches);
  const sizes = [];
  one.on('response', async (response) => {
    const body = new URL(response.url()).pathname.startsWith('/api/') ? null : await response.body().catch(() => null);
    if (body) sizes.push([body.length, gzipSync(body, { level: 9 }).length]);
  });
  await one.addInitScript(() => {
    const look = () => {
      const panel = document.querySelector('[data-mode]');
      if (panel?.dataset.mode && document.querySelector('.panel')) globalThis.usable ??= performance.now();
      else setTimeout(look, 5);
    };
    look();
  });
  await open(one, address);
  await one.waitForFunction(() => globalThis.usable);
  await sleep(1500);
  const times = await one.evaluate(() => ({
    paint: performance.getEntriesByName('first-contentful-paint')[0]?.startTime ?? NaN,
    usable: globalThis.usable,
    long: globalThis.long,
  }));
  const sum = (i) => sizes.reduce((all, size) => all + size[i], 0);
  return { one, ...times, plain: sum(0), zipped: sum(1) };
}

/** Time of script, styles and layout, s. */
async function busy(session) {
  const { metrics } = await session.send('Performance.getMetrics');
  const of = (name) => metrics.find((metric) => metric.name === name)?.value ?? 0;
  return of('ScriptDuration') + of('LayoutDuration') + of('RecalcStyleDuration');
}

/** CPU time per frame outside of the renderer, while a pass is dry-run. */
async function frames(one) {
  const session = await one.context().newCDPSession(one);
  await session.send('Performance.enable');
  const begun = [await busy(session), await one.evaluate(() => ({ ...globalThis.frames_ }))];
  await sleep(WATCHED_MS);
  const ended = [await busy(session), await one.evaluate(() => ({ ...globalThis.frames_ }))];
  const count = ended[1].count - begun[1].count;
  const renderer = ended[1].renderer - begun[1].renderer;
  return { count, renderer: renderer / count, outside: (1000 * (ended[0] - begun[0]) - renderer) / count };
}

/** From a value that is changed in one of ten thousand points to the next picture with it, ms. */
async function edits(one) {
  const rows = Array.from({ length: 10_000 }, (_, i) => `    [${(i / 1000).toFixed(3)}, 0, 60, -20, 200, 6],`);
  await keep(one, 'long.toml', SHORT.replace(/points = \[[^]*\n\]/, `points = [\n${rows.join('\n')}\n]`));
  await tab(one, 'Jobs');
  await one.locator('li.card', { hasText: 'long.toml' }).getByRole('button', { name: 'Open' }).click();
  await one.getByRole('button', { name: 'Points', exact: true }).click();
  const cell = one.getByRole('textbox', { name: 'Current A 3' });
  await cell.waitFor({ timeout: 60_000 });
  const [typed, kept] = [[], []];
  for (let i = 0; i < EDITS; i += 1) {
    const wanted = String(201 + i);
    const [type, keeps] = await cell.evaluate(async (field, value) => {
      const painted = () => new Promise((done) => requestAnimationFrame(() => setTimeout(done)));
      field.focus();
      const begun = performance.now();
      field.value = value;
      field.dispatchEvent(new Event('input', { bubbles: true }));
      await painted();
      const typedIn = performance.now() - begun;
      const left = performance.now();
      field.dispatchEvent(new Event('change', { bubbles: true }));
      field.blur();
      // The server edits the text; the table takes the next value when it has the new one.
      do await painted();
      while (document.querySelector('[aria-label="Current A 3"]')?.disabled);
      return [typedIn, performance.now() - left];
    }, wanted);
    typed.push(type);
    kept.push(keeps);
    await one.waitForFunction((value) => document.querySelector('[aria-label="Current A 3"]')?.value === value, wanted, { timeout: 60_000 });
    await sleep(1000);
  }
  return { typed: middle(typed), kept: middle(kept) };
}

const cell = await startCell();
const browser = await launch({ scenes: true });
try {
  const loads = [];
  for (let i = 0; i < LOADS; i += 1) {
    const run = await loaded(browser, cell.address);
    loads.push(run);
    if (i + 1 < LOADS) await run.one.context().close();
  }
  const { one } = loads[LOADS - 1];
  const of = (name) => middle(loads.map((run) => run[name]));
  say('load of this computer (1 min)', loadavg()[0].toFixed(1));
  say(`first contentful paint (middle of ${LOADS})`, ms(of('paint')));
  say('usable: the state of the cell is shown', ms(of('usable')));
  say('files', `${(of('zipped') / 1000).toFixed(0)} kB gzip, ${(of('plain') / 1000).toFixed(0)} kB sent`);
  const longest = loads.map((run) => Math.max(0, ...run.long));
  const blocked = loads.map((run) => run.long.reduce((all, task) => all + task - 50, 0));
  say('long tasks (> 50 ms) of a load', `${middle(loads.map((run) => run.long.length))}, longest ${ms(middle(longest))}, ${ms(middle(blocked))} beyond 50`);
  await control(one);
  await ready(one);
  await load(one, 'saddle.toml');
  await tab(one, 'Weld');
  await press(one, /Dry run/);
  await sleep(1500);
  const drawn = await frames(one);
  say('frames while a pass runs', `${((1000 * drawn.count) / WATCHED_MS).toFixed(0)} a second`);
  say('CPU time per frame outside the renderer', ms(drawn.outside));
  say('CPU time per frame in it (software GL)', ms(drawn.renderer));
  const edit = await edits(one);
  say('10,000 points: a digit typed to its picture', ms(edit.typed));
  say('10,000 points: a value kept to the next one', ms(edit.kept));
} finally {
  await browser.close();
  await cell.end();
}
