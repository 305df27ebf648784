// At which PLC of the server this page is: `?plc=2` in its address, the first one without.
import type { Connection } from './connection';

export function plcOf(page: string): number {
  const number = Number(new URL(page).searchParams.get('plc') ?? 1);
  return Number.isInteger(number) && number > 0 ? number : 1;
}

/** The address of the page at another PLC; a token stays in it. */
export function pageAt(page: string, plc: number, view: string): string {
  const address = new URL(page);
  if (plc === 1) address.searchParams.delete('plc');
  else address.searchParams.set('plc', String(plc));
  address.hash = `#/${view}`;
  return address.href;
}

/** Before anything else is asked, also after a reconnect: it is about this PLC. */
export function enterPlc(connection: Pick<Connection, 'keep'>, page: string): void {
  const plc = plcOf(page);
  if (plc !== 1) connection.keep('plcs.enter', { plc });
}
