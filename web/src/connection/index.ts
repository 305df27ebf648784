import { Connection, type Socket } from './connection';

export { Connection, type FieldsOf, type Kept, type Method, type Phase } from './connection';
export type { Events, Problem, Requests } from './protocol';
export { ConnectionLost, Refused } from './refused';

/** The WebSocket beside the page; a token in the page's address goes along. */
export function socketAddress(page: string): string {
  const address = new URL('ws', page);
  address.protocol = address.protocol === 'https:' ? 'wss:' : 'ws:';
  const token = new URL(page).searchParams.get('token');
  address.search = token ? `?token=${encodeURIComponent(token)}` : '';
  address.hash = '';
  return address.href;
}

/** The one connection of this page. */
export const connection = new Connection(() => new WebSocket(socketAddress(location.href)) as unknown as Socket);
