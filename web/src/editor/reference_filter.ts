import type { Reference } from '../connection/protocol';
import { inEnglish } from '../i18n';

/** Rows that have the text somewhere, whatever its letters; several words: all of them. */
export function containing(rows: readonly Reference[], text: string): Reference[] {
  const words = text.toLowerCase().replace(/"/g, '').split(/\s+/).filter(Boolean);
  return rows.filter(({ operand, symbol, block, instruction }) => {
    const row = `${operand}\n${inEnglish(operand)}\n${symbol}\n${block}\n${instruction}`.toLowerCase();
    return words.every((word) => row.includes(word));
  });
}
