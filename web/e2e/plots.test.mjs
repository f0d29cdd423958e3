import assert from 'node:assert/strict';
import { test } from 'node:test';
import { page } from './browser.mjs';
import { axe, bench, get, open, quiet, sleep } from './operator.mjs';

// A machine with a beam.
const { one, cell, browser } = await bench({ job: 'half-ring' });

const state = () => one.evaluate(() => document.querySelector('[data-mode]').dataset.mode);

/** From off to a dry run; a page that drew a second by software has lost its heartbeat, and takes control again. */
async function dryRun() {
  for (let i = 0; i < 90; i += 1) {
    const take = one.getByRole('button', { name: 'Take control' });
    if (await take.isVisible()) await take.click({ timeout: 2000 }).catch(() => undefined);
    const now = await state();
    if (now === 'dry_run') return;
    const what = { off: /Switch on/, idle: /^Home/, ready: /^Dry run/ }[now];
    const button = one.getByRole('group', { name: 'Commands' }).getByRole('button', { name: what ?? 'none' });
    // The key may be grey again by now: then it is tried once more.
    if (what) await button.click({ timeout: 2000 }).catch(() => undefined);
    await sleep(700);
  }
  assert.fail(`no dry run, but ${await state()}`);
}

test('the operator chooses what is drawn: it stays chosen, has units, and a value under the cursor', async () => {
  const figures = one.locator('.charts figure');
  const titles = () => figures.locator('.title').allTextContents();
  await figures.first().waitFor();
  assert.ok((await titles()).includes('Path speed mm/s'));
  const choose = one.getByRole('button', { name: 'Choose plots' });
  await choose.click();
  const machine = await get(one, '/api/machine');
  const linear = machine.axes.find((axis) => axis.unit === 'mm').name;
  const rotary = machine.axes.find((axis) => axis.unit === 'deg').name;
  await one.getByRole('checkbox', { name: `${linear}: Position` }).check();
  await one.getByRole('checkbox', { name: `${rotary}: Following error` }).check();
  await one.getByRole('checkbox', { name: `${rotary}: Speed` }).check();
  await one.getByRole('checkbox', { name: /^Max. following error/ }).uncheck();
  await axe(one, 'plots');
  await choose.click();
  const wanted = ['Path speed mm/s', `${linear}: Position mm`, `${rotary}: Speed °/s`, `${rotary}: Following error °`];
  for (const title of wanted) assert.ok((await titles()).includes(title), `${title} in ${await titles()}`);
  assert.ok(!(await titles()).some((title) => title.startsWith('Max.')));
  // Under the cursor: what it was some seconds ago, with its unit.
  const position = figures.filter({ hasText: `${linear}: Position` });
  await position.locator('.u-over').scrollIntoViewIfNeeded();
  await sleep(4000);
  const area = await position.locator('.u-over').boundingBox();
  await one.mouse.move(area.x + area.width * 0.96, area.y + area.height / 2);
  await position.locator('.at', { hasText: / s$/ }).waitFor();
  assert.match(await position.locator('.line-0').textContent(), /\d mm/);
  await one.reload();
  // Plots of axes come when the page knows the machine, a moment after the speed along the path.
  for (const title of wanted) await figures.getByText(title, { exact: true }).waitFor();
  quiet(one);
});

test('the greatest following error says of which axis it is, and in its unit', async () => {
  const two = await page(browser);
  await open(two, cell.address);
  const figure = two.locator('.charts figure', { hasText: 'Max. following error' });
  await figure.locator('.line-0', { hasText: /[a-z]+ [0-9.]+ mm/ }).waitFor();
  await figure.locator('.line-1', { hasText: /[a-z]+ [0-9.]+ °/ }).waitFor();
  quiet(two);
  await two.close();
});

test('in a dry run the spot of the beam is on its path; beside passes the speed is that of the tip', async () => {
  await dryRun();
  await one.locator('.speed', { hasText: 'Tip speed' }).waitFor();
  const off = one.locator('.below .off', { hasText: 'Beam deviation' });
  await one.waitForFunction(() => /[0-9.]+ mm/.test(document.querySelector('.below .off')?.textContent ?? ''), null, { timeout: 90_000 });
  await sleep(2000);
  const mm = Number(/([0-9.]+) mm/.exec(await off.textContent())[1]);
  assert.ok(mm < 0.3, `${mm} mm from the path`);
  quiet(one);
});
