import { expect, test } from 'vitest';
import { clockOf, clockText } from './clock';

test('the local time of this computer', () => {
  expect(clockOf(new Date(2024, 1, 9, 8, 7, 6, 5))).toEqual({ date: '2024-02-09', time: '08:07:06', parts: '005' });
});

test('what is typed; seconds can be left out', () => {
  expect(clockText(' 2024-02-09 ', '08:07 ')).toBe('2024-02-09 08:07:00');
  expect(clockText('2024-02-09', '08:07:06.5')).toBe('2024-02-09 08:07:06.5');
  expect(clockText('', 'noon')).toBe(' noon');
  expect(clockText('24.12.2024', '12:00:00')).toBe('2024-12-24 12:00:00');
  expect(clockText(' 1.2.2024 ', '12:00')).toBe('2024-02-01 12:00:00');
});
