// The accessibility check: nothing serious, nothing critical.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { tool } from './harness.mjs';

const source = readFileSync(tool('axe-core/axe.min.js'), 'utf-8');

/** `rules`: only these. */
export async function accessible(page, where, rules) {
  // Through the debugger's door: the page's content security policy lets no script in.
  await page.evaluate(source);
  const { violations } = await page.evaluate(
    (rules) => globalThis.axe.run(document, { resultTypes: ['violations'], ...(rules && { runOnly: rules }) }),
    rules,
  );
  const bad = violations
    .filter(({ impact }) => impact === 'serious' || impact === 'critical')
    .map(({ id, help, nodes }) => `${id}: ${help}: ${nodes.map((node) => `${node.target} ${node.any[0]?.message ?? ''}`).join('; ')}`);
  assert.deepEqual(bad, [], where);
}
