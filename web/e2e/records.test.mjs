// Two welds of different machines and processes beside one another; what is looked for and looked at stays; nothing is cut off.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { page } from './browser.mjs';
import { axe, bench, commands, cutOff, inMenu, jobText, keep, load, mode, open, press, quiet, ready, SHORT, sleep, tab, weld } from './operator.mjs';

const { one, cell, browser } = await bench();
const row = (of, part) => of.locator('tr', { hasText: part });

/** Opens the record of a part from the list; no number of it is cut off. */
async function shows(of, part) {
  const back = of.locator('.record > .row button').first();
  if (await back.isVisible()) await back.click();
  const search = of.getByRole('searchbox');
  await search.fill('');
  await search.press('Enter');
  await row(of, part).getByRole('button').click();
  await of.locator('.charts .uplot').first().waitFor();
  assert.deepEqual(await cutOff(of), []);
}

test('welds by arc and by beam are compared: what both have is drawn, with the values under the cursor', async () => {
  await keep(one, 'short.toml', SHORT);
  const ring = await jobText(one, 'half-ring.toml');
  await keep(one, 'ring.toml', ring.replace('end_phi_deg = 210', 'end_phi_deg = 40').split('[cosmetic]')[0]);
  for (const [job, part] of [['short.toml', 'S-1'], ['ring.toml', 'R-1']]) {
    await load(one, job, part);
    await commands(one);
    await ready(one);
    // The whole number of the part, whatever the title.
    assert.equal(await one.locator('.strip .part').evaluate((chip) => chip.scrollWidth <= chip.clientWidth && chip.textContent), `Part ${part}`);
    await weld(one);
    // The plots of the weld are drawn, also after the cell's time has begun anew.
    await sleep(3000);
    assert.ok(await drawn(one.locator('.plots canvas').first()), `plots while ${part} is welded`);
    await mode(one, 'ready');
    await commands(one);
    await press(one, /Switch off/);
    await mode(one, 'off');
  }
  await tab(one, 'Records');
  for (const part of ['R-1', 'S-1']) {
    await row(one, part).getByText('good').waitFor({ timeout: 30_000 });
    await row(one, part).getByRole('checkbox').check();
  }
  await one.getByRole('button', { name: 'Compare' }).click();
  await one.locator('.charts .uplot').nth(1).waitFor();
  assert.equal(await one.locator('.note.fault').count(), 0);
  await one.locator('.charts figcaption').first().getByText('Tip speed Actual mm/s').waitFor();
  await one.locator('.charts').focus();
  for (let i = 0; i < 20; i += 1) await one.keyboard.press('ArrowRight');
  const values = await one.locator('.charts figure').first().locator('b').allTextContents();
  assert.deepEqual(values.map((text) => Math.round(Number(text))), [10, 6]);
  await axe(one, 'comparing');
  quiet(one);
});

test('what is looked for and looked at stays when another page is looked at', async () => {
  await tab(one, 'Weld');
  await tab(one, 'Records');
  await one.locator('.charts').waitFor();
  await one.getByRole('button', { name: '← Records' }).click();
  await one.getByRole('searchbox').fill('R-1');
  await one.keyboard.press('Enter');
  await row(one, 'S-1').waitFor({ state: 'hidden' });
  await row(one, 'R-1').getByRole('button').click();
  await one.getByRole('button', { name: '← Records' }).click();
  assert.equal(await one.getByRole('searchbox').inputValue(), 'R-1');
  await row(one, 'R-1').waitFor();
  assert.equal(await row(one, 'S-1').count(), 0);
  await row(one, 'R-1').getByRole('button').click();
  const [file] = await Promise.all([one.waitForEvent('download'), one.getByRole('link', { name: /^Download: Report/ }).click()]);
  assert.equal(file.suggestedFilename(), 'weld-2-en.html');
  quiet(one);
});

for (const language of ['de', 'uk']) {
  test(`no number of a record or of tuning is cut off, ${language}`, async () => {
    await inMenu(one, (menu) => menu.locator('select').selectOption(language));
    await one.locator('nav button').nth(3).click();
    await shows(one, 'S-1');
    await one.locator('.facts table').waitFor();
    assert.ok(!/set|error|actual/i.test(await one.locator('.charts').textContent()), 'columns have words');
    await one.locator('nav button').nth(4).click();
    await one.locator('.setup .pages button').nth(7).click();
    await one.locator('.setup .must').click();
    await one.locator('.setup figure').first().waitFor({ timeout: 60_000 });
    assert.deepEqual(await cutOff(one), []);
    assert.ok(!/_hz|_per_s|_deg/.test(await one.locator('.setup .two').innerText()), 'numbers of tuning have words and units');
    quiet(one);
  });
}

for (const [language, dark] of [['en', false], ['zh', true]]) {
  test(`on a phone the list is read by scrolling sideways, and a record is opened, ${language}`, async () => {
    const two = await page(browser, { size: 'phone', language, dark });
    await open(two, cell.address);
    await two.locator('nav button').nth(3).click();
    await row(two, 'S-1').waitFor();
    const list = two.locator('.records .scrolls');
    const sizes = await two.evaluate(() => {
      const rows = [...document.querySelectorAll('.records tbody tr')].map((of) => of.getBoundingClientRect().height);
      const { clientWidth, scrollWidth } = document.querySelector('.records .scrolls');
      return { page: document.documentElement.scrollWidth, screen: innerWidth, clientWidth, scrollWidth, tallest: Math.max(...rows) };
    });
    assert.ok(sizes.page <= sizes.screen && sizes.scrollWidth > sizes.clientWidth, JSON.stringify(sizes));
    // No column so narrow that it is read letter by letter.
    assert.ok(sizes.tallest < 110, JSON.stringify(sizes));
    // The last column is reached.
    await list.evaluate((of) => of.scrollTo(of.scrollWidth, 0));
    const last = await row(two, 'S-1').locator('td').last().boundingBox();
    assert.ok(last.x >= 0 && last.x + last.width <= sizes.screen + 1, JSON.stringify(last));
    await axe(two, 'the list on a phone');
    await list.evaluate((of) => of.scrollTo(0, 0));
    for (const part of ['S-1', 'R-1']) await row(two, part).getByRole('checkbox').check();
    assert.ok(await two.locator('.records form button').isEnabled());
    await shows(two, 'S-1');
    assert.ok((await two.evaluate(() => document.documentElement.scrollWidth)) <= sizes.screen);
    quiet(two);
    await two.context().close();
  });
}

/** Something besides its ground is on a chart. */
async function drawn(canvas) {
  return canvas.evaluate((of) => {
    const { data } = of.getContext('2d').getImageData(0, 0, of.width, of.height);
    const colours = new Set();
    for (let i = 0; i < data.length; i += 4) if (data[i + 3] > 200) colours.add(`${data[i]} ${data[i + 1]} ${data[i + 2]}`);
    // Lines are blue, ticks and grid are grey.
    return [...colours].some((colour) => { const [r, , b] = colour.split(' ').map(Number); return b - r > 60; });
  });
}
