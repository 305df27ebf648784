// Starts the real program, opens its page, and looks until something is so.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { cpSync, existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { basename, extname, join, resolve } from 'node:path';
import { after } from 'node:test';
import { fileURLToPath } from 'node:url';

export const root = resolve(fileURLToPath(import.meta.url), '../../..');
/** Where npm put the tools: in the clone, or where the build of the page did. */
const modules = ['web/node_modules', 'build/web/node_modules'].map((at) => join(root, at)).find(existsSync) ?? fail('npm ci');
export const tool = (path) => join(modules, path);
const { chromium } = createRequire(tool('index.js'))('playwright-core');
const merker = resolve(process.env.MERKER ?? join(root, 'build/release/merker'));
const PATIENCE = 20_000;

/** What has to be done when all tests of the file are over, newest first. */
const endings = [];
after(async () => {
  for (const end of endings.reverse()) await end();
});

const ARGUMENTS = ['--headless', '--no-sandbox', '--disable-gpu', '--disable-background-networking']
  .concat(['--disable-component-update', '--disable-sync', '--disable-extensions', '--no-first-run'])
  // A page that does not come from the server itself may not talk to this machine otherwise.
  .concat(process.env.MERKER_PAGE ? ['--disable-features=LocalNetworkAccessChecks'] : []);

/** A folder of its own below the system's, gone at the end. */
export function scratch() {
  const folder = mkdtempSync(join(tmpdir(), 'merker-browser-'));
  endings.push(() => rmSync(folder, { recursive: true, force: true }));
  return folder;
}

/** The server with a copy of an example; ends with the file's tests. */
export async function serve(example = 'sorting-plant', port = 0) {
  const workspace = scratch();
  const project = join(workspace, basename(example));
  cpSync(join(root, 'examples', example), project, { recursive: true });
  return launch(project, workspace, port);
}

export async function launch(project, workspace, port = 0) {
  // The workspace of a user is below the home folder.
  const child = spawn(merker, ['run', project, '--port', String(port)], { env: { ...process.env, HOME: workspace } });
  let said = '';
  const collect = (data) => (said += data);
  child.stdout.on('data', collect);
  child.stderr.on('data', collect);
  const ended = new Promise((done) => child.on('exit', done));
  const close = async () => (child.kill(), await ended);
  endings.push(close);
  process.on('exit', () => child.kill('SIGKILL'));
  const address = await until(() => /https?:\/\/\S+/.exec(said)?.[0] ?? (child.exitCode !== null && fail(said)),
    () => `an address in the output of the server, which said: ${said}`);
  return { address, project, workspace, close, port: Number(new URL(address).port) };
}

function fail(said) {
  assert.fail(`the server ended: ${said}`);
}

let browser;
async function running() {
  if (!browser) {
    browser = chromium.launch({ executablePath: process.env.CHROMIUM ?? '/usr/bin/chromium', args: ARGUMENTS });
    endings.push(async () => (await browser).close());
  }
  return browser;
}

/** Opens a view. The test fails on any error of the page and any request that leaves the server. */
export async function open(server, view = 'io', { language = 'de', theme = 'light', width = 1280, height = 800 } = {}) {
  const context = await (await running()).newContext({ viewport: { width, height }, acceptDownloads: true });
  const page = await context.newPage();
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
  endings.push(() => assert.deepEqual(complaints, [], 'the page complained'));
  endings.push(() => context.close());
  return page;
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
  await page.evaluate(() => {
    document.activeElement?.blur();
    for (const message of document.querySelectorAll('.message')) message.style.display = 'none';
  });
  mkdirSync(join(root, 'docs/images/workbench'), { recursive: true });
  await page.screenshot({ path: join(root, 'docs/images/workbench', `${name}.png`) });
}
