// Characters of a serial line as fields show them: two hexadecimal digits each, "0D 0A".
import type { Parameter } from './plan.svelte';

const hex = (value: number) => value.toString(16).toUpperCase().padStart(2, '0');

export const showCharacters = (value: Parameter['value']): string =>
  Array.isArray(value) ? value.map((one) => hex(Number(one))).join(' ') : typeof value === 'number' ? hex(value) : '';

/** A number, or a list; undefined if the text is something else. */
export function parseCharacters(text: string, list: boolean): number | number[] | undefined {
  const words = text.trim().split(/[\s,]+/);
  if (!words.every((word) => /^(0x)?[0-9a-f]{1,2}$/i.test(word))) return undefined;
  const values = words.map((word) => parseInt(word.replace(/^0x/i, ''), 16));
  return list ? values : values.length === 1 ? values[0] : undefined;
}
