// The messages of the workbench: docs/workbench-protocol.md describes each. Times are nanoseconds of virtual time.

export interface Problem {
  code: string;
  severity: 'error' | 'warning' | 'note';
  file: string;
  line: number;
  column: number;
  text: string;
  /** What stands in the places of the text, for other languages. */
  arguments?: string[];
  hint?: string;
  row?: number;
  field?: string;
}

export type Fields = Record<string, unknown>;

/** An answer of the server that names problems instead of a result. */
export class Refused extends Error {
  constructor(
    readonly problems: Problem[],
    /** What was asked for. */
    readonly method = '',
  ) {
    super(problems.map((problem) => problem.text).join('\n'));
    this.name = 'Refused';
  }
}

/** The connection was lost before the answer came. */
export class ConnectionLost extends Error {
  constructor() {
    super('connection lost');
    this.name = 'ConnectionLost';
  }
}
