import { expect, test } from 'vitest';
import { between, bytesOf, count, csv, isBad, type Character } from './characters';

const one = (number: number, from: 0 | 1, name: string, meaning = ''): Character => ({
  number,
  from,
  value: 2,
  name,
  meaning,
  begin: number,
  end: number + 0.5,
});
const all = [
  one(0, 1, 'STX', 'wants to send'),
  one(1, 0, 'DLE', 'connection is there'),
  one(2, 1, "'A'"),
  one(3, 1, "'\"'", 'BCC wrong, 41 would be right'),
  one(4, 0, 'DLE', 'block acknowledged'),
];

test('both directions, blocks and faults are counted', () =>
  expect(count(all)).toEqual({ sent: [2, 3], acknowledged: 1, bad: 1 }));

test('a BREAK is a fault and no character', () => {
  const line = [one(0, 1, 'BREAK', 'BREAK begins'), one(1, 1, "'A'", 'parity fault')];
  expect(count(line)).toEqual({ sent: [0, 1], acknowledged: 0, bad: 2 });
  expect(csv(line, false, (text) => text)).toContain('partner,,"BREAK"');
});

test('a reaction telegram without error is no fault', () => {
  expect(isBad(one(0, 0, 'ETX', 'end of the block; reaction, no error, 0 bytes'))).toBe(false);
  expect(isBad(one(0, 0, 'ETX', 'end of the block; reaction, error 0AH'))).toBe(true);
});

test('what is on the line in a time, also in part', () =>
  expect(between(all, 1.2, 3).map((it) => it.number)).toEqual([1, 2, 3]));

test('CSV in both languages', () => {
  const say = (text: string) => (text === 'wants to send' ? 'will senden' : text);
  expect(csv(all.slice(0, 1), true, say)).toBe(
    'Beginn [s];Ende [s];von;Zeichen;Name;Bedeutung\r\n0,000000;0,500000;Partner;02;"STX";"will senden"\r\n',
  );
  expect(csv(all.slice(3, 4), false, (text) => text)).toContain(
    '3.000000,3.500000,partner,02,"\'""\'","BCC wrong, 41 would be right"',
  );
});

test('typed text becomes a step of a scenario', () => {
  expect(bytesOf('AB 1', 'text', 'CR')).toBe('"AB 1" CR');
  expect(bytesOf('A"ä', 'text', '')).toBe('"A" 22 E4');
  expect(bytesOf(' 02 41 BCC ', 'hex', 'CR')).toBe('02 41 BCC');
  expect(bytesOf('日', 'text', '')).toBe('');
});
