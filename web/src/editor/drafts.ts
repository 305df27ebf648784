// What was typed and not yet saved, kept by the browser over a reload. A text that gave way to another one is kept too.
// Each tab has its own; what the browser keeps for the next start is the last one that was typed in any of them.

export interface Draft {
  text: string;
  revision: number; // of the text it came from
}

export interface Storage {
  getItem(key: string): string | null;
  setItem(key: string, value: string): void;
  removeItem(key: string): void;
  readonly length: number;
  key(index: number): string | null;
}

export class Drafts {
  constructor(
    private readonly storage: Storage,
    private readonly folder: string,
    private readonly tab: Storage = storage,
  ) {}

  read(path: string): Draft | null {
    try {
      const own = this.tab.getItem(this.key(path));
      const found = own ?? this.storage.getItem(this.key(path));
      if (found !== null && own === null) this.tab.setItem(this.key(path), found);
      return JSON.parse(found ?? 'null') as Draft | null;
    } catch {
      return null;
    }
  }

  /** What has a draft in this project. */
  paths(): string[] {
    const begin = this.key('');
    const keys = [this.tab, this.storage].flatMap((kept) =>
      Array.from({ length: kept.length }, (_, index) => kept.key(index) ?? ''),
    );
    return [...new Set(keys.filter((key) => key.startsWith(begin)).map((key) => key.slice(begin.length)))];
  }

  /** False if the browser keeps nothing: the caller tells the user. */
  write(path: string, draft: Draft): boolean {
    try {
      const text = JSON.stringify(draft);
      this.tab.setItem(this.key(path), text);
      this.storage.setItem(this.key(path), text);
      return true;
    } catch {
      return false;
    }
  }

  remove(path: string): void {
    try {
      const key = this.key(path);
      // What another tab has typed since is not ours to forget.
      if (this.storage.getItem(key) === this.tab.getItem(key)) this.storage.removeItem(key);
      this.tab.removeItem(key);
    } catch {
      // nothing was kept then
    }
  }

  private key(path: string): string {
    return `merker.draft.${this.folder}/${path}`;
  }
}
