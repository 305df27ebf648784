import { alike, goodOnes, isRecord, type Good } from './alike';

/** A value of this browser that outlives a reload: language, theme, tiles. What is stored and is `good` counts: another version of the
 * page, or a hand, may have written it. */
export function kept<T>(key: string, otherwise: T, good: Good = alike(otherwise)): { value: T } {
  return holding(key, read(key, otherwise, good));
}

/** Values by name: of a project, of a plant. A bad one goes alone. */
export function keptByName<V>(key: string, good: Good): { value: Record<string, V> } {
  return holding(key, goodOnes(read(key, {}, isRecord), good) as Record<string, V>);
}

function holding<T>(key: string, first: T): { value: T } {
  let value = $state(first);
  return {
    get value() {
      return value;
    },
    set value(next: T) {
      value = next;
      try {
        localStorage.setItem(`merker.${key}`, JSON.stringify(next));
      } catch {
        // A browser that keeps nothing: the value lives as long as the page.
      }
    },
  };
}

function read<T>(key: string, otherwise: T, good: Good): T {
  try {
    const text = localStorage.getItem(`merker.${key}`);
    const stored: unknown = text === null ? otherwise : JSON.parse(text);
    return good(stored) ? (stored as T) : otherwise;
  } catch {
    return otherwise;
  }
}
