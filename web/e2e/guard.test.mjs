// An alarm from its coming to its acknowledgement; who may not, may not, also past the buttons; foreign texts are text.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { page } from './browser.mjs';
import { ask, axe, bench, commands, jobs, keep, load, logIn, mode, open, openJob, PASSWORD, press, quiet, ready, row, SHORT, sleep, startJogging, tab } from './operator.mjs';

const EVIL = '<img src=x onerror=globalThis.pwned=1><script>globalThis.pwned=1</script>';
const { one, cell, browser } = await bench({ opens: false });

/** What the cell answers to a command over a socket of the page's own. */
const command = (of, what) =>
  of.evaluate(
    (name) =>
      new Promise((done, fails) => {
        const socket = new WebSocket(`ws://${location.host}/api/live`);
        socket.onopen = () => socket.send(JSON.stringify({ kind: 'command', seq: 1, ask: { do: name } }));
        socket.onmessage = (event) => {
          const said = JSON.parse(event.data);
          if (said.kind === 'answer') done(said);
        };
        socket.onclose = () => fails(new Error('closed'));
      }),
    what,
  );

test('an alarm is raised, shown with cause and action, and goes when it is acknowledged', async () => {
  let through = true;
  await one.routeWebSocket('**/api/live', (client) => {
    const server = client.connectToServer();
    // The hand is lost on the way, the page is not.
    client.onMessage((text) => (through || !text.includes('"jog"')) && server.send(text));
    server.onMessage((text) => client.send(text));
  });
  await open(one, cell.address);
  await commands(one);
  await ready(one);
  const silent = one.getByText(/panel silent/i).first();
  // A page that draws by software can lose control before it jogs: then once more.
  for (let tries = 0; tries < 6 && !(await silent.isVisible()); tries++) {
    await startJogging(one);
    await one.getByRole('button', { name: 'theta +' }).hover();
    await one.mouse.down();
    await sleep(400);
    through = false;
    await sleep(1500);
    await one.mouse.up();
    through = true;
  }
  await silent.waitFor();
  await commands(one);
  await press(one, /^❚❚ Hold|Hold/);
  await mode(one, 'ready');
  // It is kept until somebody says that he knows.
  await open(one, cell.address);
  await one.getByText(/panel silent/i).first().waitFor();
  await tab(one, 'Weld');
  await one.locator('section', { has: one.getByRole('button', { name: 'Events' }) }).getByRole('button', { name: /^Alarms/ }).first().click();
  await one.getByText(/network or browser/i).first().waitFor();
  const known = one.getByRole('button', { name: 'Acknowledge all' });
  // A page that draws by software may have lost control again: then it takes it again.
  for (let tries = 0; tries < 5 && (await known.isVisible()); tries++) {
    await commands(one);
    await known.click();
    await sleep(700);
  }
  await one.getByText('No alarms').first().waitFor();
  await one.unrouteAll({ behavior: 'ignoreErrors' });
});

test('titles, parts and comments are text on every page that shows them', async () => {
  const evil = SHORT.replace('"Short"', JSON.stringify(EVIL)).replace('name = "short"', `name = ${JSON.stringify(EVIL)} # ${EVIL}`);
  await keep(one, 'evil.toml', evil);
  await commands(one);
  await load(one, 'evil.toml', EVIL.slice(0, 110));
  await tab(one, 'Weld');
  await one.getByText('<img src=x').first().waitFor();
  await jobs(one);
  await row(one, 'evil.toml').getByText('<img src=x').first().waitFor();
  await openJob(one, 'evil.toml', 'Open');
  for (const name of ['Set-up', 'Records', 'Weld']) {
    await tab(one, name);
    await sleep(300);
  }
  assert.equal(await one.evaluate(() => globalThis.pwned), undefined);
  assert.equal(await one.locator('img').count(), 0);
  // The report is a page of its own, where nothing runs.
  const report = await one.context().newPage();
  await report.goto(String(new URL('/api/report?job=evil.toml', cell.address)), { timeout: 60_000 });
  await report.getByText('<img src=x').first().waitFor({ state: 'attached' });
  assert.equal(await report.evaluate(() => globalThis.pwned), undefined);
  assert.equal(await report.locator('img[src=x], script').count(), 0);
  await report.close();
});

/** The form for users, past what a browser keeps from being sent. */
const user = {
  page: async (of) => {
    await tab(of, 'Set-up');
    await of.getByRole('group', { name: 'Pages of the set-up' }).getByRole('button', { name: 'Users', exact: true }).click();
  },
  fill: async (of, name, role, password, again = password) => {
    await of.getByLabel('User', { exact: true }).fill(name);
    await of.getByLabel('Role').selectOption(role);
    await of.getByLabel('New password (', { exact: false }).fill(password);
    await of.getByLabel('New password once more').fill(again);
  },
};

test('roles are refused on the server, whatever the page shows', async () => {
  const own = { role: 'admin', enabled: true, password: PASSWORD, own_password: null };
  assert.equal((await ask(one, 'PUT', '/api/users/ada', own)).status, 200);
  // The printed address opens nothing any more, nor does the session that it gave.
  await one.reload();
  await logIn(one, 'ada');
  for (const role of ['viewer', 'operator']) {
    const made = await ask(one, 'PUT', `/api/users/${role}`, { ...own, role, own_password: PASSWORD });
    assert.equal(made.status, 200);
  }
  const refusals = { viewer: ['switch_on', 'home', 'arm', 'start_weld', 'hold', 'acknowledge'], operator: ['start_teach'] };
  const two = await page(browser);
  for (const [role, asks] of Object.entries(refusals)) {
    await two.context().clearCookies();
    await two.goto(new URL('/', cell.address).href);
    await logIn(two, role);
    for (const what of asks) {
      const answer = await command(two, what);
      assert.deepEqual([answer.ok, answer.why?.key], [false, 'role'], `${role} ${what}`);
    }
    assert.equal((await command(two, 'stop')).ok, true);
    for (const [method, path, body] of [
      ['PUT', '/api/jobs/mine.toml', { text: '' }],
      ['POST', '/api/post', { text: '', dialect: 'pmac' }],
      ['PUT', '/api/users/eve', { ...own, own_password: PASSWORD }],
    ]) {
      const answer = await ask(two, method, path, body);
      assert.deepEqual([answer.status, answer.key], [403, 'role'], `${role} ${method} ${path}`);
    }
    // A job is read, not written; its plan is for who may load it.
    await jobs(two);
    await row(two, 'saddle.toml').getByRole('button', { name: 'New from template' }).click();
    assert.ok(await two.getByRole('textbox', { name: 'radius [mm]' }).first().isDisabled());
    assert.equal(await two.getByRole('button', { name: 'Save as' }).count(), 0);
    if (role === 'operator') await two.locator('.right .page').getByText(/Can be welded|Cannot be welded/).waitFor({ timeout: 60_000 });
    assert.equal(await two.locator('.note.fault').count(), 0);
  }
  await two.close();
  one.wrong = one.wrong.filter((text) => !/40[13]/.test(text));
  quiet(one);
});

test('a user that is there is not changed unasked, and a password is typed twice', async () => {
  await user.page(one);
  const key = one.getByRole('button', { name: 'Save', exact: true });
  const save = async () => {
    await one.getByLabel('Your own password').first().fill(PASSWORD);
    await key.click();
  };
  await user.fill(one, 'cleo', 'Operator', PASSWORD, `${PASSWORD}r`);
  await one.getByText('The two passwords differ.').waitFor();
  assert.ok(await key.isDisabled());
  // Too short: the server says so, whatever the page lets through.
  await user.fill(one, 'cleo', 'Operator', 'short');
  await one.locator('form').evaluate((form) => (form.noValidate = true));
  await save();
  await one.getByText(/invalid length of the password/).waitFor();
  one.wrong = one.wrong.filter((text) => !text.includes('422'));
  await one.locator('form').evaluate((form) => (form.noValidate = false));
  await user.fill(one, 'cleo', 'Operator', PASSWORD);
  await save();
  await one.getByText('Saved: cleo.').waitFor();
  const cleo = one.locator('tr', { hasText: 'cleo' });
  await cleo.getByText('Operator').waitFor();
  // The same name once more is somebody who is there.
  await user.fill(one, 'cleo', 'Service', '');
  await save();
  const dialog = one.locator('dialog[open]');
  await dialog.getByText('User cleo already exists.').waitFor();
  await dialog.getByText('The password stays.').waitFor();
  await axe(one, 'a user that is there');
  await dialog.getByRole('button', { name: 'Cancel' }).click();
  await cleo.getByText('Operator').waitFor();
  await save();
  await dialog.getByRole('button', { name: 'Change' }).click();
  await cleo.getByText('Service').waitFor();
  // Who is changed by the key of his row is not asked about.
  await cleo.getByRole('button', { name: 'Edit' }).click();
  await one.getByRole('heading', { name: 'Change user cleo' }).waitFor();
  await one.getByLabel('Role').selectOption('Viewer');
  await save();
  await cleo.getByText('Viewer').waitFor();
  assert.equal(await dialog.count(), 0);
  one.wrong = one.wrong.filter((text) => !text.includes('409'));
  quiet(one);
});
