import { expect, test } from 'vitest';
import type { StatusRow } from '../editor/status_columns';
import { givenAt, isProcessed, linesOf, signalOf, valueAt } from './signal';

const row = (line: number, vke: string, sta: string, akku1 = '00000000'): StatusRow => [line, vke, sta, '0', akku1];
const lines = linesOf([
  row(10, '0', '1'),
  row(11, '1', '0'),
  row(12, '1', '1', 'FFFFFFFE'),
  row(13, '1', '1', '3FC00000'),
]);

test('a wire has the bit of its statement', () => {
  expect(signalOf([[1, 'vke']], lines, 10)).toBe('on');
  expect(signalOf([[0, 'vke']], lines, 10)).toBe('off');
  expect(signalOf([[0, 'sta']], lines, 10)).toBe('on');
  expect(signalOf([[0, 'notSta']], lines, 10)).toBe('off');
  expect(signalOf([[1, 'notSta']], lines, 10)).toBe('on');
});

test('several are ANDed; none is power', () => {
  expect(
    signalOf(
      [
        [0, 'sta'],
        [1, 'sta'],
      ],
      lines,
      10,
    ),
  ).toBe('off');
  expect(
    signalOf(
      [
        [0, 'sta'],
        [2, 'sta'],
      ],
      lines,
      10,
    ),
  ).toBe('on');
  expect(signalOf([], lines, 10)).toBe('on');
});

test('a statement that was not processed leaves the wire without a signal, even beside a 0', () => {
  expect(
    signalOf(
      [
        [1, 'sta'],
        [7, 'sta'],
      ],
      lines,
      10,
    ),
  ).toBe('unknown');
  expect(signalOf([[0, 'vke']], null, 10)).toBe('unknown');
});

test('a CALL that was processed has power at its EN, whose wire names no statement', () => {
  const place = { x: 0, y: 0, w: 2, h: 0 };
  const shapes = [
    { kind: 'wire' as const, ...place, flow: [] },
    { kind: 'frame' as const, ...place, node: 0, line: 2 },
  ];
  expect(isProcessed({ line: 10, shapes }, lines)).toBe(true);
  expect(isProcessed({ line: 20, shapes }, lines)).toBe(false);
  expect(isProcessed({ line: 10, shapes }, null)).toBe(false);
});

test('of several rows of a line the last counts', () => {
  expect(signalOf([[0, 'vke']], linesOf([row(1, '0', '0'), row(1, '1', '0')]), 1)).toBe('on');
});

test('a value is AKKU 1 in the notation of its type', () => {
  expect(valueAt(12, 'INT', lines)).toBe('-2');
  expect(valueAt(13, 'REAL', lines)).toBe('1.5');
  expect(valueAt(99, 'INT', lines)).toBe('');
  expect(valueAt(12, 'INT', null)).toBe('');
});

test('the values of a CALL are those of its parameters', () => {
  const call: StatusRow = [20, '1', '1', '0', '00000000', '', '', '', '', '', '', { n: '5', t: 'S5T#50MS' }];
  expect(givenAt(20, 't', linesOf([call]))).toBe('S5T#50MS');
  expect(givenAt(20, 'x', linesOf([call]))).toBe('');
  expect(givenAt(21, 't', linesOf([call]))).toBe('');
  expect(givenAt(10, 't', lines)).toBe('');
});
