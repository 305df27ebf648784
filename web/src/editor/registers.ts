// Registers as they are named in the language of the page: RLO and ACCU for an English one; "DB 2" says what it is by itself.
import type { Language } from '../i18n';

export const registerName = (name: string, language: Language): string =>
  language === 'de' ? name : name.replace(/^AKKU/, 'ACCU');

/** Of "DB" and "DI" the number: the name stands before it. */
export const registerValue = (value: string): string => value.replace(/^DB (?=\d)/, '');
