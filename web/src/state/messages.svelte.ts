import { ConnectionLost, Refused, type Problem } from '../connection';

export interface Message {
  id: number;
  kind: 'problem' | 'done';
  text: string;
  arguments?: string[];
  hint: string;
  code: string;
  file: string;
  line: number;
  column: number;
}

const SHOWN = 5;
/** How long good news stays; a problem stays until somebody closes it. */
const DONE_MS = 6000;

/** What the page has to tell: newest last. The shell shows it at the lower edge. */
class Messages {
  list = $state<Message[]>([]);
  private nextId = 1;

  problem(problem: Partial<Problem> & { text: string }): void {
    this.add({ kind: 'problem', hint: '', code: '', file: '', line: 0, column: 0, ...problem });
  }

  problems(problems: Problem[]): void {
    for (const problem of problems.slice(0, SHOWN)) this.problem(problem);
  }

  done(text: string): void {
    const id = this.add({ kind: 'done', text, hint: '', code: '', file: '', line: 0, column: 0 });
    setTimeout(() => this.dismiss(id), DONE_MS);
  }

  dismiss(id: number): void {
    this.list = this.list.filter((message) => message.id !== id);
  }

  clear(): void {
    this.list = [];
  }

  private add(message: Omit<Message, 'id'>): number {
    const rest = this.list.filter((old) => old.text !== message.text || old.file !== message.file);
    this.list = [...rest, { ...message, id: this.nextId }].slice(-SHOWN);
    return this.nextId++;
  }
}

export const messages = new Messages();

/** Waits for an answer of the server and shows its problems to the user; undefined if it was refused. */
export async function attempt<T>(answer: Promise<T>): Promise<T | undefined> {
  try {
    return await answer;
  } catch (error) {
    if (error instanceof Refused) messages.problems(error.problems);
    else if (!(error instanceof ConnectionLost)) throw error;
    return undefined;
  }
}
