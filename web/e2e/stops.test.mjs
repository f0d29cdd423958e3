// Stopping from wherever one is, and going on with nothing but the weld that was left.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { ask, bench, burns, commands, keep, load, loadFromThere, mode, press, ready, SHORT, weld } from './operator.mjs';

const { one, cell } = await bench();
const LONG = SHORT.replace('"Short"', '"Long"').replaceAll(', 6]', ', 1.5]');
const dialog = () => one.locator('dialog[open]');
const continues = () => one.getByRole('button', { name: /Continue pass 1/ });

test('Hold and STOP are heard after the override was moved by the mouse', async () => {
  await ready(one);
  await keep(one, 'short.toml', LONG);
  await load(one, 'short.toml', 'N-1');
  await one.locator('.strip', { hasText: 'Part N-1' }).waitFor();
  await weld(one);
  await burns(one, true);
  const slider = one.getByRole('slider').first();
  const { width, height } = await slider.boundingBox();
  await slider.click({ position: { x: width * 0.4, y: height / 2 } });
  await one.keyboard.press('p');
  await mode(one, 'hold');
  await commands(one);
});

test('a machine that goes back in a hold says so, and can be held', async () => {
  const hold = one.getByRole('group', { name: 'Commands' }).getByRole('button', { name: /Hold/ });
  // As soon as it stands there is nothing to hold.
  await one.waitForFunction(() => [...document.querySelectorAll('.orders button')].some((key) => /Hold/.test(key.textContent) && key.disabled));
  await press(one, /Reverse/);
  await one.locator('.strip .mode', { hasText: 'Reverse' }).waitFor();
  assert.ok(await hold.isEnabled());
  await hold.click();
  await one.locator('.strip .mode', { hasText: 'Reverse' }).waitFor({ state: 'detached' });
  assert.equal(await one.locator('[data-mode]').getAttribute('data-mode'), 'hold');
  await one.getByRole('slider').first().focus();
  await one.keyboard.press('Escape');
  await mode(one, 'ready');
});

test('going on is offered for the weld that was left alone, and its crater is asked about each time', async () => {
  await commands(one);
  await continues().click();
  await dialog().getByText(/Weld \d+: Long, part N-1/).waitFor();
  await dialog().getByRole('checkbox').check();
  await dialog().getByRole('button', { name: 'Cancel' }).click();
  await continues().click();
  assert.equal(await dialog().getByRole('checkbox').isChecked(), false);
  await dialog().getByRole('button', { name: 'Cancel' }).click();
  for (const [job, part] of [['first-weld.toml', 'N-1'], ['short.toml', 'N-2']]) {
    await commands(one);
    await load(one, job, part);
    await one.getByText(/Weld \d+ \(Long, part N-1\) is unfinished: pass 1/).waitFor();
    assert.equal(await continues().count(), 0, `${job} ${part}`);
  }
  await commands(one);
  await load(one, 'short.toml', 'N-1');
  await commands(one);
  await continues().click();
  await loadFromThere(one);
  await one.locator('.note', { hasText: 'Restarts in pass 1' }).waitFor();
  await one.locator('.strip', { hasText: 'Part N-1' }).waitFor();
});

test('whoever is thrown out in a run still has STOP, and is told why', async () => {
  await commands(one);
  await load(one, 'short.toml');
  await press(one, /^Dry run/);
  await mode(one, 'dry_run');
  await one.getByRole('button', { name: /▾$/ }).click();
  await one.getByRole('button', { name: 'Log out' }).click();
  await dialog().getByText(/continues without you/).waitFor();
  await dialog().getByRole('button', { name: 'Cancel' }).click();
  // The session ends on the server, as when an administrator changes the user.
  await ask(one, 'POST', '/api/logout', {});
  await one.getByText(/The session has ended/).waitFor();
  await one.keyboard.press('Escape');
  // As soon as it is seen to stand.
  await one.getByText(/STOP was sent. State then: Ready/).waitFor();
});

test('the printed address, opened over the login page, logs in', async () => {
  await one.goto(cell.address);
  await one.waitForSelector('.panel');
  await mode(one, 'ready', 'idle', 'off');
});
