// Parts that were left in the middle, which the cell remembers by job and part.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { bench, commands, keep, loadFor, loadFromThere, mode, press, ready, SHORT, sleep, weld } from './operator.mjs';

const { one } = await bench();

/** Two passes; the second one is welded for longer. */
const [HEAD, PASS] = SHORT.split(/(?=\[\[passes\]\])/);
const passes = () => one.locator('.passes li button');
const ticks = async () => (await passes().allTextContents()).map((text) => text.includes('✓'));
const continues = (pass) => one.getByRole('button', { name: new RegExp(`^Continue pass ${pass}`) });

/** Welds until a pass is reached, and leaves it there. */
async function leaveIn(pass) {
  await commands(one);
  await weld(one);
  await one.locator(`.passes li:nth-child(${pass}) button.now`).waitFor({ timeout: 60_000 });
  await one.getByText(new RegExp(`Pass ${pass}: .*mm`)).first().waitFor();
  await one.keyboard.press('F1');
  await mode(one, 'ready');
}

test('a part that was left keeps its finished passes and its newest place, whatever is welded in between', async () => {
  await ready(one);
  const [first, second] = [PASS, PASS.replace('"short"', '"cap"').replaceAll(', 6]', ', 1]')];
  await keep(one, 'two.toml', HEAD + first + second);
  await loadFor(one, 'two.toml', 'N1-001');
  await leaveIn(2);
  await continues(2).waitFor();
  assert.deepEqual(await ticks(), [true, false]);
  await loadFor(one, 'first-weld.toml', 'G-1');
  await one.getByText(/part N1-001\) is unfinished: pass 2/).waitFor();
  assert.equal(await continues(2).count(), 0);
  await loadFor(one, 'two.toml', 'N1-001');
  await continues(2).waitFor();
  assert.deepEqual(await ticks(), [true, false]);
});

test('going on with the overlap that is offered is not asked about', async () => {
  const dialog = one.locator('dialog[open]');
  await commands(one);
  await continues(2).click();
  await loadFromThere(one);
  await weld(one);
  await sleep(1000);
  await one.keyboard.press('F1');
  await mode(one, 'ready');
  // The same place once more, with less than was welded over: it is asked about.
  await loadFor(one, 'two.toml', 'N1-001', [2, 0]);
  await press(one, /^Arm/);
  await press(one, /Start weld/);
  await dialog.getByText(/N1-001/).waitFor();
  // Enter, still held from Start, answers nothing.
  await one.keyboard.press('Enter');
  assert.ok(await dialog.isVisible());
  assert.equal(await one.locator('[data-mode]').getAttribute('data-mode'), 'ready');
  await dialog.getByRole('button', { name: 'Cancel' }).click();
  await dialog.waitFor({ state: 'hidden' });
});

test('what is finished is welded again only after a question that names it', async () => {
  await commands(one);
  await press(one, /^Arm/);
  await press(one, /Start weld/);
  const dialog = one.locator('dialog[open]');
  await dialog.getByText(/N1-001/).waitFor();
  await dialog.getByText(/Continue pass 2/).waitFor();
  await dialog.getByRole('button', { name: 'Cancel' }).click();
  await dialog.waitFor({ state: 'hidden' });
  assert.equal(await one.locator('[data-mode]').getAttribute('data-mode'), 'ready');
  await press(one, /Start weld/);
  await dialog.getByRole('button', { name: 'Weld it again' }).click();
  await mode(one, 'weld');
  await one.keyboard.press('F1');
  await mode(one, 'ready');
});
