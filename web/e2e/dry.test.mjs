// SADDLE-2020's flow: a dry run is held, left for the hand, a point recorded, and it goes on where it was left.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { axis, bench, commands, keep, load, mode, press, quiet, ready, SHORT, sleep, tab } from './operator.mjs';

const { one } = await bench();

test('a held dry run is jogged from and gone on with', async () => {
  await keep(one, 'short.toml', SHORT);
  await load(one, 'short.toml');
  await tab(one, 'Weld');
  await commands(one);
  await ready(one);
  await press(one, /^Dry run/);
  await mode(one, 'dry_run');
  await one.waitForFunction(() => /Pass 1: \d/.test(document.querySelector('.passes')?.textContent ?? ''), null, { timeout: 60_000 });
  await sleep(1500);
  await press(one, /Hold/);
  await mode(one, 'hold');
  await commands(one);
  const theta = await axis(one, 'theta');
  await one.getByRole('button', { name: 'Jog from here' }).click();
  await mode(one, 'jog');
  await commands(one);
  const note = one.getByRole('status').filter({ hasText: 'Dry run paused in pass 1' });
  await note.waitFor();
  // The hand lifts the torch and records where it is.
  const begun = await axis(one, 'h');
  await one.getByRole('button', { name: 'h +', exact: true }).hover();
  await one.mouse.down();
  for (let i = 0; i < 60 && (await axis(one, 'h')) - begun < 5; i += 1) await sleep(50);
  await one.mouse.up();
  await sleep(300);
  assert.ok((await axis(one, 'h')) - begun > 4);
  await one.getByRole('button', { name: 'Record' }).first().click();
  await note.getByRole('button', { name: 'Plan return' }).click();
  await note.waitFor({ state: 'hidden', timeout: 30_000 });
  await mode(one, 'ready');
  // Nothing has moved by itself.
  assert.ok((await axis(one, 'h')) - begun > 4);
  await commands(one);
  await press(one, /^Dry run/);
  await mode(one, 'dry_run');
  await one.waitForFunction(() => /Pass 1: \d/.test(document.querySelector('.passes')?.textContent ?? ''), null, { timeout: 60_000 });
  const again = await axis(one, 'theta');
  assert.ok(again > theta - 1.5, `it goes on where it was left: ${theta}, ${again}`);
  // Left for good.
  await press(one, /Hold/);
  await mode(one, 'hold');
  await press(one, /^Abort/);
  await mode(one, 'ready');
  assert.ok(await one.getByRole('button', { name: /^Abort/ }).isDisabled(), 'there is nothing to abort');
  quiet(one);
});
