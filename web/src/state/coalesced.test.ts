import { expect, test } from 'vitest';
import { coalesced } from './coalesced';

test('many calls while one runs are one more run', async () => {
  let runs = 0;
  const open: (() => void)[] = [];
  const run = coalesced(() => {
    runs++;
    return new Promise((done) => open.push(done));
  });
  const all = [run(), run(), run(), run()];
  expect(runs).toBe(1);
  open.shift()!();
  await Promise.resolve();
  await Promise.resolve();
  expect(runs).toBe(2);
  open.shift()!();
  await Promise.all(all);
  expect(runs).toBe(2);
  const last = run();
  expect(runs).toBe(3);
  open.shift()!();
  await last;
});

test('a run that fails does not block the next one', async () => {
  let runs = 0;
  const run = coalesced(async () => {
    if (++runs === 1) throw new Error('no');
  });
  await expect(run()).rejects.toThrow('no');
  await run();
  expect(runs).toBe(2);
});
