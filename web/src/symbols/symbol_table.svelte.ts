// The symbol table of the project. It is a text like the others: kept while unsaved, shown beside a newer one.
import { connection, Refused, type Problem } from '../connection';
import { OpenDocument } from '../editor/document.svelte';
import { Drafts } from '../editor/drafts';
import { pastedInto } from '../state/pasted';
import { attempt, messages } from '../state/messages.svelte';
import { plc } from '../state/plc.svelte';
import { renamedUses } from './renamed_uses.svelte';
import {
  emptyRow,
  fromText,
  isEmpty,
  meaningful,
  toText,
  typeOfOperand,
  type Field,
  type SymbolRow,
  type Format,
} from './rows';

const CHECK_AFTER_MS = 250;

class SymbolTable {
  rows = $state<SymbolRow[]>([]);
  problems = $state.raw<Problem[]>([]);
  path = $state('');
  private document = $state<OpenDocument | null>(null);
  private folder = '';
  /** As the server has it. */
  private known: readonly SymbolRow[] = [];
  private timer: ReturnType<typeof setTimeout> | undefined;

  get dirty(): boolean {
    return this.document?.dirty ?? false;
  }
  /** Warnings do not keep a table from being saved. */
  get wrong(): boolean {
    return this.problems.some((problem) => problem.severity === 'error');
  }
  get conflict(): boolean {
    return this.document?.conflict != null;
  }

  /** What the server has; what was typed here stays. */
  async read(): Promise<void> {
    const folder = plc.project?.folder ?? '';
    const answer = await attempt(connection.ask('symbols.read'));
    if (!answer) return;
    this.path = answer.path;
    this.known = answer.rows;
    // A line that is no row would be gone when the table is saved.
    messages.problems(
      answer.problems.filter((one) => one.severity === 'error'),
      'symbols.read',
    );
    const stored = { text: toText(answer.rows), revision: answer.revision };
    if (!this.document || folder !== this.folder) {
      this.folder = folder;
      this.document = new OpenDocument('(symbols)', stored, new Drafts(localStorage, folder));
    } else this.document.arrived(stored);
    this.show();
  }

  change(index: number, field: Field, value: string): void {
    this.rows[index]![field] = value;
    this.changed();
  }

  /** Its operand has been typed: the data type follows, as in STEP 7. */
  settle(index: number): void {
    const row = this.rows[index];
    const type = row && row.type.trim() === '' ? typeOfOperand(row.operand) : '';
    if (type) this.change(index, 'type', type);
  }

  add(): number {
    this.rows.push(emptyRow());
    return this.rows.length - 1;
  }

  /** Rows in place of this one if it is empty, else below it, as in the variable table. */
  paste(index: number, rows: SymbolRow[]): void {
    this.rows = pastedInto(this.rows, index, isEmpty(this.rows[index]!), rows);
    this.changed();
  }

  remove(index: number): void {
    this.rows.splice(index, 1);
    this.changed();
  }

  keepMine(): void {
    this.document?.keepMine();
  }

  takeTheirs(): void {
    this.document?.takeTheirs();
    this.show();
  }

  /** With a wrong row nothing is saved, and nothing typed is lost (S7-SYM-03). */
  async save(): Promise<boolean> {
    const document = this.document;
    if (!document || document.conflict) return false;
    this.rows.forEach((_, index) => this.settle(index));
    const rows = $state.snapshot(meaningful(this.rows));
    try {
      const { revision } = await connection.ask('symbols.write', {
        rows,
        revision: document.revision,
      });
      document.saved(toText(rows), revision);
      void renamedUses.look(this.known, rows, this.path);
      this.known = rows;
      this.problems = [];
      return true;
    } catch (error) {
      if (error instanceof Refused) await this.refused(error.problems);
      return false;
    }
  }

  /** Rows of a file of STEP 7 become rows here; saved like typed ones. */
  async import(format: Format, text: string, from: string): Promise<number | null> {
    const answer = await attempt(connection.ask('symbols.import', { format, text }), from);
    if (!answer) return null;
    messages.problems(answer.problems, '', from);
    this.rows = [...meaningful(this.rows), ...answer.rows];
    this.changed();
    return answer.rows.length;
  }

  /** The table as it is shown, as a file of STEP 7. */
  async export(format: Format) {
    const rows = $state.snapshot(meaningful(this.rows));
    return await attempt(connection.ask('symbols.export', { format, rows }));
  }

  problemsOf(row: number, field: Field): Problem[] {
    return this.problems.filter((problem) => problem.row === row && (problem.field ?? 'symbol') === field);
  }

  private show(): void {
    if (this.document && toText(this.rows) !== this.document.text) this.rows = fromText(this.document.text);
    this.checkSoon();
  }

  private changed(): void {
    this.document?.edit(toText(this.rows));
    this.checkSoon();
  }

  private checkSoon(): void {
    clearTimeout(this.timer);
    this.timer = setTimeout(() => void this.check(), CHECK_AFTER_MS);
  }

  private async check(): Promise<void> {
    const rows = $state.snapshot(meaningful(this.rows));
    try {
      const answer = await connection.ask('symbols.check', { rows });
      this.problems = answer.problems ?? [];
    } catch (error) {
      if (error instanceof Refused) this.problems = error.problems;
    }
  }

  private async refused(problems: Problem[]): Promise<void> {
    if (problems.some((problem) => problem.row !== undefined)) this.problems = problems;
    else {
      await this.read();
      if (!this.conflict) messages.problems(problems);
    }
  }
}

export const symbolTable = new SymbolTable();

export function followSymbols(): void {
  $effect(() => {
    void plc.files;
    if (plc.live && plc.can('symbols')) void symbolTable.read();
  });
}
