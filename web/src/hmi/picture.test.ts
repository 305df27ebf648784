import { expect, test } from 'vitest';
import { language } from '../i18n';
import {
  amount,
  constantOf,
  declared,
  fresh,
  HEIGHT,
  level,
  MOST,
  parsePicture,
  picturePath,
  placed,
  plainNumber,
  printPicture,
  shownNumber,
  signed,
  typedIn,
  WIDTH,
  type Item,
} from './picture';

const tank: Item = {
  kind: 'tank',
  x: 40,
  y: 20,
  width: 90,
  height: 140,
  operand: '"Level"',
  text: 'Tank 1',
  from: 0,
  to: 27648,
  format: 'AUTO',
};
const lamp: Item = {
  kind: 'lamp',
  x: 200,
  y: 20,
  width: 40,
  height: 40,
  operand: 'A 1.0',
  text: '',
  from: 0,
  to: 100,
  format: 'AUTO',
};

test('a picture comes back as it was written', () => {
  const text = printPicture([tank, lamp]);
  expect(text).toBe(
    '// kind ; x ; y ; width ; height ; operand ; text ; from ; to ; format\n' +
      'tank ; 40 ; 20 ; 90 ; 140 ; "Level" ; Tank 1 ; 0 ; 27648\nlamp ; 200 ; 20 ; 40 ; 40 ; A 1.0\n',
  );
  expect(parsePicture(text)).toEqual({ items: [tank, lamp], wrong: [], beyond: 0, end: [] });
  const odd = { ...lamp, operand: '"a;b"', text: 'one; two "three"\nfour' };
  expect(parsePicture(printPicture([odd])).items[0]).toMatchObject({ operand: '"a;b"', text: "one; two 'three' four" });
});

test('what is no symbol is named by its line; what is out of the picture is brought in', () => {
  expect(parsePicture('// head\n\ntank ; 1\nwheel ; 0 ; 0 ; 10 ; 10\nlamp ; 5000 ; -20 ; 44 ; 3\n')).toEqual({
    items: [
      {
        ...lamp,
        operand: '',
        x: WIDTH - 40,
        y: 0,
        height: 20,
        written: 'lamp ; 5000 ; -20 ; 44 ; 3',
        above: ['// head', '', 'tank ; 1', 'wheel ; 0 ; 0 ; 10 ; 10'],
      },
    ],
    wrong: [3, 4],
    beyond: 0,
    end: [],
  });
  expect(placed({ ...tank, y: 9999 }).y).toBe(HEIGHT - 140);
});

test('comments and lines that are no symbol stay where they are', () => {
  const text =
    '// kind ; x ; y ; width ; height ; operand ; text ; from ; to ; format\n// Line 1\n\nlamp ; 200 ; 20 ; 40 ; 40 ; A 1.0\nwheel ; 3\n// end\n';
  const { items, end } = parsePicture(text);
  expect(printPicture(items, end)).toBe(text);
});

test('a file without formats stays readable; a symbol is written anew only when it is changed', () => {
  const lines = [
    'tank;40;20;90;140;MW 10;;0;1e3',
    'text ; 9999 ; 20 ; 10 ; 10 ; ; A',
    'bar ; 20 ; 20 ; 30 ; 140 ; MW 2 ; ; 1e400',
  ];
  const old = `// kind ; x ; y ; width ; height ; operand ; text ; from ; to\n${lines.join('\n')}\n`;
  const { items, wrong, end } = parsePicture(old);
  expect(items.map(({ format }) => format)).toEqual(['AUTO', 'AUTO']);
  expect(wrong).toEqual([4]);
  const head = '// kind ; x ; y ; width ; height ; operand ; text ; from ; to ; format';
  expect(printPicture(items, end).split('\n')).toEqual([head, ...lines, '']);
  const changed = items.map((item) => ({ ...item, y: 30 }));
  expect(printPicture(changed, end).split('\n').slice(1, 3)).toEqual([
    'tank ; 40 ; 30 ; 90 ; 140 ; MW 10 ;  ; 0 ; 1000',
    `text ; ${WIDTH - 20} ; 30 ; 20 ; 20 ;  ; A`,
  ]);
});

test('symbols beyond the most are counted, and stay in the file', () => {
  const text = printPicture(Array(MOST).fill(lamp)) + 'lamp ; 0 ; 0 ; 40 ; 40\n'.repeat(200);
  const { items, wrong, beyond, end } = parsePicture(text);
  expect([items.length, wrong, beyond]).toEqual([MOST, [], 200]);
  expect(printPicture(items, end)).toBe(text);
});

test('a number and a level have the format that they are given', () => {
  const number: Item = { ...lamp, kind: 'number', operand: 'MD 34', format: 'REAL' };
  const text = printPicture([number, { ...tank, format: 'UDEC' }]);
  expect(text).toContain('number ; 200 ; 20 ; 40 ; 40 ; MD 34 ;  ;  ;  ; REAL\n');
  expect(text).toContain('; 0 ; 27648 ; UDEC\n');
  expect(parsePicture(text).items.map(({ format }) => format)).toEqual(['REAL', 'UDEC']);
  expect(amount(65535, 16, 'WORD', 'DEC')).toBe(-1);
  expect(amount(65535, 16, 'INT', 'UDEC')).toBe(65535);
  expect(amount(65535, 16, 'INT', 'AUTO')).toBe(-1);
  expect(shownNumber('W#16#00FF', 255, 16, 'INT', 'HEX')).toBe('W#16#00FF');
  expect(shownNumber('W#16#00FF', 255, 16, 'INT', 'AUTO')).toBe('255');
  language.value = 'de';
  expect(shownNumber('3.750000e+000', 3.75, 32, '', 'REAL')).toBe('3,75');
  expect(typedIn('2,5', '3.750000e+000', '', 'REAL')).toEqual({ value: '2.5', format: 'REAL' });
  expect(typedIn('00FF', 'W#16#0000', '', 'HEX')).toEqual({ value: '00FF', format: 'HEX' });
});

test('an operator types what the number shows', () => {
  const typed = (text: string, shown: string, type: string) => Object.values(constantOf(text, shown, type)).join(' ');
  expect(typed('65000', '65535', 'WORD')).toBe('65000 UDEC');
  expect(typed('21,5', '1.0', 'REAL')).toBe('21.5 AUTO');
  expect(typed('21', '1.0', 'REAL')).toBe('21.0 AUTO');
  expect(typed('5s', 'T#1S', 'TIME')).toBe('T#5s AUTO');
  expect(typed('T#5s', 'T#1S', 'TIME')).toBe('T#5s AUTO');
  expect(typed('Hi', "'abc'", 'STRING[10]')).toBe("'Hi' AUTO");
  expect(typed('-7', '12', 'INT')).toBe('-7 AUTO');
});

test('a new symbol lies on no other one', () => {
  const items: Item[] = [];
  for (let count = 0; count < 12; count++) items.push(fresh('tank', items));
  const overlap = items.some((a, index) =>
    items.some(
      (b, other) =>
        other > index && a.x < b.x + b.width && b.x < a.x + a.width && a.y < b.y + b.height && b.y < a.y + a.height,
    ),
  );
  expect(overlap).toBe(false);
});

test('levels and numbers', () => {
  expect(level(tank, 13824)).toBe(0.5);
  expect(level(tank, -5)).toBe(0);
  expect(level(tank, 1e9)).toBe(1);
  expect(level(tank, null)).toBe(0);
  expect(level({ from: 100, to: 0 }, 25)).toBe(0.75);
  expect(signed(65535, 16, 'INT')).toBe(-1);
  expect(signed(65535, 16, 'WORD')).toBe(65535);
  expect(signed(1.5, 32, 'REAL')).toBe(1.5);
  expect(plainNumber('W#16#FFF9', 65529, 16)).toBe('-7');
  expect(plainNumber('DW#16#0000_0010', 16, 32)).toBe('16');
  expect(plainNumber('1.5', 1.5, 32)).toBe('1.5');
  language.value = 'en';
  expect(plainNumber('2.150000e+001', 21.5, 32, 'REAL')).toBe('21.5');
  language.value = 'de';
  expect(plainNumber('2.150000e+001', 21.5, 32, 'REAL')).toBe('21,5');
  expect(declared('MD 20', '', 'DWORD')).toBe('');
  expect(declared('DB1.DBW 0', '', 'WORD')).toBe('');
  expect(declared('DB1.W', '', 'WORD')).toBe('WORD');
  expect(declared('MW 10', 'Level', 'INT')).toBe('INT');
  expect(plainNumber('W#16#FFFF', 65535, 16, 'WORD')).toBe('65535');
  expect(picturePath(' press 1/2 ')).toBe('press 1-2.hmi');
});
