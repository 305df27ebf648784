import { language } from './language.svelte';

export { language, type Language } from './language.svelte';
export { inEnglish, inGerman, operandText } from './operand';
export { described, figure, said, told } from './said';

/** German and English of one text. `{name}` stands for a value, `{name|one|many}` for the word that its number takes. */
export type Text = readonly [german: string, english: string];
export type Texts = Record<string, Text>;

/** 0,5 in German. */
export const inNumbers = (text: string): string => (language.value === 'de' ? text.replace('.', ',') : text);

/** A number in a sentence. Values of the PLC as its programs write them (2.15e+001) keep their point. */
export const decimal = (value: number, digits: number): string => inNumbers(value.toFixed(digits));

export const filled = (text: string, values: Record<string, string | number>): string =>
  text.replace(/\{(\w+)(?:\|([^|}]*)\|([^|}]*))?\}/g, (whole, name: string, one?: string, many?: string) =>
    String((one === undefined ? values[name] : String(values[name]) === '1' ? one : many) ?? whole),
  );

/** The function that a view takes its words from: t('key', {name: value}). Follows the language switch. */
export function translator<T extends Texts>(texts: T) {
  return (key: keyof T & string, values: Record<string, string | number> = {}): string => {
    const text = texts[key]![language.value === 'de' ? 0 : 1];
    return filled(text, values);
  };
}
