import { decimal } from '../i18n';

/** Virtual time as h:mm:ss.mmm, from nanoseconds. */
export function duration(ns: number): string {
  const ms = Math.floor(ns / 1e6);
  const two = (value: number) => String(value).padStart(2, '0');
  const seconds = Math.floor(ms / 1000);
  const clock = `${Math.floor(seconds / 3600)}:${two(Math.floor(seconds / 60) % 60)}:${two(seconds % 60)}`;
  return `${clock}.${String(ms % 1000).padStart(3, '0')}`;
}

/** A cycle time: the CPU measures whole milliseconds, so 0 is less than one. */
export function milliseconds(ms: number): string {
  if (ms === 0) return '< 1 ms';
  return `${decimal(ms, Number.isInteger(ms) ? 0 : 2)} ms`;
}
