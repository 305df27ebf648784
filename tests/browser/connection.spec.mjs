// Two browsers see the same; a lost connection is shown and repaired; how much comes over it at first.
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { bit, expect, launch, open, serve, visit } from './harness.mjs';

test('what one browser does the other one sees', async () => {
  const server = await serve();
  const [one, two] = [await open(server), await open(server, 'io', { language: 'en', theme: 'dark' })];
  // An input that nothing is wired to.
  await expect(() => bit(one, 'E 0.7'), '0');
  await one.locator('button[data-operand="E 0.7"]').click();
  await expect(() => bit(one, 'E 0.7'), '1');
  await expect(() => bit(two, 'E 0.7'), '1');
  await two.getByRole('radio', { name: 'STOP' }).click();
  await one.locator('[data-mode="STOP"]').waitFor();
});

test('a server that went away is shown; when it is back the page goes on by itself', async () => {
  const server = await serve();
  const page = await open(server);
  await server.close();
  await page.locator('[data-phase="lost"]').waitFor();
  await launch(server.project, server.workspace, server.port);
  await page.locator('[data-phase="open"]').waitFor();
  await expect(() => bit(page, 'E 0.7'), '0');
  await page.locator('button[data-operand="E 0.7"]').click();
  await expect(() => bit(page, 'E 0.7'), '1');
  page.complaints.length = 0; // the browser itself logs each failed try
});

test('a server that says nothing any more is shown as lost, not as if all were well', async () => {
  const server = await serve();
  const page = await open(server);
  server.freeze(true);
  try {
    await page.locator('[data-phase="lost"]').waitFor();
  } finally {
    server.freeze(false);
  }
  await page.locator('[data-phase="open"]').waitFor();
  page.complaints.length = 0;
});

// The page in the program is compressed, one beside it is not.
test('the first view costs less than 400 kB on the wire', { skip: Boolean(process.env.MERKER_PAGE) }, async () => {
  const server = await serve();
  const page = await open(server);
  for (const [view, shown] of [['process', 'main h1'], ['program', '.code .cm-line']]) {
    const fresh = await page.context().newPage();
    const wire = await page.context().newCDPSession(fresh);
    await wire.send('Network.enable');
    await wire.send('Network.setCacheDisabled', { cacheDisabled: true });
    let bytes = 0;
    wire.on('Network.loadingFinished', ({ encodedDataLength }) => (bytes += encodedDataLength));
    await visit(fresh, server, view);
    await fresh.locator(shown).first().waitFor();
    assert.ok(bytes > 50_000 && bytes < 400_000, `${view}: ${bytes} bytes`);
    await fresh.close();
  }
});
