import { untrack } from 'svelte';
import { connection } from '../connection';
import { among, isText, listOf, objectOf } from '../state/alike';
import { keptByName } from '../state/kept.svelte';
import { attempt } from '../state/messages.svelte';
import { pastedInto } from '../state/pasted';
import { plc } from '../state/plc.svelte';
import { parseTable, printTable, rangeOf, withoutEnd, type Row } from './table';
import { atOnce, parseTriggers, POINTS, printTriggers, type Trigger } from './triggers';

interface Draft {
  path: string;
  rows: Row[];
  monitor?: Trigger;
  modify?: Trigger;
  /** What its file holds as this browser writes it, and as it was read. */
  saved?: string;
  stored?: string;
}

const isRow = objectOf({ operand: isText, format: isText, modify: isText });
const isTrigger = objectOf({ point: among(...POINTS), once: among(true, false) });
const isDraft = objectOf(
  { path: isText, rows: listOf(isRow) },
  { monitor: isTrigger, modify: isTrigger, saved: isText, stored: isText },
);
const drafts = keptByName<Draft>('variables', isDraft);
const KEEP_AFTER_MS = 300;
const EMPTY = printTable([]);
const emptyRow = (): Row => ({ operand: '', format: 'AUTO', modify: '' });

/** The table that is being edited; this browser keeps it per project until it is saved as a file of the project. */
export class Table {
  path = $state('');
  rows = $state<Row[]>([]);
  files = $state<string[]>([]);
  monitor = $state.raw<Trigger>(atOnce);
  modify = $state.raw<Trigger>(atOnce);
  /** A file that somebody else has changed, or that is another table: it is asked whether to overwrite it. */
  others = $state('');
  private saved = EMPTY;
  private stored: string | undefined;
  private project = '';
  private timer: ReturnType<typeof setTimeout> | undefined;

  /** Shows what this browser kept of the project. */
  follow(project: string): void {
    if (project === this.project) return;
    this.keep();
    this.project = project;
    const draft = untrack(() => drafts.value[project]);
    this.path = draft?.path ?? '';
    this.rows = draft?.rows ?? [];
    this.monitor = draft?.monitor ?? atOnce;
    this.modify = draft?.modify ?? atOnce;
    this.saved = draft?.saved ?? (draft ? '' : EMPTY);
    this.stored = draft?.stored;
    this.complete();
  }

  /** The last row is always empty: to type the next operand into. */
  complete(): void {
    if (this.rows[this.rows.length - 1]?.operand !== '') this.rows.push(emptyRow());
  }

  /** An operand has been typed: a range becomes its rows. The row below them, or that is to be typed into after a range. */
  settle(row: Row): number {
    const index = this.rows.indexOf(row);
    // Gone already: its field tells once more that it has changed.
    if (index < 0) return 0;
    const operands = rangeOf(row.operand);
    if (operands.length > 1)
      this.paste(
        row,
        operands.map((operand) => ({ ...row, operand, modify: '' })),
      );
    else this.complete();
    if (operands.length <= 1) return Math.min(index + 1, this.rows.length - 1);
    const below = index + operands.length;
    return this.rows.findIndex((one, at) => at >= below && one.operand.trim() === '');
  }

  /** Rows in place of this one if it is empty or a range, else below it. */
  paste(at: Row, rows: Row[]): void {
    const index = this.rows.indexOf(at);
    const gone = at.operand.trim() === '' || rangeOf(at.operand).length > 1;
    this.rows = pastedInto(this.rows, index, gone, rows);
    this.complete();
  }

  append(operands: string[]): void {
    this.rows = [...withoutEnd(this.rows), ...operands.map((operand) => ({ ...emptyRow(), operand }))];
    this.complete();
  }

  /** After the last of several changes: a long table is not written with each key. */
  keepSoon(): void {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => this.keep(), KEEP_AFTER_MS);
  }

  keep(): void {
    clearTimeout(this.timer);
    if (!this.project) return;
    const { path, monitor, modify, saved, stored } = this;
    const draft = { path, rows: $state.snapshot(this.rows), monitor, modify, saved, stored };
    drafts.value = { ...untrack(() => drafts.value), [this.project]: draft };
  }

  async list(): Promise<void> {
    const answer = await connection.ask('files.list').catch(() => null);
    if (answer) this.files = answer.files.map((file) => file.path).filter((path) => /\.vat$/i.test(path));
    await this.refresh();
  }

  /** The text of its file. */
  print(): string {
    return printTable(this.rows, printTriggers(this.monitor, this.modify));
  }

  /** Whether something of it is not in its file. */
  changed(): boolean {
    return this.print() !== this.saved;
  }

  fresh(): void {
    this.path = '';
    this.rows = [emptyRow()];
    this.monitor = this.modify = atOnce;
    this.saved = EMPTY;
  }

  remove(row: Row): void {
    this.rows = this.rows.filter((one) => one !== row);
    this.complete();
  }

  async open(path: string): Promise<void> {
    const file = await attempt(connection.ask('files.read', { path }));
    if (file) this.take(path, file.text);
  }

  /** Somebody else may have changed the file: shown where nothing here is unsaved. */
  async refresh(): Promise<void> {
    const { path } = this;
    if (!path || !this.files.includes(path) || this.changed()) return;
    const file = await connection.ask('files.read', { path }).catch(() => null);
    if (file && path === this.path && file.text !== this.stored && !this.changed()) this.take(path, file.text);
  }

  private take(path: string, text: string): void {
    this.path = path;
    this.stored = text;
    this.rows = parseTable(text);
    Object.assign(this, parseTriggers(text));
    this.saved = this.print();
    this.complete();
  }

  /** True if the file holds the table now. `overwrite`: what somebody else has written there goes. */
  async save(path: string, overwrite = false): Promise<boolean> {
    const text = this.print();
    const there = this.files.includes(path);
    const old = there ? await attempt(connection.ask('files.read', { path })) : undefined;
    if (there && !old) return false;
    const known = path === this.path && (this.stored === undefined || old?.text === this.stored);
    this.others = old && !known && !overwrite ? path : '';
    if (this.others) return false;
    // A new file appears with its text at once: nobody sees, and no kill leaves, an empty table.
    const answer = old
      ? connection.ask('files.write', { path, text, revision: old.revision })
      : connection.ask('files.create', { path, text });
    if ((await attempt(answer)) === undefined) return false;
    this.path = path;
    this.saved = this.stored = text;
    return true;
  }
}

export const table = new Table();

/** Whether this is the project's table of the moment. */
export const projectOf = () => plc.project?.folder ?? '';
