import assert from 'node:assert/strict';
import { test } from 'node:test';
import { axe, bench, jobs, jobText, keep, openJob, planned, quiet, row, SHORT, sleep } from './operator.mjs';

const { one } = await bench({ opens: 'only' });

/** A straight line in six points, as poses. */
const STRAIGHT = `schema = 1
title = "Straight"
machine = "torch-5axis"

[[passes]]
name = "straight"

[passes.points]
columns = ["x_mm", "y_mm", "z_mm", "ax", "ay", "az", "speed_mm_s"]
start = [0, 0, 0, 0, 0, 1, 0]

[[passes.points.spans]]
along = "line"
points = [
    [10, 0, 0, 0, 0, 1, 8],
    [20, 0, 0, 0, 0, 1, 8],
    [30, 0, 0, 0, 0, 1, 8],
    [40, 0, 0, 0, 0, 1, 8],
    [50, 0, 0, 0, 0, 1, 8],
]
`;

test('a number changed in the form, undone, done again; kept under a name; comments stay', async () => {
  await openJob(one, 'saddle.toml');
  const field = one.getByRole('textbox', { name: 'radius [mm]' }).first();
  assert.equal(await field.inputValue(), '250');
  await field.fill('240');
  await planned(one);
  await one.getByRole('button', { name: 'Undo' }).click();
  assert.equal(await field.inputValue(), '250');
  await one.getByRole('button', { name: 'Redo' }).click();
  assert.equal(await field.inputValue(), '240');
  await one.getByRole('button', { name: 'Save as' }).click();
  const dialog = one.locator('dialog[open]');
  await axe(one, 'save as');
  await dialog.getByRole('textbox').fill('mine');
  await dialog.getByRole('button', { name: 'Save' }).click();
  await dialog.waitFor({ state: 'hidden' });
  const text = await jobText(one, 'mine.toml');
  assert.match(text, /radius_mm = 240 +# outer radius/);
});

test('a job for another machine has the names and units of that machine, not of the cell', async () => {
  await openJob(one, 'hillside.toml');
  await one.getByRole('button', { name: 'Plots', exact: true }).click();
  await one.locator('.right .page .u-over').first().click();
  const card = one.locator('.below .card', { hasText: 'Pass 1' });
  await card.waitFor();
  const text = await card.textContent();
  for (const axis of [/ ?x [\d.\u2212]+mm/, /y [\d.\u2212]+mm/, /z [\d.\u2212]+mm/, /a [\d.\u2212]+°/, /b [\d.\u2212]+°/]) assert.match(text, axis);
  const titles = await one.locator('.right .page figcaption > span:first-child').allTextContents();
  assert.ok(titles.includes('x mm') && titles.includes('b °') && !titles.some((title) => title.includes('theta')), `${titles}`);
  await openJob(one, 'mine.toml', 'Open');
});

test('what is wrong is said with its line, and the text stays in hand', async () => {
  await one.getByRole('button', { name: 'Text', exact: true }).click();
  const editor = one.locator('.editor .cm-content');
  await editor.click();
  await one.keyboard.press('Control+Home');
  await one.keyboard.type('nonsense = 1\n');
  await one.locator('.right .note.fault').waitFor({ timeout: 30_000 });
  assert.match(await one.locator('.right .note.fault').textContent(), /nonsense/);
  await one.getByRole('button', { name: 'Undo' }).click();
  await one.getByText(/Can be welded|Cannot be welded/).waitFor({ timeout: 60_000 });
  quiet(one);
});

test('in the form what is no number stays out, what cannot be is marked where it stands; a seam that nobody can weld is drawn', async () => {
  await one.getByRole('button', { name: 'Form', exact: true }).click();
  const field = one.getByRole('textbox', { name: 'speed [mm/s]' }).first();
  const was = await field.inputValue();
  for (const none of ['abc', '']) {
    await field.fill(none);
    await one.getByText(`Not a number. Keeping ${was}.`).waitFor();
    assert.equal(await field.getAttribute('aria-invalid'), 'true');
    await field.blur();
    assert.deepEqual([await field.inputValue(), await field.getAttribute('aria-invalid')], [was, 'false']);
  }
  await field.fill('0');
  await one.locator('.left .fault', { hasText: 'Allowed: a finite number greater than 0' }).waitFor({ timeout: 30_000 });
  assert.equal(await field.getAttribute('aria-invalid'), 'true');
  assert.equal(await one.locator('.left [aria-invalid="true"]').count(), 1);
  await axe(one, 'a wrong number');
  await one.getByRole('button', { name: 'Limits', exact: true }).click();
  await one.getByText('This is the plan before the change').waitFor();
  await one.getByRole('button', { name: 'Text', exact: true }).click();
  await one.getByRole('button', { name: /^Findings/ }).click();
  await one.locator('.right .note.fault').getByRole('button', { name: /weld · speed \[mm\/s\] = 0/ }).click();
  await one.waitForFunction(() => document.activeElement?.getAttribute('aria-invalid') === 'true');
  await field.fill('4000');
  await one.getByText('Cannot be welded as programmed').waitFor({ timeout: 60_000 });
  await one.locator('.right .page li button').first().click();
  const card = one.locator('.below .card', { hasText: 'Pass 1' });
  await card.waitFor();
  assert.match(await card.textContent(), /4000\.00 mm\/s/);
  await one.getByRole('button', { name: 'Limits', exact: true }).click();
  await one.getByText('No plan (see Findings)').waitFor();
  await one.getByRole('button', { name: /^Findings/ }).click();
  for (let i = 0; i < 2 && (await field.inputValue()) !== was; i += 1) await one.getByRole('button', { name: 'Undo' }).click();
  assert.equal(await field.inputValue(), was);
  await one.getByText('Can be welded').waitFor({ timeout: 60_000 });
  quiet(one);
});

test('a part program for a control, with its proof', async () => {
  await one.getByRole('button', { name: 'G-code', exact: true }).click();
  await one.getByRole('button', { name: 'Make part program' }).click();
  await one.getByRole('textbox', { name: 'G-code' }).waitFor({ timeout: 120_000 });
  assert.match(await one.getByRole('textbox', { name: 'G-code' }).inputValue(), /G1|G93/);
  // It is of this text and of no other.
  const old = one.getByText('The job has changed since');
  assert.equal(await old.count(), 0);
  await one.getByRole('button', { name: 'Redo' }).click();
  await old.waitFor();
  assert.ok(await one.getByRole('button', { name: 'Download' }).isDisabled());
  await one.getByRole('button', { name: 'Undo' }).click();
  await old.waitFor({ state: 'hidden' });
  await one.getByRole('button', { name: '← Jobs' }).click();
});

test('points: set in several at once, insert, delete, undo; the row stands in 3D', async () => {
  await keep(one, 'short.toml', SHORT);
  await openJob(one, 'short.toml', 'Open');
  await one.getByRole('button', { name: 'Points', exact: true }).click();
  const points = one.locator('tbody tr');
  assert.equal(await points.count(), 4);
  const point = (i) => points.nth(i).getByRole('button');
  await point(1).click();
  await one.locator('.below .card', { hasText: 'Pass 1' }).waitFor();
  await point(3).click({ modifiers: ['Shift'] });
  await one.getByRole('combobox', { name: 'Column' }).selectOption('Current A');
  await one.getByRole('textbox', { name: 'Value' }).fill('222');
  await one.getByRole('button', { name: 'Apply to 3 points' }).click();
  const current = one.getByRole('textbox', { name: 'Current A 3' });
  await one.waitForFunction(() => document.querySelector('[aria-label="Current A 3"]')?.value === '222');
  await point(1).click();
  await one.getByRole('button', { name: 'Insert after' }).click();
  await one.waitForFunction(() => document.querySelectorAll('tbody tr').length === 5);
  await point(2).click();
  await one.getByRole('button', { name: 'Delete (1)' }).click();
  await one.waitForFunction(() => document.querySelectorAll('tbody tr').length === 4);
  for (let i = 0; i < 3; i += 1) await one.getByRole('button', { name: 'Undo' }).click();
  assert.equal(await current.inputValue(), '200');
  quiet(one);
});

test('points by touch: several without a key, a span split, lines reduced', async () => {
  await keep(one, 'straight.toml', STRAIGHT);
  await openJob(one, 'straight.toml', 'Open');
  await one.getByRole('button', { name: 'Points', exact: true }).click();
  const points = one.locator('tbody tr');
  assert.equal(await points.count(), 6);
  const point = (i) => points.nth(i).getByRole('button');
  for (const field of [point(1), one.getByRole('textbox', { name: 'Speed mm/s 1' })]) {
    const { height } = await field.boundingBox();
    assert.ok(height >= 44, `${height} px are too few for a finger`);
  }
  await point(1).click();
  await one.getByRole('button', { name: 'Multi-select' }).click();
  await point(3).click();
  await one.getByRole('button', { name: 'Apply to 2 points' }).waitFor();
  await one.getByRole('button', { name: 'Multi-select' }).click();
  await point(2).click();
  await one.getByRole('button', { name: 'Split here' }).click();
  const text = () => jobText(one, 'straight.toml');
  const saved = async (count) => {
    await one.getByRole('button', { name: 'Save', exact: true }).click();
    await one.getByRole('button', { name: 'Save', exact: true }).and(one.locator(':disabled')).waitFor();
    assert.equal((await text()).match(/passes\.points\.spans/g).length, count);
  };
  await one.getByRole('button', { name: 'Save', exact: true }).and(one.locator(':enabled')).waitFor();
  await saved(2);
  await one.getByRole('button', { name: 'Undo' }).click();
  await one.getByRole('button', { name: 'Reduce' }).click();
  await one.waitForFunction(() => document.querySelectorAll('tbody tr').length < 6);
  assert.equal(await points.count(), 2, 'a straight line is one');
  await jobs(one);
  quiet(one);
});

test('points: the way to them is chosen, an arc from two; undone byte by byte', async () => {
  await openJob(one, 'points.toml');
  await one.getByRole('button', { name: 'Points', exact: true }).click();
  const points = one.locator('tbody tr');
  const ways = async () => (await points.locator('td:nth-child(2)').allTextContents()).join(' ');
  const before = await ways();
  assert.equal(before, 'start line line arc spline spline spline spline');
  const choose = async (from, to, way) => {
    await points.nth(from).getByRole('button').click();
    await points.nth(to).getByRole('button').click({ modifiers: ['Shift'] });
    await one.getByRole('combobox', { name: 'Interpolation' }).selectOption(way);
    await one.getByRole('button', { name: /^Set interpolation/ }).click();
  };
  const is = (wanted) =>
    one.waitForFunction((of) => [...document.querySelectorAll('tbody td:nth-child(2)')].map((td) => td.textContent).join(' ') === of, wanted);
  await choose(4, 6, 'arc');
  await one.getByText('An arc is made of two points').waitFor();
  await choose(5, 6, 'line');
  await is('start line line arc spline line line spline');
  await one.getByRole('button', { name: 'Undo' }).click();
  await is(before);
  // The second of four points of the spline is what the arc goes through.
  await choose(4, 5, 'arc');
  await is('start line line arc arc spline spline');
  await planned(one);
  assert.equal(await one.getByRole('combobox', { name: 'Interpolation' }).locator('option').count(), 4, 'no rapid with the arc on');
  await one.getByRole('button', { name: 'Undo' }).click();
  await is(before);
  await one.locator('.bar').getByText('template').waitFor();
  await one.getByRole('button', { name: '← Jobs' }).click();
  quiet(one);
});

test('points with times can be cubics, which have the speeds of the spline; a speed is set', async () => {
  const timed = STRAIGHT.replace('"speed_mm_s"', '"time_s"').replaceAll(', 8],', ', 1.25],').replace('"line"', '"spline"');
  await keep(one, 'timed.toml', timed);
  await openJob(one, 'timed.toml', 'Open');
  await one.getByRole('button', { name: 'Points', exact: true }).click();
  const points = one.locator('tbody tr');
  await points.nth(1).getByRole('button').click();
  await points.nth(5).getByRole('button').click({ modifiers: ['Shift'] });
  await one.getByRole('combobox', { name: 'Interpolation' }).selectOption('cubic');
  await one.getByRole('button', { name: /^Set interpolation/ }).click();
  // Evenly along x: 10 mm in 1.25 s, at every point and where it begins.
  const speed = (i) => one.getByRole('textbox', { name: `X mm/s ${i}` });
  for (let i = 0; i < 6; i += 1) assert.equal(Number(await speed(i).inputValue()), 8);
  await planned(one);
  await speed(3).fill('10');
  await speed(3).press('Enter');
  await planned(one);
  assert.equal(await one.locator('.right .note.fault').count(), 0);
  await one.getByRole('button', { name: 'Insert after' }).and(one.locator(':disabled')).waitFor();
  await points.nth(3).getByRole('button').click();
  await one.getByRole('button', { name: 'Insert after' }).click();
  await one.waitForFunction(() => document.querySelectorAll('tbody tr').length === 7);
  // Halfway the cubic from 10 to 8 mm/s over 10 mm is slower than both: 1.5 x 8 - (10 + 8) / 4.
  assert.equal(Number(await speed(4).inputValue()), 7.5);
  assert.equal(await speed(3).inputValue(), '10');
  await planned(one);
  for (let i = 0; i < 3; i += 1) await one.getByRole('button', { name: 'Undo' }).click();
  await one.waitForFunction(() => ![...document.querySelectorAll('thead th')].some((th) => th.textContent === 'X mm/s'));
  await one.getByRole('button', { name: '← Jobs' }).click();
  quiet(one);
});

test('a joint and a procedure are added in the form; a procedure of its own is held against', async () => {
  await openJob(one, 'first-weld.toml');
  const form = one.locator('.form');
  const options = await form.getByRole('combobox', { name: 'machine' }).locator('option').allTextContents();
  assert.ok(options.some((text) => text.startsWith('torch-5axis · ')), `${options}`);
  await form.getByRole('combobox', { name: 'Add a section' }).selectOption('joint');
  await form.getByRole('button', { name: 'Add' }).click();
  await form.getByRole('textbox', { name: 'root gap [mm]' }).waitFor();
  await form.getByRole('textbox', { name: 'thickness [mm]' }).fill('8');
  await form.getByRole('combobox', { name: 'Kind of joint' }).selectOption('t_bevel');
  await form.getByRole('combobox', { name: 'prepared' }).waitFor();
  assert.equal(await form.getByRole('textbox', { name: 'thickness [mm]' }).inputValue(), '8', 'what both kinds have stays');
  await one.getByRole('button', { name: 'Cross-section' }).click();
  await one.locator('.right svg').first().waitFor();
  await form.locator('fieldset', { hasText: 'cap' }).first().getByRole('button', { name: 'Remove' }).click();
  await form.getByRole('textbox', { name: 'thickness [mm]' }).waitFor({ state: 'detached' });
  await one.getByRole('button', { name: 'Findings' }).click();
  // The procedure: its own copy, with a speed that the job is too fast for.
  await form.getByRole('button', { name: /^▸ Procedure/ }).click();
  assert.ok(await form.getByRole('textbox', { name: 'speed [mm/s] 2' }).isDisabled(), 'what ships is not changed');
  await form.getByRole('button', { name: 'Make a copy' }).click();
  await form.getByRole('button', { name: 'Save procedure' }).waitFor();
  await planned(one);
  await form.getByRole('textbox', { name: 'speed [mm/s] 2' }).fill('9');
  await form.getByRole('button', { name: 'Save procedure' }).click();
  await one.locator('.right .page').getByText('Outside WPS limits').waitFor({ timeout: 60_000 });
  // One that could not be read is not kept: what is wrong is told with the file's name.
  await form.getByRole('textbox', { name: 'speed [mm/s] 2' }).fill('-9');
  await form.getByRole('button', { name: 'Save procedure' }).click();
  await form.locator('.note.fault', { hasText: 'first-weld-135-saddle.toml' }).waitFor({ timeout: 30_000 });
  await jobs(one);
  assert.equal(await one.locator('li.card', { hasText: '135-saddle.toml' }).count(), 0, 'a procedure is no job');
  // The browser tells of it too.
  one.wrong = one.wrong.filter((said) => !said.includes('422'));
  quiet(one);
});

test('limits: what bounds the speed where, linked with 3D, and what is used of each axis', async () => {
  await openJob(one, 'ellipse.toml');
  const field = one.getByRole('textbox', { name: 'speed [mm/s]' }).first();
  await field.fill('60');
  // Planning begins when the hand rests.
  await sleep(800);
  await planned(one);
  await one.getByRole('button', { name: 'Limits', exact: true }).click();
  const page = one.locator('.right .page');
  const stretch = page.locator('li button', { hasText: /[xy]: (acceleration|jerk) / }).first();
  await stretch.click();
  const card = one.locator('.below .card', { hasText: 'Pass 1' });
  await card.waitFor();
  const [from, to] = (await stretch.textContent()).match(/([0-9.]+)–([0-9.]+) mm/).slice(1).map(Number);
  const at = Number((await card.textContent()).match(/: ([0-9.]+) mm/)[1]);
  assert.ok(at >= from - 1 && at <= to + 1, `${at} is not in ${from} to ${to}`);
  // Every chart shows its values there, as soon as it is drawn.
  await page.locator('figcaption').nth(2).getByText(`${at.toFixed(1)} mm`).waitFor();
  const captions = await page.locator('figcaption').allTextContents();
  assert.ok(captions.length === 3 && captions.every((text) => text.includes(`${at.toFixed(1)} mm`)), `${captions}`);
  assert.match(captions[1], /^ ?x.*speed ≤ \d.* % of \d.*mm\/s.*jerk ≤/);
  await jobs(one);
  quiet(one);
});

const table = (name) => one.locator('fieldset', { has: one.locator(`legend[title="${name}"]`) });
/** Waits until the text has this: the cell writes it. */
const inText = async (wanted) => {
  await one.getByRole('button', { name: 'Text', exact: true }).click();
  await one.locator('.cm-content').waitFor();
  await one.waitForFunction((of) => new RegExp(of).test(document.querySelector('.editor').shadowRoot.querySelector('.cm-content').innerText), wanted.source);
  await one.getByRole('button', { name: 'Form', exact: true }).click();
};

test('values of nested inline tables can be read and changed', async () => {
  await openJob(one, 'Hillside');
  const beads = table('beads');
  await beads.waitFor();
  const current = beads.getByRole('textbox', { name: 'current [A]' });
  assert.equal(await current.inputValue(), '150');
  assert.equal(await beads.getByRole('textbox', { name: 'layer thickness [mm]' }).count(), 3);
  for (const field of await beads.getByRole('textbox').all()) assert.ok((await field.boundingBox()).width >= 72);
  await current.fill('155');
  await inText(/process = \{ current_a = 155, voltage_v = 18/);
});

test('a value that the format allows can be added, with what it means', async () => {
  const shell = table('seam.nozzle.body.cylinder');
  const add = shell.getByRole('combobox', { name: 'Add a value' });
  assert.match(await add.locator('option[value="thickness_mm"]').getAttribute('title'), /Thickness of the wall/);
  await add.selectOption('thickness_mm');
  const thickness = shell.getByRole('textbox', { name: 'thickness [mm]' });
  await thickness.fill('12');
  await thickness.blur();
  await inText(/axis = \[1, 0, 0\]\s*\n\s*thickness_mm = 12/);
  // What it has is offered no longer.
  assert.equal(await add.locator('option[value="thickness_mm"]').count(), 0);
  // While a plan is made, what is said of the last one is dim.
  await one.locator('.view.plans').waitFor({ state: 'detached' });
  await axe(one, 'form');
  await jobs(one);
});

test('ten thousand points: the table has few rows in the page, and scrolls at once', async () => {
  const rows = Array.from({ length: 10_000 }, (_, i) => `    [${(i / 1000).toFixed(3)}, 0, 60, -20, 200, 6],`);
  await keep(one, 'long.toml', SHORT.replace(/points = \[[^]*\n\]/, `points = [\n${rows.join('\n')}\n]`));
  await jobs(one);
  await row(one, 'long.toml').getByRole('button', { name: 'Open' }).click();
  await one.getByRole('button', { name: 'Points', exact: true }).click();
  await one.locator('tbody tr').first().waitFor();
  assert.ok((await one.locator('tbody tr').count()) < 60);
  await one.locator('.box').evaluate((box) => (box.scrollTop = box.scrollHeight));
  await one.getByRole('button', { name: '10000', exact: true }).waitFor();
});
