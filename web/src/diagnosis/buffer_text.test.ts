import { expect, test } from 'vitest';
import type { DiagnosticEntry } from '../connection/protocol';
import { bufferText, type Head } from './buffer_text';

const entry = (more: Partial<DiagnosticEntry> = {}): DiagnosticEntry => ({
  number: 1,
  event: '16#2521',
  time: 0,
  clock: '2005-09-01 08:00:00.123',
  text: 'BCD conversion error',
  help: '',
  ...more,
});
const head: Head = {
  title: 'Diagnostic buffer',
  lines: ['Plant', '', 'CPU 314C'],
  label: (name) => name,
  moduleAt: '{name} in {rack}/{slot}',
  moduleNone: 'none at {address}',
};
const text = (...entries: DiagnosticEntry[]) => bufferText(entries, head).split('\r\n');

test('what it is of, then number, time, date, event and event ID of each', () => {
  expect(text(entry(), entry({ number: 2 })).slice(0, 10)).toEqual([
    'Diagnostic buffer',
    'Plant',
    'CPU 314C',
    '',
    'number:     1',
    'timeOfDay:  08:00:00.123',
    'date:       2005-09-01',
    'text:       BCD conversion error',
    'event:      16#2521',
    '',
  ]);
});

test('details: the module, the place, a help of several lines', () => {
  const module = { address: 4, output: false };
  const all = text(entry({ help: 'first\nsecond', block: 'FC 1', file: 'main.awl', line: 8, module }));
  expect(all.slice(-5)).toEqual([
    'module:     none at 4',
    'place:      FC 1, main.awl:8',
    'helpText:   first',
    '            second',
    '',
  ]);
  expect(text(entry({ module: { ...module, rack: 0, slot: '4', name: 'DI' } }))).toContain('module:     DI in 0/4');
});

test('a PLC without a clock and without event IDs', () => {
  const all = text(entry({ clock: '', event: '0', time: 1_500_000_000 })).join('\n');
  expect(all).toMatch(/\nelapsed: +0:00:01\.500/);
  expect(all).not.toMatch(/date|event/);
});

test('an empty buffer is its head', () => {
  expect(text()).toEqual(['Diagnostic buffer', 'Plant', 'CPU 314C', '']);
});
