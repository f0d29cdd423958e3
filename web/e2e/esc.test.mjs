// Esc and STOP: what is open is closed first, and a STOP that reaches nobody fills the screen.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { axe, bench, burns, commands, keep, loadFor, mode, open, ready, SHORT, sleep, tab, weld } from './operator.mjs';

const { one, cell } = await bench();
const modeNow = () => one.locator('[data-mode]').getAttribute('data-mode');
const user = () => one.getByRole('button', { name: /▾$/ });
const menus = {
  user: { key: user, inside: () => one.getByRole('button', { name: 'Log out' }) },
  Show: { key: () => one.getByRole('button', { name: 'Show', exact: true }), inside: () => one.getByText('Section plane') },
  'Choose plots': { key: () => one.getByRole('button', { name: 'Choose plots' }), inside: () => one.getByRole('region', { name: 'Choose plots' }) },
};

test('Esc closes the menu that is open and the weld goes on; Esc with nothing open stops it', async () => {
  await ready(one);
  await keep(one, 'long.toml', SHORT.replaceAll(', 6]', ', 0.5]'));
  await loadFor(one, 'long.toml', 'N-1');
  await weld(one);
  await burns(one, true);
  await one.getByRole('button', { name: 'Plots', exact: true }).click();
  for (const { key, inside } of Object.values(menus)) {
    await key().click();
    await inside().waitFor();
    await one.keyboard.press('Escape');
    await inside().waitFor({ state: 'detached' });
    await sleep(300);
    assert.equal(await modeNow(), 'weld');
  }
  // Two that are open: the one opened last goes first.
  await user().click();
  await menus.user.inside().click();
  const dialog = one.locator('dialog[open]');
  await dialog.waitFor();
  await one.keyboard.press('Escape');
  await dialog.waitFor({ state: 'hidden' });
  assert.ok(await menus.user.inside().isVisible());
  await one.keyboard.press('Escape');
  await menus.user.inside().waitFor({ state: 'detached' });
  await sleep(300);
  assert.equal(await modeNow(), 'weld');
  await one.keyboard.press('Escape');
  await mode(one, 'ready');
});

test('a menu closes by a press outside and when the page is left', async () => {
  for (const { key, inside } of Object.values(menus)) {
    if (!(await key().isVisible())) await one.getByRole('button', { name: 'Plots', exact: true }).click();
    await key().click();
    await inside().waitFor();
    await one.locator('.strip').click();
    await inside().waitFor({ state: 'detached' });
    await key().click();
    await inside().waitFor();
    await key().click();
    await inside().waitFor({ state: 'detached' });
    await key().click();
    // By the keyboard nothing outside is pressed.
    await one.getByRole('navigation').getByRole('button', { name: 'Records' }).focus();
    await one.keyboard.press('Enter');
    await inside().waitFor({ state: 'detached' });
    await tab(one, 'Weld');
  }
});

test('in a field Esc stops nothing, and F1 does', async () => {
  await commands(one);
  await loadFor(one, 'long.toml', 'N-2');
  await weld(one);
  await tab(one, 'Records');
  await one.getByRole('textbox').first().focus();
  await one.keyboard.press('Escape');
  await sleep(300);
  assert.equal(await modeNow(), 'weld');
  await one.keyboard.press('F1');
  await mode(one, 'ready');
});

test('STOP goes by a request of its own where the connection is silent', async () => {
  await tab(one, 'Weld');
  await commands(one);
  await loadFor(one, 'long.toml', 'N-3');
  await weld(one);
  // The socket stays open and nothing goes through it any more.
  await one.evaluate(() => {
    WebSocket.prototype.send = () => undefined;
  });
  await one.keyboard.press('F1');
  await mode(one, 'ready');
  assert.equal(await one.getByRole('alertdialog').count(), 0);
});

test('a STOP that reaches nobody fills the screen until the cell is seen to stand again, or somebody has read it', async () => {
  const screen = one.getByRole('alertdialog');
  let cut = false;
  let line;
  await one.routeWebSocket('**/api/live', (client) => {
    if (cut) return client.close();
    line = { client, server: client.connectToServer() };
  });
  await one.route('**/api/**', (route) => (cut ? route.abort() : route.fallback()));
  // Only a new page has its socket routed.
  await open(one, cell.address);
  await one.getByText('Connected').waitFor();
  cut = true;
  await line.server.close();
  await line.client.close();
  await one.getByText('No connection').waitFor();
  await one.getByText('Alarms unknown').waitFor().catch(async () => {
    await one.getByRole('button', { name: 'Alarms' }).click();
    await one.getByText('Alarms unknown').waitFor();
  });
  assert.equal(await one.getByText('No alarms').count(), 0);
  assert.equal(await one.getByText('Take control to operate this cell').count(), 0);
  await one.keyboard.press('Escape');
  await screen.getByText('STOP DID NOT REACH THE CELL').waitFor({ timeout: 5000 });
  await screen.getByText('Press the emergency stop').waitFor();
  const { width, height } = await screen.boundingBox();
  assert.deepEqual([width, height], [1280, 800]);
  await axe(one, 'STOP did not reach');
  // Esc is STOP here too, and closes nothing.
  await one.keyboard.press('Escape');
  await sleep(300);
  assert.ok(await screen.isVisible());
  await screen.getByRole('button', { name: 'I have read this' }).click();
  await screen.waitFor({ state: 'hidden' });
  await one.getByRole('button', { name: 'STOP' }).click();
  await screen.waitFor();
  cut = false;
  await screen.waitFor({ state: 'hidden', timeout: 15_000 });
  await one.getByText('Connected').waitFor({ timeout: 45_000 });
});
