// The picture that is open: each change is saved at once, and can be undone.
import { connection, Refused } from '../connection';
import { attempt } from '../state/messages.svelte';
import { told } from '../i18n';
import { parsePicture, placed, printPicture, type Item } from './picture';

const MOST_UNDO = 100;

export class OpenPicture {
  items = $state.raw<Item[]>([]);
  /** Lines of the file that are no symbol. */
  wrong = $state.raw<number[]>([]);
  /** Symbols that are too many: they are in the file only. */
  beyond = $state(0);
  undos = $state(0);
  /** What is shown and written; none until a file has been read. */
  path = $state('');
  /** Why the file that is wanted cannot be read; empty: it has been, or nothing has come yet. */
  why = $state('');
  private wanted = '';
  private revision = 0;
  private end: string[] = [];
  private before: Item[][] = [];
  private saving: Promise<void> = Promise.resolve();
  private unsaved = 0;

  /** Reads it again as well: another browser may have changed it. */
  async read(path: string): Promise<void> {
    if (this.unsaved > 0 && path === this.path) return;
    this.wanted = path;
    let stored;
    try {
      stored = await connection.ask('files.read', { path });
    } catch (error) {
      if (error instanceof Refused && path === this.wanted) this.close(told(error.problems[0]!));
      return;
    }
    if (path !== this.wanted || (path === this.path && stored.revision === this.revision) || this.unsaved > 0) return;
    this.why = '';
    if (path !== this.path) this.before = [];
    this.undos = this.before.length;
    this.path = path;
    this.revision = stored.revision;
    ({ items: this.items, wrong: this.wrong, beyond: this.beyond, end: this.end } = parsePicture(stored.text));
  }

  /** Nothing is shown: what was there before is another picture, or what this one no longer is. */
  private close(why: string): void {
    this.path = '';
    this.why = why;
    this.before = [];
    this.undos = this.beyond = 0;
    this.items = [];
    this.wrong = [];
  }

  change(items: Item[]): void {
    this.before = [...this.before, this.items].slice(-MOST_UNDO);
    this.undos = this.before.length;
    this.put(items);
  }

  undo(): void {
    const last = this.before.at(-1);
    if (!last) return;
    this.before = this.before.slice(0, -1);
    this.undos = this.before.length;
    this.put(last);
  }

  /** While something is drawn over the picture: seen, not saved. */
  show(items: Item[]): void {
    this.items = items;
  }

  private put(items: Item[]): void {
    this.items = items.map(placed);
    this.unsaved++;
    const { path } = this;
    const text = printPicture(this.items, this.end);
    // One after the other: each names the revision that the last one made.
    this.saving = this.saving.then(() => this.write(path, text));
  }

  private async write(path: string, text: string): Promise<void> {
    const answer = await attempt(connection.ask('files.write', { path, text, revision: this.revision }));
    this.unsaved--;
    if (path !== this.path) return;
    if (answer) this.revision = answer.revision;
    else if (this.unsaved === 0) await this.read(path);
  }
}
