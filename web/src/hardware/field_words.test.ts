import { expect, test } from 'vitest';
import type { Problem } from '../connection';
import { language, told } from '../i18n';
import { inFields } from './field_words';

const problem = (code: string, text: string, ...values: string[]) =>
  ({ code, text, arguments: values, severity: 'error', file: '', line: 0, column: 0 }) as Problem;
const refusals = [
  problem('P0704', "'hysteresis' must be 0 to 255", 'hysteresis', '0 to 255'),
  problem('P0744', '\'interrupts\' needs interrupts = "process"', 'interrupts', 'interrupts = "process"'),
  problem('P0737', 'mode "pwm" is not possible with CPU; valid: endless', 'mode "pwm"', 'CPU', 'endless'),
];

test('a refusal names the field, not the key of the file', () => {
  language.value = 'de';
  expect(refusals.map((one) => told(inFields(one, 'count')))).toEqual([
    '„Hysterese“ muss sein: 0 bis 255',
    '„Prozessalarm“ setzt voraus: „Alarme: Prozess“',
    '„Betriebsart: Pulsweitenmodulation“ ist bei CPU nicht möglich; möglich sind: endless',
  ]);
  language.value = 'en';
  expect(refusals.map((one) => told(inFields(one, 'count')))).toEqual([
    '“Hysteresis” must be 0 to 255',
    '“Hardware interrupt” needs “Interrupts: process”',
    '“Operating mode: Pulse width modulation” is not possible with CPU; valid: endless',
  ]);
});

test('what is no field stays as it is', () => {
  const other = problem('P0702', "TOML error: 'nothing'", "'nothing'");
  expect(inFields(other)).toEqual({ ...other, arguments: undefined });
});
