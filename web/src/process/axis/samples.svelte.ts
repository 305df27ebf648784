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
  /** What the last one of each list saw: another view or language in between forgets no verdict. */
  private static readonly before = new Map<number, { of: string; columns: Columns }>();
  private of = '';
  private kept: Kept<'trend.set'> | null = null;
  private readonly forget: () => void;

  constructor(private readonly list: number) {
    this.forget = connection.on('samples', (message) => this.receive(message));
  }

  /** `project`: whose PLC it is. */
  follow(names: string[], everyMs: number, project: string): void {
    this.keep();
    this.names = names;
    this.of = JSON.stringify([project, names]);
    const seen = Samples.before.get(this.list);
    this.columns = seen?.of === this.of ? seen.columns : [[], ...names.map(() => [])];
    const fields = { list: this.list, items: names.map((operand) => ({ operand })), everyMs };
    if (this.kept) this.kept.update(fields);
    else this.kept = connection.keep('trend.set', fields, undefined, 'trend.drop', { list: this.list });
  }

  private keep(): void {
    if (this.of) Samples.before.set(this.list, { of: this.of, columns: this.columns });
  }

  drop(): void {
    this.keep();
    this.kept?.drop();
    this.kept = null;
    this.forget();
  }

  private receive({ list, rows }: Events['samples']): void {
    if (list !== this.list || rows[0]?.length !== this.names.length + 1) return;
    this.columns = append(this.columns, rows);
  }
}
