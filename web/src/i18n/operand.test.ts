import { expect, test } from 'vitest';
import { inEnglish, inGerman } from './operand';

test('inputs, outputs and counters have English letters (S7-MNE-11)', () => {
  const pairs = {
    'E 0.0': 'I 0.0',
    'EB 0': 'IB 0',
    'A 1.7': 'Q 1.7',
    'AD 4': 'QD 4',
    'PEW 752': 'PIW 752',
    'PAB 3': 'PQB 3',
    'Z 1': 'C 1',
  };
  for (const [german, english] of Object.entries(pairs)) {
    expect(inEnglish(german)).toBe(english);
    expect(inGerman(english)).toBe(german);
  }
  expect(inEnglish('E 124.0…126.7')).toBe('I 124.0…126.7');
});

test('all else stays', () => {
  for (const same of ['M 1.0', 'MW 10', 'T 1', 'DB1.DBW 0', '"A 1"', 'plant.Belt.A', 'AR1', 'EN', '', 'I 0.0', 'Q 1.0'])
    expect(inEnglish(same)).toBe(same);
});

test('each operand of a list has its German letters', () => {
  expect(inGerman('qb 1, I 0.0,C 1, Q')).toBe('Ab 1, E 0.0,Z 1, A');
  for (const same of ['AB 1', 'M 1.0', 'DB1.DBW 0', '"Q 1"', 'Conveyor', '']) expect(inGerman(same)).toBe(same);
});
