import { expect, test, vi } from 'vitest';
import type { Project } from '../connection/protocol';
import { Plc } from './plc.svelte';

const project: Project = {
  name: '',
  folder: '',
  mpiAddress: 2,
  can: [],
  family: 'S7',
  model: '',
  example: false,
  serial: false,
  empty: false,
  changed: [],
  station: '',
  network: '',
};

test('only the fields that came change', () => {
  const plc = new Plc();
  plc.receive({ mode: 'RUN', cycles: 7 });
  const strange = { event: 'state', mode: 'RUN' as const, cycles: 8, unknown: 1, phase: 'lost', isForced: null };
  plc.receive(strange);
  expect([plc.mode, plc.cycles, plc.live]).toEqual(['RUN', 8, true]);
  expect('unknown' in plc).toBe(false);
  expect([plc.phase, typeof plc.isForced]).toEqual(['connecting', 'function']);
});

test('where only the time goes on, it is shown ten times a second, and the last one of all', () => {
  vi.useFakeTimers();
  const plc = new Plc();
  plc.receive({ mode: 'RUN', time: 1, cycles: 1 });
  plc.receive({ time: 2, cycles: 2 });
  vi.advanceTimersByTime(33);
  plc.receive({ time: 3 });
  expect([plc.time, plc.cycles]).toEqual([1, 1]);
  vi.advanceTimersByTime(67);
  expect([plc.time, plc.cycles]).toEqual([3, 2]);
  plc.receive({ time: 4 });
  plc.receive({ mode: 'STOP' });
  expect([plc.time, plc.mode]).toEqual([4, 'STOP']);
  vi.useRealTimers();
});

test('a closed project leaves a dark CPU', () => {
  const plc = new Plc();
  plc.receive({ leds: { ...plc.leds, RUN: 'on' }, mode: 'RUN', forces: [{ operand: 'A 1.0', value: '1' }] });
  plc.receive({ project: null });
  expect([plc.mode, plc.leds.RUN, plc.forces.length]).toEqual(['STOP', 'off', 0]);
});

test('a forced operand is found by each of its names', () => {
  const plc = new Plc();
  plc.receive({ forces: [{ operand: '"Slider"', value: '1' }] });
  expect(plc.isForced('A 1.2', '"Slider"')).toBe(true);
  expect(plc.isForced('A 1.2')).toBe(false);
});

test('a machine lacks what it cannot do; without a machine nothing is missing', () => {
  const plc = new Plc();
  expect([plc.can('rack'), plc.lacks('rack')]).toEqual([false, false]);
  plc.receive({ project: { ...project, can: ['stacks'] } });
  expect([plc.can('stacks'), plc.lacks('stacks')]).toEqual([true, false]);
  expect([plc.can('rack'), plc.lacks('rack')]).toEqual([false, true]);
});
