import { expect, test } from 'vitest';
import { rowsInSight } from './virtual';

test('short tables are there as a whole', () => {
  expect(rowsInSight(0, 600, 24, 10)).toEqual({ first: 0, end: 10 });
  expect(rowsInSight(0, 600, 24, 0)).toEqual({ first: 0, end: 0 });
});

test('of a long one the rows in sight with some around them', () => {
  expect(rowsInSight(0, 480, 24, 1000)).toEqual({ first: 0, end: 32 });
  expect(rowsInSight(500 * 24, 480, 24, 1000)).toEqual({ first: 488, end: 528 });
  expect(rowsInSight(990 * 24, 480, 24, 1000)).toEqual({ first: 976, end: 1000 });
});

test('a row more or less above the edge moves nothing; what has gone away does not count', () => {
  expect(rowsInSight(504 * 24, 480, 24, 1000)).toEqual(rowsInSight(505 * 24, 456, 24, 1000));
  expect(rowsInSight(5000 * 24, 480, 24, 100)).toEqual({ first: 100, end: 100 });
  expect(rowsInSight(-300, 480, 24, 1000).first).toBe(0);
});
