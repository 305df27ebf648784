// The project as the program view sees it: files, open texts, blocks of both sides, problems. It outlives a change of view.
import { SvelteMap } from 'svelte/reactivity';
import { connection, ConnectionLost, Refused, type Problem } from '../connection';
import type { BlockInterface, BlockRow, Compared, FileRow } from '../connection/protocol';
import { attempt, messages } from '../state/messages.svelte';
import { coalesced } from '../state/coalesced';
import { plc } from '../state/plc.svelte';
import { emptyCatalogue, SymbolIndex, type Catalogue } from './catalogue';
import { OpenDocument } from './document.svelte';
import { Drafts } from './drafts';
import type { Mnemonics } from './mnemonics';

export type Side = 'offline' | 'online';
export type Difference = Compared['state'];

const CHECK_AFTER_MS = 300;

/** What becomes of a refusal: a message, or nothing. */
type Asking = <T>(answer: Promise<T>) => Promise<T | undefined>;

const isError = ({ severity }: Problem): boolean => severity === 'error';
const isAmong = (list: readonly Problem[], { code, file, line, column }: Problem): boolean =>
  list.some((one) => one.code === code && one.file === file && one.line === line && one.column === column);

class Workspace {
  files = $state.raw<FileRow[]>([]);
  blocks = $state.raw<Record<Side, BlockRow[]>>({ offline: [], online: [] });
  compared = $state.raw<Compared[]>([]);
  catalogue = $state.raw<Catalogue>(emptyCatalogue());
  problems = $state.raw<Problem[]>([]);
  interfaces = $state.raw<BlockInterface[]>([]);
  checked = $state(false);
  documents = new SvelteMap<string, OpenDocument>();
  current = $state<OpenDocument | null>(null);
  symbols = $derived(new SymbolIndex(this.catalogue.symbols));

  private folder = $state('');
  private drafts = new Drafts(localStorage, '', sessionStorage);
  private saving = new WeakMap<OpenDocument, Promise<boolean>>();
  private looks = 0;
  /** Whether what was typed in all files of this project is open again. */
  private restored = false;
  private timer: ReturnType<typeof setTimeout> | undefined;

  /** Whether what is here is of that project. */
  isOf(folder: string | undefined): boolean {
    return this.folder === folder;
  }

  /** Another project: its texts, and what was typed in it before. */
  enter(folder: string): void {
    if (folder === this.folder) return;
    this.folder = folder;
    this.drafts = new Drafts(localStorage, folder, sessionStorage);
    this.documents.clear();
    this.current = null;
    this.files = [];
    this.blocks = { offline: [], online: [] };
    this.compared = [];
    this.interfaces = [];
    this.problems = [];
    this.checked = false;
    this.restored = false;
  }

  /** After a change of files, by any browser or on the disk. They may come faster than a program is compiled. */
  readonly refreshFiles = coalesced(() => this.readFiles());
  readonly refreshBlocks = coalesced(() => this.readBlocks());
  private readonly check = coalesced(() => this.readProblems());

  private async readFiles(): Promise<void> {
    const answer = await attempt(connection.ask('files.list'));
    if (answer) this.files = answer.files;
    for (const document of [...this.documents.values()])
      if (document.code) continue;
      else if (this.exists(document.path)) await this.reread(document);
      else if (!document.dirty) this.close(document.path);
    if (answer && !this.restored) await this.restore();
    const catalogue = plc.can('completion') && (await quiet(connection.ask('program.completion')));
    if (catalogue) this.catalogue = catalogue;
    this.checkSoon();
  }

  /** After a reload: their dots, their problems and "load" are those of all drafts, not only of the text that is shown. */
  private async restore(): Promise<void> {
    this.restored = true;
    for (const path of this.drafts.paths()) if (this.exists(path)) await this.fetch(path, quiet);
  }

  private async readBlocks(): Promise<void> {
    const ask = async (side: Side): Promise<BlockRow[]> =>
      (await quiet(connection.ask('program.blocks', { side })))?.blocks ?? [];
    const look = ++this.looks;
    const blocks = { offline: await ask('offline'), online: await ask('online') };
    if (look !== this.looks) return; // a later look has seen more
    this.blocks = blocks;
    const compared = (await quiet(connection.ask('program.compare')))?.blocks ?? [];
    if (look === this.looks) this.compared = compared;
  }

  async open(path: string, ask: Asking = attempt): Promise<OpenDocument | undefined> {
    const document = await this.fetch(path, ask);
    if (document) this.current = document;
    this.checkSoon();
    return document;
  }

  /** The text with what was typed, without showing it. */
  async fetch(path: string, ask: Asking = attempt): Promise<OpenDocument | undefined> {
    const document = this.documents.get(path);
    if (document) return document;
    const stored = await ask(connection.ask('files.read', { path }));
    if (!stored) return undefined;
    const fresh = this.documents.get(path) ?? new OpenDocument(path, stored, this.drafts, null, this.isCopy(path));
    this.documents.set(path, fresh);
    return this.documents.get(path);
  }

  /** A block of the CPU, or one that the project has as machine code only, as AWL to read. */
  async openCode(block: string, side: Side, mnemonics: Mnemonics, path = `CPU: ${block}`): Promise<void> {
    const answer = await attempt(connection.ask('program.listing', { block, side, mnemonics }));
    if (!answer) return;
    const document = new OpenDocument(path, { text: answer.text, revision: 0 }, this.drafts, { block, side });
    this.documents.set(document.path, document);
    this.current = document;
  }

  async delete(path: string): Promise<void> {
    if ((await attempt(connection.ask('files.delete', { path }))) === undefined) return;
    this.drafts.remove(path);
    this.close(path);
  }

  /** With what was typed in it; references of merker.toml are the server's. */
  async rename(path: string, to: string): Promise<boolean> {
    const document = this.documents.get(path);
    if (document && !document.readonly && !(await this.save(document))) return false;
    const answer = await attempt(connection.ask('files.rename', { path, to }));
    if (answer === undefined) return false;
    const shown = this.current?.path === path;
    this.drafts.remove(path);
    this.close(path);
    if (shown) await this.open(to);
    return true;
  }

  /** Blocks that the project has as well are saved there; they are compiled only if merker.toml names them. */
  isCopy(path: string): boolean {
    return path.startsWith('online/') && !this.blocks.offline.some((block) => block.file === path);
  }

  private exists(path: string): boolean {
    return this.files.some((file) => file.path === path);
  }

  close(path: string): void {
    this.documents.delete(path);
    if (this.current?.path === path) this.current = [...this.documents.values()].at(-1) ?? null;
  }

  edit(document: OpenDocument, text: string, typed = false): void {
    document.edit(text, typed);
    this.checkSoon();
  }

  /** False if it could not be saved; the text stays as it is. One save of a text follows the other: each names the revision that the last one made. */
  save(document: OpenDocument): Promise<boolean> {
    const before = this.saving.get(document) ?? Promise.resolve(true);
    const now = before.then(() => this.write(document));
    this.saving.set(document, now);
    return now;
  }

  private async write(document: OpenDocument): Promise<boolean> {
    if (document.readonly || document.conflict) return false;
    if (!document.dirty) return true;
    const { path, text, revision } = document;
    try {
      // A file that was deleted meanwhile comes back with what was typed.
      const answer = this.exists(path)
        ? await connection.ask('files.write', { path, text, revision })
        : await connection.ask('files.create', { path, text });
      document.saved(text, answer.revision);
      return true;
    } catch (error) {
      if (error instanceof Refused) await this.refused(document, error);
      return false;
    }
  }

  /** Saves everything and loads it, or single blocks, into the CPU. `listed`: shows the list of problems, which then is not told in messages as well. */
  async load(blocks?: string[], listed?: () => void): Promise<boolean> {
    messages.solved('program.load');
    for (const document of this.documents.values())
      if (!(await this.save(document)) && !document.readonly) return false;
    if (plc.lacks('download')) return this.reopen(listed);
    try {
      await connection.ask('program.load', blocks ? { blocks } : {});
      return true;
    } catch (error) {
      if (error instanceof Refused) await this.notLoaded(error.problems, listed);
      else if (!(error instanceof ConnectionLost)) throw error;
      return false;
    }
  }

  // A machine that takes no blocks one by one: the project is opened again, unless it has errors.
  private async reopen(listed?: () => void): Promise<boolean> {
    const answer = await attempt(connection.ask('program.check'));
    if (!answer) return false;
    if (answer.problems.some(isError)) await this.notLoaded(answer.problems, listed);
    else return (await attempt(connection.ask('projects.open', { folder: this.folder }))) !== undefined;
    return false;
  }

  private async notLoaded(problems: Problem[], listed?: () => void): Promise<void> {
    await this.readProblems();
    const told = listed ? problems.filter((problem) => !isAmong(this.problems, problem)) : problems;
    messages.problems(told.filter(isError), 'program.load');
    if (told.length < problems.length) listed?.();
  }

  /** What the CPU has in an operand. */
  async value(operand: string): Promise<string | undefined> {
    const answer = await quiet(
      connection.ask('variables.read', {
        items: [{ operand, format: 'AUTO' }],
      }),
    );
    const item = answer?.items[0];
    return item?.problem ? undefined : item?.text;
  }

  /** By name in upper case; empty while the block has errors. */
  addressesOf(path: string, line: number): Map<string, string> {
    const found = this.interfaces.find((one) => one.file === path && one.line === line);
    return new Map(found?.variables.map((variable) => [variable.name.toUpperCase(), variable.address]));
  }

  checkSoon(): void {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => void this.check(), CHECK_AFTER_MS);
  }

  private async readProblems(): Promise<void> {
    const changed = [...this.documents.values()].filter((document) => document.dirty && !document.readonly);
    const files = changed.map(({ path, text }) => ({ path, text }));
    const answer = await quiet(connection.ask('program.check', { files }));
    if (!answer) return;
    if (answer.interfaces) this.interfaces = answer.interfaces;
    this.problems = answer.problems;
    this.checked = true;
    for (const document of this.documents.values())
      document.problems = answer.problems.filter((problem) => problem.file === document.path);
  }

  private async reread(document: OpenDocument): Promise<void> {
    const stored = await quiet(connection.ask('files.read', { path: document.path }));
    if (stored) document.arrived(stored);
  }

  // Another browser was faster: its text is shown beside ours. Anything else is told as the server says it.
  private async refused(document: OpenDocument, error: Refused): Promise<void> {
    await this.reread(document);
    if (!document.conflict) messages.problems(error.problems);
  }
}

/** For what repeats by itself: a refusal is no message for the user. */
export async function quiet<T>(answer: Promise<T>): Promise<T | undefined> {
  try {
    return await answer;
  } catch {
    return undefined;
  }
}

export const workspace = new Workspace();

/** Follows the server as long as the calling component lives. */
export function followWorkspace(): void {
  $effect(() => {
    if (plc.live && plc.project) workspace.enter(plc.project.folder);
  });
  $effect(() => {
    void plc.files;
    if (plc.live && plc.project) void workspace.refreshFiles();
  });
  $effect(() => {
    void [plc.files, plc.program];
    if (plc.live && plc.can('blocks')) void workspace.refreshBlocks();
  });
}
