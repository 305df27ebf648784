import { expect, test } from 'vitest';
import { ABSOLUTE, JOG, judgeJog, judgeRun, lastStretch, RELATIVE, type Row } from './judgement';

const rest: Row = {
  time: 0,
  plant: 0,
  speed: 0,
  position: 0,
  distance: 0,
  mode: 0,
  working: false,
  changedOver: false,
  cutOff: false,
  reached: false,
  errors: 0,
  plus: false,
  minus: false,
};
/** A jog of so many pulses in the plant and in the CPU. */
function jog(direction: 1 | -1, plant: number, counted: number, seconds = 1): Row[] {
  return Array.from({ length: 11 }, (_, index) => ({
    ...rest,
    time: (index * seconds) / 10,
    plant: (plant * index) / 10,
    position: (counted * index) / 10,
    mode: JOG,
    working: index < 10,
    plus: direction > 0 && index < 10,
    minus: direction < 0 && index < 10,
  }));
}

test('the last stretch', () => {
  const rows = [true, true, false, true, true, false].map((working) => ({ ...rest, working }));
  expect(lastStretch(rows, (row) => row.working)).toEqual([3, 5]);
  expect(lastStretch([], (row) => row.working)).toBeNull();
  expect(lastStretch([rest], (row) => row.working)).toBeNull();
});

test('a jog as it should be, in both directions', () => {
  expect(judgeJog(jog(1, 1000, 1000), 1)).toBe('good');
  expect(judgeJog(jog(-1, -1000, -1000), -1)).toBe('good');
  expect(judgeJog(jog(1, 1000, 1000), -1)).toBeUndefined();
});

test('what is wrong with a jog', () => {
  expect(judgeJog(jog(1, 1000, -1000), 1)).toBe('reversedCount');
  expect(judgeJog(jog(1, -1000, -1000), 1)).toBe('reversedDrive');
  expect(judgeJog(jog(-1, 1000, 1000), -1)).toBe('reversedDrive');
  expect(judgeJog(jog(1, 1000, 0), 1)).toBe('notCounted');
  expect(judgeJog(jog(1, 1000, 1), 1)).toBe('notCounted');
  expect(judgeJog(jog(1, 1000, -1), 1)).toBe('notCounted');
  expect(judgeJog(jog(1, 1000, 990), 1)).toBe('good');
  expect(judgeJog(jog(1, 0, 0), 1)).toBe('stands');
  expect(judgeJog(jog(1, 0, 0, 0.2), 1)).toBeUndefined();
});

/** A jog with these speeds, a sample every tenth of a second, as the CPU counts it too. */
function speeds(direction: 1 | -1, ...list: number[]): Row[] {
  let position = 0;
  return list.map((speed, index) => ({
    ...rest,
    time: index / 10,
    speed,
    plant: (position += speed / 10),
    position,
    mode: JOG,
    working: true,
    plus: direction > 0,
    minus: direction < 0,
  }));
}

test('an axis that still moves from the jog before', () => {
  const slowing = [1000, 800, 600, 400, 200];
  expect(judgeJog(speeds(-1, ...slowing), -1)).toBeUndefined();
  expect(judgeJog(speeds(-1, ...slowing, -200, -400), -1)).toBe('good');
  expect(judgeJog(speeds(-1, ...slowing, 0, 200, 400), -1)).toBe('reversedDrive');
  expect(judgeJog(speeds(-1, 0, 200, 400, 600), -1)).toBe('reversedDrive');
  // The drive is reversed, and the axis came from the other side.
  expect(judgeJog(speeds(-1, -1000, -500, 0, 200, 400), -1)).toBe('reversedDrive');
  expect(judgeJog(speeds(1, 1000, 900, 950, 1000), 1)).toBe('good');
});

test('a short touch does not forget what the jog before has shown', () => {
  const pause = { ...rest, plant: 1000, position: 1000 };
  const touch = { ...pause, mode: JOG, working: true, plus: true };
  expect(judgeJog([...jog(1, 1000, 1000), pause, touch, pause], 1)).toBe('good');
});

/** A run to a target: travels to the changeover point, creeps, is cut off, coasts. */
function run({
  speed = 1000,
  end = 2000,
  target = 2000,
  cutOffAt = 1900,
  mode = RELATIVE,
  reached = true,
} = {}): Row[] {
  const rows: Row[] = [];
  const add = (row: Partial<Row>) =>
    rows.push({
      ...rest,
      time: rows.length / 10,
      mode,
      plant: row.position!,
      distance: target - row.position!,
      ...row,
    });
  add({ position: 0 });
  add({ position: 0, working: true });
  add({ position: 1000, working: true, speed: 5000 });
  add({ position: 1500, working: true, speed: Math.max(speed, 2000), changedOver: true });
  add({ position: 1700, working: true, speed, changedOver: true });
  add({ position: cutOffAt - 1, working: true, speed, changedOver: true });
  add({ position: cutOffAt, speed, changedOver: true, cutOff: true });
  add({ position: end, speed: 0, changedOver: true, cutOff: true, reached });
  add({ position: end, speed: 0, changedOver: true, cutOff: true, reached });
  return rows;
}

test('a run that ends in the target range', () => {
  const good = judgeRun(run(), 50, 1000)!;
  expect(good).toMatchObject({ outcome: 'good', direction: 1, speedAtCutOff: 1000, rest: 0, spare: 199, errors: 0 });
  expect(good.travel).toBeCloseTo(0.2);
  expect(good.creep).toBeCloseTo(0.3);
  expect(judgeRun(run({ mode: ABSOLUTE }), 50, 1000)!.outcome).toBe('good');
});

test('short of the target range, beyond it, too fast', () => {
  expect(judgeRun(run({ end: 1960, reached: false }), 50, 1000)!.outcome).toBe('short');
  expect(judgeRun(run({ end: 2026 }), 50, 1000)!.outcome).toBe('over');
  expect(judgeRun(run({ end: 1975 }), 50, 1000)!.outcome).toBe('good');
  expect(judgeRun(run({ speed: 3000 }), 50, 1000)).toMatchObject({ outcome: 'tooFast', spare: 0 });
});

test('in minus direction the same', () => {
  const mirrored = (rows: Row[]) =>
    rows.map((row) => ({
      ...row,
      position: -row.position,
      plant: -row.plant,
      speed: -row.speed,
      distance: -row.distance,
    }));
  expect(judgeRun(mirrored(run()), 50, 1000)).toMatchObject({ outcome: 'good', direction: -1 });
  expect(judgeRun(mirrored(run({ end: 1960, reached: false })), 50, 1000)!.outcome).toBe('short');
  expect(judgeRun(mirrored(run({ end: 2040 })), 50, 1000)!.outcome).toBe('over');
});

test('a run that was aborted, that moves, that was none', () => {
  const aborted = run().map((row) => ({ ...row, cutOff: false, errors: row.working ? 0 : 0x2000 }));
  expect(judgeRun(aborted, 50, 1000)).toMatchObject({ outcome: 'aborted', errors: 0x2000 });
  expect(judgeRun(run().slice(0, 5), 50, 1000)).toBeUndefined();
  expect(judgeRun(run().slice(0, 8), 50, 1000)).toBeUndefined();
  expect(judgeRun([], 50, 1000)).toBeUndefined();
});

test('a path that begins within the changeover difference shows nothing of it', () => {
  const rows = run().map((row) => (row.working ? { ...row, changedOver: true } : row));
  expect(judgeRun(rows, 50, 1000)!.outcome).toBe('tooShortPath');
});
