// What an operator has written is not lost, not replaced unasked, and not taken for something else.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { bench, jobText, keep, mode, openJob, quiet, ready, record, SHORT, sleep, startJogging, tab } from './operator.mjs';

const { one } = await bench();
const text = (name) => jobText(one, name);
const cellOf = (title, i) => one.getByRole('textbox', { name: `${title} ${i}`, exact: true });
const kept = () => one.waitForFunction(() => !/not saved/.test(document.querySelector('.bar .name')?.textContent ?? ''));

test('a row of points is written from field to field by the keyboard; keys of the machine move nothing there', async () => {
  await ready(one);
  await keep(one, 'short.toml', SHORT);
  await openJob(one, 'short.toml', 'Open');
  await one.getByRole('button', { name: 'Points', exact: true }).click();
  const first = cellOf('theta °', 1);
  await first.fill('5');
  await one.keyboard.press('Tab');
  await one.keyboard.type('1');
  await one.keyboard.press('Tab');
  await one.keyboard.type('61');
  await one.keyboard.press('Tab');
  const here = await one.evaluate(() => document.activeElement?.getAttribute('aria-label'));
  assert.match(here ?? '', /^beta/, 'the field after the third is in hand');
  await one.waitForFunction(() => document.querySelector('[aria-label="theta ° 1"]')?.value === '5' && document.querySelector('[aria-label="s mm 1"]')?.value === '1');
  await one.locator('tbody tr').nth(2).getByRole('button').first().focus();
  for (const key of ['r', 'Home', 's']) await one.keyboard.press(key);
  await sleep(600);
  await mode(one, 'ready');
  assert.equal(await one.locator('[data-mode]').getAttribute('data-mode'), 'ready');
  quiet(one);
});

test('what is no number is said, and does not stand in the table', async () => {
  const field = cellOf('h mm', 2);
  const was = await field.inputValue();
  for (const wrong of ['12.3.4', 'abc', '', '1e400']) {
    await field.fill(wrong);
    await field.press('Enter');
    await one.getByText(`Not a number. Keeping ${was}.`).waitFor();
    assert.equal(await field.inputValue(), was, wrong);
  }
});

test('Save keeps what was just written, also where the line is slow, and says saved of nothing else', async () => {
  await one.route('**/api/edit', async (route) => {
    await sleep(400);
    await route.continue();
  });
  const field = cellOf('h mm', 3);
  await field.fill('59');
  await one.getByRole('button', { name: 'Save', exact: true }).click();
  await kept();
  assert.match(await text('short.toml'), /59/);
  await field.fill('58');
  await one.keyboard.press('Control+s');
  await kept();
  assert.match(await text('short.toml'), /58/);
  assert.equal(await one.evaluate(() => document.activeElement?.getAttribute('aria-label')), 'h mm 3');
  await one.unroute('**/api/edit');
});

test('a job of somebody else is replaced only when that is said; a copy gets a name that nothing has', async () => {
  await keep(one, 'short.toml', SHORT.replace('Short', 'Elsewhere'));
  await cellOf('h mm', 3).fill('57');
  await one.keyboard.press('Tab');
  await one.getByRole('button', { name: 'Save', exact: true }).click();
  const dialog = one.locator('dialog[open]');
  await dialog.getByText(/short.toml exists with other text/).waitFor();
  await dialog.getByRole('button', { name: 'Cancel' }).click();
  assert.match(await text('short.toml'), /Elsewhere/);
  await one.getByRole('button', { name: 'Save', exact: true }).click();
  await dialog.getByRole('button', { name: 'Replace' }).click();
  await kept();
  assert.match(await text('short.toml'), /57/);
  await keep(one, 'saddle-1.toml', SHORT);
  await openJob(one, 'saddle.toml');
  await one.getByRole('button', { name: 'Save as' }).click();
  const name = dialog.getByRole('textbox');
  assert.equal(await name.inputValue(), 'saddle-2');
  await name.fill('saddle-1');
  await dialog.getByRole('button', { name: 'Save', exact: true }).click();
  await one.getByText(/saddle-1.toml exists with other text/).waitFor();
  await dialog.last().getByRole('button', { name: 'Cancel' }).click();
  assert.match(await text('saddle-1.toml'), /Short/);
  await one.locator('dialog[open]').getByRole('button', { name: 'Cancel' }).click();
});

test('a procedure that was changed is asked about, one that cannot be is refused, and a copy replaces none', async () => {
  const form = one.locator('.form');
  await form.getByRole('button', { name: /^▸ Procedure/ }).click();
  await form.getByRole('button', { name: 'Make a copy' }).click();
  const speed = form.getByRole('textbox', { name: 'speed [mm/s] 2' });
  await form.getByRole('button', { name: 'Save procedure' }).waitFor();
  await speed.fill('9');
  await one.getByRole('button', { name: 'Text', exact: true }).click();
  await one.getByRole('button', { name: 'Form', exact: true }).click();
  await form.getByRole('button', { name: /^▸ Procedure/ }).click();
  assert.equal(await speed.inputValue(), '9', 'another page has not lost it');
  await form.getByRole('button', { name: 'Save procedure' }).click();
  while (!/speed_mm_s.*9/.test(await text('saddle-135-saddle.toml'))) await sleep(100);
  await speed.fill('-9');
  await form.getByRole('button', { name: 'Save procedure' }).click();
  await form.locator('.note.fault', { hasText: 'saddle-135-saddle.toml' }).waitFor();
  assert.doesNotMatch(await text('saddle-135-saddle.toml'), /-9/);
  await openJob(one, 'saddle.toml');
  await form.getByRole('button', { name: /^▸ Procedure/ }).click();
  await form.getByRole('button', { name: 'Make a copy' }).click();
  await form.getByRole('button', { name: 'Save procedure' }).waitFor();
  assert.match(await text('saddle-135-saddle-2.toml'), /speed_mm_s/);
  assert.match((await text('saddle-135-saddle.toml')).match(/speed_mm_s.*/)[0], /9/);
});

test('the page is not left without a question while something is not saved', async () => {
  let asked = 0;
  one.on('dialog', (dialog) => {
    asked += 1;
    void dialog.dismiss();
  });
  await one.evaluate(() => setTimeout(() => location.reload(), 0));
  await sleep(1500);
  assert.equal(asked, 1);
  await one.getByRole('button', { name: '← Jobs' }).click();
  await one.getByRole('button', { name: 'Discard changes' }).click();
  await one.locator('li.card').first().waitFor();
});

test('points recorded by hand come back after Clear and over a reload, and belong to their machine', async () => {
  await startJogging(one);
  const points = one.getByRole('button', { name: /^Remove point/ });
  for (let i = 0; i < 3; i += 1) await record(one);
  assert.equal(await points.count(), 3);
  await one.getByRole('button', { name: 'Clear', exact: true }).click();
  assert.equal(await points.count(), 0);
  await one.getByRole('button', { name: 'Bring back 3 points' }).click();
  await one.reload();
  await one.waitForSelector('.panel');
  await tab(one, 'Jog · Teach');
  await points.nth(2).waitFor();
  assert.equal(await points.count(), 3);
  const section = one.locator('section', { hasText: 'Teach by hand' });
  await section.getByRole('textbox').fill('short');
  await section.getByRole('spinbutton').fill('-5');
  await section.getByRole('button', { name: 'Save as program' }).click();
  await section.getByText(/mm\/s: Allowed: (more than 0|a number greater than 0)/).waitFor();
  await section.getByRole('spinbutton').fill('5');
  await section.getByRole('button', { name: 'Save as program' }).click();
  await one.locator('dialog[open]').getByText(/short.toml exists with other text/).waitFor();
  await one.locator('dialog[open]').getByRole('button', { name: 'Cancel' }).click();
  await one.evaluate(() => {
    const of = JSON.parse(sessionStorage.getItem('seamwright.taught'));
    sessionStorage.setItem('seamwright.taught', JSON.stringify({ ...of, machine: 'torch-5axis y z a b x' }));
  });
  await one.reload();
  await one.waitForSelector('.panel');
  await tab(one, 'Jog · Teach');
  await section.getByText(/recorded on torch-5axis/).waitFor();
  assert.ok(await section.getByRole('button', { name: 'Save as program' }).isDisabled());
  // What was refused above the browser tells on its console too.
  one.wrong = one.wrong.filter((said) => !/status of (409|422)/.test(said));
  quiet(one);
});

test('numbers of an axis stay typed while another is looked at; one that is ten times as much is asked about', async () => {
  await tab(one, 'Set-up');
  await one.getByRole('button', { name: 'Axes and drives' }).click();
  const axes = one.getByRole('group', { name: 'Axis' });
  const speed = one.getByRole('textbox', { name: /^Max. speed/ }).first();
  await axes.getByRole('button').nth(1).click();
  const was = await speed.inputValue();
  await speed.fill(String(Number(was) * 10));
  await axes.getByRole('button').nth(0).click();
  assert.notEqual(await speed.inputValue(), String(Number(was) * 10));
  await tab(one, 'Weld');
  await tab(one, 'Set-up');
  await one.getByRole('button', { name: 'Axes and drives' }).click();
  await axes.getByRole('button', { name: '•' }).click();
  assert.equal(await speed.inputValue(), String(Number(was) * 10));
  await one.getByRole('button', { name: 'Save', exact: true }).click();
  const dialog = one.locator('dialog[open]');
  await dialog.getByText(`${was} → ${Number(was) * 10}`).waitFor();
  await dialog.getByRole('button', { name: 'Cancel' }).click();
  await one.getByRole('button', { name: 'Cancel' }).click();
  assert.equal(await speed.inputValue(), was);
});
