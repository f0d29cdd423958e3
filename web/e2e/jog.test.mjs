import assert from 'node:assert/strict';
import { afterEach, test } from 'node:test';
import { axis, bench, control, ready, record, sleep, startJogging } from './operator.mjs';

const { one, cell } = await bench();
await ready(one);
await startJogging(one);

// What fails leaves no key held for the next.
afterEach(async () => {
  if (!one.isClosed()) await one.mouse.up();
});

/**
 * Presses theta + and waits until it moves and `also` holds. A page that drew a second by software has lost its heartbeat: the cell
 * stops, and wants to see the hand at rest before it moves again. Then it is pressed again.
 */
async function held(also = async () => true) {
  const key = one.getByRole('button', { name: 'theta +' });
  for (let tries = 1; ; tries += 1) {
    await startJogging(one);
    const begun = await axis(one, 'theta');
    await key.hover();
    await one.mouse.down();
    for (let i = 0; i < 40 && Math.abs((await axis(one, 'theta')) - begun) < 0.2; i += 1) await sleep(50);
    const now = await axis(one, 'theta');
    const moves = Math.abs(now - begun) >= 0.2;
    if (moves && (await also())) return key;
    assert.ok(tries < 3, moves ? 'theta moves, but not so' : `theta has not moved: ${begun} to ${now}`);
    await one.mouse.up();
    await sleep(500);
  }
}

/** What the cell answers to where it stands. */
async function place() {
  const answer = await one.context().request.get(new URL('/api/position', cell.address).href);
  return { status: answer.status(), ...(await answer.json()) };
}

test('no place is recorded while an axis moves, by the key or past it', async () => {
  const recordable = one.getByRole('button', { name: 'Record point', disabled: false });
  await recordable.waitFor();
  // A page that draws by software shows it for a moment only, so both are watched all the while.
  await one.evaluate(() => {
    const look = () => {
      const greyed = [...document.querySelectorAll('button')].some((key) => key.textContent.trim() === 'Record point' && key.disabled);
      window.refused ||= greyed && document.body.textContent.includes('The axes are still moving: wait a moment.');
    };
    new MutationObserver(look).observe(document.body, { subtree: true, childList: true, attributes: true, characterData: true });
  });
  let busy;
  let watches = true;
  const watched = (async () => {
    for (; watches; await sleep(30)) {
      const now = await place();
      if (now.status === 409) busy = now;
    }
  })();
  const key = await held(async () => busy && one.evaluate(() => window.refused)).finally(() => (watches = false));
  await watched;
  await ways['the pointer lifted outside of the button'](key);
  assert.deepEqual([busy.key, busy.text], ['busy', 'the axes are still moving: wait a moment']);
  await stands();
  await recordable.waitFor();
  await record(one);
  const stood = await place();
  assert.ok(Math.abs(stood.axes[0] - (await axis(one, 'theta'))) < 0.02);
});

/**
 * Waits until the axes stand, at most 5 s, and checks that they still do half a second later. The cell reports it: a page drawn in
 * software shows an axis late. It gives no position while an axis moves.
 */
async function stands() {
  const where = async () => (await place()).axes?.[0];
  await sleep(700);
  let then = await where();
  for (let i = 0; i < 22 && then === undefined; i += 1) {
    await sleep(200);
    then = await where();
  }
  await sleep(500);
  const now = await where();
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
  test(`jogging ends by ${way}`, async () => {
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

test('the cell stops by itself when the page hangs with the button held', async () => {
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
  await one.getByText('No one in control').waitFor();
  await control(one);
  await startJogging(one);
  // After a silence the cell wants to see the hand at rest before it moves again.
  await one.getByRole('button', { name: 'theta +' }).hover();
  await one.mouse.down();
  await sleep(200);
  await one.mouse.up();
  await stands();
});

test('the keyboard: an arrow moves while held, and no longer', async () => {
  let moved = 0;
  // Without a heartbeat it does not move: then once more.
  for (let tries = 0; tries < 3 && moved > -0.2; tries += 1) {
    await startJogging(one);
    await one.locator('.speeds button').nth(1).focus();
    const begun = await axis(one, 'theta');
    await one.keyboard.down('ArrowLeft');
    await sleep(800);
    await one.keyboard.up('ArrowLeft');
    await stands();
    moved = (await axis(one, 'theta')) - begun;
  }
  assert.ok(moved < -0.2, `theta moved by ${moved}`);
});

test('a key that sends all axes to a place: they go while it is held, and stand there', async () => {
  await held();
  await one.mouse.up();
  await stands();
  const theta = async () => (await place()).axes?.[0];
  const home = one.getByRole('button', { name: 'Home position' });
  const begun = await theta();
  assert.ok(Math.abs(begun) > 0.2, `theta is at home already: ${begun}`);
  // Let go early, it stops on the way.
  await home.hover();
  await one.mouse.down();
  for (let i = 0; i < 40 && Math.abs((await axis(one, 'theta')) - begun) < 0.05; i += 1) await sleep(20);
  await one.mouse.up();
  await stands();
  assert.ok(Math.abs((await theta()) - begun) >= 0.05, 'theta has not moved');
  // A heartbeat that is lost on the way stops it too: then the key is pressed again.
  for (let tries = 0; tries < 5 && Math.abs(await theta()) > 0.005; tries += 1) {
    await startJogging(one);
    await home.hover();
    await one.mouse.down();
    for (let i = 0; i < 50 && !(Math.abs(await theta()) <= 0.005); i += 1) await sleep(100);
    await one.mouse.up();
    await stands();
  }
  assert.ok(Math.abs(await theta()) < 0.02, `theta is not at home: ${await theta()}`);
});

test('recorded places become a program', async () => {
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

test('the page closed with the button held', async () => {
  await held();
  await one.close();
  await stands();
});
