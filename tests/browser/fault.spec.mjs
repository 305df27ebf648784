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

/** Line 16 is one of the four of a box; DB 1 has no such word. */
const DRAWN = `DATA_BLOCK DB 1
STRUCT
  A : WORD ;
END_STRUCT ;
BEGIN
END_DATA_BLOCK
FUNCTION FC 1 : VOID
BEGIN
NETWORK
TITLE =Before
      U     E     0.0;
      =     A     4.0;
NETWORK
TITLE =Sum
      L     MW    10;
      L     DBW   20;
      +I    ;
      T     MW    12;
      NOP   0;
END_FUNCTION
ORGANIZATION_BLOCK OB 1
BEGIN
NETWORK
      AUF   DB    1;
      UC    FC    1;
END_ORGANIZATION_BLOCK
`;

test('in a drawn network the box with the failing statement is marked, and the ways lead to it', async () => {
  const folder = join(workspace, 'drawn');
  mkdirSync(folder);
  writeFileSync(join(folder, 'merker.toml'), '[project]\nname = "Drawn"\n');
  writeFileSync(join(folder, 'main.awl'), DRAWN);
  const look = await open(await launch(folder, workspace), 'program?file=main.awl&line=11');
  await look.locator('[data-mode="STOP"]').waitFor();
  const failed = look.locator('.networks .item.failed');
  const here = () => look.evaluate(() => document.activeElement.getAttribute('aria-label'));
  for (const view of ['FUP', 'KOP']) {
    await look.getByRole('button', { name: view, exact: true }).click();
    const name = `Box ADD_I, hier ging die CPU in STOP`;
    await until(async () => (await failed.count()) === 1 && (await failed.getAttribute('aria-label')) === name, `the mark in ${view}`);
    await look.locator('[data-head="1"]').click();
    const bar = look.getByRole('status').filter({ hasText: 'STOP in FC 1, Zeile 16' });
    await bar.getByRole('button', { name: 'Zur Anweisung' }).click();
    await until(async () => /^IN2, Eingang von ADD_I: DBW +20/.test(await here()), 'the operand that failed has the keyboard');
    assert.equal(await bar.getByRole('button').count(), 0, 'it is in sight');
  }
  await accessible(look, 'a fault in a box');
  await look.locator('[data-head="1"]').click();
  await look.getByRole('link', { name: 'Diagnose' }).click();
  await look.getByRole('table').locator('tbody tr').filter({ hasText: /16#4562|16#252/ }).first().click();
  await look.getByRole('button', { name: 'Baustein öffnen' }).click();
  await until(async () => /DBW +20/.test(await here()), 'the way from the diagnosis');
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
