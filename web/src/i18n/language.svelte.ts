import { among } from '../state/alike';
import { kept } from '../state/kept.svelte';

export type Language = 'de' | 'en';

function preferred(): Language {
  return typeof navigator !== 'undefined' && /^de/i.test(navigator.language) ? 'de' : 'en';
}

export const language = kept<Language>('language', preferred(), among('de', 'en'));
