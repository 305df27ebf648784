// The hardware as it would be after the next download: merker.toml as an open text, and what the server makes of it.
import { connection, Refused, type Problem } from '../connection';
import type { OpenDocument } from '../editor/document.svelte';
import { workspace } from '../editor/workspace.svelte';
import { attempt } from '../state/messages.svelte';
import { plc } from '../state/plc.svelte';
import { inFields } from './field_words';
import { slotOf, type Rack, type Slot } from './rack';

export const SETTINGS = 'merker.toml';
export const FIRST_SLOT = 1;
export const LAST_SLOT = 11;

export interface Parameter {
  key: string;
  kind: 'text' | 'address' | 'number' | 'choice' | 'flag' | 'bits' | 'amount' | 'length' | 'characters' | 'causes';
  value: string | number | boolean | number[] | string[] | null;
  /** Of an address: the file names it. */
  given?: boolean;
  choices?: string[] | number[];
  count?: number;
  /** Channels that share an edge. */
  group?: number;
  min?: number;
  max?: number;
  hint?: string;
  /** Of a module whose parameters are pages. */
  page?: string;
  /** Shown, but not to be changed. */
  fixed?: boolean;
}

export interface Channel {
  /** Of an analog channel; 'number': of a counting one. */
  side: 'input' | 'output' | 'number';
  number: number;
  parameters: Parameter[];
}

export interface PlannedSlot extends Slot {
  parameters?: Parameter[];
  channels?: Channel[];
}

export interface PlannedRack extends Rack {
  slots: PlannedSlot[];
}

export interface SlotProblem extends Problem {
  rack?: number;
  slot?: string;
}

export interface ModuleType {
  order: string;
  name: string;
  text: string;
  kind: string;
  slots: [number, number];
  inputBytes: number;
  outputBytes: number;
  current: number;
}

interface Planned {
  text: string;
  racks: PlannedRack[];
  cpu: { table: string; parameters: Parameter[] }[];
  configured: boolean;
  current: { rack: number; taken: number; possible: number }[];
  problems: SlotProblem[];
}

export interface Place {
  rack: number;
  slot: string;
}

export type Change =
  | ({ change: 'place'; type: string } & Place)
  | ({ change: 'remove' } & Place)
  | ({ change: 'move'; toRack: number; toSlot: string } & Place)
  | ({ change: 'set'; key: string; value: Parameter['value']; side?: string; number?: number } & Place)
  | { change: 'set'; table: string; key: string; value: Parameter['value'] }
  | { change: 'plant'; name: string; kind: string; parameters: Pair[]; wires: Pair[] };

/** Counting channels have words of their own. */
const familyOf = (changes: Change[]): string =>
  changes.some((one) => one.change === 'set' && 'side' in one && one.side === 'number') ? 'count' : '';

export interface Pair {
  key: string;
  value: string | number | boolean;
}

class Plan {
  document = $state<OpenDocument | null>(null);
  planned = $state.raw<Planned | null>(null);
  types = $state.raw<ModuleType[]>([]);
  missing = $state(false);
  past = $state.raw<string[]>([]);
  private looked = '';
  /** What it was opened with was refused. */
  private failed = false;
  private before: Promise<unknown> = Promise.resolve();

  async open(): Promise<void> {
    this.document = null;
    this.planned = null;
    this.past = [];
    this.looked = '';
    const files = await attempt(connection.ask('files.list'));
    this.failed = files === undefined;
    this.missing = files !== undefined && !files.files.some((file) => file.path === SETTINGS);
    if (!files || this.missing) return;
    this.document = (await workspace.fetch(SETTINGS)) ?? null;
    this.failed = this.document === null;
    const listed = await attempt(connection.ask('hardware.catalogue'));
    if (listed) this.types = listed.types;
  }

  /** The text or the program changed: a project that was opened anew meanwhile has refused what was asked before. */
  keepUp(): void {
    if (this.document) void this.look(this.document.text);
    else if (this.failed) void this.open();
  }

  async look(text: string): Promise<void> {
    if (this.looked === text && this.planned) return;
    this.looked = text;
    const answer = await attempt(connection.ask('hardware.edit', { text }));
    if (answer && this.document?.text === text) this.planned = answer;
  }

  /** False if the server refuses it; then nothing has changed. One after the other: each begins with what came before. */
  change(...changes: Change[]): Promise<boolean> {
    const done = this.before.then(() => this.apply(changes));
    this.before = done.catch(() => {});
    return done;
  }

  private async apply(changes: Change[]): Promise<boolean> {
    const document = this.document;
    if (!document) return false;
    const before = document.text;
    const asked = connection.ask('hardware.edit', { text: before, changes }).catch((error: unknown) => {
      if (!(error instanceof Refused)) throw error;
      const named = error.problems.map((one) => inFields(one, familyOf(changes)));
      throw new Refused(named, error.method);
    });
    const answer = await attempt(asked);
    if (!answer || document.text !== before) return false;
    this.looked = answer.text;
    this.planned = answer;
    if (answer.text === before) return true;
    this.past = [...this.past, before];
    workspace.edit(document, answer.text);
    return true;
  }

  undo(): void {
    const text = this.past.at(-1);
    if (text === undefined || !this.document) return;
    this.past = this.past.slice(0, -1);
    workspace.edit(this.document, text);
  }

  at(place: Place): PlannedSlot | undefined {
    return this.planned?.racks
      .find((rack) => rack.rack === place.rack)
      ?.slots.find((slot) => slotOf(slot) === place.slot);
  }

  async save(): Promise<boolean> {
    return this.document !== null && (await workspace.save(this.document));
  }

  /** Number of errors in the whole project as it is stored; undefined if it could not be asked. */
  async compile(): Promise<number | undefined> {
    if (!(await this.save())) return undefined;
    const answer = await attempt(connection.ask('program.check'));
    return answer?.problems.filter((problem) => problem.severity === 'error').length;
  }

  async load(): Promise<boolean> {
    if (plc.mode !== 'STOP' && (await attempt(connection.ask('cpu.stop'))) === undefined) return false;
    return workspace.load();
  }
}

export const plan = new Plan();
