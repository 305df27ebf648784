import { expect, test } from 'vitest';
import { parseTable, printTable } from './table';
import { atOnce, parseTriggers, printTriggers } from './triggers';

test('triggers come back as they were written', () => {
  const monitor = { point: 'begin', once: false } as const;
  const modify = { point: 'stop', once: true } as const;
  const line = printTriggers(monitor, modify);
  expect(line).toBe('// trigger: monitor begin every; modify stop once');
  expect(parseTriggers(`// operand ; format ; modify value\n${line}\nMW 2\n`)).toEqual({ monitor, modify });
});

test('without a line everything happens at once', () => {
  expect(printTriggers(atOnce, atOnce)).toBe('');
  expect(parseTriggers('MW 2 // trigger: monitor begin once')).toEqual({ monitor: atOnce, modify: atOnce });
});

test('the line stands in the table and is no row of it', () => {
  const triggers = { monitor: { point: 'end', once: true }, modify: atOnce } as const;
  const text = printTable(
    [{ operand: 'MW 2', format: 'DEC', modify: '' }],
    printTriggers(triggers.monitor, triggers.modify),
  );
  expect(parseTriggers(text)).toEqual(triggers);
  expect(parseTable(text)).toHaveLength(1);
});
