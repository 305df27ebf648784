import { expect, test } from 'vitest';
import { failedOf, statusOf } from './failed';

const level = {
  ob: 1,
  priority: 1,
  block: 'FC 1',
  offset: 4,
  file: 'main.awl',
  line: 8,
  registers: { AKKU1: '0000FFFF', AKKU2: '00001234', STW: '0006', DB: 'DB 5', DI: '-' },
};

test('the statement of the level that was interrupted last', () => {
  const below = { ...level, block: 'OB 1', line: 20 };
  expect(failedOf([level, below])).toMatchObject({ block: 'FC 1', file: 'main.awl', line: 8 });
  expect(failedOf([])).toBeNull();
  expect(failedOf([{ ...level, file: undefined }] as never)).toBeNull();
});

test('its registers as a row of the program status', () => {
  // VKE and STA are bits 1 and 2 of the status word.
  expect(statusOf(failedOf([level])!)).toEqual([8, '1', '1', '0', '0000FFFF', '00001234', '', '', '0006', 'DB 5', '']);
});
