import { expect, test } from 'vitest';
import { isQueryOfTimer, networkLines, operandKey, operandsIn, operandsOf } from './nearby';
import { outline } from './outline';

const source = `FUNCTION FC 1 : VOID
BEGIN
NETWORK
TITLE = about M 99.0
      U     E 0.0;   // not M 1.1
      UN    "Motor";
      L     "Plant data".Small; T MW   10;
NETWORK
M001: L     S5T#2S;
      SE    T   5;
      SPB   M001;
      CALL  "Slider", "Small boxes" (
           Travel := "Plant data".List[2].Time,
           Out    := #out.part[1].x );
      T     DB5.DBX 0.3;
END_FUNCTION
`;
const lines = source.split('\n');
const isBlock = (symbol: string) => /Slider|boxes/.test(symbol);
const [block] = outline(source);
const at = (line: number) => {
  const { first, last } = networkLines(block!, line);
  return operandsIn(lines.slice(first - 1, last), isBlock);
};

test('the operands of the network with the cursor, each once', () => {
  expect(at(5)).toEqual(['E 0.0', '"Motor"', '"Plant data".Small', 'MW 10']);
  expect(at(11)).toEqual(['T 5', '"Plant data".List[2].Time', '#out.part[1].x', 'DB5.DBX 0.3']);
  expect(at(1)).toEqual(at(5));
});

test('constants are no operands', () => {
  const all = ['L W#16#FFFF;', 'L P#M 10.0;', 'L P#DB5.DBX 0.0;', 'L S5T#2S;', 'L #FFFF;', 'L MW 10;'];
  expect(operandsIn(all, isBlock)).toEqual(['#FFFF', 'MW 10']);
});

test('where the operands of a line end', () => {
  const line = '      L     "Plant data".Small; T MW   10; // MW 20';
  expect(operandsOf(line).map(({ written, end }) => [written, line.slice(end, end + 1)])).toEqual([
    ['"Plant data".Small', ';'],
    ['MW   10', ';'],
  ]);
  expect(operandsOf('TITLE = about M 99.0')).toEqual([]);
  expect(operandKey('mw   10')).toBe(operandKey('MW 10'));
});

test('a block without networks is one', () => {
  const [db] = outline('DATA_BLOCK DB 1\nSTRUCT\n a : INT ;\nEND_STRUCT\nBEGIN\nEND_DATA_BLOCK\n');
  expect(networkLines(db!, 3)).toEqual({ first: 1, last: 6 });
});

test('a query of a timer sees its bit, not its time', () => {
  for (const text of ['  U T 5;', 'm1: UN "Pause";', '      ON    T 5', 'AN T 5;'])
    expect(isQueryOfTimer(text, 'T 5')).toBe(true);
  expect(isQueryOfTimer('  U E 0.0;', 'E 0.0')).toBe(false);
  for (const text of ['  L T 5;', '  SE T 5;', 'U: L T 5;']) expect(isQueryOfTimer(text, 'T 5')).toBe(false);
  expect(isQueryOfTimer('  U Z 1;', 'Z 1')).toBe(true);
});
