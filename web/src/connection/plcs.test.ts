import { expect, test } from 'vitest';
import { enterPlc, pageAt, plcOf } from './plcs';

const page = 'http://127.0.0.1:8080/?token=abc&plc=3#/io';

test('the address says at which PLC the page is', () => {
  expect(plcOf(page)).toBe(3);
  expect(plcOf('http://127.0.0.1:8080/')).toBe(1);
  for (const wrong of ['0', '-1', '1.5', 'x']) expect(plcOf(`http://127.0.0.1/?plc=${wrong}`)).toBe(1);
});

test('the address of another PLC keeps the token', () => {
  expect(pageAt(page, 2, 'projects')).toBe('http://127.0.0.1:8080/?token=abc&plc=2#/projects');
  expect(pageAt(page, 1, 'io')).toBe('http://127.0.0.1:8080/?token=abc#/io');
});

test('only who is elsewhere has to enter', () => {
  const kept: unknown[] = [];
  const connection = { keep: (...given: unknown[]) => (kept.push(given), { update() {}, drop() {} }) };
  enterPlc(connection as never, 'http://127.0.0.1/');
  enterPlc(connection as never, page);
  expect(kept).toEqual([['plcs.enter', { plc: 3 }]]);
});
