import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { Connection, type Socket } from './connection';
import { socketAddress } from './index';
import { ConnectionLost, Refused } from './refused';

class TestSocket implements Socket {
  onopen: (() => void) | null = null;
  onmessage: ((event: { data: unknown }) => void) | null = null;
  onclose: (() => void) | null = null;
  sent: Record<string, unknown>[] = [];
  send(text: string) {
    this.sent.push(JSON.parse(text));
  }
  close() {
    this.onclose?.();
  }
  says(message: unknown) {
    this.onmessage?.({ data: JSON.stringify(message) });
  }
}

let sockets: TestSocket[] = [];
const latest = () => sockets[sockets.length - 1]!;
function connected(): Connection {
  const connection = new Connection(() => {
    sockets.push(new TestSocket());
    return latest();
  });
  connection.start();
  latest().onopen?.();
  return connection;
}

beforeEach(() => {
  sockets = [];
  vi.useFakeTimers();
});
afterEach(() => void vi.useRealTimers());

test('answers go to the question with their number, in any order', async () => {
  const connection = connected();
  const first = connection.ask('files.list');
  const second = connection.ask('files.read', { path: 'a.awl' });
  expect(latest().sent).toEqual([
    { id: 1, do: 'files.list' },
    { id: 2, do: 'files.read', path: 'a.awl' },
  ]);
  latest().says({ id: 2, result: 'text' });
  latest().says({ id: 1, result: 'list' });
  expect(await first).toBe('list');
  expect(await second).toBe('text');
});

test('problems refuse, a result that holds problems does not', async () => {
  const connection = connected();
  const refused = connection.ask('files.read', { path: '' });
  const checked = connection.ask('program.check');
  latest().says({ id: 1, problems: [{ code: 'P1', text: 'no such file' }] });
  latest().says({ id: 2, result: { problems: [1] } });
  await expect(refused).rejects.toThrow(Refused);
  expect(await checked).toEqual({ problems: [1] });
});

test('events reach their handlers until they end it', () => {
  const connection = connected();
  const seen: unknown[] = [];
  const end = connection.on('values', (message) => seen.push(message.list));
  latest().says({ event: 'values', list: 3 });
  latest().says({ event: 'other', list: 4 });
  end();
  latest().says({ event: 'values', list: 5 });
  expect(seen).toEqual([3]);
});

test('what is said of fields that have changed since is not told', async () => {
  const connection = connected();
  const told: unknown[] = [];
  const first = { list: 1, items: [{ operand: 'a' }] };
  const kept = connection.keep(
    'watch.set',
    first,
    (result) => told.push(result),
    'watch.drop',
    { list: 1 },
    (problems) => told.push(problems[0]!.code),
  );
  kept.update({ list: 1, items: [{ operand: 'b' }] });
  kept.update({ list: 1, items: [{ operand: 'c' }] });
  latest().says({ id: 1, result: 'of a' });
  latest().says({ id: 2, problems: [{ code: 'of b' }] });
  latest().says({ id: 3, result: 'of c' });
  await vi.advanceTimersByTimeAsync(0);
  expect(told).toEqual(['of c']);
});

test('a lost connection rejects what waits, comes back and subscribes again', async () => {
  const connection = connected();
  const phases: string[] = [];
  connection.onPhase = (phase) => phases.push(phase);
  const kept = connection.keep('watch.set', { list: 1, items: [{ operand: 'a' }] });
  connection.keep('process.watch', { on: true }).drop();
  kept.update({ list: 1, items: [{ operand: 'b' }] });
  const open = connection.ask('files.list');
  latest().close();
  await expect(open).rejects.toThrow(ConnectionLost);
  await expect(connection.ask('files.list')).rejects.toThrow(ConnectionLost);
  vi.advanceTimersByTime(250);
  expect(sockets.length).toBe(2);
  latest().onopen?.();
  expect(phases).toEqual(['lost', 'open']);
  expect(latest().sent).toEqual([{ id: 5, do: 'watch.set', list: 1, items: [{ operand: 'b' }] }]);
});

test('what is kept is asked again when the project or the program is another one', () => {
  const connection = connected();
  connection.keep('watch.set', { list: 1, items: [] });
  connection.renew();
  expect(latest().sent.map((message) => message.do)).toEqual(['watch.set', 'watch.set']);
});

test('each failed try waits longer, up to a limit; the user may try at once', () => {
  const connection = connected();
  for (const wait of [250, 500, 1000, 2000, 4000, 4000]) {
    const before = sockets.length;
    latest().close();
    vi.advanceTimersByTime(wait - 1);
    expect(sockets.length).toBe(before);
    vi.advanceTimersByTime(1);
    expect(sockets.length).toBe(before + 1);
  }
  latest().close();
  const before = sockets.length;
  connection.retry();
  expect(sockets.length).toBe(before + 1);
});

test('silence is asked about; a server that does not answer is lost, one that answers is not', () => {
  const connection = connected();
  const phases: string[] = [];
  connection.onPhase = (phase) => phases.push(phase);
  for (let tick = 0; tick < 10; tick++) {
    vi.advanceTimersByTime(2000);
    expect(latest().sent.at(-1)).toMatchObject({ do: 'ping' });
    latest().says({ id: latest().sent.at(-1)!.id, result: {} });
  }
  expect(phases).toEqual([]);
  vi.advanceTimersByTime(4000);
  expect(phases).toEqual(['stalled']);
  vi.advanceTimersByTime(4000);
  expect(phases).toEqual(['stalled', 'lost']);
  const before = sockets.length;
  vi.advanceTimersByTime(250);
  expect(sockets.length).toBe(before + 1);
  connection.close();
});

test('what the watchdog of the server says is shown until a state comes; it is not lost meanwhile', () => {
  const connection = connected();
  const phases: string[] = [];
  connection.onPhase = (phase) => phases.push(phase);
  for (const seconds of [2, 4, 6, 8, 10, 12]) {
    latest().says({ event: 'stalled', place: 'hardware.edit', seconds });
    vi.advanceTimersByTime(2000);
  }
  expect(connection.phase).toBe('stalled');
  expect(connection.stalledAt).toBe('hardware.edit');
  expect(new Set(phases)).toEqual(new Set(['stalled']));
  latest().says({ event: 'state', cycles: 5 });
  expect(connection.phase).toBe('open');
  expect(connection.stalledAt).toBe('');
  latest().says({ event: 'stalled', place: 'the PLC', seconds: 2 });
  latest().says({ event: 'stalled', place: 'the PLC', seconds: 0 });
  expect(connection.phase).toBe('open');
  connection.close();
});

test('a connection that never opens is tried again', () => {
  const connection = connected();
  latest().close();
  vi.advanceTimersByTime(250);
  const before = sockets.length;
  vi.advanceTimersByTime(8000 + 500);
  expect(sockets.length).toBe(before + 1);
  connection.close();
});

test('the socket stands beside the page and takes its token along', () => {
  expect(socketAddress('http://127.0.0.1:8314/#/io')).toBe('ws://127.0.0.1:8314/ws');
  expect(socketAddress('https://host/plc/?token=a%2Bb#/io')).toBe('wss://host/plc/ws?token=a%2Bb');
});
