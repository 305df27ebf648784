// An import from the drop to the report.
import { connection, type Requests } from '../connection';
import { attempt } from '../state/messages.svelte';
import type { Dropped } from './dropped';
import { send } from './send';

export type Stage = 'idle' | 'sending' | 'looking' | 'choosing' | 'running' | 'done';
type Found = Requests['import.look']['result'];
type Result = Requests['import.run']['result'];

/** As the server has it. */
export const MOST_BYTES = 256 << 20;

class Importer {
  stage = $state<Stage>('idle');
  names = $state<string[]>([]);
  sent = $state(0);
  total = $state(0);
  found = $state.raw<Found | null>(null);
  result = $state.raw<Result | null>(null);
  /** Counts the imports: answers to one that was cancelled come to nothing. */
  private turn = 0;

  get active(): boolean {
    return this.stage !== 'idle';
  }

  /** Sends the files and looks what they are. */
  async take(files: readonly Dropped[]): Promise<void> {
    const turn = ++this.turn;
    const current = () => this.turn === turn;
    this.names = [...new Set(files.map(({ path }) => path.split('/', 1)[0]!))];
    this.sent = 0;
    this.total = files.reduce((sum, { file }) => sum + file.size, 0);
    this.found = this.result = null;
    this.stage = 'sending';
    if (!(await this.sendAll(files, current))) return this.leave(current);
    if (!current()) return;
    this.stage = 'looking';
    const found = await attempt(connection.ask('import.look'));
    if (!current()) return;
    if (!found) return this.cancel();
    this.found = found;
    this.stage = 'choosing';
  }

  private async sendAll(files: readonly Dropped[], current: () => boolean): Promise<boolean> {
    if ((await attempt(connection.ask('import.begin'))) === undefined) return false;
    try {
      return await send(files, async (parts, bytes) => {
        if (!current() || (await attempt(connection.ask('import.add', { files: parts }))) === undefined) return false;
        this.sent += bytes;
        return current();
      });
    } catch {
      return false; // a file that has gone, or must not be read
    }
  }

  async run(fields: Requests['import.run']['fields']): Promise<void> {
    const turn = this.turn;
    this.stage = 'running';
    const result = await attempt(connection.ask('import.run', fields));
    if (this.turn !== turn) return;
    this.result = result ?? null;
    this.stage = result ? 'done' : 'choosing';
  }

  /** Ends it in whatever stage; nothing is left on the server. */
  cancel(): void {
    this.turn++;
    this.stage = 'idle';
    connection.ask('import.cancel').catch(() => {});
  }

  /** The connection is gone, and with it what was sent. True: there was something to lose. */
  disconnected(): boolean {
    if (!this.active || this.stage === 'done') return false;
    this.turn++;
    this.stage = 'idle';
    return true;
  }

  private leave(current: () => boolean): void {
    if (current()) this.cancel();
  }
}

export const importer = new Importer();
