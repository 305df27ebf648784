// Files to the server, in messages of a megabyte.
import type { Requests } from '../connection';
import { toBase64 } from './base64';
import type { Dropped } from './dropped';

type Part = Requests['import.add']['fields']['files'][number];
export const PIECE = 1 << 20;
const MOST_PARTS = 1000;

/** `add` gets the messages one after the other, and says whether further ones are wanted. The next one is read meanwhile. */
export async function send(
  files: readonly Dropped[],
  add: (parts: Part[], bytes: number) => Promise<boolean>,
): Promise<boolean> {
  let parts: Part[] = [];
  let bytes = 0;
  let added = Promise.resolve(true);
  const flush = async (): Promise<boolean> => {
    if (!(await added)) return false;
    if (parts.length > 0) added = add(parts, bytes);
    parts = [];
    bytes = 0;
    return true;
  };
  for (const { path, file } of files) {
    let at = 0;
    do {
      const piece = new Uint8Array(await file.slice(at, at + PIECE - bytes).arrayBuffer());
      parts.push({ path, data: toBase64(piece) });
      at += piece.length;
      bytes += piece.length;
      if ((bytes >= PIECE || parts.length >= MOST_PARTS) && !(await flush())) return false;
    } while (at < file.size);
  }
  return (await flush()) && added;
}
