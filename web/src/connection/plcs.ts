// At which PLC of the server this page is: `?plc=2` in its address, the first one without.
import type { Connection } from './connection';
import type { Events } from './protocol';

/** Null: the address names none that there can be. */
export function plcOf(page: string): number | null {
  const asked = new URL(page).searchParams.get('plc') ?? '1';
  return /^[1-9]\d{0,3}$/.test(asked) ? Number(asked) : null;
}

/** The address of the page at another PLC; a token stays in it. */
export function pageAt(page: string, plc: number, view: string): string {
  const address = new URL(page);
  if (plc === 1) address.searchParams.delete('plc');
  else address.searchParams.set('plc', String(plc));
  address.hash = `#/${view}`;
  return address.href;
}

type State = Events['state'];

/** Until this page has entered its PLC, the server tells of the first one. */
export class Entrance {
  /** What came of the first one; null: the page is where it shall be. */
  private held: State | null = null;
  constructor(private plc: number) {}

  /** A new connection is at the first PLC. */
  begin(): void {
    this.held = this.plc === 1 ? null : {};
  }

  /** The state that is to be shown; null: it is of the first PLC. */
  pass(message: State): State | null {
    if (this.held === null) return message;
    if (message.plcs?.here === this.plc) this.held = null;
    else this.held = { ...this.held, ...message };
    return this.held === null ? message : null;
  }

  /** There is no such PLC: the page stays at the first one, whose state this is. */
  refused(): State {
    const state = this.held ?? {};
    this.plc = 1;
    this.held = null;
    return state;
  }
}

/** Before anything else is asked, also after a reconnect: it is about this PLC. `onUnknown`: there is no such PLC. */
export function enterPlc(
  connection: Pick<Connection, 'keep'>,
  page: string,
  onUnknown: (first: State) => void,
): Entrance {
  const plc = plcOf(page);
  const entrance = new Entrance(plc ?? 1);
  if (plc === null) onUnknown({});
  else if (plc !== 1) {
    const kept = connection.keep('plcs.enter', { plc }, undefined, undefined, undefined, () => {
      kept.drop();
      onUnknown(entrance.refused());
    });
  }
  return entrance;
}
