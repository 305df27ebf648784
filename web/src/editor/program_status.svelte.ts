// The live program status of one block (S7-EDIT-21), asked for as long as somebody looks at it.
import { connection, type Events, type Kept } from '../connection';
import { unusedColumns, type StatusRow } from './status_columns';

type StatusEvent = Events['status'];

export class ProgramStatus {
  rows = $state.raw<readonly StatusRow[] | null>(null);
  running = $state(true);
  /** Columns that this machine has no values for; known after the first rows. */
  unused = $state.raw<readonly string[]>([]);
  private kept: Kept<'status.show'> | null = null;
  private place = '';
  private readonly end: () => void;

  constructor() {
    this.end = connection.on('status', (message) => this.receive(message));
  }

  show(file: string, line: number): void {
    const place = `${file}:${line}`;
    if (this.kept && place === this.place) return;
    this.place = place;
    this.rows = null;
    this.running = true;
    if (this.kept) this.kept.update({ file, line });
    else
      this.kept = connection.keep(
        'status.show',
        { file, line },
        undefined,
        'status.hide',
        {},
        () => (this.running = false),
      );
  }

  hide(): void {
    this.kept?.drop();
    this.kept = null;
    this.place = '';
    this.rows = null;
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
    if (event.rows?.length) this.learn(unusedColumns(event.rows));
  }
}
