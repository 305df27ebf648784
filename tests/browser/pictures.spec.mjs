// The pictures of docs/workbench.md, of the sorting plant at work: only when MERKER_SCREENSHOTS asks for them.
import { test } from 'node:test';
import { open, picture, serve, turn, until, visit } from './harness.mjs';

const wanted = Boolean(process.env.MERKER_SCREENSHOTS);

/** Operands typed into the variable table, with the format and the modify value of each. */
async function fillTable(page, rows) {
  for (const [operand, format, modify] of rows) {
    const row = page.locator('tbody tr').last();
    await row.locator('input').first().fill(operand);
    await page.keyboard.press('Tab');
    const filled = page.locator(`tr[data-operand='${operand}']`);
    await until(async () => (await filled.locator('.value').innerText()).trim() !== '', operand);
    if (format) await filled.locator('select').selectOption(format);
    if (modify) await filled.locator('.modify input').fill(modify);
  }
}

/** The plant brings boxes by itself. */
async function play(page) {
  await turn(page, 'RUN-P');
  await visit(page, page.server, 'variables');
  await fillTable(page, [
    ['"Light barrier small"', '', ''],
    ['"Slider small"', '', ''],
    ['"Slider middle"', '', ''],
    ['"Travel time small"', '', ''],
    ['"Plant data".Small', 'DEC', ''],
    ['"Slider large"', '', '0'],
    ['EB 0', 'BIN', ''],
  ]);
}

test('pictures of the views', { skip: !wanted }, async () => {
  const server = await serve();
  const page = await open(server, 'io', { language: 'en' });
  page.server = server;
  await play(page);
  const forced = page.locator("tr[data-operand='\"Slider large\"']");
  await forced.getByRole('button', { name: /^Force/ }).click();
  await forced.locator('.mark b').waitFor();
  await picture(page, 'variables');
  for (const view of ['projects', 'hardware', 'symbols', 'io', 'process', 'trends', 'diagnosis']) {
    await visit(page, server, view);
    await page.waitForTimeout(2000);
    await picture(page, view === 'projects' ? 'project' : view);
  }
});

test('picture of three boxes on the belt', { skip: !wanted }, async () => {
  const page = await open(await serve(), 'process');
  await turn(page, 'RUN-P');
  await page.getByRole('switch', { name: 'Kästen kommen von selbst' }).click();
  await page.getByRole('button', { name: 'Zurück zum Anfang' }).click();
  await page.getByRole('switch', { name: 'Kästen kommen von selbst' }).click();
  for (const box of ['NEW_LARGE', 'NEW_MIDDLE', 'NEW_SMALL']) {
    await page.locator(`button[data-push="${box}"]`).click({ delay: 200 });
    await page.waitForTimeout(1500);
  }
  await picture(page, 'process-light');
});

test('picture of the simulator dialog', { skip: !wanted }, async () => {
  const page = await open(await serve(), 'io', { language: 'en' });
  await turn(page, 'RUN-P');
  const dialog = page.getByRole('dialog');
  await page.getByRole('button', { name: 'Simulator …' }).click();
  await dialog.getByLabel('Name of the state').fill('three boxes');
  await dialog.getByRole('button', { name: 'Save', exact: true }).click();
  await until(async () => (await dialog.getByLabel('Saved state').innerText()).includes('three boxes'), 'the saved state');
  await dialog.getByRole('button', { name: 'Record', exact: true }).click();
  await dialog.getByText('0 actions recorded').waitFor();
  await picture(page, 'simulator');
});

test('pictures of the dark theme', { skip: !wanted }, async () => {
  const server = await serve();
  const page = await open(server, 'io', { language: 'en', theme: 'dark' });
  page.server = server;
  await play(page);
  await visit(page, server, 'io');
  await page.waitForTimeout(1500);
  await picture(page, 'io-dark');
  await visit(page, server, 'program?file=sorting.awl&line=42');
  await page.getByRole('switch', { name: 'Status' }).click();
  await page.waitForTimeout(1500);
  await picture(page, 'program');
});
