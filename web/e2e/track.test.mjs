// A simulated part that lies elsewhere than planned: tracked on the screen and in the record.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { bench, burns, commands, get, jobText, keep, mode, quiet, ready, sleep, tab, weld } from './operator.mjs';

const { one } = await bench();

/** Up to which part of the pass the first chart of *Tracking* has a line. */
const farthest = () =>
  one.locator('.tracking canvas').first().evaluate((of) => {
    const { data } = of.getContext('2d').getImageData(0, 0, of.width, of.height);
    // Lines are blue or brown, grid and words are grey.
    const coloured = (i) => data[i + 3] > 200 && Math.max(data[i], data[i + 1], data[i + 2]) - Math.min(data[i], data[i + 1], data[i + 2]) > 60;
    let last = 0;
    for (let i = 0; i < data.length; i += 4) if (coloured(i)) last = Math.max(last, (i / 4) % of.width);
    return last / of.width;
  });

/** Thirty degrees of the example saddle. */
const short = async () => {
  const job = await jobText(one, 'saddle.toml');
  const text = job.replace('overlap_mm = 20', 'end_phi_deg = 30');
  assert.notEqual(text, job);
  return text;
};

test('a part out of its place is found by the sensor, and the record says by how much', async () => {
  await keep(one, 'tracked.toml', await short());
  await tab(one, 'Jobs');
  await one.locator('li.card', { hasText: 'tracked.toml' }).first().getByRole('button', { name: 'Load' }).click();
  const dialog = one.locator('dialog[open]');
  await dialog.getByRole('textbox').fill('T-1');
  await dialog.getByRole('combobox').selectOption('misplaced');
  await dialog.getByRole('button', { name: 'Load' }).click();
  await dialog.waitFor({ state: 'hidden', timeout: 60_000 });
  await commands(one);
  await ready(one);
  await weld(one);
  await burns(one, true);
  await one.locator('.tracking').getByText('Joint found').waitFor({ timeout: 30_000 });
  await one.locator('.tracking .uplot').nth(1).waitFor();
  await mode(one, 'ready');
  await tab(one, 'Records');
  await one.locator('tr', { hasText: 'T-1' }).getByText('good').waitFor({ timeout: 30_000 });
  const [record] = await get(one, '/api/records?part=T-1');
  const trace = await get(one, `/api/records/${record.id}/trace?columns=arc,correction_lateral_mm,correction_height_mm&most=500`);
  const [arc, lateral, height] = trace.values;
  const most = Math.max(...arc.map((on, i) => (on > 0.5 ? Math.hypot(lateral[i] ?? 0, height[i] ?? 0) : 0)));
  assert.ok(most > 0.5 && most < 4, `${most} mm`);
  // Its plots begin with what was seen of the joint.
  await one.locator('tr', { hasText: 'T-1' }).getByRole('button').click();
  await one.locator('.charts .uplot').nth(3).waitFor();
  const captions = await one.locator('.charts figcaption').allTextContents();
  assert.deepEqual(captions.slice(0, 4).map((text) => text.replace(/ mm .*/, '').trim()), ['Seam deviation, lateral', 'Seam deviation, height', 'Correction, lateral', 'Correction, height']);
  // The next weld of the same program begins with an empty window: what the last one was like is not drawn ahead of it.
  await tab(one, 'Weld');
  await commands(one);
  await one.locator('.tracking canvas').first().waitFor();
  await sleep(1000);
  const before = await farthest();
  assert.ok(before > 0.85, `the last weld is still drawn, up to ${before} of the chart`);
  await weld(one);
  await burns(one, true);
  await one.locator('.tracking').getByText('Joint found').waitFor({ timeout: 30_000 });
  await sleep(1500);
  const reached = await farthest();
  assert.ok(reached > 0 && reached < 0.8 * before, `drawn up to ${reached} of the chart`);
  await mode(one, 'ready');
  quiet(one);
});
