/** A value of this browser that outlives a reload: language, theme, tiles. */
export function kept<T>(key: string, otherwise: T): { value: T } {
  let value = $state(read(key, otherwise));
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

function read<T>(key: string, otherwise: T): T {
  try {
    const text = localStorage.getItem(`merker.${key}`);
    return text === null ? otherwise : (JSON.parse(text) as T);
  } catch {
    return otherwise;
  }
}
