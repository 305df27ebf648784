// The live program status of one block (S7-EDIT-21), asked for as long as somebody looks at it.
import { connection, type Events, type Kept } from '../connection';
import { unusedColumns, type StatusRow } from './status_columns';

type StatusEvent = Events['status'];

export class ProgramStatus {
  rows = $state.raw<readonly StatusRow[] | null>(null);
  running = $state(true);
  /** Columns that this machine has no values for; known after the first rows. */
  unused = $state.raw<readonly string[]>([]);
  /** Instance data blocks that the function block is called with. */
  instances = $state.raw<readonly number[]>([]);
  /** The one of the call that is shown. */
  shown = $state<number>();
  /** The one whose calls somebody wants to see; null: the last call of all. */
  chosen = $state<number | null>(null);
  private kept: Kept<'status.show'> | null = null;
  private file = '';
  private line = 0;
  /** By place: who comes back to a block finds the call chosen there. */
  private readonly choices = new Map<string, number>();
  private readonly end: () => void;

  constructor() {
    this.end = connection.on('status', (message) => this.receive(message));
  }

  show(file: string, line: number): void {
    if (this.kept && file === this.file && line === this.line) return;
    this.file = file;
    this.line = line;
    this.chosen = this.choices.get(this.place()) ?? null;
    this.instances = [];
    this.ask();
  }

  choose(instance: number | null): void {
    this.chosen = instance;
    if (instance) this.choices.set(this.place(), instance);
    else this.choices.delete(this.place());
    this.ask();
  }

  private place(): string {
    return `${this.file}:${this.line}`;
  }

  private ask(): void {
    const { file, line, chosen } = this;
    const fields = { file, line, ...(chosen && { instance: chosen }) };
    this.rows = null;
    this.shown = undefined;
    this.running = true;
    if (this.kept) this.kept.update(fields);
    else this.kept = connection.keep('status.show', fields, undefined, 'status.hide', {}, () => (this.running = false));
  }

  hide(): void {
    this.kept?.drop();
    this.kept = null;
    this.file = '';
    this.rows = null;
    this.instances = [];
    this.running = true;
  }

  destroy(): void {
    this.hide();
    this.end();
  }

  // The same columns are not told again with each event.
  private learn(unused: string[]): void {
    if (unused.join() !== this.unused.join()) this.unused = unused;
  }

  private receive(event: StatusEvent): void {
    if (!this.kept) return;
    this.running = event.rows !== null;
    this.rows = event.rows;
    this.shown = event.instance;
    if (event.instances.join() !== this.instances.join()) this.instances = event.instances;
    if (event.rows?.length) this.learn(unusedColumns(event.rows));
  }
}
