import assert from 'node:assert/strict';
import { after, before, test } from 'node:test';
import { hasBrowser, launch, page } from './browser.mjs';
import { isReal, NO_CELL, startCell } from './cell.mjs';
import { axis, control, mode, open, ready, record, sleep, tab } from './operator.mjs';

const options = { skip: hasBrowser ? false : 'no Chromium' };
const onReal = { skip: hasBrowser ? (isReal ? false : `the mock goes nowhere by itself: ${NO_CELL}`) : 'no Chromium' };
let cell;
let browser;
let one;
let other;

before(async () => {
  if (!hasBrowser) return;
  cell = await startCell();
  browser = await launch();
  one = await page(browser);
  other = await page(browser);
  await open(one, cell.address);
  await open(other, cell.address);
  await control(one);
  await ready(one);
  await tab(one, 'Jog · Teach');
  await one.getByRole('button', { name: 'Start jogging' }).click();
  await mode(one, 'jog');
});
after(async () => {
  await browser?.close();
  await cell?.end();
});

/** Presses theta + and waits until it moves. */
async function held() {
  await mode(one, 'jog');
  const begun = await axis(one, 'theta');
  const key = one.getByRole('button', { name: 'theta +' });
  await key.hover();
  await one.mouse.down();
  for (let i = 0; i < 40 && Math.abs((await axis(one, 'theta')) - begun) < 0.2; i += 1) await sleep(50);
  const now = await axis(one, 'theta');
  assert.ok(Math.abs(now - begun) >= 0.2, `theta has not moved: ${begun} to ${now}`);
  return key;
}

test('no place is recorded while an axis moves, by the key or past it', onReal, async () => {
  const place = () => one.evaluate(async () => {
    const answer = await fetch('/api/position');
    return { status: answer.status, ...(await answer.json()) };
  });
  const isOff = (off) =>
    one.waitForFunction((off) => [...document.querySelectorAll('button')].some((key) => key.textContent.trim() === 'Record point' && key.disabled === off), off);
  await isOff(false);
  const key = await held();
  const moving = await place();
  await isOff(true);
  await one.getByText('The axes have not come to rest: wait a moment.').waitFor();
  await ways['the pointer lifted outside of the button'](key);
  assert.deepEqual([moving.status, moving.key, moving.text], [409, 'busy', 'the axes have not come to rest: wait a moment']);
  await stands();
  await isOff(false);
  await record(one);
  const stood = await place();
  assert.ok(Math.abs(stood.axes[0] - (await axis(one, 'theta'))) < 0.02);
  one.wrong = one.wrong.filter((text) => !text.includes('409'));
});

/** It stands half a second later, as the other panel sees it. */
async function stands() {
  await sleep(700);
  const then = await axis(other, 'theta');
  await sleep(500);
  const now = await axis(other, 'theta');
  assert.ok(Math.abs(now - then) < 0.02, `theta still moves: ${then} to ${now}`);
}

const ways = {
  'the pointer lifted outside of the button': async () => {
    await one.mouse.move(5, 5);
    await one.mouse.up();
  },
  'pointercancel': (key) => key.evaluate((of) => of.dispatchEvent(new PointerEvent('pointercancel', { bubbles: true }))),
  'lostpointercapture': (key) => key.evaluate((of) => of.dispatchEvent(new PointerEvent('lostpointercapture'))),
  'blur of the window': () => one.evaluate(() => window.dispatchEvent(new Event('blur'))),
  'the page hidden': () =>
    one.evaluate(() => {
      Object.defineProperty(document, 'hidden', { value: true, configurable: true });
      document.dispatchEvent(new Event('visibilitychange'));
      delete document.hidden;
    }),
  'another speed': () => one.evaluate(() => document.querySelector('.speeds button').click()),
  'the other frame': () => one.evaluate(() => document.querySelector('[aria-label="Move by"] button:last-child').click()),
};

for (const [way, release] of Object.entries(ways)) {
  test(`jogging ends by ${way}`, options, async () => {
    const key = await held();
    await release(key);
    await stands();
    // Still pressed, it does not begin again by itself.
    await stands();
    await one.mouse.up();
    await one.getByRole('button', { name: 'Axes', exact: true }).click();
    await one.locator('.speeds button').nth(1).click();
  });
}

test('the cell stops by itself when the page hangs with the button held', options, async () => {
  await held();
  const hangs = one.evaluate(() => {
    const until = performance.now() + 3000;
    while (performance.now() < until);
  });
  await stands();
  await hangs;
  await one.mouse.up();
  await stands();
  // Without a heartbeat it has lost control too, and takes nothing back by itself.
  await one.getByText('Nobody commands').waitFor();
  await control(one);
  if (await one.getByRole('button', { name: 'Start jogging' }).isVisible()) {
    await one.getByRole('button', { name: 'Start jogging' }).click();
  }
  await mode(one, 'jog');
  // After a silence the cell wants to see the hand at rest before it moves again.
  await one.getByRole('button', { name: 'theta +' }).hover();
  await one.mouse.down();
  await sleep(200);
  await one.mouse.up();
  await stands();
});

test('the keyboard: an arrow moves while held, and no longer', options, async () => {
  await mode(one, 'jog');
  await one.locator('.speeds button').nth(1).focus();
  const begun = await axis(one, 'theta');
  await one.keyboard.down('ArrowLeft');
  await sleep(800);
  await one.keyboard.up('ArrowLeft');
  await stands();
  assert.ok((await axis(one, 'theta')) < begun - 0.2);
});

test('a key that sends all axes to a place: they go while it is held, and stand there', onReal, async () => {
  await held();
  await one.mouse.up();
  await stands();
  const home = one.getByRole('button', { name: 'Home position' });
  const begun = await axis(one, 'theta');
  assert.ok(Math.abs(begun) > 0.2, `theta is at home already: ${begun}`);
  // Let go early, it stops on the way.
  await home.hover();
  await one.mouse.down();
  for (let i = 0; i < 40 && Math.abs((await axis(one, 'theta')) - begun) < 0.05; i += 1) await sleep(20);
  await one.mouse.up();
  await stands();
  assert.ok(Math.abs((await axis(one, 'theta')) - begun) >= 0.05, 'theta has not moved');
  await home.hover();
  await one.mouse.down();
  for (let i = 0; i < 100 && Math.abs(await axis(one, 'theta')) > 0.005; i += 1) await sleep(100);
  await one.screenshot({ path: new URL('shots/go.png', import.meta.url).pathname });
  await one.mouse.up();
  await stands();
  assert.ok(Math.abs(await axis(one, 'theta')) < 0.02, `theta is not at home: ${await axis(one, 'theta')}`);
});

test('recorded places become a program', options, async () => {
  for (let i = 0; i < 3; i += 1) {
    await record(one);
    await held();
    await one.mouse.up();
    await sleep(400);
  }
  await one.getByRole('textbox', { name: 'Name' }).fill('by-hand');
  await one.getByRole('button', { name: 'Save as program' }).click();
  await one.getByText('Saved: by-hand.toml').waitFor();
});

test('the page closed with the button held', options, async () => {
  await held();
  await one.close();
  await stands();
});
