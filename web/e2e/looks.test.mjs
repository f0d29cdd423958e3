import assert from 'node:assert/strict';
import { test } from 'node:test';
import { SIZES } from './browser.mjs';
import { axe, bench, control, inMenu, jobs, openJob, quiet, settled, shot } from './operator.mjs';

const TABS = 5;
const { one } = await bench({ opens: 'only' });

/** Goes to a tab, and waits until it has its data. */
async function go(i) {
  await one.locator('nav button').nth(i).click();
  await settled(one, 250);
}

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
async function fits(where) {
  await settled(one, 100);
  for (const [size, viewport] of Object.entries(SIZES)) {
    await one.setViewportSize(viewport);
    await settled(one);
    await shot(one, `${where}-${size}`);
    assert.deepEqual(await overflowing(one), [], `${where}, ${size}`);
  }
}

for (const language of ['en', 'uk', 'zh', 'de', 'ru']) {
  test(`${language}: everything fits on every screen`, async () => {
    await one.setViewportSize(SIZES.touch);
    await inMenu(one, (menu) => menu.locator('select').selectOption(language));
    await one.waitForFunction((of) => document.documentElement.lang === of, language);
    for (const i of [0, 1, 3, 4]) {
      await go(i);
      await fits(`${language} tab ${i}`);
    }
    // On a phone the pages are a list.
    const pages = one.locator('.setup .one select');
    const count = await pages.locator('option').count();
    assert.ok(count > 5, `${count} pages`);
    for (let i = 0; i < count; i += 1) {
      await pages.selectOption({ index: i });
      await fits(`${language} set-up ${i}`);
    }
    await go(2);
    await fits(`${language} tab 2`);
    // The editor, with its pages.
    await one.locator('li.card', { hasText: 'points.toml' }).getByRole('button').nth(1).click();
    await one.locator('.right .good').waitFor({ timeout: 60_000 });
    for (const half of ['.left', '.right']) {
      const pages = one.locator(`.halves ${half} .pages button`);
      for (let i = 0; i < (await pages.count()); i += 1) {
        await pages.nth(i).click();
        await fits(`${language} editor ${half} ${i}`);
      }
    }
    await one.locator('.editor-tab .row button').first().click();
    quiet(one);
  });
}

for (const theme of ['light', 'dark']) {
  test(`axe finds nothing on any tab, ${theme}`, async () => {
    await one.setViewportSize(SIZES.touch);
    await inMenu(one, async (menu) => {
      await menu.locator('select').selectOption('en');
      if (theme === 'dark') await menu.getByRole('button', { name: 'Dark' }).click();
    });
    // Only colours differ.
    const check = (where) => axe(one, where, ...(theme === 'dark' ? ['color-contrast'] : []));
    const press = async (name, where = name) => {
      await one.getByRole('button', { name, exact: true }).click();
      await settled(one, 300);
      await check(where);
      await shot(one, `${theme}-${where}`);
    };
    for (let i = 0; i < TABS; i += 1) {
      await go(i);
      await check(`tab ${i}`);
      await shot(one, `${theme}-${i}`);
    }
    for (const name of ['Axes and drives', 'Tool', 'Sensors', 'Inputs and outputs', 'Tuning', 'Alarm catalogue', 'Users', 'Audit log']) await press(name);
    await openJob(one, 'saddle.toml');
    for (const name of ['Form', 'Part and fixtures', 'Text', 'G-code']) await press(name);
    await openJob(one, 'points.toml');
    for (const name of ['Points', 'Plots', 'Limits']) await press(name);
    await press(/^Save as/, 'saving as');
    await one.keyboard.press('Escape');
    await jobs(one);
    await control(one);
    await one.locator('li.card').first().getByRole('button', { name: 'Load' }).click();
    await one.locator('dialog[open]').waitFor();
    await check('loading');
    await one.keyboard.press('Escape');
    await one.getByRole('button', { name: 'Give up control' }).click();
    await go(0);
    for (const name of ['Alarms', 'Events', 'Show', "Why can't I start?"]) await press(new RegExp(name.replace('?', '')), name);
    // As it was, for the other theme.
    await one.getByRole('button', { name: /Why can't I start/ }).click();
    quiet(one);
  });
}
