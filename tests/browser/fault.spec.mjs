// After a STOP by a fault: its statement is marked in every view of the program, and the head of the page says why.
import assert from 'node:assert/strict';
import { mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { accessible } from './axe.mjs';
import { launch, open, scratch, turn, until, write } from './harness.mjs';

const PROGRAM = `DATA_BLOCK DB 1
STRUCT
  A : WORD ;
END_STRUCT ;
BEGIN
END_DATA_BLOCK
ORGANIZATION_BLOCK OB 1
BEGIN
NETWORK
      U     E     0.0;
      =     A     0.0;
NETWORK
      AUF   DB    1;
      TAK   ;
      L     DBW [MD 30];
      T     MW    20;
END_ORGANIZATION_BLOCK
`;
const lineOf = (words) => PROGRAM.split('\n').findIndex((one) => one.includes(words)) + 1;

const workspace = scratch();
const project = join(workspace, 'fault');
mkdirSync(project);
writeFileSync(join(project, 'merker.toml'), '[project]\nname = "Fault"\n');
writeFileSync(join(project, 'main.awl'), PROGRAM);
const server = await launch(project, workspace);
const page = await open(server, 'program');

test('the failing statement of a network that stays AWL is marked as in the text', async () => {
  await turn(page, 'RUN-P');
  await write(page, { 'MD 30': 800 });
  await page.locator('[data-mode="STOP"]').waitFor();
  await until(async () => /DBW \[MD 30\]/.test(await page.locator('.code .cm-failed-line').innerText()), 'the line in the text');
  for (const view of ['KOP', 'FUP']) {
    await page.getByRole('button', { name: view, exact: true }).click();
    const failed = page.locator('[data-network="2"] li.failed');
    await until(async () => /✖\s*L\s+DBW \[MD 30\]/.test(await failed.innerText()), `the line in ${view}`);
    // What prevents the drawing is another statement.
    assert.match(await page.locator('[data-network="2"] .reason').innerText(), new RegExp(`Zeile (?!${lineOf('MD 30')}\\b)`));
    const colour = (one) => one.evaluate((element) => getComputedStyle(element).backgroundColor);
    assert.notEqual(await colour(failed), await colour(page.locator('[data-network="2"] li').first()));
  }
  await accessible(page, 'a fault in the ladder');
});

test('mode and reason stand beside each other in the head of an upright tablet', async () => {
  for (const [width, height] of [[768, 1024], [800, 1280], [820, 1180]]) {
    await page.setViewportSize({ width, height });
    const mode = page.locator('aside [data-mode="STOP"]');
    const ends = await mode.evaluate((one) => {
      const range = document.createRange();
      range.selectNodeContents(one);
      return range.getBoundingClientRect().right;
    });
    const reason = await page.locator('aside').getByRole('link', { name: /STOP/ }).boundingBox();
    assert.ok(ends <= reason.x, `${width}: the mode ends at ${ends}, the reason begins at ${reason.x}`);
    assert.ok(reason.width > 60, `${width}: ${reason.width} px of the reason`);
  }
});
