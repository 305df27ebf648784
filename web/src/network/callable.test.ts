import { expect, test } from 'vitest';
import { SymbolIndex } from '../editor/catalogue';
import { blocksOf, instanceOf, needsInstance, spelled } from './callable';

const symbols = new SymbolIndex([
  { name: 'Classifier', operand: 'FB 1', type: 'FB 1', comment: '' },
  { name: 'Belt', operand: 'DB 4', type: 'FB 1', comment: '' },
  { name: 'Start', operand: 'E 0.0', type: 'BOOL', comment: '' },
]);
const block = (id: string) => ({ id, symbol: '', title: '' });
const catalogue = { blocks: ['OB 1', 'FB 1', 'FC 1', 'FC 1', 'SFC 20', 'DB 4'].map(block) };
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

test.each([
  ['Belt', '"Belt"'],
  ['db 77', 'DB 77'],
  ['FC 1', ''],
  ['x', ''],
])('the instance %s', (typed, wanted) => expect(instanceOf(typed, data, symbols)).toBe(wanted));
