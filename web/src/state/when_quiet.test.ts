import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { whenQuiet } from './when_quiet';

const listeners = new Set<() => void>();
beforeEach(() => {
  vi.useFakeTimers();
  vi.stubGlobal('addEventListener', (_: string, listener: () => void) => listeners.add(listener));
  vi.stubGlobal('removeEventListener', (_: string, listener: () => void) => listeners.delete(listener));
});
afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
  listeners.clear();
});

test('once, after the last time that it was asked for', () => {
  const action = vi.fn();
  const later = whenQuiet(action);
  for (const _ of [1, 2, 3]) {
    later.ask();
    vi.advanceTimersByTime(200);
  }
  expect(action).not.toHaveBeenCalled();
  vi.advanceTimersByTime(100);
  expect(action).toHaveBeenCalledTimes(1);
  expect(listeners.size).toBe(0);
});

test('at once when the page goes, and not again', () => {
  const action = vi.fn();
  whenQuiet(action).ask();
  for (const leave of [...listeners]) leave();
  vi.advanceTimersByTime(1000);
  expect(action).toHaveBeenCalledTimes(1);
});

test('never when it was done meanwhile', () => {
  const action = vi.fn();
  const later = whenQuiet(action);
  later.ask();
  later.cancel();
  vi.advanceTimersByTime(1000);
  expect(action).not.toHaveBeenCalled();
});
