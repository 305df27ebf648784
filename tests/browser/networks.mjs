// KOP and FUP on a page, for its tests: what is drawn, what is typed, the text behind it.
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { replaceAll, text } from './editor.mjs';
import { expect, launch, scratch, until } from './harness.mjs';

/** An OB 1 of one network; `rest`: the networks behind it. */
export const OF = (statements, rest = '') => `ORGANIZATION_BLOCK OB 1\nBEGIN\nNETWORK\n${statements.map((one) => `      ${one}\n`).join('')}${rest}END_ORGANIZATION_BLOCK\n`;

export function networksOf(page) {
  const press = async (...keys) => { for (const key of keys) await page.keyboard.press(key); };
  const network = (number = 1) => page.locator(`[data-network="${number}"]`);
  const field = () => page.getByRole('combobox').and(page.locator('.networks input'));
  const elements = (number = 1) => network(number).getByRole('button').and(page.locator('[data-node]:not(.junction)'))
    .evaluateAll((all) => all.map((one) => one.getAttribute('aria-label')).join(' | '));
  /** Without declarations. */
  const statements = async () => (await text(page)).split('\n').filter((line) => line.endsWith(';') && !line.includes(' : ')).map((line) => line.trim().replace(/\s+/g, ' ')).join(' ');
  const inside = () => until(() => page.evaluate(() => document.activeElement?.closest('.networks') !== null), 'the keyboard in the networks');
  /** What has the keyboard. */
  const marked = (label) => expect(() => page.evaluate(() => document.activeElement?.getAttribute('aria-label') ?? document.activeElement?.id), label);
  /** The field opens by itself. */
  const operand = async (name) => {
    await field().waitFor();
    await page.keyboard.type(name);
    await press('Enter');
  };
  const drawn = async (view, source) => {
    await press('Control+2');
    await replaceAll(page, source);
    await press(view === 'kop' ? 'Control+1' : 'Control+3');
    await inside();
  };
  return { press, network, field, elements, statements, inside, marked, operand, drawn };
}

export function holder(page) {
  /** Edits wait for their answer until `release`. */
  const hold = () => page.evaluate(() => {
    const { send } = WebSocket.prototype;
    const held = [];
    WebSocket.prototype.send = function (data) {
      if (String(data).includes('"networks.edit"')) held.push(() => send.call(this, data));
      else send.call(this, data);
    };
    window.release = () => ((WebSocket.prototype.send = send), held.forEach((go) => go()));
  });
  const release = () => page.evaluate(() => window.release());
  return { hold, release };
}

/** A server with a project of one file. */
export function project(model, file, source) {
  const workspace = scratch();
  const folder = join(workspace, 'project');
  mkdirSync(folder);
  writeFileSync(join(folder, 'merker.toml'), `[cpu]\nmodel = "${model}"\n`);
  writeFileSync(join(folder, file), source);
  return launch(folder, workspace);
}
