// The form of a job: everything that the file has is there, and what the format allows can be added.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { axe, bench, open, tab } from './operator.mjs';

const { one, cell } = await bench();

const table = (name) => one.locator('fieldset', { has: one.locator(`legend[title="${name}"]`) });
/** Waits until the text has this: the cell writes it. */
const inText = async (wanted) => {
  await one.getByRole('button', { name: 'Text', exact: true }).click();
  await one.locator('.cm-content').waitFor();
  await one.waitForFunction((of) => new RegExp(of).test(document.querySelector('.editor').shadowRoot.querySelector('.cm-content').innerText), wanted.source);
  await one.getByRole('button', { name: 'Form', exact: true }).click();
};

test('values of nested inline tables can be read and changed', async () => {
  await open(one, cell.address);
  await tab(one, 'Jobs');
  await one.locator('li.card', { hasText: 'Hillside' }).getByRole('button', { name: 'New from template' }).click();
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
});
