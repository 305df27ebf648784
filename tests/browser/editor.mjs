// The editor of the program view, for its tests. It lives in a shadow root, which locators look through.
import { until } from './harness.mjs';

export const content = (page) => page.locator('.code .cm-content');

/** The whole text, also what is scrolled out of sight. */
export const text = (page) => content(page).evaluate((element) => element.cmTile.root.view.state.doc.toString());

/** Puts the cursor at the beginning of a line. */
export async function toLine(page, line) {
  await content(page).focus();
  await page.keyboard.press('Control+g');
  const field = page.locator('.code .cm-panel input');
  await field.fill(String(line));
  await field.press('Enter');
  await page.keyboard.press('Home');
}

/** Replaces the whole text by typing nothing: as from the clipboard. */
export async function replaceAll(page, source) {
  await content(page).focus();
  await page.keyboard.press('Control+a');
  await page.keyboard.insertText(source);
  await until(async () => (await text(page)) === source, 'the new text');
}

export const problems = (page) => page.locator('#program-panel li');

/** What the status columns show beside a line: one text per column. */
export async function statusOf(page, line) {
  const top = (locator) => locator.evaluateAll((elements) => elements.map((element) => [element.getBoundingClientRect().top, element.innerText]));
  const numbers = await top(page.locator('.code .cm-lineNumbers .cm-gutterElement'));
  const rows = await top(page.locator('.code .cm-status-gutter .cm-gutterElement'));
  const at = numbers.find(([, number]) => number === String(line))?.[0];
  const row = rows.find(([place]) => at !== undefined && Math.abs(place - at) < 4)?.[1] ?? '';
  return row.split('\n').map((cell) => cell.trim());
}
