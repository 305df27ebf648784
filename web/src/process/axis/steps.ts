// The steps of the commissioning: what each finds in the values of plant and axis.
import type { Axis } from '../../connection/protocol';
import type { commissioning } from '../../i18n/texts/commissioning';
import type { Plant, Signal } from '../plants.svelte';
import type { Columns } from '../../trends/curves';
import type { Movement, Outcome, Row, RunJudgement } from './judgement';

export type Word = keyof typeof commissioning & string;
export type State = 'open' | 'good' | 'bad';

/** A line of what must be seen: its name, what is, whether that is right; a plain one only informs. */
export interface Seen {
  name: string;
  text: string;
  state: State | 'plain';
}

/** Names of the samples that a `Row` is made of. */
export const sampled = (plant: string, block: string): string[] => [
  ...['ENCODER', 'SPEED'].map((signal) => `plant.${plant}.${signal}`),
  ...['position', 'distance_to_go', 'mode', 'working', 'changed_over', 'cut_off', 'reached', 'errors'].map(
    (name) => `axis.${name}`,
  ),
  ...['DIR_P', 'DIR_M'].map((name) => `${block.replace(' ', '')}.${name}`),
];

/** The last samples; those without an axis are none. */
export function rowsOf(columns: Columns, most: number): Row[] {
  const rows: Row[] = [];
  const from = Math.max(0, columns[0].length - most);
  const at = (column: number, row: number) => Number(columns[column]?.[row] ?? 0);
  for (let row = from; row < columns[0].length; ++row) {
    if (columns[3]?.[row] == null) continue;
    rows.push({
      time: columns[0][row]!,
      plant: at(1, row),
      speed: at(2, row),
      position: at(3, row),
      distance: at(4, row),
      mode: at(5, row),
      working: at(6, row) !== 0,
      changedOver: at(7, row) !== 0,
      cutOff: at(8, row) !== 0,
      reached: at(9, row) !== 0,
      errors: at(10, row),
      plus: at(11, row) !== 0,
      minus: at(12, row) !== 0,
    });
  }
  return rows;
}

export type Wiring = { state: State; word: Word; values: Record<string, string | number>; signal: string };

/** Whether each signal of the plant stands at the terminal where the manual wants it. */
export function wiringOf(axis: Axis, plant: Plant): Wiring[] {
  return axis.wires.map(({ signal, operand }): Wiring => {
    const found: Signal | undefined = plant.values.find((one) => one.name === signal);
    const row = { signal, state: 'bad' as State };
    if (!found?.operand) return { ...row, word: 'unwired', values: { wanted: operand } };
    if (found.operand !== operand)
      return { ...row, word: 'wiredTo', values: { operand: found.operand, wanted: operand } };
    if (found.stuck !== null) return { ...row, word: 'brokenWire', values: { operand, value: found.stuck } };
    return { ...row, state: 'good', word: 'wired', values: { operand } };
  });
}

/** Length measurement and reference switch are not needed by every axis. */
export const needed = (wire: Wiring) =>
  !(wire.word === 'unwired' && ['N', 'WORKPIECE', 'REFERENCE'].includes(wire.signal));

export const MOVEMENTS: Record<Movement, { text: Word; cause?: Word }> = {
  good: { text: 'moveGood' },
  stands: { text: 'moveStands', cause: 'causeStands' },
  notCounted: { text: 'moveNotCounted', cause: 'causeNotCounted' },
  reversedCount: { text: 'moveReversedCount', cause: 'causeReversedCount' },
  reversedDrive: { text: 'moveReversedDrive', cause: 'causeReversedDrive' },
};

export const OUTCOMES: Record<Outcome, { text: Word; cause: Word }> = {
  good: { text: 'runGood', cause: 'causeGood' },
  aborted: { text: 'runAborted', cause: 'causeAborted' },
  tooFast: { text: 'runTooFast', cause: 'causeTooFast' },
  short: { text: 'runShort', cause: 'causeShort' },
  over: { text: 'runOver', cause: 'causeOver' },
  tooShortPath: { text: 'runTooShortPath', cause: 'causeTooShortPath' },
};

/** SFB 46 has neither CONV_EN nor DECEL. */
const DIGITAL: Partial<Record<Word, Word>> = {
  causeStands: 'causeStandsDigital',
  causeReversedDrive: 'causeReversedDriveDigital',
  causeTooFast: 'causeTooFastDigital',
};
const ofOutput = (cause: Word, digital: boolean): Word => (digital && DIGITAL[cause]) || cause;

export function causeOf(movement: Movement, digital: boolean): Word | undefined {
  const { cause } = MOVEMENTS[movement];
  return cause && ofOutput(cause, digital);
}

/** A few pulses with creep speed are needed: as many as it travels in some cycles. */
export function adviceOf(run: RunJudgement, creepSpeed: number, digital: boolean): Word {
  const least = Math.ceil(creepSpeed * 0.02);
  return ofOutput(causeOfRun(run, least), digital);
}

function causeOfRun(run: RunJudgement, least: number): Word {
  return run.outcome === 'good' && run.spare <= least ? 'causeTight' : OUTCOMES[run.outcome].cause;
}

/** Bad if anything is, good if anything is good and nothing bad. */
export function together(states: Seen['state'][]): State {
  if (states.includes('bad')) return 'bad';
  return states.includes('good') ? 'good' : 'open';
}
