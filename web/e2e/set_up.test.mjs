// A machine is set up: its tool found by touching a point, its drives, an axis sent home; alarms one by one, and put aside.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { page as blank } from './browser.mjs';
import { axe, axis, bench, commands, keep, load, mode, open, press, quiet, ready, SHORT, sleep, startJogging, tab } from './operator.mjs';

const { one, cell, browser } = await bench();

const page = (name) => one.getByRole('group', { name: 'Pages of the set-up' }).getByRole('button', { name, exact: true }).click();
const file = () => readFileSync(join(cell.data, 'jobs/machines/saddle-4axis.toml'), 'utf8');

/** Holds a key until an axis has moved by so much. */
async function hold(name, key, by) {
  await tab(one, 'Jog · Teach');
  await commands(one);
  const begun = await axis(one, name);
  const left = async () => by - Math.abs((await axis(one, name)) - begun);
  // Where a page is drawn by software a hand may be lost for a moment: then it presses again.
  for (let press = 0; press < 20 && (await left()) > 0; press += 1) {
    await commands(one);
    await one.getByRole('button', { name: key, exact: true }).hover();
    await one.mouse.down();
    for (let i = 0; i < 30 && (await left()) > 0; i += 1) await sleep(50);
    await one.mouse.up();
  }
  await sleep(500);
}

test('a tool is found by touching one point, looked at, kept, and in force with the next loading', async () => {
  await keep(one, 'short.toml', SHORT);
  await load(one, 'short.toml');
  await tab(one, 'Weld');
  await commands(one);
  await ready(one);
  await startJogging(one);
  // The torch is only swung: the point that stays is the axis of the swing, 100 mm above the tip.
  for (let i = 0; i < 4; i += 1) {
    await tab(one, 'Set-up');
    await page('Tool');
    await one.getByRole('button', { name: 'Record this touch' }).click();
    if (i < 3) await hold('beta', 'beta +', 10);
  }
  await one.getByRole('button', { name: 'Compute the TCP' }).click();
  const answer = one.getByRole('status').filter({ hasText: 'TCP found' });
  await answer.getByText(/more than 20 mm/).waitFor();
  await answer.getByText(/Not determined along/).waitFor();
  assert.match(await answer.textContent(), /Z 100\.0/);
  await one.getByRole('button', { name: 'Save this TCP' }).click();
  await one.getByText(/Saved in machines\/saddle-4axis.toml/).waitFor();
  assert.match(file(), /tip_mm = \[.*, .*, (100|99\.99|100\.00)/);
  const anew = one.getByRole('button', { name: 'Load the job again' });
  assert.equal(await anew.isDisabled(), true, 'with the drives on');
  await one.getByRole('button', { name: 'Back to the current TCP' }).click();
  await one.waitForFunction(() => document.querySelector('.setup .good') !== null);
  await anew.waitFor({ state: 'hidden' });
  assert.match(file(), /tip_mm = \[0\.0, 0\.0, 0\.0\]/);
});

test('one axis goes home alone', async () => {
  await tab(one, 'Weld');
  await commands(one);
  await press(one, /Hold/);
  await mode(one, 'ready');
  assert.ok(Math.abs(await axis(one, 'beta')) > 20);
  await tab(one, 'Set-up');
  await page('Machine');
  await one.getByRole('button', { name: 'Home axis beta' }).click();
  await mode(one, 'homing');
  await mode(one, 'ready');
  await tab(one, 'Weld');
  assert.ok(Math.abs(await axis(one, 'beta')) < 0.05);
});

test('a drive is set as the loader allows, and in force with the next loading', async () => {
  await tab(one, 'Set-up');
  await page('Axes and drives');
  await one.getByRole('group', { name: 'Axis' }).getByRole('button', { name: 's', exact: true }).click();
  const gain = one.getByLabel(/Proportional gain/);
  assert.match(await one.getByLabel(/Dead time of the current/).getAttribute('placeholder'), /^[\d.]+$/, 'what holds without a number');
  await gain.fill('-1');
  await one.getByRole('button', { name: 'Save', exact: true }).click();
  await one.getByRole('alert').filter({ hasText: 'kp_per_s' }).waitFor();
  // The browser says that it was refused.
  one.wrong = one.wrong.filter((text) => !text.includes('422'));
  await gain.fill('25');
  await one.getByLabel(/Max. speed/).fill('40');
  await one.getByRole('button', { name: 'Save', exact: true }).click();
  await one.getByText(/Saved in machines/).waitFor();
  assert.match(file(), /kp_per_s = 25/);
  await commands(one);
  await tab(one, 'Weld');
  await press(one, /Switch off/);
  await mode(one, 'off');
  await tab(one, 'Set-up');
  await page('Axes and drives');
  const anew = one.getByRole('button', { name: 'Load the job again' });
  await anew.click();
  await anew.waitFor({ state: 'hidden', timeout: 30_000 });
  await page('Machine');
  await one.getByRole('row', { name: /^s \[mm\].* 40\.0/ }).waitFor();
});

test('a camera is found from a picture of a grid, what is no grid is refused with its reason, and the map is kept', async () => {
  await tab(one, 'Set-up');
  await page('Sensors');
  await one.getByRole('group', { name: 'Sensors' }).getByRole('button', { name: 'camera', exact: true }).click();
  // A picture of nothing, made by the page itself.
  const plain = await one.evaluate(async () => {
    const canvas = Object.assign(document.createElement('canvas'), { width: 640, height: 480 });
    canvas.getContext('2d').fillRect(0, 0, 640, 480);
    return canvas.toDataURL('image/png').split(',')[1];
  });
  await one.locator('input[type=file]').setInputFiles({ name: 'plain.png', mimeType: 'image/png', buffer: Buffer.from(plain, 'base64') });
  await one.getByRole('alert').filter({ hasText: 'No dark dots' }).waitFor();
  await one.getByLabel('Height of the plate').fill('20');
  await one.getByRole('button', { name: 'Simulated picture' }).click();
  await one.getByText('The picture fits the grid.').waitFor();
  await one.getByText('In place of the plane at z = 20.000 mm').waitFor();
  const picture = one.locator('canvas[aria-label^="Picture with the dots"]');
  const marks = await picture.evaluate((canvas) => {
    const { data } = canvas.getContext('2d').getImageData(0, 0, canvas.width, canvas.height);
    let [net, off] = [0, 0];
    for (let i = 0; i < data.length; i += 4) {
      if (data[i + 2] > data[i] + 80) net += 1;
      if (data[i] > data[i + 2] + 80) off += 1;
    }
    return { net, off };
  });
  assert.ok(marks.net > 5000 && marks.off > 200, JSON.stringify(marks));
  await one.getByRole('button', { name: 'Save this map' }).click();
  await one.getByText(/Saved in machines/).waitFor();
  assert.match(file(), /z_mm = 20\.0 +# towards the camera.*\nmm_per_px = \[0\.0(8|9)\d{3,}, /);
  await one.getByRole('group', { name: 'Sensors' }).getByRole('button', { name: 'stripe', exact: true }).click();
  const angle = one.getByLabel(/Camera’s axis to the laser’s plane/);
  await angle.fill('95');
  await one.getByRole('button', { name: 'Save', exact: true }).click();
  await one.getByRole('alert').filter({ hasText: 'angle_deg' }).waitFor();
  one.wrong = one.wrong.filter((text) => !text.includes('422'));
  await angle.fill('26');
  await one.getByRole('button', { name: 'Save', exact: true }).click();
  await one.getByText(/Saved in machines/).waitFor();
  assert.match(file(), /angle_deg = 26/);
});

test('an alarm is acknowledged by itself, and one that only tells is put aside', async () => {
  await tab(one, 'Weld');
  await commands(one);
  await ready(one);
  await startJogging(one);
  await one.getByRole('button', { name: 'theta +', exact: true }).hover();
  await one.mouse.down();
  await sleep(400);
  await one.evaluate(() => {
    const until = performance.now() + 1500;
    while (performance.now() < until);
  });
  await one.mouse.up();
  await tab(one, 'Weld');
  await one.getByText('panel silent').first().waitFor();
  await commands(one);
  await one.getByRole('button', { name: /^Shelve/ }).first().click();
  await axe(one, 'shelving');
  await one.locator('dialog[open]').getByRole('button', { name: '30 min' }).click();
  await one.getByText(/Shelved: \d/).waitFor();
  await one.getByText('No alarms').first().waitFor();
  await one.getByRole('button', { name: 'Take back' }).click();
  const known = one.getByRole('button', { name: /Acknowledge this alarm: .*panel silent/ });
  await known.waitFor();
  await commands(one);
  await known.click();
  await known.waitFor({ state: 'hidden' });
  quiet(one);
});

test('the audit log says that there is more, shows it, is searched whole, and what is new comes by itself', async () => {
  await tab(one, 'Set-up');
  for (let i = 0; i < 210; i += 1) await keep(one, i === 0 ? 'needle.toml' : 'many.toml', SHORT.replace('"Short"', `"Short ${i}"`));
  await page('Audit log');
  const rows = one.locator('.setup tbody tr');
  await one.getByText('Newest 200 entries; older ones exist.').waitFor();
  assert.equal(await rows.count(), 200);
  assert.equal(await rows.getByText('needle.toml').count(), 0);
  await keep(one, 'newest.toml', SHORT);
  await rows.first().getByText('save job newest.toml').waitFor({ timeout: 10_000 });
  await one.getByRole('button', { name: 'Show older ones' }).click();
  await rows.getByText('needle.toml').first().waitFor();
  for (const more = one.getByRole('button', { name: 'Show older ones' }); await more.isVisible(); await sleep(300)) await more.click();
  await one.getByText(/^\d+ entries$/).waitFor();
  // What stands behind the newest is found.
  await one.getByRole('searchbox').fill('NEEDLE');
  await one.keyboard.press('Enter');
  await one.getByText('1 entry').waitFor();
  assert.equal(await rows.count(), 1);
  await one.getByRole('searchbox').fill('there is no such thing');
  await one.keyboard.press('Enter');
  await one.getByText('No entry contains this text.').waitFor();
  await axe(one, 'audit log');
});

test('on a phone the pages of the set-up are one choice before their content', async () => {
  const two = await blank(browser, { size: 'phone' });
  await open(two, cell.address);
  await two.locator('nav button').nth(4).click();
  const choice = two.getByRole('combobox', { name: 'Pages of the set-up' });
  await choice.waitFor();
  const [bar, content] = [await two.locator('.setup .one').boundingBox(), await two.locator('.setup .scrolls').boundingBox()];
  assert.ok(bar.height < 80 && content.y - bar.y < 100, JSON.stringify({ bar, content }));
  assert.equal(await two.locator('.setup .pages').isVisible(), false);
  for (const name of await choice.locator('option').allTextContents()) {
    await choice.selectOption({ label: name });
    await two.getByRole('region', { name, exact: true }).waitFor();
    await sleep(300);
    assert.ok(await two.evaluate(() => document.documentElement.scrollWidth <= innerWidth), name);
    await axe(two, `${name} on a phone`);
  }
  quiet(two);
  await two.context().close();
});
