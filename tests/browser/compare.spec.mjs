// Two programs beside each other: project and CPU, two projects; blocks, symbols, hardware (S7-MGR-15).
import assert from 'node:assert/strict';
import { cpSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { accessible } from './axe.mjs';
import { expect, launch, open, root, scratch, until, visit } from './harness.mjs';
import { crowding } from './layout.mjs';

const workspace = scratch();
const project = join(workspace, 'plant');
cpSync(join(root, 'examples/sorting-plant'), project, { recursive: true });
// Another project of the workspace: two places of one block, a symbol, a module.
const other = join(workspace, 'merker', 'plant 2');
mkdirSync(join(workspace, 'merker'));
cpSync(project, other, { recursive: true });
const change = (folder, file, ...changes) => {
  const path = join(folder, file);
  let text = readFileSync(path, 'utf-8');
  for (const [from, to] of changes) {
    assert.ok(text.includes(from), `${file} has ${from}`);
    text = text.replace(from, to);
  }
  writeFileSync(path, text);
};
change(other, 'sorting.awl', ['BeamSmall  : BOOL := TRUE', 'BeamSmall  : BOOL := FALSE'], ['      FN    #Edge;', '      FP    #Edge;']);
change(other, 'sorting.sym', ['"Light barrier small"', '"Barrier small"']);
change(other, 'sorting.awl', ['"Light barrier small"', '"Barrier small"']);

const server = await launch(project, workspace);
const page = await open(server, 'compare');
const blocks = page.getByRole('list', { name: 'Bausteine' }).getByRole('button');
const names = async () => (await blocks.allInnerTexts()).map((one) => one.replace(/\s+/g, ' ').trim());
const status = () => page.locator('.comparison [role=status]').innerText();
const rows = (name) => page.getByRole('table', { name }).locator('tbody tr[data-state]');

test('project and CPU are the same; what is changed is seen at once', async () => {
  await page.getByText('Kein Unterschied.').waitFor();
  change(project, 'sorting.awl', ['TITLE = Size of a box', 'TITLE = Width of a box']);
  await expect(async () => (await names()).join(), 'FB 1 nur der Text');
  await expect(status, 'Unterschied 1 von 1');
  await accessible(page, 'comparison');
});

test('two projects: the sources of a block, from difference to difference with the keyboard', async () => {
  await page.getByLabel('Rechts').selectOption('plant 2');
  let seen;
  await until(async () => (seen = await names()).includes('FB 1 verschieden'), () => `FB 1 in ${seen}`);
  await blocks.filter({ hasText: 'FB 1' }).focus();
  await page.keyboard.press('Enter');
  await until(async () => / von [3-9]$/.test(await status()), status);
  await page.keyboard.press('F7');
  await until(async () => /^Unterschied 2 von/.test(await status()), 'the second');
  await page.keyboard.press('Shift+F7');
  await page.keyboard.press('Shift+F7');
  await until(async () => /^Unterschied (\d) von \1$/.test(await status()), 'the last');
  const inSight = () => page.locator('.comparison').evaluate((one) => {
    const host = one.querySelector('.texts');
    const frame = host.getBoundingClientRect();
    return [...host.shadowRoot.querySelectorAll('.cm-changedLine')].some((line) => {
      const { top, bottom } = line.getBoundingClientRect();
      return top >= frame.top && bottom <= frame.bottom;
    });
  });
  await expect(inSight, true, 'the difference in sight');
  await page.getByRole('switch', { name: 'Maschinencode' }).press('Space');
  await until(async () => (await page.locator('.comparison').evaluate((one) => one.querySelector('.texts').shadowRoot.textContent)).includes('FP '), 'the code');
});

test('what differs at the end of a long line comes into sight, and the sides scroll together', async () => {
  const long = `// ${'a word and another one '.repeat(6)}`;
  change(project, 'sorting.awl', ['      FN    #Edge;', `      FN    #Edge; ${long}50`]);
  change(other, 'sorting.awl', ['      FP    #Edge;', `      FN    #Edge; ${long}70`]);
  await page.getByRole('switch', { name: 'Maschinencode' }).press('Space');
  await page.getByLabel('Rechts').selectOption('CPU');
  await page.getByLabel('Rechts').selectOption('plant 2');
  await page.setViewportSize({ width: 768, height: 1024 });
  await blocks.filter({ hasText: 'FB 1' }).press('Enter');
  const sides = () => page.locator('.comparison .texts').evaluate((host) => [...host.shadowRoot.querySelectorAll('.cm-scroller')].map((one) => {
    const { left, right } = one.getBoundingClientRect();
    const marks = [...one.querySelectorAll('.cm-changedText')].map((mark) => ({ text: mark.textContent, ...mark.getBoundingClientRect().toJSON() }));
    return { at: one.scrollLeft, seen: marks.some((mark) => /[57]/.test(mark.text) && mark.left >= left && mark.right <= right) };
  }));
  // The texts compared may still be those of before: then the answer that comes begins at the first difference anew.
  const last = () => status().then((words) => /^Unterschied (\d+) von \1$/.test(words));
  let seen;
  await until(async () => {
    if (await last()) return (seen = await sides()).every((one) => one.seen);
    await page.keyboard.press('F7');
  }, () => `the number in sight: ${JSON.stringify(seen)}`);
  await page.locator('.comparison .texts').evaluate((host) => (host.shadowRoot.querySelectorAll('.cm-scroller')[1].scrollLeft = 40));
  await expect(async () => (await sides()).map(({ at }) => at).join(), '40,40', 'both sides');
  await page.setViewportSize({ width: 1280, height: 800 });
});

test('symbols and hardware row by row; the sides are swapped', async () => {
  await page.getByRole('tab', { name: /^Symbole \(2\)/ }).click();
  await expect(async () => (await rows('Symbole').allInnerTexts()).map((one) => one.split('\t').slice(0, 2).join(': ').trim()).join(', '),
    'Barrier small: nur rechts, Light barrier small: nur links');
  await accessible(page, 'symbols compared');
  await page.getByRole('button', { name: 'Seiten tauschen' }).press('Enter');
  await until(async () => /^Barrier small\s+nur links/.test(await rows('Symbole').first().innerText()), 'swapped');
  await page.getByRole('tab', { name: /^Hardware \(0\)/ }).click();
  await page.getByText('Kein Unterschied.').waitFor();
  await page.getByRole('switch', { name: 'auch was gleich ist' }).press('Space');
  await until(async () => (await rows('Hardware').count()) > 3, 'modules');
});

test('there is room for it on every screen', async () => {
  await page.getByRole('tab', { name: /^Bausteine/ }).click();
  for (const [width, height] of [[1024, 768], [768, 1024], [1280, 800]]) {
    await page.setViewportSize({ width, height });
    let found;
    await until(async () => (found = await crowding(page)).length === 0, () => found.join('\n'));
    await accessible(page, `comparison at ${width}`);
  }
});

test('a project that was open before is in the lists once', async () => {
  await page.evaluate((folder) => new Promise((done) => {
    const socket = new WebSocket(new URL('ws', location.href).href.replace(/^http/, 'ws').replace(/#.*/, ''));
    const asks = [folder, 'plant 2', folder];
    const ask = () => asks.length ? socket.send(JSON.stringify({ id: asks.length, do: 'projects.open', folder: asks.shift() })) : done(socket.close());
    socket.onopen = ask;
    socket.onmessage = ({ data }) => JSON.parse(data).id && ask();
  }), project);
  await visit(page, server, 'compare');
  let listed;
  await until(async () => (listed = await page.getByLabel('Rechts').locator('option').allInnerTexts()).some((one) => one === 'plant 2'), () => listed);
  assert.deepEqual(listed.filter((one) => one.endsWith('plant 2')), ['plant 2']);
});

test('a CPU that is set otherwise is different; all of its properties can be read', async () => {
  change(other, 'merker.toml', ['model = "314C-2 PtP"', 'model = "314C-2 PtP"\nmpi_address = 5\ncycle_monitoring = "300ms"']);
  await page.reload();
  await page.locator('[data-phase="open"]').waitFor();
  await page.getByLabel('Rechts').selectOption('plant 2');
  await page.getByRole('tab', { name: /^Hardware \(1\)/ }).click();
  const cpu = rows('Hardware').filter({ hasText: 'CPU 314C-2 PtP' });
  await until(async () => /^CPU\s+verschieden\s+CPU 314C-2 PtP 6ES7 314-6BF01-0AB0/.test(await cpu.innerText()), 'the CPU');
  assert.equal(await cpu.locator('del').innerText(), 'MPI-Adresse: 2; Zyklusüberwachungszeit: 150ms');
  assert.equal(await cpu.locator('ins').innerText(), 'MPI-Adresse: 5; Zyklusüberwachungszeit: 300ms');
  await page.getByRole('switch', { name: 'auch was gleich ist' }).press('Space');
  await until(async () => (await rows('Hardware').count()) > 3, 'modules');
  const cut = () => page.getByRole('table', { name: 'Hardware' }).evaluate((table) =>
    [...table.querySelectorAll('td')].filter((one) => one.scrollWidth > one.clientWidth + 1).map((one) => one.innerText).join('\n'));
  for (const [width, height] of [[1024, 768], [768, 1024], [1280, 800]]) {
    await page.setViewportSize({ width, height });
    await expect(cut, '', `at ${width}`);
    await accessible(page, `hardware compared at ${width}`);
  }
});

test('an answer that comes anew keeps the place', async () => {
  await page.getByRole('tab', { name: /^Bausteine/ }).click();
  await page.getByRole('switch', { name: 'auch was gleich ist' }).press('Space');
  await blocks.filter({ hasText: 'FB 1' }).press('Enter');
  await until(async () => /^Unterschied 1 von [3-9]$/.test(await status()), status);
  await page.keyboard.press('F7');
  await until(async () => /^Unterschied 2 von/.test(await status()), 'the second');
  const all = Number((await status()).match(/\d+$/)[0]);
  const view = () => page.locator('.comparison .texts').evaluate((host) => host.shadowRoot.querySelector('.cm-mergeView').dataset.kept ?? '');
  await page.locator('.comparison .texts').evaluate((host) => (host.shadowRoot.querySelector('.cm-mergeView').dataset.kept = 'yes'));
  // Another answer with the same texts: only a symbol is new.
  const count = async () => (await page.getByRole('tab', { name: /^Symbole/ }).innerText()).trim();
  const before = await count();
  change(project, 'sorting.sym', ['"Light barrier small"', '"Spare"   M 99.0  BOOL\n"Light barrier small"']);
  await until(async () => (await count()) !== before, 'the answer');
  assert.match(await status(), /^Unterschied 2 von/);
  assert.equal(await view(), 'yes', 'the texts are those of before');
  // One more difference behind the others.
  change(project, 'sorting.awl', ['END_FUNCTION_BLOCK', '      NOP   0;\nEND_FUNCTION_BLOCK']);
  await expect(status, `Unterschied 2 von ${all + 1}`);
});

test('a channel that is set otherwise makes its module different', async () => {
  change(other, 'merker.toml', ['[[module]]\nslot = 4', '[[module]]\nslot = "2.3"\n[[module.channel]]\ninput = 1\nrange = "4..20mA"\n\n[[module]]\nslot = 4']);
  await page.reload();
  await page.locator('[data-phase="open"]').waitFor();
  await page.getByLabel('Rechts').selectOption('plant 2');
  await page.getByRole('tab', { name: /^Hardware \(2\)/ }).click();
  const analog = rows('Hardware').filter({ hasText: '0/2.3' });
  await expect(() => analog.locator('del').innerText(), 'Kanal E 1: Messbereich: ±10V');
  await expect(() => analog.locator('ins').innerText(), 'Kanal E 1: Messbereich: 4..20mA');
});
