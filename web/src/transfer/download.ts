// The project as a zip, fetched piece by piece.
import { connection } from '../connection';
import { attempt } from '../state/messages.svelte';
import { download } from '../trends/files';
import { fromBase64 } from './base64';

/** The zip that the user has now, and what is not in it; undefined if it was refused. */
export async function downloadProject(): Promise<{ name: string; left: string[] } | undefined> {
  const zip = await attempt(connection.ask('download.begin'));
  if (!zip) return undefined;
  const parts: Uint8Array<ArrayBuffer>[] = [];
  for (let at = 0; at < zip.size; at += parts.at(-1)!.length) {
    const piece = await attempt(connection.ask('download.piece', { at }));
    if (!piece?.data) return undefined;
    parts.push(fromBase64(piece.data));
  }
  connection.ask('download.end').catch(() => {});
  download(zip.name, new Blob(parts, { type: 'application/zip' }));
  return { name: zip.name, left: zip.left };
}
