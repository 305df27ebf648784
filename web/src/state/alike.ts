// What a browser has stored may be anything: tests of the shape that is wanted.

export type Good = (stored: unknown) => boolean;
type Fields = Record<string, unknown>;

export const isRecord = (stored: unknown): stored is Fields =>
  typeof stored === 'object' && stored !== null && !Array.isArray(stored);
export const isText: Good = (stored) => typeof stored === 'string';
export const isNumber: Good = Number.isFinite;

/** One of these. */
export const among =
  (...words: readonly unknown[]): Good =>
  (stored) =>
    words.includes(stored);

export const listOf =
  (good: Good): Good =>
  (stored) =>
    Array.isArray(stored) && stored.every(good);

/** Those of the values that are good, by their names. */
export const goodOnes = (stored: unknown, good: Good): Fields =>
  isRecord(stored) ? Object.fromEntries(Object.entries(stored).filter(([, value]) => good(value))) : {};

/** These fields at least; `may`: those that can be missing. */
export const objectOf =
  (fields: Record<string, Good>, may: Record<string, Good> = {}): Good =>
  (stored) =>
    isRecord(stored) &&
    Object.entries(fields).every(([name, good]) => good(stored[name])) &&
    Object.entries(may).every(([name, good]) => stored[name] === undefined || good(stored[name]));

/** Of the kind of this value; the elements of a list and the values of an object, too. */
export function alike(other: unknown): Good {
  if (typeof other === 'number') return isNumber;
  if (Array.isArray(other)) return listOf(other.length > 0 ? alike(other[0]) : () => true);
  return isRecord(other) ? isRecord : (stored) => typeof stored === typeof other;
}
