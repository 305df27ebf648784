// Starts the real program, opens its page, and looks until something is so.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { cpSync, existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { basename, extname, join, resolve } from 'node:path';
import { after, afterEach, beforeEach } from 'node:test';
import { fileURLToPath } from 'node:url';

export const root = resolve(fileURLToPath(import.meta.url), '../../..');
/** Where npm put the tools: in the clone, or where the build of the page did. */
const modules = ['web/node_modules', 'build/web/node_modules'].map((at) => join(root, at)).find(existsSync) ?? fail('npm ci');
export const tool = (path) => join(modules, path);
const { chromium } = createRequire(tool('index.js'))('playwright-core');
const merker = resolve(process.env.MERKER ?? join(root, 'build/release/merker'));
// A busy machine is slow; who waits for a state loses nothing by patience.
const PATIENCE = Number(process.env.MERKER_PATIENCE ?? 60_000);

/** What has to be done when all tests of the file are over: pages go before what they talk to, each newest first. */
const endings = { page: [], staying: [], judgement: [], program: [], folder: [] };
after(async () => {
  const failures = [];
  for (const end of Object.values(endings).flatMap((some) => some.reverse())) {
    try {
      await end();
    } catch (failure) {
      failures.push(failure);
    }
  }
  if (failures.length) throw failures[0];
});

/** A page that a test opened goes with it: left open it would draw on, for nobody. Those of the file stay for all its tests. */
let pagesOfFile = 0;
beforeEach(() => (pagesOfFile = endings.page.length));
afterEach(async () => {
  for (const end of endings.page.splice(pagesOfFile).reverse()) await end();
});

const ARGUMENTS = ['--headless', '--no-sandbox', '--disable-gpu', '--disable-background-networking']
  // It ends the process that draws if that had to wait ten seconds for a processor.
  .concat(['--disable-gpu-watchdog'])
  .concat(['--disable-component-update', '--disable-sync', '--disable-extensions', '--no-first-run'])
  // A page that does not come from the server itself may not talk to this machine otherwise.
  .concat(process.env.MERKER_PAGE ? ['--disable-features=LocalNetworkAccessChecks'] : []);

/** A folder of its own below the system's, gone at the end. */
export function scratch() {
  const folder = mkdtempSync(join(tmpdir(), 'merker-browser-'));
  endings.folder.push(() => rmSync(folder, { recursive: true, force: true }));
  return folder;
}

/** The server with a copy of an example, without its German words, as the page makes it; ends with the file's tests. */
export async function serve(example = 'sorting-plant', port = 0) {
  const workspace = scratch();
  const project = join(workspace, basename(example));
  cpSync(join(root, 'examples', example), project, { recursive: true, filter: (path) => !['german.txt', 'README.de.md'].includes(basename(path)) });
  return launch(project, workspace, port);
}

export async function launch(project, workspace, port = 0, more = []) {
  // The workspace of a user is below the home folder.
  const child = spawn(merker, ['run', project, '--port', String(port), ...more], { env: { ...process.env, HOME: workspace } });
  let said = '';
  const collect = (data) => (said += data);
  child.stdout.on('data', collect);
  child.stderr.on('data', collect);
  const ended = new Promise((done) => child.on('exit', done));
  const close = async () => (child.kill(), await ended);
  endings.program.push(close);
  process.on('exit', () => child.kill('SIGKILL'));
  const address = await until(() => /https?:\/\/\S+/.exec(said)?.[0] ?? (child.exitCode !== null && fail(said)),
    () => `an address in the output of the server, which said: ${said}`);
  // A network that goes away: the server is there and says nothing.
  const freeze = (on) => child.kill(on ? 'SIGSTOP' : 'SIGCONT');
  return { address, project, workspace, close, freeze, said: () => said, port: Number(new URL(address).port) };
}

function fail(said) {
  assert.fail(`the server ended: ${said}`);
}

let browser;
async function running() {
  if (!browser) {
    browser = chromium.launch({ executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium-headless-shell', args: ARGUMENTS });
    endings.program.push(async () => (await browser).close());
  }
  return browser;
}

/** Opens a view. The test fails on any error of the page and any request that leaves the server. `stays`: for later tests as well. */
export async function open(server, view = 'io', { language = 'de', theme = 'light', width = 1280, height = 800, stays = false } = {}) {
  const context = await (await running()).newContext({ viewport: { width, height }, acceptDownloads: true });
  const page = await context.newPage();
  await slowed(context, page);
  page.setDefaultTimeout(PATIENCE);
  const complaints = [];
  page.complaints = complaints;
  page.on('pageerror', (error) => complaints.push(error.stack ?? error.message));
  page.on('console', (message) => message.type() === 'error' && complaints.push(message.text()));
  const host = new URL(server.address).host;
  page.on('request', (request) => {
    const url = new URL(request.url());
    if (url.host && url.host !== host) complaints.push(`request to ${url.host}`);
  });
  await page.addInitScript(([language, theme]) => {
    localStorage.setItem('merker.language', JSON.stringify(language));
    localStorage.setItem('merker.theme', JSON.stringify(theme));
  }, [language, theme]);
  if (process.env.MERKER_PAGE) await page.route(`http://${host}/**`, pageFrom(resolve(process.env.MERKER_PAGE)));
  await visit(page, server, view);
  await page.locator('[data-phase="open"]').waitFor();
  endings.judgement.push(() => assert.deepEqual(complaints, [], 'the page complained'));
  endings[stays ? 'staying' : 'page'].push(() => context.close());
  return page;
}

/** MERKER_SLOW=4: the page has a quarter of the processor, as on a busy machine. */
async function slowed(context, page) {
  const rate = Number(process.env.MERKER_SLOW ?? 1);
  if (rate > 1) await (await context.newCDPSession(page)).send('Emulation.setCPUThrottlingRate', { rate });
}

export const visit = (page, server, view) => page.goto(`${server.address.replace(/\/$/, '')}/#/${view}`);

/** A freshly built page in place of the one in the program, to try it without linking. */
function pageFrom(folder) {
  const types = { '.html': 'text/html', '.js': 'text/javascript', '.css': 'text/css', '.svg': 'image/svg+xml' };
  return (route) => {
    const { pathname } = new URL(route.request().url());
    const file = join(folder, pathname === '/' ? 'index.html' : pathname);
    return route.fulfill({ body: readFileSync(file), contentType: types[extname(file)] });
  };
}

/** Looks again until the look gives something; `what` says what was awaited. */
export async function until(look, what = 'this') {
  const end = Date.now() + PATIENCE;
  for (;;) {
    const found = await look();
    if (found) return found;
    if (Date.now() > end) assert.fail(`never came: ${typeof what === 'function' ? what() : what}`);
    await new Promise((done) => setTimeout(done, 25));
  }
}

/** Until the look gives this value. */
export async function expect(look, value, what = '') {
  let last;
  await until(async () => (last = await look()) === value, () => `${what} ${JSON.stringify(value)}, last seen ${JSON.stringify(last)}`);
}

/** The first message with these words. */
export const message = (page, words) => page.locator('.message').filter({ hasText: words }).first().waitFor();

/** Closes all messages, so that the next one is new. Good news goes by itself, sometimes while it is being closed. */
export async function quiet(page) {
  const close = page.locator('.message').getByRole('button', { name: /^(Meldung schließen|Dismiss message)$/ });
  await until(async () => (await close.count()) === 0 || (await close.first().click({ timeout: 500 }).catch(() => {}), false), 'no message');
}

/** Esc, until the dialog is closed. */
export async function leave(page) {
  await page.keyboard.press('Escape');
  await expect(() => page.getByRole('dialog').count(), 0, 'open dialogs');
}

/** Watches an attribute from now on; the result tells each value it has had, however short. */
export async function history(locator, attribute) {
  const handle = await locator.elementHandle();
  await handle.evaluate((element, attribute) => {
    element.had = [element.getAttribute(attribute)];
    new MutationObserver(() => element.had.push(element.getAttribute(attribute))).observe(element, { attributeFilter: [attribute] });
  }, attribute);
  return () => handle.evaluate((element) => element.had);
}

/** What one bit key of the I/O view shows: "0", "1" or "?". */
export const bit = (page, operand) => page.locator(`button[data-operand="${operand}"] .lamp`).innerText();

/** Presses the mode selector. */
export async function turn(page, position) {
  await page.getByRole('radio', { name: position, exact: true }).click();
  const mode = position === 'STOP' ? 'STOP' : 'RUN';
  await page.locator(`[data-mode="${mode}"]`).waitFor();
}

/** Writes a picture for the documents, if somebody asked for them. */
export async function picture(page, name) {
  if (!process.env.MERKER_SCREENSHOTS) return;
  await page.mouse.move(0, 0);
  const focused = await page.evaluateHandle(() => {
    for (const message of document.querySelectorAll('.message')) message.style.display = 'none';
    // The folder of a user, not the temporary one of the test.
    const texts = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    while (texts.nextNode()) texts.currentNode.data = texts.currentNode.data.replace(/\/\S*merker-browser-\w+/, '~/merker');
    let element = document.activeElement;
    while (element?.shadowRoot?.activeElement) element = element.shadowRoot.activeElement;
    element?.blur();
    return element;
  });
  mkdirSync(join(root, 'docs/images/workbench'), { recursive: true });
  await page.screenshot({ path: join(root, 'docs/images/workbench', `${name}.png`) });
  // The test goes on with its keys.
  await focused.evaluate((element) => element?.focus());
}

/** Writes operands, as a variable table does: from a connection of its own. */
export const write = (page, values) =>
  page.evaluate(
    (items) =>
      new Promise((done, failed) => {
        const socket = new WebSocket(new URL('ws', location.href).href.replace(/^http/, 'ws').replace(/#.*/, ''));
        socket.onopen = () => socket.send(JSON.stringify({ id: 1, do: 'variables.write', items }));
        socket.onmessage = ({ data }) => {
          const answer = JSON.parse(data);
          if (answer.id !== 1) return;
          socket.close();
          answer.problems ? failed(new Error(data)) : done(0);
        };
      }),
    Object.entries(values).map(([operand, value]) => ({ operand, value: String(value) })),
  );
