// What the samples of a commissioning say: did the axis move as it was told, and where did a run end?

/** Samples in the order of time; what the PLC does not have is null. */
export interface Row {
  time: number;
  /** Where the encoder of the plant really is, in pulses, and how fast. */
  plant: number;
  speed: number;
  /** As the CPU counts it. */
  position: number;
  distance: number;
  mode: number;
  working: boolean;
  changedOver: boolean;
  cutOff: boolean;
  reached: boolean;
  errors: number;
  /** DIR_P and DIR_M as the SFB has them. */
  plus: boolean;
  minus: boolean;
}

export const JOG = 1,
  RELATIVE = 4,
  ABSOLUTE = 5;

/** The last stretch of rows with a property, from its first row to the one behind its last. */
export function lastStretch(rows: Row[], has: (row: Row) => boolean): [number, number] | null {
  let end = rows.length - 1;
  while (end >= 0 && !has(rows[end]!)) --end;
  if (end < 0) return null;
  let begin = end;
  while (begin > 0 && has(rows[begin - 1]!)) --begin;
  return [begin, end + 1];
}

export type Movement = 'good' | 'stands' | 'notCounted' | 'reversedCount' | 'reversedDrive';

/** Fewer pulses say nothing. */
const ENOUGH = 8;
/** A drive that starts is waited for, in seconds. */
const PATIENCE = 0.5;

/** Of the last jog in one direction that says something; undefined: there was none. */
export function judgeJog(rows: Row[], direction: 1 | -1): Movement | undefined {
  const wanted = (row: Row) => row.mode === JOG && row.working && (direction > 0 ? row.plus : row.minus);
  let before = rows;
  for (let found = lastStretch(before, wanted); found; found = lastStretch(before, wanted)) {
    const said = judgeStretch(rows.slice(found[0], found[1] + 1), direction);
    if (said) return said;
    before = rows.slice(0, found[0]);
  }
  return undefined;
}

/** Its last row may be the one behind the jog. */
function judgeStretch(rows: Row[], direction: 1 | -1): Movement | undefined {
  const turned = turningPoint(rows);
  if (turned === undefined) return undefined;
  const from = rows[turned]!,
    to = rows.at(-1)!;
  const moved = (to.plant - from.plant) * direction,
    counted = (to.position - from.position) * direction;
  if (Math.abs(moved) < ENOUGH) return to.time - from.time < PATIENCE ? undefined : 'stands';
  if (moved < 0) return 'reversedDrive';
  // With one track alone a pulse is counted up and down again.
  if (Math.abs(counted) < moved / 2) return 'notCounted';
  return counted < 0 ? 'reversedCount' : 'good';
}

/**
 * Where the jog itself begins: an axis that still moves from the jog before first comes to rest, which is no answer to this
 * one. Undefined: it still does.
 */
function turningPoint(rows: Row[]): number | undefined {
  const moves = rows.filter((row) => row.speed !== 0);
  if (moves.length === 0) return 0;
  const way = Math.sign(moves.at(-1)!.speed);
  let other = rows.length - 2;
  while (other >= 0 && Math.sign(rows[other]!.speed) === way) --other;
  if (other >= 0) return other;
  const slowest = rows.reduce((least, row, index) => (slower(row, rows[least]!) ? index : least), 0);
  return slower(rows.at(-1)!, rows[0]!) && slowest === rows.length - 1 ? undefined : slowest;
}

const slower = (one: Row, than: Row) => Math.abs(one.speed) < Math.abs(than.speed);

export type Outcome = 'good' | 'aborted' | 'tooFast' | 'short' | 'over' | 'tooShortPath';

export interface RunJudgement {
  outcome: Outcome;
  direction: 1 | -1;
  /** Seconds until the changeover point, from there to the cut-off point, and until it stands. */
  travel: number;
  creep: number;
  coast: number;
  speedAtCutOff: number;
  /** The way with creep speed before the cut-off point: the changeover difference can be so much smaller. */
  spare: number;
  /** Target minus position when it stands. */
  rest: number;
  errors: number;
}

const FASTER = 1.02;

/** The last relative or absolute run; undefined: there was none, or the axis still moves. */
export function judgeRun(rows: Row[], targetRange: number, creepSpeed: number): RunJudgement | undefined {
  const stretch = lastStretch(rows, (row) => row.working && (row.mode === RELATIVE || row.mode === ABSOLUTE));
  if (!stretch || stretch[1] >= rows.length) return undefined;
  const [begin, end] = stretch;
  const stands = rows.findIndex((row, index) => index >= end && row.speed === 0 && rows[index - 1]!.speed === 0);
  if (stands < 0) return undefined;
  const run = rows.slice(begin, stands + 1);
  const first = run[0]!,
    last = run.at(-1)!;
  const cut = run.findIndex((row) => row.cutOff);
  const over = run.findIndex((row) => row.changedOver);
  const direction = (run.find((row) => !row.cutOff && row.distance !== 0)?.distance ?? 1) < 0 ? -1 : 1;
  const errors = run.reduce((all, row) => all | row.errors, 0);
  const at = (index: number) => run[index < 0 ? run.length - 1 : index]!;
  // The row of the cut-off is the first after it: the speed of the one before is that of the cut-off.
  const before = at(Math.max(0, cut - 1));
  const common = {
    direction: direction as 1 | -1,
    travel: at(over).time - first.time,
    creep: cut < 0 ? 0 : at(cut).time - at(over).time,
    coast: cut < 0 ? 0 : last.time - at(cut).time,
    speedAtCutOff: cut < 0 ? 0 : Math.abs(before.speed),
    spare: cut < 0 ? 0 : creepWay(run.slice(0, cut), creepSpeed),
    rest: last.distance,
    errors,
  };
  return { outcome: outcomeOf(run, cut, over, common, targetRange, creepSpeed), ...common };
}

function creepWay(run: Row[], creepSpeed: number): number {
  let from = run.length - 1;
  while (from > 0 && Math.abs(run[from - 1]!.speed) <= creepSpeed * FASTER) --from;
  return run.length ? Math.abs(run.at(-1)!.position - run[from]!.position) : 0;
}

type Common = Omit<RunJudgement, 'outcome'>;

function outcomeOf(run: Row[], cut: number, over: number, one: Common, range: number, creep: number): Outcome {
  if (cut < 0) return 'aborted';
  if (over === 0) return 'tooShortPath';
  if (one.speedAtCutOff > creep * FASTER) return 'tooFast';
  const rest = one.rest * one.direction;
  if (rest > range / 2) return 'short';
  if (rest < -range / 2 || (!run.at(-1)!.reached && rest < 0)) return 'over';
  return 'good';
}
