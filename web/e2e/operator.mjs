// What an operator does, in the panel's own words (English).
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { join } from 'node:path';
import { after } from 'node:test';
import { launch, page as blank } from './browser.mjs';
import { startCell } from './cell.mjs';

/**
 * A cell with a job (see `startCell`), a browser and a page for the tests of a file, ended after them. With `scenes` the browser draws
 * them. The page shows the panel, in control of the cell: `opens` can be false for neither, or 'only'.
 */
export async function bench({ job, scenes = false, opens = true, ...view } = {}) {
  const cell = await startCell(job);
  const browser = await launch({ scenes });
  after(async () => {
    await browser.close();
    await cell.end();
  });
  const one = await blank(browser, view);
  if (opens) await open(one, cell.address);
  if (opens === true) await control(one);
  return { cell, browser, one };
}

/** What the server answers to a request of the page's own, with the token of its session. */
export const ask = (page, method, path, body) =>
  page.evaluate(
    async ([how, where, text]) => {
      const session = await (await fetch('/api/session')).json();
      const headers = { 'content-type': 'application/json', 'x-seamwright': session.token };
      const answer = await fetch(where, { method: how, headers, body: text });
      return { status: answer.status, ...(await answer.json().catch(() => ({}))) };
    },
    [method, path, JSON.stringify(body)],
  );

/** What the server answers to a question of the page's own. */
export const get = (page, path) => page.evaluate(async (of) => (await fetch(of)).json(), path);

/** The text of a job. */
export const jobText = async (page, name) => (await get(page, `/api/jobs/${name}`)).text;

export const PASSWORD = 'correct horse battery';

export async function logIn(page, user) {
  await page.getByLabel('User').fill(user);
  await page.getByLabel('Password').fill(PASSWORD);
  await page.getByRole('button', { name: /Log in/ }).click();
  await page.waitForSelector('.panel', { timeout: 30_000 });
}

/** A page that drew a second by software has lost its heartbeat, and control with it: then it takes it again. */
export async function commands(page) {
  if (await page.getByRole('button', { name: 'Take control' }).isVisible()) await control(page);
}

/** A weld of a few seconds with the machine of the saddle: a turn of its first axis. */
export const SHORT = `schema = 1
title = "Short"
machine = "saddle-4axis"

[[passes]]
name = "short"

[passes.points]
columns = ["theta", "s", "h", "beta", "current_a", "speed_mm_s"]
start = [0, 0, 60, -20, 200, 0]

[[passes.points.spans]]
along = "line"
points = [
    [4, 0, 60, -20, 200, 6],
    [8, 0, 60, -20, 210, 6],
    [12, 0, 60, -20, 200, 6],
]
`;

export async function open(page, address) {
  const to = new URL(address);
  // Where only what is behind # differs, the page would stay.
  if (page.url().startsWith(to.origin)) to.search = String(Date.now());
  await page.goto(to.href);
  await page.waitForSelector('.panel');
  await page.waitForFunction(() => document.querySelector('[data-mode]')?.dataset.mode);
}

export const tab = (page, name) => page.getByRole('navigation').getByRole('button', { name, exact: true }).click();

/** The list of jobs, whatever was open and not kept. */
export async function jobs(page) {
  // The list is read when it comes into sight.
  for (const name of ['Records', 'Jobs']) await tab(page, name);
  const back = page.getByRole('button', { name: '← Jobs' });
  if (!(await back.isVisible())) return;
  await back.click();
  const discard = page.getByRole('button', { name: 'Discard changes' });
  await page.locator('li.card').or(discard).first().waitFor();
  if (await discard.isVisible()) await discard.click();
}

/** The card of a job in the list. */
export const row = (page, name) => page.locator('li.card', { hasText: name }).first();

/** Opens a job, as a new one from a template, and waits until it is planned. */
export async function openJob(page, name, key = 'New from template') {
  await jobs(page);
  await row(page, name).getByRole('button', { name: key }).click();
  await planned(page);
}

/** Waits until the job that is open is planned, or cannot be. */
export async function planned(page) {
  await page.locator('.right .page').getByText(/Can be welded|Cannot be welded|not a job/).waitFor({ timeout: 120_000 });
  await page.waitForFunction(() => !document.querySelector('.view.plans'), null, { timeout: 120_000 });
}

/** Uses the menu behind the user's name. */
export async function inMenu(page, act) {
  const key = page.getByRole('button', { name: /▾$/ });
  await key.click();
  await act(page.locator('header .menu'));
  await key.click();
}

export const press = (page, name) => page.getByRole('group', { name: 'Commands' }).getByRole('button', { name }).click();

export async function control(page) {
  await page.getByRole('button', { name: 'Take control' }).click();
  await page.getByText('In control: you').waitFor();
}

export async function mode(page, ...wanted) {
  await page.waitForFunction((list) => list.includes(document.querySelector('[data-mode]')?.dataset.mode), wanted, {
    timeout: 45_000,
  });
}

export const burns = (page, on) => page.waitForSelector(`[data-burns="${on}"]`, { timeout: 60_000 });

/** Keeps a job through the server, as the editor would. */
export async function keep(page, name, text) {
  const { status } = await ask(page, 'PUT', `/api/jobs/${name}`, { text });
  assert.ok(status < 300, `keeping ${name}: ${status}`);
}

export async function load(page, name, part = '') {
  await tab(page, 'Jobs');
  await commands(page);
  const row = page.locator('li.card', { hasText: name }).first();
  await row.getByRole('button', { name: 'Load' }).click();
  const dialog = page.locator('dialog[open]');
  await dialog.getByRole('textbox').fill(part);
  await dialog.getByRole('button', { name: 'Load' }).click();
  await dialog.waitFor({ state: 'hidden', timeout: 40_000 });
}

/** Loads a job through the server, for a part of which nothing is welded, or from a place on. */
export async function loadFor(page, job, part, from = null) {
  const { status } = await ask(page, 'POST', '/api/load', { job, part, from });
  assert.equal(status, 200);
}

/** Says that the crater was looked at, and loads the weld that was left, from there on. */
export async function loadFromThere(page) {
  const dialog = page.locator('dialog[open]');
  await dialog.getByRole('checkbox').check();
  await dialog.getByRole('button', { name: 'Load from there' }).click();
  await dialog.waitFor({ state: 'hidden', timeout: 60_000 });
}

/** Homes as soon as the drives have power: until then the key is greyed, so it is never refused. */
export async function home(page) {
  await mode(page, 'idle', 'ready');
  await commands(page);
  await press(page, /^Home/);
  await mode(page, 'homing', 'ready');
  assert.ok(!(await page.getByText('Refused:').isVisible()), 'Home was pressed when it could be, and refused');
  await mode(page, 'ready');
}

/** From off to ready. */
export async function ready(page) {
  await press(page, /Switch on/);
  await home(page);
}

/** Arms and starts, as soon as nothing stands against it. */
export async function weld(page) {
  await commands(page);
  await press(page, /^Arm/);
  await page.locator('.strip', { hasText: 'Armed' }).waitFor();
  await press(page, /Start weld/);
  await mode(page, 'weld');
}

/** Jogs on its page, also after a silence took control. */
export async function startJogging(page) {
  await tab(page, 'Jog · Teach');
  await commands(page);
  const start = page.getByRole('button', { name: 'Start jogging' });
  await start.or(page.getByRole('button', { name: 'End jogging' })).first().waitFor();
  if (await start.isVisible()) await start.click();
  await mode(page, 'jog', 'teach');
}

/** What the read-out of an axis shows. */
export async function axis(page, name) {
  const text = await page.locator('aside dl div', { has: page.locator('dt', { hasText: name }) }).last().locator('dd').textContent();
  return Number(text.replace('\u2212', '-').replace(/[^0-9.-]/g, ''));
}

/** Records the place the machine is at. The cell tells that place, so the point is there only when it has answered. */
export async function record(page) {
  const points = page.getByRole('button', { name: /^Remove point/ });
  const before = await points.count();
  await page.getByRole('button', { name: 'Record point' }).click();
  await points.nth(before).waitFor();
}

/** A picture of the page to look at, in the folder `SEAMWRIGHT_SHOTS`; without that none is made. */
export async function shot(page, name) {
  const folder = process.env.SEAMWRIGHT_SHOTS;
  if (folder) await page.screenshot({ path: join(folder, `${name.replaceAll(' ', '-')}.png`) });
}

/** Waits until the page is drawn as it is now; first for data, if `ms` says so. */
export const settled = (page, ms = 0) =>
  page.evaluate((wait) => new Promise((done) => setTimeout(() => requestAnimationFrame(() => requestAnimationFrame(done)), wait)), ms);

export const sleep = (ms) => new Promise((done) => setTimeout(done, ms));

/**
 * Nothing was said on the console but what the renderer says of itself, and that the program of a record was asked for again before
 * it was planned: then the first question is answered with 409. `besides` is what else the test provoked.
 */
export function quiet(page, besides = /^$/) {
  const renderer = page.context().browser().scenes ? 'GL Driver Message' : 'WebGL context';
  const expected = new RegExp(`${renderer}|status of 409 .*/records/[0-9]+/work$`);
  assert.deepEqual(page.wrong.filter((text) => !expected.test(text) && !besides.test(text)), []);
}

const AXE = readFileSync(createRequire(import.meta.url).resolve('axe-core/axe.min.js'), 'utf8');

/** Axe finds nothing on the page as it is now, an open dialog with it; `rules`: of these only. */
export async function axe(page, where, ...rules) {
  // Once for a page: reading all of it takes longer than a look.
  if (await page.evaluate(() => !('axe' in window))) await page.evaluate(AXE);
  const found = await page.evaluate(async (only) => {
    const { violations } = await window.axe.run({ resultTypes: ['violations'], ...(only.length > 0 && { runOnly: only }) });
    return violations.map((v) => `${v.id} ${v.nodes.map((n) => n.target.join(' ')).slice(0, 3).join(' | ')}`);
  }, rules);
  assert.deepEqual(found, [], where);
}

/** Tables that are wider than what they lie in, and what of them nobody can scroll to. */
export const cutOff = (page) =>
  page.evaluate(() =>
    [...document.querySelectorAll('table')].flatMap((table) => {
      const box = table.getBoundingClientRect();
      const clips = (of) => of && (getComputedStyle(of).overflowX === 'visible' ? clips(of.parentElement) : of);
      const around = table.closest('.card') ?? clips(table.parentElement);
      if (box.width === 0 || !around || table.closest('.wide')) return [];
      const over = Math.round(box.right - around.getBoundingClientRect().right);
      return over > 0 ? [`${table.textContent.trim().slice(0, 40)} by ${over}`] : [];
    }),
  );
