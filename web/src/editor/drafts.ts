// What was typed and not yet saved, kept by the browser over a reload. A text that gave way to another one is kept too.

export interface Draft {
  text: string;
  revision: number; // of the text it came from
}

export interface Storage {
  getItem(key: string): string | null;
  setItem(key: string, value: string): void;
  removeItem(key: string): void;
}

export class Drafts {
  constructor(
    private readonly storage: Storage,
    private readonly folder: string,
  ) {}

  read(path: string): Draft | null {
    try {
      return JSON.parse(this.storage.getItem(this.key(path)) ?? 'null') as Draft | null;
    } catch {
      return null;
    }
  }

  /** False if the browser keeps nothing: the caller tells the user. */
  write(path: string, draft: Draft): boolean {
    try {
      this.storage.setItem(this.key(path), JSON.stringify(draft));
      return true;
    } catch {
      return false;
    }
  }

  remove(path: string): void {
    try {
      this.storage.removeItem(this.key(path));
    } catch {
      // nothing was kept then
    }
  }

  private key(path: string): string {
    return `merker.draft.${this.folder}/${path}`;
  }
}
