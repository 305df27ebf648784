import { expect, test } from 'vitest';
import type { Reference } from '../connection/protocol';
import { containing } from './reference_filter';

const row = (operand: string, symbol: string, block: string): Reference => ({
  operand,
  symbol,
  block,
  file: 'a.awl',
  line: 1,
  network: 1,
  instruction: `U     ${operand}`,
  access: 'R',
});
const rows = [row('A 1.0', 'Slider small', 'OB 1'), row('A 1.1', 'Slider large', 'FC 1'), row('M 0.0', '', 'FC 1')];
const found = (text: string) => containing(rows, text).map(({ operand }) => operand);

test('a part of a symbol finds it, several words all have to be there', () => {
  expect(found('slid')).toEqual(['A 1.0', 'A 1.1']);
  expect(found('SLIDER fc')).toEqual(['A 1.1']);
  expect(found('"slider small"')).toEqual(['A 1.0']);
  expect(found('valve')).toEqual([]);
});

test('a part of an operand is one of either language', () => {
  expect(found('a slider')).toEqual(['A 1.0', 'A 1.1']);
  expect(found('q 1.1')).toEqual(['A 1.1']);
});
