import assert from 'node:assert/strict';
import { test } from 'node:test';
import { page, SIZES } from './browser.mjs';
import { axe, bench, control, open, quiet, shot, sleep } from './operator.mjs';

const TABS = 5;
const { cell, browser } = await bench();

const go = (of, i) => of.locator('nav button').nth(i).click();

/** Words that do not fit their key, plots that lie on one another, and a page that is wider than the screen. */
const overflowing = (of) =>
  of.evaluate(() => {
    const wrong = [];
    if (document.documentElement.scrollWidth > innerWidth) wrong.push(`page ${document.documentElement.scrollWidth}`);
    for (const key of document.querySelectorAll('button, .key, select, .chip, h2, legend')) {
      // Newer browsers tell how wide a closed list's longest choice is: one that ends with dots fits.
      const dots = key.tagName === 'SELECT' && getComputedStyle(key).textOverflow === 'ellipsis';
      const wide = !dots && key.scrollWidth > key.clientWidth + 1;
      if (key.clientWidth > 0 && (wide || key.scrollHeight > key.clientHeight + 3)) {
        wrong.push(`${key.tagName} "${key.textContent.trim().slice(0, 40)}" ${key.scrollWidth}>${key.clientWidth} ${key.scrollHeight}>${key.clientHeight}`);
      }
      const box = key.getBoundingClientRect();
      if (box.width > 0 && (box.left < -1 || box.right > innerWidth + 1)) wrong.push(`${key.textContent.trim().slice(0, 40)} is beside the screen`);
    }
    const figures = [...document.querySelectorAll('figure')].map((figure) => figure.getBoundingClientRect());
    figures.forEach((a, i) => {
      for (const b of figures.slice(i + 1)) {
        const [wide, high] = [Math.min(a.right, b.right) - Math.max(a.left, b.left), Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top)];
        if (wide > 1 && high > 1) wrong.push(`plots over one another by ${wide} x ${high}`);
      }
    });
    return wrong;
  });

/** Looks at the page as it is now on every size of screen; leaves it at the last, a phone's. */
async function fits(one, where) {
  for (const [size, viewport] of Object.entries(SIZES)) {
    await one.setViewportSize(viewport);
    await sleep(150);
    await shot(one, `${where}-${size}`);
    assert.deepEqual(await overflowing(one), [], `${where}, ${size}`);
  }
}

for (const language of ['en', 'uk', 'zh', 'de', 'ru']) {
  test(`${language}: everything fits on every screen`, async () => {
    const one = await page(browser, { language });
    await open(one, cell.address);
    for (let i = 0; i < TABS; i += 1) {
      await go(one, i);
      await sleep(250);
      await fits(one, `${language} tab ${i}`);
    }
    // On a phone the pages are a list.
    const pages = one.locator('.setup .one select');
    const count = await pages.locator('option').count();
    assert.ok(count > 5, `${count} pages`);
    for (let i = 0; i < count; i += 1) {
      await one.setViewportSize(SIZES.phone);
      await pages.selectOption({ index: i });
      await sleep(150);
      await fits(one, `${language} set-up ${i}`);
    }
    // The editor, with its pages.
    await go(one, 2);
    await one.locator('li.card', { hasText: 'points.toml' }).getByRole('button').nth(1).click();
    await one.locator('.right .good').waitFor({ timeout: 60_000 });
    for (const half of ['.left', '.right']) {
      const pages = one.locator(`.halves ${half} .pages button`);
      for (let i = 0; i < (await pages.count()); i += 1) {
        await pages.nth(i).click();
        await sleep(150);
        await fits(one, `${language} editor ${half} ${i}`);
      }
    }
    assert.equal(await one.evaluate(() => document.documentElement.lang), language);
    quiet(one);
    await one.context().close();
  });
}

for (const dark of [false, true]) {
  test(`axe finds nothing on any tab, ${dark ? 'dark' : 'light'}`, async () => {
    const one = await page(browser, { dark });
    await open(one, cell.address);
    const check = (where) => axe(one, where);
    for (let i = 0; i < TABS; i += 1) {
      await go(one, i);
      await sleep(500);
      await check(`tab ${i}`);
      await shot(one, `${dark ? 'dark' : 'light'}-${i}`);
    }
    for (const name of ['Axes and drives', 'Tool', 'Sensors', 'Inputs and outputs', 'Tuning', 'Alarm catalogue', 'Users', 'Audit log']) {
      await one.getByRole('button', { name, exact: true }).click();
      await sleep(300);
      await check(name);
    }
    await go(one, 2);
    await one.locator('li.card', { hasText: 'saddle.toml' }).first().getByRole('button', { name: 'New from template' }).click();
    await sleep(1500);
    for (const name of ['Form', 'Part and fixtures', 'Text', 'G-code', 'Points', 'Plots', 'Limits']) {
      if (name === 'Points') {
        await one.getByRole('button', { name: '← Jobs' }).click();
        await one.locator('li.card', { hasText: 'points.toml' }).getByRole('button', { name: 'New from template' }).click();
      }
      await one.getByRole('button', { name, exact: true }).click();
      await sleep(800);
      await check(name);
      await shot(one, `${dark ? 'dark' : 'light'}-${name}`);
    }
    await one.getByRole('button', { name: 'Save as' }).click();
    await check('saving as');
    await one.keyboard.press('Escape');
    await go(one, 2);
    const back = one.getByRole('button', { name: '← Jobs' });
    if (await back.isVisible()) await back.click();
    await control(one);
    await one.locator('li.card').first().getByRole('button', { name: 'Load' }).click();
    await one.locator('dialog[open]').waitFor();
    await check('loading');
    await one.keyboard.press('Escape');
    await one.getByRole('button', { name: 'Give up control' }).click();
    await go(one, 0);
    for (const name of ['Alarms', 'Events', 'Show', "Why can't I start?"]) {
      await one.getByRole('button', { name }).click();
      await sleep(200);
      await check(name);
    }
    quiet(one);
    await one.context().close();
  });
}
