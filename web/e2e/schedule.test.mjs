// A table of seams: imported, planned with progress, cancelled, sorted, filtered, drawn, exported, a row opened as a job.
import assert from 'node:assert/strict';
import { after, test } from 'node:test';
import { page as blank } from './browser.mjs';
import { axe, bench, quiet, settled, shot, tab } from './operator.mjs';

const TABLE = `name,template,machine,count,setup_min,seam.nozzle.radius_mm
*,hillside,torch-5axis,,12,
N1,,,4,,60
N2,,,2,,45
N3,,saddle-4axis|torch-5axis,,,50
N4,,,,,400
`;

const { one, cell } = await bench({ opens: 'only' });
after(() => quiet(one, /status of (409|422)/));

const upload = (name, text) => one.locator('input[type=file]').setInputFiles({ name, mimeType: 'text/csv', buffer: Buffer.from(text) });
const button = (name) => one.getByRole('button', { name, exact: true });
const names = () => one.locator('.schedule tbody tr td:nth-child(2)').allTextContents();

await tab(one, 'Jobs');
await button('Schedules →').click();

test('a table with a fault is refused with line and column, one without is listed', async () => {
  await upload('bad.csv', 'name,template\nN1,nothing\n');
  await one.getByText(/bad\.csv:2/).waitFor();
  await upload('nozzles.csv', TABLE);
  await one.getByRole('region', { name: 'nozzles.csv' }).waitFor();
  await one.locator('tbody tr').nth(3).waitFor();
  assert.deepEqual(await names(), ['N1', 'N2', 'N3', 'N4']);
  assert.equal(await one.getByRole('cell', { name: 'waiting' }).count(), 4);
});

test('its rows are planned with progress and cancelled, and go on where they were', async () => {
  await button('Plan all rows').click();
  await one.locator('.schedule progress').waitFor();
  await button('Cancel').click();
  await one.getByText(/cancelled; what was planned is kept/).waitFor({ timeout: 20_000 });
  await one.getByRole('button', { name: /^Plan (the missing|all) rows$/ }).click();
  await one.locator('.schedule progress').waitFor();
  await shot(one, 'schedule running');
  await one.locator('.schedule progress').waitFor({ state: 'detached', timeout: 180_000 });
  await one.getByRole('link', { name: 'CSV' }).waitFor();
  assert.equal(await one.getByRole('cell', { name: 'can be welded' }).count(), 3);
});

test('rows are sorted and filtered, and parts stand on their machines', async () => {
  await one.getByRole('columnheader', { name: 'Time, min' }).getByRole('button').click();
  const times = async () => (await one.locator('tbody tr td:nth-child(7)').allTextContents()).slice(0, 3).map(Number);
  const up = await times();
  assert.deepEqual(up, [...up].sort((a, b) => a - b));
  await one.getByRole('columnheader', { name: 'Time, min' }).getByRole('button').click();
  assert.deepEqual(await times(), [...up].reverse());
  await one.getByRole('group', { name: 'Show' }).getByRole('button', { name: /^invalid/ }).click();
  assert.deepEqual(await names(), ['N4']);
  await one.getByRole('group', { name: 'Show' }).getByRole('button', { name: /^all/ }).click();
  await one.getByRole('searchbox', { name: 'Search' }).fill('N2');
  assert.deepEqual(await names(), ['N2']);
  await one.getByRole('searchbox', { name: 'Search' }).fill('');
  // Four parts of N1, two of N2, one of N3.
  assert.equal(await one.locator('.gantt .line button').count(), 7);
  await one.locator('.gantt .line button', { hasText: 'N3' }).first().click();
  await one.locator('tr.chosen', { hasText: 'N3' }).waitFor();
  await settled(one, 300);
  await shot(one, 'schedule');
  await axe(one, 'schedule');
});

test('results are exported as CSV, Parquet and a report', async () => {
  const got = async (name) => {
    const answer = await one.request.get(new URL(await one.getByRole('link', { name }).getAttribute('href'), cell.address).href);
    assert.equal(answer.status(), 200, name);
    return answer.body();
  };
  // A fault has lines of its own.
  const csv = (await got('CSV')).toString().split('\n').filter((line) => /^([0-9]+|row),/.test(line));
  assert.ok(csv.length === 5 && csv[0].startsWith('row,name,status'), csv[0]);
  assert.equal((await got('Parquet')).subarray(0, 4).toString(), 'PAR1');
  assert.match((await got('Report')).toString(), /<html/);
});

test('a row is opened as a job with its values', async () => {
  await one.getByRole('button', { name: 'Open as a job: N1' }).click();
  await one.locator('p.name', { hasText: 'N1.toml' }).waitFor();
  await button('Text').click();
  await one.locator('.cm-content').getByText('radius_mm').first().waitFor();
  const text = (await one.locator('.cm-content').innerText()).replaceAll('\u00a0', ' ');
  assert.match(text, /radius_mm = 60/);
  assert.match(text, /machine = "torch-5axis"/);
});

test('in dark', async () => {
  const two = await blank(one.context().browser(), { dark: true });
  await two.context().addCookies(await one.context().cookies());
  await two.goto(new URL('/', cell.address).href);
  await two.waitForSelector('.panel');
  await tab(two, 'Jobs');
  await two.getByRole('button', { name: 'Schedules →' }).click();
  await two.getByRole('button', { name: 'Open' }).click();
  await two.getByRole('region', { name: 'nozzles.csv' }).waitFor();
  await settled(two, 500);
  await shot(two, 'schedule dark');
  // What is stale is grey.
  await two.waitForFunction(() => !document.querySelector('.stale'));
  await axe(two, 'schedule in dark');
});
