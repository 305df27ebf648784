import { expect, test } from 'vitest';
import { language } from '../i18n';
import {
  append,
  csv,
  laned,
  laneShare,
  namesOf,
  scaleOf,
  shownValue,
  titleOf,
  type Columns,
  type Curve,
} from './curves';

const curve = (operand: string, bits: number, unit = ''): Curve => ({
  operand,
  address: operand,
  symbol: '',
  unit,
  bits,
});
const curves = [curve('MW 10', 16), curve('E 0.0', 1), curve('A 1.0', 1)];

test('rows follow each other; when time goes back they begin anew', () => {
  const first = append([[], [], []], [[1000, 1, null]]);
  const second = append(first, [[2000, 2, 3]]);
  expect(second).toEqual([
    [1, 2],
    [1, 2],
    [null, 3],
  ]);
  expect(append(second, [[500, 9, 9]])).toEqual([[0.5], [9], [9]]);
});

test('bits lie in lanes, the first on top; numbers stay', () => {
  const columns: Columns = [
    [0, 1],
    [5, 6],
    [0, 1],
    [1, null],
  ];
  expect(laned(columns, curves)).toEqual([
    [0, 1],
    [5, 6],
    [1.125, 1.875],
    [0.875, null],
  ]);
  expect(laneShare(curves)).toBeCloseTo(0.22);
  expect(laneShare([curves[0]!])).toBe(0);
  expect(laneShare([curves[1]!])).toBe(1);
});

test('curves of one unit share an axis', () => {
  expect(scaleOf(curve('plant.A.B', 0, '%'))).toBe(scaleOf(curve('plant.A.C', 0, '%')));
  expect(scaleOf(curves[0]!)).not.toBe(scaleOf(curves[1]!));
});

test('a CSV file has what is in sight, with quoted names', () => {
  const named = { ...curves[0]!, symbol: 'Level, "north"' };
  expect(
    csv(
      [
        [0, 1, 2],
        [5, 6, null],
      ],
      [named],
      1,
      2,
    ),
  ).toBe('time [s],"Level, ""north"""\r\n1.000,6\r\n2.000,\r\n');
});

test('a German CSV file has semicolons and decimal commas', () => {
  const speed = { ...curves[0]!, symbol: 'Speed', unit: '%' };
  const columns: Columns = [
    [1, 2],
    [0.5, 60],
  ];
  expect(csv(columns, [speed], 0, 5, true)).toBe('Zeit [s];Speed [%]\r\n1,000;0,5\r\n2,000;60\r\n');
});

test('values are short', () => {
  expect(shownValue(curve('a', 0, 'degC'), 20.123456)).toBe('20.123 °C');
  expect(shownValue(curve('a', 1), 1)).toBe('1');
  expect(shownValue(curve('a', 1), null)).toBe('–');
  language.value = 'de';
  expect(shownValue(curve('a', 32), 21.5)).toBe('21,500');
  language.value = 'en';
});

test('a curve keeps the name that the user gave it, with its other ones below', () => {
  const names = (operand: string, address: string, symbol = '') => {
    const { name, others } = namesOf({ ...curve(operand, 32), address, symbol });
    return [name, ...others].join(' | ');
  };
  expect(names('DB1.R', 'DB1.DBD 14')).toBe('DB1.R | DB1.DBD 14');
  expect(names('"Level"', 'MW 10', 'Level')).toBe('"Level" | MW 10');
  expect(names('mw10', 'MW 10', 'Level')).toBe('MW 10 | Level');
  expect(names('plant.Belt.SPEED', 'plant.Belt.SPEED')).toBe('plant.Belt.SPEED');
  expect(names('E 0.0', 'E 0.0')).toBe('I 0.0');
  expect(titleOf({ ...curve('DB1.R', 32), address: 'DB1.DBD 14' })).toBe('DB1.R');
});
