import assert from 'node:assert/strict';
import { test } from 'node:test';
import { page } from './browser.mjs';
import { axe, bench, commands, jobs, load, mode, open, openJob, planned, quiet, ready, record, sleep, startJogging, tab } from './operator.mjs';

const { one, cell, browser } = await bench({ scenes: true });

test('every template is planned and shown', async () => {
  await tab(one, 'Jobs');
  await one.locator('li.card').first().waitFor();
  const count = await one.locator('li.card').count();
  assert.ok(count > 8, `${count} templates`);
  for (let i = 0; i < count; i += 1) {
    await one.locator('li.card').nth(i).getByRole('button', { name: 'New from template' }).click();
    await planned(one);
    assert.equal(await one.locator('.right .note.fault').count(), 0, await one.locator('.bar strong').textContent());
    if (i === 0) {
      const address = await one.getByRole('link', { name: 'Report of the plan' }).getAttribute('href');
      const [status, text] = await one.evaluate(async (of) => {
        const answer = await fetch(of.replace('=en', '=de'));
        return [answer.status, await answer.text()];
      }, address);
      assert.equal(status, 200);
      assert.match(text, /<html lang="de">[^]*<h2>Befunde/);
    }
    await one.getByRole('button', { name: '← Jobs' }).click();
    await one.locator('li.card').first().waitFor();
  }
  quiet(one);
});

test('a span, or the whole pass, is chosen in 3D: its length and time, its points in the table', async () => {
  await openJob(one, 'points.toml');
  await one.getByRole('button', { name: 'Points', exact: true }).click();
  const point = (i) => one.locator('tbody tr').nth(i).getByRole('button');
  await point(3).click();
  const card = one.locator('.below .card', { hasText: 'Pass 1' });
  await card.getByRole('button', { name: 'Span 2/3' }).click();
  // A quarter of a circle of 30 mm, at 8 mm/s.
  await card.getByText(/80\.\d–127\.\d mm · 47\.\d mm · 0:06/).waitFor();
  await one.getByRole('button', { name: 'Apply to 1 point' }).waitFor();
  await card.getByRole('button', { name: 'Whole pass' }).click();
  await one.getByRole('button', { name: 'Apply to 7 points' }).waitFor();
  await one.getByRole('combobox', { name: 'Column' }).selectOption('Speed mm/s');
  await one.getByRole('textbox', { name: 'Value' }).fill('4');
  await one.getByRole('button', { name: 'Apply to 7 points' }).click();
  await planned(one);
  await card.getByText(/mm · 1:0\d/).waitFor();
  await card.getByRole('button', { name: 'Whole pass' }).click();
  await jobs(one);
  quiet(one);
});

test('the joint is drawn to scale with its beads, and follows its numbers while they are written', async () => {
  await openJob(one, 'thick-saddle.toml');
  // Whoever changes the joint sees its picture.
  const angle = one.getByRole('textbox', { name: 'bevel angle [°]' }).first();
  await angle.focus();
  const picture = one.locator('.section svg');
  await picture.waitFor();
  const beads = await picture.locator('.bead').count();
  assert.ok(beads > 5, `${beads} beads`);
  const sizes = () => picture.locator('text.size').allTextContents();
  const before = await sizes();
  assert.ok(before.some((text) => /^[0-9]+°$/.test(text)), `${before}`);
  await angle.fill('59');
  await one.waitForFunction((old) => [...document.querySelectorAll('.section text.size')].map((e) => e.textContent).join() !== old, before.join(), { timeout: 20_000 });
  // Another place of the seam has another section; a bead's number leads to its pass in 3D.
  const where = one.getByRole('slider', { name: 'Place along the seam' });
  await where.fill('2');
  await one.locator('.facts').getByText(/s = [1-9][0-9.]* mm/).waitFor();
  await one.locator('.facts td button').nth(1).click();
  await one.locator('.below .card', { hasText: /Pass [0-9]+: [0-9]/ }).waitFor();
  assert.equal(await picture.locator('.bead.shown').count(), 1);
  await axe(one, 'cross-section');
  quiet(one);
});

test('bodies are added, moved and deleted in a form, and are seen at once', async () => {
  await openJob(one, 'saddle.toml');
  await one.getByRole('button', { name: 'Part and fixtures', exact: true }).click();
  const drawn = () => one.waitForResponse((answer) => answer.url().endsWith('/api/draft')).then((answer) => answer.json());
  for (const shape of ['box', 'cylinder', 'cone']) {
    await one.getByRole('combobox', { name: 'Shape' }).selectOption(shape);
    const answer = drawn();
    await one.getByRole('button', { name: 'Add', exact: true }).click();
    assert.equal((await answer).fixtures.at(-1).name, `${shape} 1`);
  }
  const box = one.locator('fieldset', { hasText: 'box 1' }).first();
  let answer = drawn();
  await box.getByRole('textbox', { name: 'At Z' }).fill('400.5');
  assert.equal((await answer).fixtures[0].frame[11], 400.5);
  answer = drawn();
  await box.getByRole('textbox', { name: 'Size X' }).fill('80');
  assert.deepEqual((await answer).fixtures[0].shape.size, [80, 40, 40]);
  await axe(one, 'bodies');
  answer = drawn();
  await one.getByRole('button', { name: 'Delete cylinder 1' }).click();
  assert.deepEqual((await answer).fixtures.map((of) => of.name), ['box 1', 'cone 1']);
  answer = drawn();
  await one.getByRole('button', { name: 'Undo' }).click();
  assert.equal((await answer).fixtures.length, 3);
  quiet(one);
});

test('what the section plane cuts open is closed', async () => {
  await openJob(one, 'saddle.toml');
  await one.getByRole('button', { name: 'Top', exact: true }).click();
  await one.getByRole('button', { name: 'Show' }).click();
  for (const layer of ['Machine', 'Sensors', 'Zones']) await one.getByRole('checkbox', { name: layer }).uncheck();
  const menu = one.locator('.menu');
  // A face is flat and hatched: so many pixels of the picture have one of its two colours.
  const flat = async (colour = [158, 165, 172]) => {
    await sleep(1500);
    const canvas = one.locator('canvas[aria-label]').first();
    const png = (await canvas.screenshot({ timeout: 40_000 })).toString('base64');
    return one.evaluate(async ([text, colour]) => {
      const bytes = Uint8Array.from(atob(text), (of) => of.charCodeAt(0));
      const image = await createImageBitmap(new Blob([bytes], { type: 'image/png' }));
      const paper = new OffscreenCanvas(image.width, image.height).getContext('2d');
      paper.drawImage(image, 0, 0);
      const { data } = paper.getImageData(0, 0, image.width, image.height);
      // 0xb7bfc7, darker in linear light once or twice.
      const is = (i) => colour.every((value, k) => Math.abs(data[i + k] - value) < 4);
      let count = 0;
      for (let i = 0; i < data.length; i += 4) if (is(i)) count += 1;
      return count;
    }, [png, colour]);
  };
  const whole = await flat();
  await menu.getByRole('combobox', { name: 'Section plane' }).selectOption('z');
  const cut = await flat();
  const hatched = await flat([125, 131, 136]);
  assert.ok(hatched > cut / 12 && hatched < cut / 3, `${hatched} pixels of its hatching`);
  assert.ok(cut > 3000 && cut > 4 * whole, `${whole} pixels of a face before, ${cut} after`);
  await menu.getByRole('combobox', { name: 'Section plane' }).selectOption('');
  assert.ok((await flat()) < 4 * whole + 1000);
  for (const layer of ['Machine', 'Sensors', 'Zones']) await one.getByRole('checkbox', { name: layer }).check();
  await one.getByRole('button', { name: 'Show' }).click();
  quiet(one);
});

test('passes are coloured by clearance, the nearest pair has its line and its names', async () => {
  await openJob(one, 'saddle.toml');
  await one.getByRole('button', { name: 'Show' }).click();
  await one.getByRole('combobox', { name: 'Passes coloured by' }).selectOption('clearance');
  await one.locator('.below .scale', { hasText: 'mm' }).waitFor();
  await one.locator('p.near', { hasText: /Clearance [0-9.]+ mm/ }).getByText(' – ').waitFor();
  quiet(one);
});

test('inputs and outputs have names and live states; axes can be tuned in simulation', async () => {
  await tab(one, 'Set-up');
  await one.getByRole('button', { name: 'Inputs and outputs' }).click();
  const gas = one.locator('tr', { has: one.getByRole('rowheader', { name: 'gas Gas valve', exact: true }) });
  await gas.getByText('off').first().waitFor();
  await axe(one, 'inputs and outputs');
  await one.getByRole('button', { name: 'Tuning' }).click();
  await one.getByRole('button', { name: 'Tune and measure' }).click();
  await one.locator('.uplot').nth(1).waitFor({ timeout: 60_000 });
  await one.getByText('Phase margin').waitFor();
  await axe(one, 'tuning');
  quiet(one);
});

test('what is near is told by hand before it is too near; touched points tell where the part stands', async () => {
  await jobs(one);
  await load(one, 'saddle.toml');
  await commands(one);
  await ready(one);
  await startJogging(one);
  await one.getByRole('button', { name: '30 %' }).click();
  const note = one.locator('p.near.note');
  const jog = async (name, ms) => {
    await one.getByRole('button', { name }).hover();
    await one.mouse.down();
    await sleep(ms);
    await one.mouse.up();
    await sleep(600);
  };
  // Where a page is drawn by software a hand may be lost for a moment: then it presses again.
  for (let i = 0; i < 20 && !(await note.isVisible()); i += 1) await jog('h \u2212', 700);
  assert.match(await note.textContent(), /Clearance [0-9.]+ mm.+ – .+\(min\./);
  await record(one);
  for (let i = 0; i < 2; i += 1) {
    await jog('theta +', 1200);
    await record(one);
  }
  await one.getByRole('button', { name: 'End jogging' }).click();
  await mode(one, 'ready');
  await openJob(one, 'saddle.toml');
  await one.getByRole('button', { name: 'Part and fixtures', exact: true }).click();
  await one.getByRole('button', { name: 'Compute the position' }).click();
  const moved = one.getByText('The part is moved by');
  await moved.waitFor();
  // What was computed of other points, or of another probe, is not offered; what is no radius is none of 0.
  const radius = one.getByLabel('Probe radius, mm');
  await radius.fill('2');
  await moved.waitFor({ state: 'hidden' });
  for (const wrong of ['abc', '', '-1']) {
    await radius.fill(wrong);
    await one.getByRole('alert').filter({ hasText: 'Probe radius, mm: Allowed: a number, 0 or greater' }).waitFor();
    assert.ok(await one.getByRole('button', { name: 'Compute the position' }).isDisabled(), wrong);
  }
  await radius.fill('0');
  await moved.waitFor();
  await one.getByLabel('Point 1 is on').selectOption('body');
  await moved.waitFor({ state: 'hidden' });
  await one.getByLabel('Point 1 is on').selectOption('nozzle');
  await moved.waitFor();
  // Nor is what was computed before the job was changed: it would undo the change.
  await one.getByRole('button', { name: 'Add', exact: true }).click();
  await moved.waitFor({ state: 'hidden' });
  await one.getByRole('button', { name: 'Compute the position' }).click();
  await moved.waitFor();
  await one.getByRole('button', { name: 'Put it into the job' }).click();
  await moved.waitFor({ state: 'hidden' });
  assert.equal(await one.getByText('The job has no bodies of its own').count(), 0, 'the body that was added is still there');
  await one.getByRole('button', { name: 'Text', exact: true }).click();
  await one.locator('.editor .cm-content').getByText('offset = "touched"').waitFor();
  quiet(one);
});

test('a pass that is tracked shows what was seen and corrected over its length', async () => {
  const two = await page(browser);
  let s = 0;
  await two.routeWebSocket('**/api/live', (client) => {
    const server = client.connectToServer();
    client.onMessage((text) => server.send(text));
    server.onMessage((text) => {
      const message = JSON.parse(text);
      if (message.kind !== 'status') return client.send(text);
      // Once more from the start every twenty seconds, however late the page looks.
      s = (s + 1) % 600;
      const state = s > 200 && s < 300 ? 'coasted' : 'seen';
      const head = { head: 1, deviation_mm: [Math.sin(s / 60), 0.2], correction_mm: [Math.sin(s / 60) - 0.01, 0.19], confidence: 0.9, sigma_mm: 0.02, state };
      return client.send(JSON.stringify({ ...message, pass: 1, s_mm: s, tracking: [head, { ...head, head: 2 }] }));
    });
  });
  await open(two, cell.address);
  // It comes by itself, but not over an alarm that nobody has acknowledged.
  await two.getByRole('button', { name: 'Tracking', exact: true }).waitFor();
  if ((await two.locator('tr.unacknowledged, tr.returned').count()) > 0) await two.getByRole('button', { name: 'Tracking', exact: true }).click();
  await two.locator('.tracking').getByText('Joint found').waitFor();
  await two.locator('.tracking .uplot').nth(1).waitFor();
  await two.locator('.tracking').getByText('No view, holding').waitFor();
  await two.getByRole('button', { name: 'Head 2' }).click();
  await two.locator('.tracking').getByText('Joint found').waitFor();
  await two.getByRole('button', { name: 'Plots', exact: true }).click();
  await sleep(300);
  assert.equal(await two.locator('.tracking').count(), 0, 'the page that was chosen stays');
  quiet(two);
  await two.close();
});
