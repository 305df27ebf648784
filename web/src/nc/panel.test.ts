import { expect, test } from 'vitest';
import { axes, dataOf, offsets, page, PAGE, ranges, tool } from './panel';

test('a sheet names its data row by row', () => {
  expect(dataOf(axes).slice(0, 5)).toEqual([
    'nc.position 1',
    'nc.workpiece_position 1',
    'nc.feed 1',
    'nc.following_error 1',
    'nc.position 2',
  ]);
  expect(dataOf(offsets(2)).slice(0, 3)).toEqual([
    'nc.settable_offset 2.1',
    'nc.settable_offset 2.1.1',
    'nc.programmable_offset 1.1',
  ]);
  expect(dataOf(tool(7))[2]).toBe('nc.tool 7.2');
});

test('a page stays inside its range and ends with it', () => {
  const [first, , central] = ranges.R;
  expect(dataOf(page(first!, 50))).toHaveLength(PAGE);
  expect(dataOf(page(first!, 495))).toEqual([495, 496, 497, 498, 499].map((row) => `nc.R 1.${row}`));
  expect(page(central!, 3).first).toBe(900);
  expect(page(central!, 5000)).toMatchObject({ first: 999, rows: 1 });
  expect(page(first!, NaN).first).toBe(0);
});
