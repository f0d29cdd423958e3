import assert from 'node:assert/strict';
import { test } from 'node:test';
import { page } from './browser.mjs';
import { axe, bench, control, mode, open, quiet, ready, sleep, startJogging } from './operator.mjs';

const { cell, browser, one } = await bench();
const two = await page(browser);

test('a second panel only watches, STOP apart, until it takes over', async () => {
  await open(two, cell.address);
  await two.getByText(/In control: .*\(station/).waitFor();
  const commands = two.getByRole('group', { name: 'Commands' });
  assert.ok(await commands.getByRole('button', { name: /Switch on/ }).isDisabled());
  assert.ok(await two.getByRole('button', { name: /STOP/ }).isEnabled());
  await ready(one);
  await mode(two, 'ready');
  await two.getByRole('button', { name: 'Take control' }).click();
  await two.locator('dialog[open]').waitFor();
  await axe(two, 'taking over');
  await two.locator('dialog[open]').getByRole('button', { name: 'Take control' }).click();
  await two.getByText('In control: you').waitFor();
  await one.getByText(/In control: .*\(station/).waitFor();
  assert.ok(await one.getByRole('button', { name: /Switch off/ }).isDisabled());
  await two.getByRole('button', { name: 'Give up control' }).click();
  await one.getByText('No one in control').waitFor();
  quiet(one);
  quiet(two);
});

test('a connection that comes back resumes nothing', async () => {
  const links = [];
  await one.routeWebSocket('**/api/live', (client) => {
    const link = { client, server: client.connectToServer(), sent: [] };
    client.onMessage((text) => {
      link.sent.push(JSON.parse(text));
      link.server.send(text);
    });
    link.server.onMessage((text) => client.send(text));
    links.push(link);
  });
  await open(one, cell.address);
  await control(one);
  await mode(one, 'ready');
  await startJogging(one);
  await one.getByRole('button', { name: 'theta +' }).hover();
  await one.mouse.down();
  await sleep(300);
  await links[0].server.close();
  await links[0].client.close();
  await one.getByText('No connection').waitFor();
  await one.waitForFunction(() => document.querySelector('header [role=status]')?.textContent.includes('Connected'));
  await sleep(1000);
  await one.mouse.up();
  assert.equal(links.length, 2);
  assert.deepEqual([...new Set(links[1].sent.map((message) => message.kind))], ['beat']);
  await one.getByText('No one in control').waitFor();
  assert.ok(links[0].sent.some((message) => message.kind === 'jog'));
});

test('data that stops coming is greyed with its age', async () => {
  let through = true;
  await two.routeWebSocket('**/api/live', (client) => {
    const server = client.connectToServer();
    client.onMessage((text) => server.send(text));
    server.onMessage((text) => through && client.send(text));
  });
  await open(two, cell.address);
  through = false;
  await two.getByText(/Data \d+\.\d s old/).waitFor();
  assert.ok((await two.locator('.stale').count()) > 2);
  through = true;
  await two.getByText('Connected').waitFor();
  assert.equal(await two.locator('.stale').count(), 0);
});
