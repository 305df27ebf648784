// What an axis did in the last minutes, sampled by the server.
import { connection, type Events, type Kept } from '../../connection';
import { append, type Columns } from '../../trends/curves';

/** The list of the Trends view is 1. */
export const CURVES = 2,
  RUNS = 3;

export class Samples {
  /** Seconds, then a column for each name; null where the PLC has no such value. */
  columns = $state.raw<Columns>([[]]);
  private names: string[] = [];
  private kept: Kept<'trend.set'> | null = null;
  private readonly forget: () => void;

  constructor(private readonly list: number) {
    this.forget = connection.on('samples', (message) => this.receive(message));
  }

  follow(names: string[], everyMs: number): void {
    this.names = names;
    this.columns = [[], ...names.map(() => [])];
    const fields = { list: this.list, items: names.map((operand) => ({ operand })), everyMs };
    if (this.kept) this.kept.update(fields);
    else this.kept = connection.keep('trend.set', fields, undefined, 'trend.drop', { list: this.list });
  }

  drop(): void {
    this.kept?.drop();
    this.kept = null;
    this.forget();
  }

  private receive({ list, rows }: Events['samples']): void {
    if (list !== this.list || rows[0]?.length !== this.names.length + 1) return;
    this.columns = append(this.columns, rows);
  }
}
