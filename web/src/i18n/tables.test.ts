// Tables of the page that the program has as well: the rows are the same.
import { expect, test } from 'vitest';
import { instructions } from '../editor/mnemonics';
import { FORMATS } from '../state/formats';
import { read } from './sources';

test('the display formats are those of the monitor', () => {
  const rows = read('src/tool/monitor/display_format.cpp').matchAll(/\{\w+, "(\w+)", (\d+), (\d+)\}/g);
  const formats = [...rows].map(([, name, shortest, widest]) => [name, Number(shortest), Number(widest)]);
  expect(formats.length).toBeGreaterThan(10);
  expect(FORMATS).toEqual(formats);
});

test('the mnemonics of both settings are those of the instructions', () => {
  const rows = read('src/s7/mc7/operations.inc').matchAll(/^OPERATION\(\w+,\s*"([^"]*)",\s*"([^"]*)"/gm);
  const pairs = [...rows].map(([, german, international]) => [german, international] as const);
  expect(pairs.length).toBeGreaterThan(150);
  const different = new Set(pairs.filter(([german, international]) => german !== international).map(String));
  expect(instructions.map(String).sort()).toEqual([...different].sort());
});
