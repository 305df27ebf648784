// What a person at the page waits for: the first view, and from a key or a click to what it shows. Prints the table of docs/performance.md.
//   MERKER=build/bench/merker node bench/page/measure.mjs
import { cpSync, mkdirSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { content, toLine } from '../../tests/browser/editor.mjs';
import { launch, open, root, scratch, turn, until, visit } from '../../tests/browser/harness.mjs';

const ROUNDS = 5;
const QUIET_MS = 1000; // nothing is to come behind the first view

const workspace = scratch();
const project = join(workspace, 'sorting-plant');
cpSync(join(root, 'examples/sorting-plant'), project, { recursive: true });
mkdirSync(join(workspace, 'merker'));
// A data block of a thousand elements, which nothing uses.
writeFileSync(join(project, 'large.awl'), 'DATA_BLOCK DB 99\n  STRUCT\n    List : ARRAY [1..1000] OF INT ;\n  END_STRUCT ;\nBEGIN\nEND_DATA_BLOCK\n');
const server = await launch(project, workspace);
const page = await open(server, 'io');
await turn(page, 'RUN-P');

const middle = (values) => values.sort((a, b) => a - b)[Math.floor(values.length / 2)];
async function several(once) {
  const values = [];
  for (let round = 0; round < ROUNDS; round++) values.push(await once());
  return middle(values);
}
const print = (what, value, unit) => console.log(`${what.padEnd(66)}${String(value).padStart(7)} ${unit}`);

/** The first view in a browser that has nothing of it: bytes, paints, how long its scripts kept the keyboard waiting, how far it jumped. */
async function first(view, shown) {
  const fresh = await page.context().newPage();
  const wire = await page.context().newCDPSession(fresh);
  await wire.send('Network.enable');
  await wire.send('Network.setCacheDisabled', { cacheDisabled: true });
  let bytes = 0;
  wire.on('Network.loadingFinished', ({ encodedDataLength }) => (bytes += encodedDataLength));
  await fresh.addInitScript(() => {
    window.seen = { blocked: 0, moved: 0, largest: 0 };
    const watch = (type, each) => new PerformanceObserver((list) => list.getEntries().forEach(each)).observe({ type, buffered: true });
    watch('longtask', ({ duration }) => (window.seen.blocked += Math.max(0, duration - 50)));
    watch('layout-shift', ({ value, hadRecentInput }) => !hadRecentInput && (window.seen.moved += value));
    watch('largest-contentful-paint', ({ startTime }) => (window.seen.largest = startTime));
  });
  await visit(fresh, server, view);
  await shown(fresh);
  await fresh.waitForTimeout(QUIET_MS);
  const seen = await fresh.evaluate(() => ({ ...window.seen, paint: performance.getEntriesByName('first-contentful-paint')[0].startTime }));
  await fresh.close();
  return { ...seen, bytes };
}

/** In the page: from the act to the frame behind the change that shows it. */
const untilShown = (act, done, on = page) =>
  on.evaluate(
    ([act, done]) =>
      new Promise((told) => {
        const shown = new Function(`return (${done})`);
        const began = performance.now();
        const look = () => (shown() ? requestAnimationFrame(() => setTimeout(() => told(performance.now() - began))) : setTimeout(look));
        new Function(act)();
        look();
      }),
    [act, done],
  );

/** From a key to the frame that shows it, as the browser itself measures it, in steps of 8 ms from 16 ms on: the middle. */
async function keys(text) {
  await page.evaluate(() => {
    window.late = [];
    window.watching?.disconnect();
    window.watching = new PerformanceObserver((list) => window.late.push(...list.getEntries().filter(({ name }) => name === 'keydown').map(({ duration }) => duration)));
    window.watching.observe({ type: 'event', durationThreshold: 16 });
  });
  for (const letter of text) {
    await page.keyboard.press(letter);
    await page.waitForTimeout(100);
  }
  const late = await page.evaluate(() => window.late);
  return middle([...late, ...Array(Math.max(0, text.length - late.length)).fill(16)]);
}

for (const [name, view, shown] of [
  ['the plant', 'process', (on) => on.locator('[data-signal]').first().waitFor()],
  ['the program', 'program?file=sorting.awl', (on) => on.locator('.code .cm-line').first().waitFor()],
]) {
  const rounds = [];
  for (let round = 0; round < ROUNDS; round++) rounds.push(await first(view, shown));
  const of = (fact) => middle(rounds.map((one) => one[fact]));
  print(`${name} as the first view: on the wire`, Math.round(of('bytes') / 1000), 'kB');
  print('  first content painted', Math.round(of('paint')), 'ms');
  print('  the largest part of it painted', Math.round(of('largest')), 'ms');
  print('  scripts that kept a key waiting, beyond 50 ms each, together', Math.round(of('blocked')), 'ms');
  print('  what jumped, as a share of the screen', of('moved').toFixed(3), '');
}

const views = ['projects', 'hardware', 'symbols', 'program', 'io', 'variables', 'process', 'trends', 'diagnosis'];
const openings = [];
for (let round = 0; round <= ROUNDS; round++)
  for (const view of views) {
    const took = await untilShown(`document.querySelector('nav a[href="#/${view}"]').click()`, `document.querySelector('nav a[href="#/${view}"][aria-current]') && document.querySelector('main h1')`);
    if (round > 0) openings.push([took, view]);
  }
const slowest = views.map((view) => [middle(openings.filter(([, of]) => of === view).map(([took]) => took)), view]).sort(([a], [b]) => b - a)[0];
print(`another view, seen before: the slowest (${slowest[1]})`, Math.round(slowest[0]), 'ms');

await visit(page, server, 'io');
await page.locator('button[data-operand="E 0.5"]').waitFor();
const bit = `document.querySelector('button[data-operand="E 0.5"] .lamp')`;
let on = 0;
const toggled = await several(() => untilShown(`document.querySelector('button[data-operand="E 0.5"]').click()`, `${bit}.innerText === '${(on = 1 - on)}'`));
print('an input is toggled: its new value, by the PLC', Math.round(toggled), 'ms');
// What the browser needs for any key on this machine: the others are told as many times of it.
await page.locator('#tile-operand').focus();
const plain = await keys('abcdefghijklmnopqrst');
print('a key in a field that nothing follows: the middle of twenty', plain, 'ms');
const times = (late) => `ms, ${(late / plain).toFixed(1)} times that of the field`;

await visit(page, server, 'program?file=sorting.awl');
await content(page).waitFor();
await toLine(page, 42);
const typed = await keys('abcdefghijklmnopqrst');
print('a key in the program: the middle of twenty', typed, times(typed));
await page.keyboard.press('Control+Shift+F');
const field = page.locator('#program-panel input[type=search]');
await field.waitFor();
await until(() => field.evaluate((one) => one.getRootNode().activeElement === one), 'the field of the search');
const text = `document.querySelector('#program-panel input[type=search]')`;
let round = 0;
const found = await several(() => {
  const word = ['slider', 'barrier', 'box', 'count', 'time'][round++ % 5];
  return untilShown(`const one = ${text}; one.value = '${word}'; one.dispatchEvent(new Event('input', { bubbles: true }))`,
    `[...document.querySelectorAll('#program-panel mark')].some((one) => one.textContent.toLowerCase() === '${word}')`);
});
print('a word is looked for in all files: the first places, 150 ms of waiting for more letters', Math.round(found), 'ms');

await visit(page, server, 'program?file=large.awl&line=3');
await page.getByRole('button', { name: 'Datensicht' }).waitFor();
const data = async () => {
  const took = await untilShown(`[...document.querySelectorAll('button')].find((one) => one.textContent.trim() === 'Datensicht').click()`, `document.querySelector('tr[data-path]')`);
  await page.getByRole('button', { name: 'Datensicht' }).click();
  return took;
};
print('the data view of a block of 1,000 elements', Math.round(await several(data)), 'ms');

await visit(page, server, 'variables');
const range = async () => {
  await page.getByRole('button', { name: 'Neu', exact: true }).click();
  await until(async () => (await page.locator('tbody tr').count()) === 1, 'an empty table');
  return untilShown(
    `const one = document.querySelector('tbody tr:last-child input'); one.value = 'M 100.0..224.7'; one.dispatchEvent(new Event('input', { bubbles: true })); one.dispatchEvent(new Event('change', { bubbles: true }))`,
    `document.querySelectorAll('tbody tr[data-operand]').length > 10 && /[01]/.test(document.querySelector('tbody tr:nth-child(9) .value').textContent)`,
  );
};
print('1,000 variables: from the range typed to their values', Math.round(await several(range)), 'ms');
print('  elements of the page then', await page.evaluate(() => document.querySelectorAll('*').length), '');
await page.locator('tbody tr[data-operand] .modify input').first().focus();
const entered = await keys('01234567890123456789');
print('  a key in this table: the middle of twenty', entered, times(entered));
await server.close();
process.exit(0);
