// What a replacement has changed, and that it can still be taken back after a reload of the page.
import type { Storage } from './drafts';

/** A text before and after a replacement. */
export interface Change {
  file: string;
  before: string;
  after: string;
}
export interface Replaced {
  folder: string;
  count: number;
  changes: Change[];
}

const KEY = 'merker.replaced';
/** Characters: a fifth of what a browser keeps, drafts need the rest. More than that is taken back before a reload or not at all. */
const MOST = 1_000_000;

export function keep(storage: Storage, replaced: Replaced | null): void {
  try {
    const text = replaced ? JSON.stringify(replaced) : '';
    if (text === '' || text.length > MOST) storage.removeItem(KEY);
    else storage.setItem(KEY, text);
  } catch {
    // A browser that keeps nothing: it lives as long as the page.
  }
}

export function keptReplaced(storage: Storage): Replaced | null {
  try {
    return JSON.parse(storage.getItem(KEY) ?? 'null') as Replaced | null;
  } catch {
    return null;
  }
}
