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

/** Replaces the whole text by typing nothing: as from the clipboard. Again, if an answer of the page has moved the cursor meanwhile. */
export async function replaceAll(page, source) {
  const isThere = async () => (await text(page)) === source;
  await until(async () => {
    await content(page).focus();
    await page.keyboard.press('Control+a');
    await page.keyboard.insertText(source);
    for (let looks = 0; looks < 40 && !(await isThere()); looks++) await page.waitForTimeout(50);
    return isThere();
  }, 'the new text');
}

export const problems = (page) => page.locator('#program-panel li');

/** What the status columns show beside a line: one text per column. */
export async function statusOf(page, line) {
  // Both gutters in one look: between two the text may scroll.
  const row = await page.locator('.code .cm-gutters').first().evaluate((gutters, line) => {
    const cells = (gutter) => [...gutters.parentElement.querySelectorAll(`${gutter} .cm-gutterElement`)];
    const top = (cell) => cell.getBoundingClientRect().top;
    const at = cells('.cm-lineNumbers').find((cell) => cell.innerText === String(line));
    return at && cells('.cm-status-gutter').find((cell) => Math.abs(top(cell) - top(at)) < 4)?.innerText;
  }, line);
  return (row ?? '').split('\n').map((cell) => cell.trim());
}
