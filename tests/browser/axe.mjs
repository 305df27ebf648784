// The accessibility check.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { tool } from './harness.mjs';

const source = readFileSync(tool('axe-core/axe.min.js'), 'utf-8');

/** Nothing serious, nothing critical. `rules`: only these. */
export async function accessible(page, where, rules) {
  await check(page, where, rules, ({ impact }) => impact === 'serious' || impact === 'critical');
}

/** Nothing at all, by any rule that axe has by default. */
export async function faultless(page, where) {
  await check(page, where, undefined, () => true);
}

async function check(page, where, rules, counts) {
  // Through the debugger's door: the page's content security policy lets no script in.
  await page.evaluate(source);
  const { violations } = await page.evaluate(
    (rules) => globalThis.axe.run(document, { resultTypes: ['violations'], ...(rules && { runOnly: rules }) }),
    rules,
  );
  const bad = violations
    .filter(counts)
    .map(({ id, help, nodes }) => `${id}: ${help}: ${nodes.map((node) => `${node.target} ${node.any[0]?.message ?? ''}`).join('; ')}`);
  assert.deepEqual(bad, [], where);
}
