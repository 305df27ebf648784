import { expect, test } from 'vitest';
import { SymbolIndex } from '../editor/catalogue';
import { blocksOf, instanceOf, instancesFor, needsInstance, spelled } from './callable';

const symbols = new SymbolIndex([
  { name: 'Classifier', operand: 'FB 1', type: 'FB 1', comment: '' },
  { name: 'Belt', operand: 'DB 4', type: 'FB 1', comment: '' },
  { name: 'Start', operand: 'E 0.0', type: 'BOOL', comment: '' },
]);
const block = (id: string) => ({ id, symbol: '', title: '' });
const catalogue = {
  blocks: [
    ...['OB 1', 'FB 1', 'FC 1', 'FC 1', 'SFC 20', 'DB 1', 'DB 2'].map(block),
    { ...block('DB 4'), instanceOf: 'FB 1' },
    { ...block('DB 5'), instanceOf: 'SFB 4' },
  ],
};
const blocks = blocksOf(catalogue, /^S?F[BC] /);
const data = blocksOf(catalogue, /^DB /);

test('each block that can be called is offered once', () => {
  expect(blocks.map(({ id }) => id)).toEqual(['FB 1', 'FC 1', 'SFC 20']);
});

test('a block of the program is offered, not the one of the library with its number', () => {
  const named = (symbol: string) => ({ id: 'FC 1', symbol, title: '' });
  expect(blocksOf({ blocks: [named('Count boxes'), named('AD_DT_TM')] }, /^FC /)).toEqual([named('Count boxes')]);
});

test.each([
  ['fc1', 'FC 1'],
  ['SFC 20', 'SFC 20'],
  ['classifier', '"Classifier"'],
  ['"Classifier"', '"Classifier"'],
  ['#motor', '#motor'],
  ['Cl', ''],
  ['FC 9', ''],
  ['Start', ''],
  ['', ''],
])('%s is spelled %s', (typed, wanted) => expect(spelled(typed, blocks, symbols)).toBe(wanted));

test.each([
  ['fb1', true],
  ['Classifier', true],
  ['FC 1', false],
  ['', false],
])('whether %s needs a data block', (typed, wanted) => expect(needsInstance(typed, symbols)).toBe(wanted));

const offered = (typed: string) => instancesFor(typed, data, symbols, 'new');

test.each([
  ['fb1', ['DB 4', 'DB 3']],
  ['Classifier', ['DB 4', 'DB 3']],
  ['SFB 4', ['DB 5', 'DB 3']],
  ['FB 2', ['DB 3']],
])('the instances of %s, and a number that is free', (typed, wanted) =>
  expect(offered(typed).map(({ id }) => id)).toEqual(wanted),
);

test.each([
  ['Belt', '"Belt"'],
  ['db 4', 'DB 4'],
  ['db 77', 'DB 77'],
  ['DB 2', ''],
  ['DB 5', ''],
  ['FC 1', ''],
  ['x', ''],
])('the instance %s of FB 1', (typed, wanted) =>
  expect(instanceOf(typed, offered('FB 1'), data, symbols)).toBe(wanted),
);
