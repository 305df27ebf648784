import { Text } from '@codemirror/state';
import { expect, test } from 'vitest';
import { diagnostics, rangeOf } from './problems';

const doc = Text.of(['      U     E 0.8;', '      =     "My motor"', '', '      U(']);
const marked = (line: number, column: number): string => {
  const { from, to } = rangeOf(doc, line, column);
  return doc.sliceString(from, to);
};

test('a problem marks its word (S7-EDIT-06)', () => {
  expect(marked(1, 13)).toBe('E 0.8');
  expect(marked(2, 13)).toBe('"My motor"');
});

test('places at or behind the end of a line stay inside the text', () => {
  expect(marked(1, 99)).toBe(';');
  expect(rangeOf(doc, 3, 1)).toEqual({ from: doc.line(3).from, to: doc.line(3).from });
  expect(rangeOf(doc, 99, 1).to).toBeLessThanOrEqual(doc.length);
});

test('problems without a line belong to no place', () => {
  const problem = {
    code: 'P1',
    severity: 'error' as const,
    file: 'a',
    line: 0,
    column: 0,
    length: 0,
    text: 'x',
    arguments: [],
  };
  expect(diagnostics(doc, [problem])).toEqual([]);
  expect(diagnostics(doc, [{ ...problem, line: 1, column: 13 }])[0]!.message).toBe('P1 x');
});
