// Pulses as a person reads them, and the way that they are.
import { language } from '../../i18n';
import { isNumber } from '../../state/alike';
import { keptByName } from '../../state/kept.svelte';
import { plc } from '../../state/plc.svelte';
import { pulsesPerEncoderTurn, turn } from './rail';

/** The way of one turn of the encoder in mm, by plant: the SFBs know pulses only, so it is of the picture alone. */
const pitches = keptByName<number>('pitch', isNumber);
const USUAL_PITCH = 10;
const keyOf = (plant: string) => `${plc.project?.folder ?? ''} ${plant}`;

export const pitchOf = (plant: string): number => pitches.value[keyOf(plant)] ?? USUAL_PITCH;
export function setPitch(plant: string, mm: number): void {
  if (Number.isFinite(mm) && mm > 0) pitches.value = { ...pitches.value, [keyOf(plant)]: mm };
}

const locale = () => (language.value === 'de' ? 'de-DE' : 'en-GB');
export const whole = (value: number) => new Intl.NumberFormat(locale()).format(Math.floor(value));
export const decimal = (value: number, digits: number) =>
  new Intl.NumberFormat(locale(), { minimumFractionDigits: digits, maximumFractionDigits: digits }).format(value);

/** Degrees of a rotary axis, else mm. */
export function wayText(parameters: Record<string, number>, pulses: number, pitch: number): string {
  const { revolution = 0 } = parameters;
  if (revolution > 0) return `${decimal(360 * turn(revolution, pulses), 1)}°`;
  return `${decimal((pulses / pulsesPerEncoderTurn(parameters)) * pitch, 1)} mm`;
}
