import { connection, ConnectionLost, Refused, type Problem } from '../connection';

export interface Message {
  id: number;
  /** `news`: what somebody else did. */
  kind: 'problem' | 'done' | 'news';
  text: string;
  arguments?: string[];
  code: string;
  file: string;
  line: number;
  column: number;
  /** The file is none of the project: there is nothing to open. */
  elsewhere?: boolean;
  /** What was refused. */
  method: string;
  /** Until somebody closes it; good news goes by itself. */
  stays: boolean;
  /** The dialog that was open: what lies below cannot be pressed. */
  dialog?: string;
}

const NOWHERE = { code: '', file: '', line: 0, column: 0, method: '' };
const SHOWN = 3;
/** How long good news stays; a problem stays until something succeeds later, another view opens or somebody closes it. */
const DONE_MS = 6000;

/** What the page has to tell: newest last. The shell shows it at the lower edge. */
class Messages {
  list = $state<Message[]>([]);
  /** Open dialogs, the last one on top. */
  private dialogs: string[] = [];
  private nextId = 1;
  /** What has a number below this was there when somebody did something last. */
  private known = 0;

  problem(problem: Partial<Problem> & { text: string; elsewhere?: boolean }, method = ''): void {
    this.add({ ...NOWHERE, kind: 'problem', method, stays: true, ...problem });
  }

  /** `from`: what the file is called on the computer that it came from. */
  problems(problems: Problem[], method = '', from = ''): void {
    for (const problem of problems.slice(0, SHOWN))
      this.problem(from && problem.file ? { ...problem, file: from, elsewhere: true } : problem, method);
  }

  /** `stays`: until somebody closes it. */
  done(text: string, stays = false): void {
    this.list = this.list.filter((one) => one.kind !== 'problem' || one.id >= this.known);
    const id = this.add({ ...NOWHERE, kind: 'done', text, stays });
    if (!stays) setTimeout(() => this.dismiss(id), DONE_MS);
  }

  /** Until somebody closes it. */
  news(text: string): void {
    this.add({ ...NOWHERE, kind: 'news', text, stays: true });
  }

  /** A key or the pointer: the messages that are there belong to what was done before. */
  acted(): void {
    this.known = this.nextId;
  }

  /** A dialog opens; the result closes it. What somebody has seen in it before the last key goes; what came since is told outside. */
  enter(dialog: string): () => void {
    this.dialogs.push(dialog);
    return () => {
      this.dialogs = this.dialogs.filter((one) => one !== dialog);
      // Not at once: while an effect ends, Svelte reads what the list was before.
      queueMicrotask(() => this.left(dialog));
    };
  }

  private left(dialog: string): void {
    const outside = (one: Message) => (one.dialog === dialog ? { ...one, dialog: undefined } : one);
    this.list = this.list.filter((one) => one.dialog !== dialog || one.id >= this.known).map(outside);
  }

  dismiss(id: number): void {
    this.list = this.list.filter((message) => message.id !== id);
  }

  /** What was refused before has been done now. */
  solved(method: string): void {
    if (this.list.some((one) => one.method === method && one.kind === 'problem'))
      this.list = this.list.filter((one) => one.method !== method || one.kind !== 'problem');
  }

  /** Another view: what the last one was refused is no news there. */
  leave(): void {
    this.list = this.list.filter((one) => one.kind !== 'problem');
  }

  private add(message: Omit<Message, 'id'>): number {
    const rest = this.list.filter((old) => old.text !== message.text || old.file !== message.file);
    const dialog = message.kind === 'problem' ? this.dialogs.at(-1) : undefined;
    this.list = [...rest, { ...message, dialog, id: this.nextId }].slice(-SHOWN);
    return this.nextId++;
  }
}

export const messages = new Messages();
connection.onDone = (method) => messages.solved(method);

/** Waits for an answer of the server and shows its problems to the user; undefined if it was refused. */
export async function attempt<T>(answer: Promise<T>, from = ''): Promise<T | undefined> {
  try {
    return await answer;
  } catch (error) {
    if (error instanceof Refused) messages.problems(error.problems, error.method, from);
    else if (!(error instanceof ConnectionLost)) throw error;
    return undefined;
  }
}
