import { expect, test } from 'vitest';
import { fromBase64, toBase64 } from './base64';
import { pathOf } from './dropped';
import { PIECE, send } from './send';

test('bytes survive a message', () => {
  const bytes = Uint8Array.from({ length: 100_003 }, (_, at) => (at * 7) % 256);
  expect(fromBase64(toBase64(bytes))).toEqual(bytes);
  expect(toBase64(new Uint8Array([77, 97]))).toBe('TWE=');
});

test('hidden files stay, names become paths', () => {
  expect(pathOf(['Plant', 'hrs', 'S7RESOFF.DBF'])).toBe('Plant/hrs/S7RESOFF.DBF');
  expect(pathOf(['Plant', '.git', 'config'])).toBeUndefined();
  expect(pathOf(['..', 'x'])).toBeUndefined();
  expect(pathOf(['a\\b:c'])).toBe('a_b_c');
});

const file = (path: string, length: number) => ({ path, file: new File([new Uint8Array(length).fill(7)], path) });

/** The messages: paths, and how many bytes each has. */
async function sent(files: ReturnType<typeof file>[], most = Infinity) {
  const messages: [string, number][][] = [];
  const good = await send(files, async (parts) => {
    messages.push(parts.map(({ path, data }) => [path, fromBase64(data).length]));
    return messages.length < most;
  });
  return { messages, good };
}

test('small files go together, large ones in pieces, empty ones, too', async () => {
  const { messages, good } = await sent([file('a', 3), file('empty', 0), file('large', PIECE), file('b', 1)]);
  expect(good).toBe(true);
  expect(messages).toEqual([
    [
      ['a', 3],
      ['empty', 0],
      ['large', PIECE - 3],
    ],
    [
      ['large', 3],
      ['b', 1],
    ],
  ]);
});

test('nothing more is sent to who wants no more', async () => {
  const { messages, good } = await sent([file('large', 5 * PIECE)], 2);
  expect(good).toBe(false);
  expect(messages.length).toBe(2);
});
