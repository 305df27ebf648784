import { decimal } from '../i18n';

/** A value of a plant as text: bits as 0 and 1, the others with what can be read at a glance. */
export function shown(signal: { binary: boolean; unit: string }, value: number | undefined): string {
  if (value === undefined) return '?';
  if (signal.binary) return value ? '1' : '0';
  const unit = signal.unit === 'degC' ? '°C' : signal.unit;
  const digits = Number.isInteger(value) ? 0 : unit === 'm' ? 2 : 1;
  return `${decimal(value, digits)}${unit ? ` ${unit}` : ''}`;
}
