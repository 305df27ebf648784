// Keys as a German keyboard names them.
import type { Language } from './language.svelte';

const german: Record<string, string> = { Ctrl: 'Strg', Shift: 'Umschalt', Del: 'Entf', Home: 'Pos1', End: 'Ende' };

/** "Ctrl Del" is "Strg Entf" on the German page. */
export const keyNames = (keys: string, language: Language): string =>
  language === 'de' ? keys.replace(/[A-Za-z]+/g, (key) => german[key] ?? key) : keys;
