// A simulated part that lies elsewhere than planned: tracked on the screen and in the record.
import assert from 'node:assert/strict';
import { mkdirSync } from 'node:fs';
import { test } from 'node:test';
import { bench, burns, commands, control, keep, mode, open, quiet, ready, tab, weld } from './operator.mjs';

const shots = new URL('shots/', import.meta.url).pathname;
const { one, cell, options } = await bench({ real: 'the mock has no sensors', only: true });
mkdirSync(shots, { recursive: true });

/** Thirty degrees of the example saddle. */
const short = async () => {
  const job = await one.evaluate(async () => (await (await fetch('/api/jobs/saddle.toml')).json()).text);
  const text = job.replace('overlap_mm = 20', 'end_phi_deg = 30');
  assert.notEqual(text, job);
  return text;
};

test('a part out of its place is found by the sensor, and the record says by how much', options, async () => {
  await open(one, cell.address);
  await control(one);
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
  await one.locator('.tracking').getByText('Joint seen').waitFor({ timeout: 30_000 });
  await one.locator('.tracking .uplot').nth(1).waitFor();
  await one.screenshot({ path: `${shots}track.png` });
  await mode(one, 'ready');
  await tab(one, 'Records');
  await one.locator('tr', { hasText: 'T-1' }).getByText('good').waitFor({ timeout: 30_000 });
  const most = await one.evaluate(async () => {
    const [record] = await (await fetch('/api/records?part=T-1')).json();
    const trace = await (await fetch(`/api/records/${record.id}/trace?columns=arc,correction_lateral_mm,correction_height_mm&most=500`)).json();
    const [arc, lateral, height] = trace.values;
    return Math.max(...arc.map((on, i) => (on > 0.5 ? Math.hypot(lateral[i] ?? 0, height[i] ?? 0) : 0)));
  });
  assert.ok(most > 0.5 && most < 4, `${most} mm`);
  quiet(one);
});
