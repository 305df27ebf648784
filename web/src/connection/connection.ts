import type { Events, Problem, Requests } from './protocol';
import { ConnectionLost, Refused } from './refused';

/** stalled: the server is there, the PLC says nothing. */
export type Phase = 'connecting' | 'open' | 'stalled' | 'lost';
type Fields = Record<string, unknown>;
type Handler = (message: any) => void;

export type Method = keyof Requests;
export type FieldsOf<M extends Method> = Requests[M]['fields'];
/** The fields are left out where none has to be given. */
type Given<M extends Method> = {} extends FieldsOf<M> ? [fields?: FieldsOf<M>] : [fields: FieldsOf<M>];

interface Waiting {
  method: string;
  resolve(result: unknown): void;
  reject(reason: Error): void;
}

/** What the server is to send as long as the page wants it: asked again after each reconnect. */
export interface Kept<M extends Method = Method> {
  update(fields: FieldsOf<M>): void;
  drop(): void;
}

interface KeptRequest {
  method: Method;
  fields: Fields | undefined;
  onResult: ((result: any) => void) | undefined;
  onProblems: ((problems: Problem[]) => void) | undefined;
}

/** The part of a WebSocket that the connection uses; tests bring their own. */
export interface Socket {
  onopen: (() => void) | null;
  onmessage: ((event: { data: unknown }) => void) | null;
  onclose: (() => void) | null;
  send(text: string): void;
  close(): void;
}

const FIRST_RETRY_MS = 250;
const LONGEST_RETRY_MS = 4000;
/** A network that went away says nothing: after one quiet tick the page asks, after two what it shows counts as old, after four it
 * takes the connection for lost. */
const TICK_MS = 2000;
const QUIET_TICKS = 2;
const MOST_QUIET_TICKS = 4;

/** Questions with promised answers, events, and a connection that comes back by itself. */
export class Connection {
  phase: Phase = 'connecting';
  /** What the PLC is busy with while it says nothing, as far as the server knows. */
  stalledAt = '';
  onPhase: (phase: Phase) => void = () => {};
  /** Something that was asked for has been done. */
  onDone: (method: string) => void = () => {};
  /** Of several stations the one that the page shows: requests say it, so that none is done to another one. */
  station = '';

  private socket: Socket | null = null;
  private nextId = 1;
  private readonly waiting = new Map<number, Waiting>();
  private readonly handlers = new Map<string, Set<Handler>>();
  private readonly kept = new Set<KeptRequest>();
  private retryMs = FIRST_RETRY_MS;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private closed = false;
  private clock: ReturnType<typeof setInterval> | undefined;
  private quiet = 0;

  constructor(private readonly open: () => Socket) {}

  start(): void {
    const socket = this.open();
    this.socket = socket;
    socket.onopen = () => this.opened();
    socket.onmessage = (event) => this.received(String(event.data));
    socket.onclose = () => this.lost();
    this.quiet = 0;
    clearInterval(this.clock);
    this.clock = setInterval(() => this.listen(), TICK_MS);
  }

  // Ticks, not times, are counted: a page that slept hears first what came meanwhile.
  private listen(): void {
    this.quiet++;
    if (this.quiet === 1) this.ask('ping').catch(() => {});
    if (this.quiet === QUIET_TICKS && this.phase === 'open') this.show('stalled');
    if (this.quiet >= MOST_QUIET_TICKS) this.giveUp();
  }

  private giveUp(): void {
    const socket = this.socket;
    if (socket) socket.onopen = socket.onmessage = socket.onclose = null;
    socket?.close();
    this.lost();
  }

  /** Tries again at once, for an impatient user. */
  retry(): void {
    if (this.phase !== 'lost') return;
    clearTimeout(this.timer);
    this.retryMs = FIRST_RETRY_MS;
    this.start();
  }

  close(): void {
    this.closed = true;
    clearTimeout(this.timer);
    clearInterval(this.clock);
    this.socket?.close();
  }

  /** Asks and promises the result; rejects with Refused (problems of the server) or ConnectionLost. */
  ask<M extends Method>(method: M, ...[fields]: Given<M>): Promise<Requests[M]['result']> {
    return this.request(method, fields);
  }

  private request<T>(method: string, fields: Fields = {}): Promise<T> {
    const socket = this.socket;
    if (!this.isOpen() || !socket) return Promise.reject(new ConnectionLost());
    const id = this.nextId++;
    return new Promise<T>((resolve, reject) => {
      this.waiting.set(id, { method, resolve: resolve as (result: unknown) => void, reject });
      const shown = this.station && !method.startsWith('stations.') ? { station: this.station } : {};
      socket.send(JSON.stringify({ ...shown, ...fields, id, do: method }));
    });
  }

  /** Calls the handler at each event of this name; the result ends that. */
  on<E extends keyof Events>(event: E, handler: (message: Events[E]) => void): () => void {
    const handlers = this.handlers.get(event) ?? new Set();
    this.handlers.set(event, handlers.add(handler));
    return () => handlers.delete(handler);
  }

  /** A subscription: sent now and after each reconnect until it is dropped. What is said of fields that have changed since is not
   * told. */
  keep<M extends Method, D extends Method = 'ping'>(
    method: M,
    fields: FieldsOf<M>,
    onResult?: (result: Requests[M]['result']) => void,
    dropMethod?: D,
    dropFields?: FieldsOf<D>,
    onProblems?: (problems: Problem[]) => void,
  ): Kept<M> {
    const request: KeptRequest = { method, fields, onResult, onProblems };
    this.kept.add(request);
    this.send(request);
    return {
      update: (changed) => {
        request.fields = changed;
        this.send(request);
      },
      drop: () => {
        this.kept.delete(request);
        if (dropMethod) this.request(dropMethod, dropFields).catch(() => {});
      },
    };
  }

  /** Sends what is kept once more: another project or program gives other answers. */
  renew(): void {
    for (const request of this.kept) this.send(request);
  }

  private send(request: KeptRequest): void {
    const { fields } = request;
    const counts = () => this.kept.has(request) && request.fields === fields;
    this.request(request.method, fields).then(
      (result) => counts() && request.onResult?.(result),
      (error: Error) => error instanceof Refused && counts() && request.onProblems?.(error.problems),
    );
  }

  private opened(): void {
    this.stalledAt = '';
    this.retryMs = FIRST_RETRY_MS;
    this.show('open');
    this.renew();
  }

  private lost(): void {
    this.socket = null;
    clearInterval(this.clock);
    const waiting = [...this.waiting.values()];
    this.waiting.clear();
    this.show('lost');
    for (const one of waiting) one.reject(new ConnectionLost());
    if (this.closed) return;
    this.timer = setTimeout(() => this.start(), this.retryMs);
    this.retryMs = Math.min(this.retryMs * 2, LONGEST_RETRY_MS);
  }

  private received(text: string): void {
    this.quiet = 0;
    const message = JSON.parse(text) as Fields;
    if (message.event === 'stalled') return this.stalled(message as unknown as Events['stalled']);
    if (this.phase === 'stalled') this.heard();
    if (typeof message.event === 'string') {
      for (const handler of this.handlers.get(message.event) ?? []) handler(message);
    } else {
      this.answered(message);
    }
  }

  /** The server's watchdog: it tells this again and again while it lasts, and once with 0 seconds when it is over. */
  private stalled(message: Events['stalled']): void {
    if (message.seconds === 0) return this.heard();
    this.stalledAt = message.place;
    this.show('stalled');
  }

  private heard(): void {
    this.stalledAt = '';
    if (this.phase === 'stalled') this.show('open');
  }

  private isOpen(): boolean {
    return this.phase === 'open' || this.phase === 'stalled';
  }

  private answered(message: Fields): void {
    const waiting = this.waiting.get(Number(message.id));
    this.waiting.delete(Number(message.id));
    // `program.check` has problems inside its result; only an answer without result is a refusal.
    if ('result' in message) {
      if (waiting) this.onDone(waiting.method);
      waiting?.resolve(message.result);
    } else waiting?.reject(new Refused((message.problems as Problem[] | undefined) ?? [], waiting?.method));
  }

  private show(phase: Phase): void {
    this.phase = phase;
    this.onPhase(phase);
  }
}
