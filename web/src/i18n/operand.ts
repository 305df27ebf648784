// Operands in the words of the page's language. The server's are German (S7-MNE-11); sources stay as they are written.
import { language } from './language.svelte';

const ENGLISH: Record<string, string> = { E: 'I', A: 'Q', Z: 'C' };

/** "EB 0" is "IB 0", "PAW 752" is "PQW 752" and "Z 1" is "C 1" in English; symbols and data stay. */
export const inEnglish = (operand: string): string =>
  operand.replace(/^(P?)([EAZ])(?=[BWD]?\s?\d|$)/, (_, outside: string, area: string) => outside + ENGLISH[area]!);

const GERMAN = Object.fromEntries(Object.entries(ENGLISH).map(([german, english]) => [english, german]));

/** The way back, of each operand of a list: "QB 1, C 1" is "AB 1, Z 1". A program of STEP 5 knows no other words. */
export const inGerman = (operands: string): string =>
  operands.replace(
    /(^|,)(\s*P?)([IQC])(?=[BWD]?\s?\d|\s*(?:,|$))/gi,
    (_, comma: string, outside: string, area: string) => comma + outside + GERMAN[area.toUpperCase()]!,
  );

export const operandText = (operand: string): string => (language.value === 'en' ? inEnglish(operand) : operand);
