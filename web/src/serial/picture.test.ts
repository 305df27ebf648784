import { expect, test, vi } from 'vitest';
import { draw, scale, stepOf, timeText } from './picture';

vi.mock('../trends/look', () => ({ colour: (name: string) => name }));

test('steps of the axis are 1, 2, 5 times a power of ten', () => {
  expect(stepOf(0.9)).toBe(1);
  expect(stepOf(1)).toBe(1);
  expect(stepOf(1.1)).toBe(2);
  expect(stepOf(0.003)).toBeCloseTo(0.005, 9);
  expect(stepOf(60)).toBe(100);
});

test('times have the digits that the step needs', () => {
  expect(timeText(61.5, 0.5)).toBe('0:01:01.5');
  expect(timeText(1.0002, 0.0002)).toBe('0:00:01.0002');
});

test('pixels and seconds', () => {
  const to = scale(176, { from: 1, to: 3 });
  expect(to.x(1)).toBe(76);
  expect(to.x(3)).toBe(176);
  expect(to.time(126)).toBe(2);
});

test('no time stands on the axis before the PLC began', () => {
  const texts: string[] = [];
  const pen = { fillText: (text: string) => texts.push(text), measureText: () => ({ width: 0 }) };
  const rest = new Proxy(pen, { get: (of, name) => Reflect.get(of, name) ?? (() => {}), set: () => true });
  const look = { width: 1076, height: 168, hexadecimal: false, names: ['X27', 'Partner'] as [string, string] };
  draw(rest as unknown as CanvasRenderingContext2D, [], { from: -0.5, to: 0.5 }, look);
  expect(texts.filter((text) => text.includes('-'))).toEqual([]);
  expect(texts).toContain('0:00:00.2');
});
