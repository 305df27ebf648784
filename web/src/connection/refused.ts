// What becomes of a request without a result.
import type { Problem } from './protocol';

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
