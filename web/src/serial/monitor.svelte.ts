import { connection, type Events, type Kept } from '../connection';
import type { SerialLine } from '../connection/protocol';
import { attempt } from '../state/messages.svelte';
import type { Character } from './characters';

/** More characters are not kept. */
export const MOST = 20_000;
const NS = 1e9;

/** The line of X27 while the page shows it. */
export class LineMonitor {
  characters = $state.raw<Character[]>([]);
  line = $state.raw<SerialLine | null>(null);
  /** False until the server has told whether there is an interface. */
  known = $state(false);
  /** Characters that came while nobody could be told. */
  lost = $state(0);
  private next = 0;
  private kept: Kept | null = null;
  private end: (() => void) | null = null;

  follow(): void {
    this.end = connection.on('serial', (message) => this.receive(message));
    this.kept = connection.keep(
      'serial.watch',
      { on: true },
      ({ line }) => {
        this.line = line;
        this.known = true;
      },
      'serial.watch',
      { on: false },
    );
  }

  leave(): void {
    this.kept?.drop();
    this.end?.();
  }

  clear(): void {
    this.characters = [];
    this.lost = 0;
  }

  /** A step of a scenario without "serial X27"; false if it was refused. */
  async do(step: string): Promise<boolean> {
    return (await attempt(connection.ask('serial.do', { step }))) !== undefined;
  }

  receive(message: Events['serial']): void {
    this.line = message.line;
    // After a reconnect the server tells again what it has; another PLC begins with 0.
    const known =
      message.first < this.next ? this.characters.filter((one) => one.number < message.first) : this.characters;
    const before = message.first < this.next ? (known.at(-1)?.number ?? message.first - 1) + 1 : this.next;
    if (message.first > before && known.length) this.lost += message.first - before;
    const fresh = message.rows.map(
      ([from, value, name, meaning, begin, end], index): Character => ({
        number: message.first + index,
        from: from as 0 | 1,
        value,
        name,
        meaning,
        begin: begin / NS,
        end: end / NS,
      }),
    );
    this.next = message.first + fresh.length;
    if (fresh.length || known !== this.characters) this.characters = [...known, ...fresh].slice(-MOST);
  }
}
