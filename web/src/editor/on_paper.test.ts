import { expect, test } from 'vitest';
import { onPaper } from './on_paper';
import { blockAt, outline } from './outline';

const text = [
  '// A plant.',
  '',
  'TYPE UDT 1',
  'STRUCT',
  'END_STRUCT',
  'END_TYPE',
  '',
  '// Counts boxes,',
  '// one by one.',
  'FUNCTION FC 1 : VOID',
  'TITLE = Count',
  'BEGIN',
  'END_FUNCTION',
  '',
].join('\n');
const at = (line: number) => onPaper('main.awl', text, blockAt(outline(text), line));

test('the block of the cursor is printed, with the comment above it', () => {
  expect(at(11)).toEqual({ title: 'main.awl: FC 1 Count', text: text.split('\n').slice(7, 13).join('\n') });
  expect(at(3)).toEqual({ title: 'main.awl: UDT 1', text: text.split('\n').slice(2, 6).join('\n') });
});

test('at no block the whole file is printed', () => {
  expect(at(1)).toEqual({ title: 'main.awl', text });
});
