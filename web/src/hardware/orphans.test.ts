import { expect, test } from 'vitest';
import { orphansOf } from './orphans';
import type { Parameter } from './plan.svelte';

const rows = (...keys: string[]): Parameter[] => keys.map((key) => ({ key, kind: 'text', value: '' }));

test('the substitute value goes with its choice', () => {
  expect(orphansOf('on_stop', 'keep', rows('on_stop', 'substitute'))).toEqual(['substitute']);
  expect(orphansOf('on_stop', 'keep', rows('on_stop'))).toEqual([]);
  expect(orphansOf('on_stop', 'substitute', rows('on_stop', 'substitute'))).toEqual([]);
});

test('another drive: what only the one before has goes, the creep speed before the maximum', () => {
  const analog = rows(
    'name',
    'input',
    'drive',
    'interrupts',
    'max_speed',
    'creep_speed',
    'voltage',
    'report_target_range',
  );
  expect(orphansOf('drive', 'digital', analog)).toEqual(['creep_speed', 'max_speed', 'voltage']);
  expect(orphansOf('drive', 'analog', rows('drive', 'control_type'))).toEqual(['control_type']);
  expect(orphansOf('drive', 'none', analog)).toEqual([
    'creep_speed',
    'report_target_range',
    'interrupts',
    'max_speed',
    'voltage',
  ]);
});

test('without a drive the type of axis goes behind the parameters of this type', () => {
  const rotary = rows('drive', 'axis', 'rotary_end', 'report_target_range');
  expect(orphansOf('drive', 'none', rotary)).toEqual(['report_target_range', 'rotary_end', 'axis']);
});

test('another type of axis', () => {
  const linear = rows('axis', 'low_limit', 'high_limit', 'monitor_working_range', 'report_working_range');
  expect(orphansOf('axis', 'rotary', linear)).toEqual([
    'report_working_range',
    'monitor_working_range',
    'low_limit',
    'high_limit',
  ]);
  expect(orphansOf('axis', 'linear', rows('axis', 'rotary_end'))).toEqual(['rotary_end']);
});

test('an interrupt needs its monitor and the selection', () => {
  const all = rows('interrupts', 'monitor_actual_value', 'report_actual_value', 'report_target_range');
  expect(orphansOf('monitor_actual_value', false, all)).toEqual(['report_actual_value']);
  expect(orphansOf('monitor_actual_value', true, all)).toEqual([]);
  expect(orphansOf('interrupts', 'none', all)).toEqual(['report_actual_value', 'report_target_range']);
  expect(orphansOf('interrupts', 'diagnostics', all)).toEqual([]);
});

test('another protocol: what only the one before has goes, and a character delay that may be too short', () => {
  const ascii = rows('serial.mode', 'serial.character_delay', 'serial.end', 'serial.telegrams', 'serial.data_bits');
  expect(orphansOf('serial.protocol', '3964R', ascii)).toEqual(['serial.character_delay', 'serial.mode', 'serial.end']);
  expect(orphansOf('serial.protocol', 'RK512', ascii)).toContain('serial.telegrams');
  expect(orphansOf('serial.protocol', 'RK512', ascii)).toContain('serial.data_bits');
  const procedure = rows('serial.priority', 'serial.acknowledge_delay', 'serial.telegrams');
  expect(orphansOf('serial.protocol', 'ASCII', procedure)).toEqual(['serial.priority', 'serial.acknowledge_delay']);
  expect(orphansOf('serial.protocol', '3964', procedure)).toEqual([]);
});

test('another end of telegrams, or no flow control: what belongs to the one before has no meaning', () => {
  const all = rows('serial.end', 'serial.length', 'serial.end_characters', 'serial.xon', 'serial.telegrams');
  expect(orphansOf('serial.end', 'count', all)).toEqual(['serial.end_characters']);
  expect(orphansOf('serial.end', 'delay', all)).toEqual(['serial.length', 'serial.end_characters']);
  expect(orphansOf('serial.flow_control', 'none', all)).toEqual(['serial.xon']);
  expect(orphansOf('serial.flow_control', 'XON/XOFF', all)).toEqual([]);
});

test('another mode has another preset, and only four wires have flow control', () => {
  const all = rows('serial.mode', 'serial.preset', 'serial.flow_control');
  expect(orphansOf('serial.mode', 'RS485', all)).toEqual(['serial.preset', 'serial.flow_control']);
  expect(orphansOf('serial.mode', 'RS422', all)).toEqual(['serial.preset']);
});
