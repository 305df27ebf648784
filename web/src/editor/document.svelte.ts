import type { Problem } from '../connection';
import { afterFrame } from '../state/after_frame';
import { whenQuiet } from '../state/when_quiet';
import type { Drafts } from './drafts';

export interface Stored {
  text: string;
  revision: number;
}

/** One open text: what was typed, what the server has, and whether another browser came in between. */
export class OpenDocument {
  text = $state('');
  /** The text as of the last frame, for what is worked out from all of it: a key is shown first. */
  settled = $state('');
  private settling = false;
  private readonly keeping = whenQuiet(() => this.keep());
  problems = $state<Problem[]>([]);
  /** The server's newer text, while this browser has changes of its own. */
  conflict = $state<Stored | null>(null);
  private stored = $state<Stored>({ text: '', revision: 0 });

  constructor(
    readonly path: string,
    stored: Stored,
    private readonly drafts: Drafts,
    /** The block of which this is the machine code, to read only. */
    readonly code: { block: string; side: 'offline' | 'online' } | null = null,
    /** A file that was fetched from the CPU and is no part of the program: to read only. */
    readonly copied = false,
  ) {
    this.stored = stored;
    this.text = this.settled = stored.text;
    const draft = this.readonly ? null : drafts.read(path);
    if (!draft || draft.text === stored.text) return;
    this.text = this.settled = draft.text;
    if (draft.revision !== stored.revision) this.conflict = stored;
  }

  get readonly(): boolean {
    return this.code !== null || this.copied;
  }

  get dirty(): boolean {
    return this.text !== this.stored.text;
  }

  get revision(): number {
    return this.stored.revision;
  }

  /** Typed by the user key by key, or changed by a command of the page. */
  edit(text: string, typed = false): void {
    this.text = text;
    if (typed) {
      this.settleSoon();
      this.keeping.ask();
    } else {
      this.settled = text;
      this.keep();
    }
  }

  private settleSoon(): void {
    if (this.settling) return;
    this.settling = true;
    afterFrame(() => {
      this.settling = false;
      this.settled = this.text;
    });
  }

  /** What the server has now. Without changes of our own the text follows; with them both are kept. */
  arrived(stored: Stored): void {
    if (stored.revision === this.stored.revision) return;
    if (!this.dirty || stored.text === this.text) this.take(stored);
    else this.conflict = stored;
  }

  /** Saved: the server has `text`, whatever was typed since. */
  saved(text: string, revision: number): void {
    this.stored = { text, revision };
    this.conflict = null;
    this.keep();
  }

  /** Goes on with our text, which will replace the other one at the next save. */
  keepMine(): void {
    if (!this.conflict) return;
    this.stored = this.conflict;
    this.conflict = null;
    this.keep();
  }

  /** Goes on with the other text; ours can be brought back with "undo". */
  takeTheirs(): void {
    if (this.conflict) this.take(this.conflict);
  }

  private take(stored: Stored): void {
    this.stored = stored;
    this.text = this.settled = stored.text;
    this.conflict = null;
    this.keep();
  }

  private keep(): void {
    this.keeping.cancel();
    if (this.readonly) return;
    if (this.dirty) this.drafts.write(this.path, { text: this.text, revision: this.revision });
    else this.drafts.remove(this.path);
  }
}
