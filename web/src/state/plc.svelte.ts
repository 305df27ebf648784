import { connection, type Events, type Phase } from '../connection';
import type { Entrance } from '../connection/plcs';
import { stateFields, type Lamps, type Playback, type Project } from '../connection/protocol';

type State = Required<Events['state']>;
export type Mode = State['mode'];
export type SwitchPosition = State['switch'];
export type Led = Lamps[LedName];
export const LEDS = ['SF', 'BF', 'DC5V', 'FRCE', 'RUN', 'STOP'] as const;
export type LedName = (typeof LEDS)[number];

/** What a machine can do; docs/workbench-protocol.md has the table. */
export type Ability = Project['can'][number];

const DARK: Record<LedName, Led> = { SF: 'off', BF: 'off', DC5V: 'off', FRCE: 'off', RUN: 'off', STOP: 'off' };

/** They change with each frame of the server, 30 a second. Nobody reads more than ten, and each change paints the page anew. */
const RUNNING: ReadonlySet<string> = new Set(['event', 'time', 'clock', 'cycles', 'cycle']);
const RUNNING_MS = 100;

/** What the server pushes to everybody. Reading a field in a component makes the component follow it. */
export class Plc implements State {
  project = $state<Project | null>(null);
  mode = $state<Mode>('STOP');
  powered = $state(true);
  switch = $state<SwitchPosition>('STOP');
  leds = $state<Record<LedName, Led>>({ ...DARK });
  stopReason = $state('');
  time = $state(0);
  clock = $state('');
  cycles = $state(0);
  /** In milliseconds; null where the PLC measures none. */
  cycle = $state<{ last: number; min: number; max: number } | null>(null);
  pace = $state<State['pace']>({ mode: 'real', factor: 1 });
  reached = $state(1);
  engine = $state<'interpreter' | 'jit'>('interpreter');
  forces = $state<{ operand: string; value: string }[]>([]);
  breakpoint = $state<{ file: string; line: number; block: string; why: string } | null>(null);
  breakpoints = $state.raw<Record<string, number[]>>({});
  diagnostics = $state(0);
  timersByHand = $state(false);
  recording = $state<{ since: number; actions: number; full: boolean } | null>(null);
  playback = $state.raw<Playback | null>(null);
  program = $state(0);
  files = $state(0);
  /** Connected, this one included. */
  browsers = $state(1);
  /** Which PLC of the server this is, and how many are in use. */
  plcs = $state<State['plcs']>({ here: 1, count: 1 });

  /** False until the first state came, and while the connection is lost: everything shown is old then. */
  live = $state(false);
  phase = $state<Phase>('connecting');
  stalledAt = $state('');

  /** Whether the machine of the open project can do this. */
  can(ability: Ability): boolean {
    return this.project?.can.includes(ability) ?? false;
  }

  /** Whether there is a machine and it cannot: without a project nothing is missing. */
  lacks(ability: Ability): boolean {
    return this.project !== null && !this.can(ability);
  }

  /** No block is processed now, and none is until somebody does something. */
  get stands(): boolean {
    return this.mode === 'STOP' || this.mode === 'HALT' || this.pace.mode === 'pause';
  }

  /** Whether an operand is forced, by its text or its address. */
  isForced(...names: string[]): boolean {
    return this.forces.some((force) => names.includes(force.operand));
  }

  private waiting: Events['state'] = {};
  private shownAt = -RUNNING_MS;
  private timer: ReturnType<typeof setTimeout> | undefined;

  /** Takes over the fields that changed; where only the time went on, ten times a second. */
  receive(message: Events['state']): void {
    this.live = true;
    this.waiting = { ...this.waiting, ...message };
    const rest = this.shownAt + RUNNING_MS - performance.now();
    if (rest <= 0 || Object.keys(message).some((name) => !RUNNING.has(name))) this.show();
    else this.timer ??= setTimeout(() => this.show(), rest);
  }

  private show(): void {
    clearTimeout(this.timer);
    const message = this.waiting;
    this.timer = undefined;
    this.waiting = {};
    this.shownAt = performance.now();
    if (message.project === null) this.close();
    for (const name of stateFields) this.take(name, message);
  }

  private take<Name extends keyof State>(name: Name, message: Events['state']): void {
    const value = message[name] as State[Name] | undefined;
    if (value !== undefined) (this as State)[name] = value;
  }

  /** Without a project there is no CPU. */
  private close(): void {
    this.mode = 'STOP';
    this.leds = { ...DARK };
    this.stopReason = '';
    this.cycle = this.breakpoint = null;
    this.forces = [];
    this.timersByHand = false;
    this.recording = this.playback = null;
  }
}

export const plc = new Plc();

export function followPlc(entrance: Entrance): void {
  let known: string | undefined;
  connection.on('state', (pushed) => {
    const message = entrance.pass(pushed);
    if (message === null) return;
    plc.receive(message);
    connection.station = plc.project?.station ?? '';
    const now = `${plc.project?.folder} ${plc.project?.station} ${plc.program}`;
    if (known !== undefined && known !== now) connection.renew();
    known = now;
  });
  connection.onPhase = (phase) => {
    // After a pause what was shown before holds again; after a new connection the first state has to come.
    if (phase === 'open' && plc.phase === 'stalled') plc.live = true;
    else if (phase !== 'open') plc.live = false;
    else entrance.begin();
    plc.phase = phase;
    plc.stalledAt = connection.stalledAt;
  };
}
