// A job for another machine brings that machine: names, keys and picture are its own at once, on every page.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { bench, commands, get, keep, load, mode, open, press, quiet, ready, SHORT, sleep, tab } from './operator.mjs';
import { page } from './browser.mjs';

const { one, cell, browser } = await bench();

const names = (of) => of.locator('aside dl dt').allTextContents();

test('a job for another machine: both pages have its axes, keys and process', async () => {
  const two = await page(browser);
  await open(two, cell.address);
  const before = (await names(one)).join(' ');
  for (const [job, off] of [['half-ring.toml', 'Beam off'], ['first-weld.toml', 'Arc off']]) {
    await load(one, job);
    for (const of of [one, two]) await of.getByText(off).first().waitFor({ timeout: 20_000 });
    await tab(one, 'Jog · Teach');
    const axes = (await get(one, '/api/machine')).axes.map((axis) => axis.name);
    for (const of of [one, two]) {
      const shown = (await names(of)).join(' ');
      for (const name of axes) assert.match(shown, new RegExp(`\\b${name}\\b`), `${job}: ${shown}`);
    }
    for (const name of axes) await one.getByRole('button', { name: `${name} +`, exact: true }).waitFor({ timeout: 5000 });
  }
  assert.equal((await names(one)).join(' '), before);
  quiet(one);
  await two.close();
});

test('the speed that is shown is that of the axes, whatever the override', async () => {
  await keep(one, 'short.toml', SHORT);
  await load(one, 'short.toml');
  await tab(one, 'Weld');
  await commands(one);
  await ready(one);
  await one.getByRole('slider', { name: 'Override' }).fill('50');
  await press(one, /^Dry run/);
  await mode(one, 'dry_run');
  // Two places on the pass and the times between them.
  const at = () =>
    one.evaluate(() => {
      const s = /Pass 1: ([\d.]+)/.exec(document.querySelector('.passes')?.textContent ?? '');
      return s ? [Number(s[1]), performance.now() / 1000] : null;
    });
  await one.waitForFunction(() => Number(/Pass 1: ([\d.]+)/.exec(document.querySelector('.passes')?.textContent ?? '')?.[1]) > 5, null, { timeout: 60_000 });
  const from = await at();
  const speeds = [];
  for (let i = 0; i < 10; i += 1) {
    await sleep(150);
    speeds.push(Number.parseFloat(await one.locator('aside p.speed strong').first().textContent()));
  }
  const to = await at();
  const mean = (to[0] - from[0]) / (to[1] - from[1]);
  const shown = speeds.sort((a, b) => a - b)[5];
  assert.ok(Math.abs(shown / mean - 1) < 0.2, `${shown} shown, ${mean} mm/s measured`);
  await press(one, /Hold/);
  await mode(one, 'hold');
  quiet(one);
});
