import { expect, it } from 'vitest';
import { refusedItems } from './refused_values';

const items = [
  { operand: 'DB1.B', value: '2 ' },
  { operand: 'DB1.W', value: '70000' },
];
const refused = (...args: string[]) => refusedItems(items, { arguments: args }).map(({ operand }) => operand);

it('means the operand or the value that is named, else all', () => {
  expect(refused('DB1.W', '2')).toEqual(['DB1.W']);
  expect(refused('2', 'BOOL')).toEqual(['DB1.B']);
  expect(refused('something')).toEqual(['DB1.B', 'DB1.W']);
});
