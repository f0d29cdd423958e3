// All data as one file, and back: the cell begins anew with them, and everybody has to log in.
import assert from 'node:assert/strict';
import { readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { page } from './browser.mjs';
import { ask, axe, bench, commands, control, get, keep, logIn, mode, PASSWORD, press, quiet, SHORT, sleep, tab } from './operator.mjs';

const { one, cell, browser } = await bench({ opens: 'only' });

const data = (of) => of.getByRole('region', { name: 'Backup' });
const choose = (of, file) => data(of).getByLabel(/Backup file/).setInputFiles(file);
const check = (of) => data(of).getByRole('button', { name: 'Send and check' }).click();

test('a backup replaces all data after it was checked, with the machine off only', async () => {
  const ada = { role: 'admin', enabled: true, password: PASSWORD, own_password: null };
  // The first administrator is told what follows: the address that was printed is no key any more.
  await tab(one, 'Set-up');
  await one.getByRole('button', { name: 'Users', exact: true }).click();
  await one.getByLabel('User', { exact: true }).fill('ada');
  for (const field of [/New password \(/, 'New password once more']) await one.getByLabel(field).fill(PASSWORD);
  await one.getByRole('button', { name: 'Save', exact: true }).click();
  await one.getByText('Saved: ada. Log in as this user now').waitFor();
  await logIn(one, 'ada');
  await keep(one, 'yesterday.toml', SHORT);
  await tab(one, 'Set-up');
  await one.getByRole('button', { name: 'Backup', exact: true }).click();
  const [download] = await Promise.all([one.waitForEvent('download'), data(one).getByRole('link', { name: 'Download backup' }).click()]);
  const file = join(cell.data, '..', `${process.pid}-backup.tar`);
  assert.match(download.suggestedFilename(), /^seamwright-backup-\d{12}\.tar$/);
  await download.saveAs(file);
  // Today there is another job, and Eve.
  assert.equal((await ask(one, 'DELETE', '/api/jobs/yesterday.toml', {})).status, 204);
  await keep(one, 'today.toml', SHORT);
  assert.equal((await ask(one, 'PUT', '/api/users/eve', { ...ada, own_password: PASSWORD })).status, 200);
  // What is no backup, or not all of one, is said so.
  for (const [name, bytes, said] of [
    ['foreign', Buffer.from('PK something else'.repeat(100)), /Not a complete Seamwright backup/],
    ['cut', readFileSync(file).subarray(0, 9000), /Not a complete Seamwright backup/],
  ]) {
    const bad = join(cell.data, '..', `${process.pid}-${name}.tar`);
    writeFileSync(bad, bytes);
    await choose(one, bad);
    await check(one);
    await data(one).getByText(said).waitFor();
  }
  // With the drives on nothing is even checked.
  await control(one);
  await press(one, /Switch on/);
  await mode(one, 'idle', 'ready');
  await choose(one, file);
  await data(one).getByText('Switch the machine off first').waitFor();
  assert.ok(await data(one).getByRole('button', { name: 'Send and check' }).isDisabled());
  await commands(one);
  await press(one, /Switch off/);
  await mode(one, 'off');
  await check(one);
  await data(one).getByText('The backup is complete').waitFor();
  const other = await page(browser);
  await other.goto(new URL('/', cell.address).href);
  await logIn(other, 'eve');
  await data(one).getByRole('button', { name: /Replace all data/ }).click();
  const dialog = one.locator('dialog[open]');
  await axe(one, 'replacing data');
  await dialog.getByLabel(/own password/i).fill('not hers at all');
  await dialog.getByRole('button', { name: 'Replace all data' }).click();
  await data(one).getByText('Refused: your own password is needed for this, and it is wrong').waitFor();
  await data(one).getByRole('button', { name: /Replace all data/ }).click();
  await dialog.getByLabel(/own password/i).fill(PASSWORD);
  await dialog.getByRole('button', { name: 'Replace all data' }).click();
  // All are out; Eve is nobody any more.
  for (const of of [one, other]) await of.getByRole('button', { name: /Log in/ }).waitFor({ timeout: 60_000 });
  await logIn(one, 'ada');
  const jobs = (await get(one, '/api/jobs')).map((job) => job.name);
  assert.ok(jobs.includes('yesterday.toml') && !jobs.includes('today.toml'), `${jobs}`);
  assert.deepEqual((await get(one, '/api/users')).map((user) => user.name), ['ada']);
  const audit = (await get(one, '/api/audit')).map((row) => row.result.text);
  assert.ok(audit.some((result) => result.includes("before-restore-")), `${audit}`);
  const kept = readdirSync(cell.data).find((name) => name.startsWith('before-restore-'));
  assert.ok(readdirSync(join(cell.data, kept, 'jobs')).includes('today.toml'));
  await sleep(300);
  await other.close();
  quiet(one, /40[0-9]|422|WebSocket|ERR_CONNECTION/);
});
