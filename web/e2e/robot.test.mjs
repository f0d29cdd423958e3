// A robot: jogging in frames and about the tip, typed targets, configuration, the reach map.
import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { page as blank } from './browser.mjs';
import { axe, bench, commands, get, jobText, keep, load, openJob, planned, quiet, ready, settled, shot, sleep, startJogging, tab } from './operator.mjs';

/** A weld of an arm beside its home position, with a wall 400 mm behind it. */
const job = (wall) => `schema = 1
title = "Arm"
machine = "ur10e"
[[passes]]
name = "short"
[passes.points]
columns = ["j1", "j2", "j3", "j4", "j5", "j6", "current_a", "speed_mm_s"]
start = [0, -90, -90, -90, 90, 0, 200, 0]
[[passes.points.spans]]
along = "line"
points = [[1, -90, -90, -90, 90, 0, 200, 6], [2, -90, -90, -90, 90, 0, 200, 6]]
[[fixtures]]
name = "wall"
shape.box = { size_mm = [600, 20, 600] }
at = { move_mm = [${wall.join(', ')}] }
`;

const { one, cell } = await bench({ scenes: true });
// Whoever asks where a moving machine stands is refused.
after(() => quiet(one, /status of 409 .*\/api\/position/));

await keep(one, 'arm.toml', job([5000, 0, 0]));
await load(one, 'arm.toml');
// Drawing the machine by software may cost the page its heartbeat.
await settled(one, 1500);
await commands(one);
await ready(one);
const home = (await get(one, '/api/position')).tip;
await keep(one, 'arm.toml', job([home[0], home[1] - 400, home[2]]));
await load(one, 'arm.toml');

const where = () => get(one, '/api/position');

/** Waits until the axes stand, and tells where. */
async function stands() {
  for (let i = 0; i < 100; i += 1) {
    await sleep(100);
    const { axes, tip } = await where();
    if (axes) return { axes, tip };
  }
  throw new Error('the axes do not come to rest');
}

/** Holds a key until `enough` says so of the place; again if the page has lost its heartbeat meanwhile. */
async function hold(key, enough) {
  for (let tries = 0; tries < 6; tries += 1) {
    await startJogging(one);
    await key.hover();
    await one.mouse.down();
    await sleep(700);
    await one.mouse.up();
    const now = await stands();
    if (enough(now)) return now;
  }
  throw new Error('the key moves nothing');
}

const far = (a, b) => Math.hypot(...[0, 1, 2].map((i) => a[i] - b[i]));
const group = (name) => one.getByRole('group', { name, exact: true });
const jog = (name) => one.getByRole('button', { name, exact: true });

test('the tip goes along the axes of the chosen frame, and the torch turns about it', async () => {
  await startJogging(one);
  await group('Move by').getByRole('button', { name: 'Torch tip' }).click();
  await group('Frame').getByRole('button', { name: 'Tool', exact: true }).click();
  const from = await stands();
  const moved = await hold(jog('Z +'), (now) => far(now.tip, from.tip) > 1);
  // Towards the work: against the direction out of it.
  const by = [0, 1, 2].map((i) => moved.tip[i] - from.tip[i]);
  const along = by.reduce((sum, v, i) => sum - v * from.tip[3 + i], 0);
  assert.ok(Math.abs(along - Math.hypot(...by)) < 0.1, `${by} is not along the tool`);
  await group('Move by').getByRole('button', { name: 'About the tip' }).click();
  const begun = await stands();
  const turned = await hold(jog('RX +'), (now) => Math.hypot(...[3, 4, 5].map((i) => now.tip[i] - begun.tip[i])) > 0.005);
  assert.ok(far(turned.tip, begun.tip) < 0.6, `the tip left its place by ${far(turned.tip, begun.tip)} mm`);
  // Larger steps than a degree are not offered.
  assert.equal(await one.locator('.steps button').count(), 4);
});

test('the configuration is shown with its turns, and the orientation in three conventions', async () => {
  const readouts = one.getByRole('complementary', { name: 'Read-outs' });
  await readouts.getByText('Elbow').waitFor();
  await readouts.getByText(/Turns/).waitFor();
  const names = async () => (await readouts.locator('dl.pairs dt').allTextContents()).map((name) => name.trim());
  assert.deepEqual(await names(), ['X', 'Y', 'Z', 'RX', 'RY', 'RZ']);
  const next = readouts.locator('button.convention');
  await next.click();
  assert.deepEqual(await names(), ['X', 'Y', 'Z', 'A', 'B', 'C']);
  await next.click();
  assert.deepEqual(await names(), ['X', 'Y', 'Z', 'Q1', 'Q2', 'Q3', 'Q4']);
  await next.click();
});

test('a typed target is checked and shown before it moves, and gone to while the key is held', async () => {
  await startJogging(one);
  const from = await stands();
  await jog('Typed target ▾').click();
  const form = one.locator('form', { has: jog('Check') });
  await form.getByRole('button', { name: 'Torch tip' }).click();
  await form.getByRole('combobox', { name: 'Orientation' }).selectOption('kept');
  const field = (name) => form.getByLabel(name, { exact: true });
  await field('Y mm').fill(String(home[1] - 400));
  await jog('Check').click();
  await form.getByText('the axes would stop on the way').waitFor();
  await form.getByText(/wall/).waitFor();
  assert.equal(await jog('Go there (hold)').count(), 0, 'what the cell would refuse is not offered');
  await settled(one, 600);
  await shot(one, 'robot target refused');
  await field('Y mm').fill(String(from.tip[1]));
  await field('Z mm').fill(String((from.tip[2] + 40).toFixed(3)));
  await jog('Check').click();
  await jog('Go there (hold)').waitFor();
  const still = await stands();
  assert.ok(far(still.tip, from.tip) < 0.05, 'checking moves nothing');
  await settled(one, 600);
  await shot(one, 'robot target');
  await axe(one, 'jog page with a target');
  for (let tries = 0; tries < 6 && Math.abs((await stands()).tip[2] - from.tip[2] - 40) > 0.1; tries += 1) {
    await startJogging(one);
    await jog('Go there (hold)').hover();
    await one.mouse.down();
    await sleep(2500);
    await one.mouse.up();
  }
  const there = await stands();
  assert.ok(Math.abs(there.tip[2] - from.tip[2] - 40) < 0.1 && Math.abs(there.tip[1] - from.tip[1]) < 0.1, `${there.tip}`);
  await jog('Typed target ▴').click();
});

/** Opens the page of frames. */
async function openFrames() {
  await tab(one, 'Set-up');
  await one.getByRole('group', { name: 'Pages of the set-up' }).getByRole('button', { name: 'Frames', exact: true }).click();
  await one.getByText('Tool centre point (TCP)').waitFor();
}

const entry = (name) => one.locator('.scrolls li', { has: one.getByText(name, { exact: true }) });

test('frames are shown in three conventions, changed and put back', async () => {
  await openFrames();
  for (const name of ['Base', 'Flange', 'Tool', 'Work']) await entry(name).waitFor();
  await entry('Tool').getByText(/X 90\.00 {2}Y 0\.00 {2}Z 330\.00 {2}RX 0\.000° {2}RY 35\.000°/).waitFor();
  const convention = one.locator('.scrolls').getByRole('combobox', { name: 'Orientation' });
  await convention.selectOption('abc');
  await entry('Tool').getByText(/A 0\.000° {2}B 35\.000° {2}C 0\.000°/).waitFor();
  await convention.selectOption('quaternion');
  await entry('Tool').getByText(/Q1 0\.953717/).waitFor();
  await convention.selectOption('xyz');
  await entry('Tool').getByRole('button', { name: 'Change' }).click();
  const form = one.locator('form.edit');
  await form.getByLabel('Z mm', { exact: true }).fill('400');
  await form.getByRole('button', { name: 'Save' }).click();
  // Far from what it was: confirmed by a second press.
  await form.getByText(/Large change: 70\.0 mm/).waitFor();
  await form.getByRole('button', { name: 'Save' }).click();
  await entry('Tool').getByText(/before: X 90\.00 {2}Y 0\.00 {2}Z 330\.00/).waitFor();
  await one.getByText(/takes effect|in force|Saved/).first().waitFor();
  await settled(one, 300);
  await shot(one, 'frames');
  await axe(one, 'frames');
  await entry('Tool').getByRole('button', { name: 'Put the old one back' }).click();
  await entry('Tool').getByText(/Z 330\.00/).first().waitFor();
  assert.match(await one.evaluate(async () => (await (await fetch('/api/frames')).json()).file), /ur10e\.toml$/);
});

test('a user frame is taught by three points, and the tip goes along it', async () => {
  await startJogging(one);
  await group('Move by').getByRole('button', { name: 'Torch tip' }).click();
  await group('Frame').getByRole('button', { name: 'Work', exact: true }).click();
  await one.locator('.speeds button').nth(3).click();
  await openFrames();
  await one.getByRole('button', { name: 'New user frame' }).click();
  const form = one.locator('form.edit');
  await form.getByLabel('Name').fill('table');
  const record = async (name) => {
    await form.getByRole('button', { name: `Record: ${name}` }).and(one.locator(':enabled')).click();
    await form.getByRole('button', { name: `✓ Record: ${name}` }).waitFor();
  };
  assert.ok(await form.getByRole('button', { name: 'Save' }).isVisible());
  await record('Origin');
  const far = async (key, i) => {
    const begun = (await stands()).tip[i];
    await hold(jog(key), (now) => Math.abs(now.tip[i] - begun) > 30);
    await openFrames();
  };
  // What was recorded is there again after the visit to the other page.
  await far('Y −', 1);
  await record('Point on the x axis');
  await far('X −', 0);
  await record('Point on the side of y');
  await form.getByText(/Points .* mm apart/).waitFor();
  await form.getByRole('button', { name: 'Save' }).click();
  await entry('table').waitFor();
  await startJogging(one);
  await group('Move by').getByRole('button', { name: 'Torch tip' }).click();
  await group('Frame').getByRole('button', { name: 'table' }).click();
  const from = await stands();
  const moved = await hold(jog('X −'), (now) => Math.hypot(...[0, 1, 2].map((i) => now.tip[i] - from.tip[i])) > 5);
  const [x, y, z] = [0, 1, 2].map((i) => moved.tip[i] - from.tip[i]);
  // The x axis of the frame is -y of the work.
  assert.ok(y > 5 && Math.abs(x) < 0.1 * y && Math.abs(z) < 0.1 * y, `${[x, y, z]}`);
});

test('the plan of a pass has the configuration of the arm, at its start and at picked places', async () => {
  await openJob(one, 'arm', 'Open');
  await one.getByRole('button', { name: 'Plots', exact: true }).click();
  await one.locator('.right .page').getByText(/Configuration:/).waitFor();
  await one.locator('.right .page p.arm', { hasText: /Elbow/ }).waitFor();
  await one.getByRole('button', { name: /^Findings/ }).click();
});

test('the reach map: searched with progress, the best place put into the job by one press and taken out by one', async () => {
  const ellipse = await jobText(one, 'ellipse.toml');
  await keep(one, 'edge.toml', `${ellipse}\n[placement]\nmove_mm = [200, 0, 0]\n`);
  await openJob(one, 'edge', 'Open');
  await one.getByRole('button', { name: 'Reach', exact: true }).click();
  const page = one.locator('.right .page');
  for (const [name, value] of [['X from', '-300'], ['X to', '300'], ['X places', '5'], ['Y from', '-100'], ['Y to', '100'], ['Y places', '3']]) {
    await page.getByRole('textbox', { name }).fill(value);
  }
  // Cancelled, nothing stays.
  await page.getByRole('button', { name: 'Search the best place' }).click();
  await page.locator('progress').waitFor();
  await page.getByRole('button', { name: 'Cancel' }).click();
  await page.locator('progress').waitFor({ state: 'detached' });
  await page.getByRole('button', { name: 'Search the best place' }).click();
  await page.getByText('✓ Best place').waitFor({ timeout: 120_000 });
  assert.equal(await page.locator('.map .place').count(), 15);
  await page.locator('.map .place').first().click();
  await settled(one, 300);
  await shot(one, 'reach map');
  await axe(one, 'reach map');
  await page.getByRole('button', { name: 'Put into the job' }).click();
  const text = async () => {
    await one.getByRole('button', { name: 'Text', exact: true }).click();
    await one.locator('.cm-content').waitFor();
    return (await one.locator('.cm-content').innerText()).replaceAll('\u00a0', ' ');
  };
  assert.doesNotMatch(await text(), /move_mm = \[200, 0, 0\]/);
  await page.getByRole('button', { name: 'Undo' }).click();
  assert.match(await text(), /move_mm = \[200, 0, 0\]/);
  await one.getByRole('button', { name: /^Findings/ }).click();
  await planned(one);
});

test('in dark, as an operator sees it', async () => {
  const browser = one.context().browser();
  const two = await blank(browser, { dark: true });
  const state = await one.context().cookies();
  await two.context().addCookies(state);
  await two.goto(new URL('/', cell.address).href);
  await two.waitForSelector('.panel');
  await tab(two, 'Jog · Teach');
  await settled(two, 1500);
  await shot(two, 'robot jog dark');
  // What is stale is grey.
  await two.waitForFunction(() => !document.querySelector('.stale'));
  await axe(two, 'jog page in dark');
  await two.close();
});
