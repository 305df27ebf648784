import { language, type Text } from '../i18n';
import * as parts from '../i18n/texts/parts';
import * as signals from '../i18n/texts/signals';

export const SIGNALS: Record<string, Record<string, Text>> = {
  'sorting plant': signals.sortingPlantSignals,
  vessel: signals.vesselSignals,
  'garage door': signals.garageDoorSignals,
  'traffic light': signals.trafficLightSignals,
  lift: signals.liftSignals,
  temperature: signals.temperatureSignals,
  axis: signals.axisSignals,
  'bouncing switch': parts.bouncingSwitchSignals,
  encoder: parts.encoderSignals,
  'first order': parts.firstOrderSignals,
  generator: parts.generatorSignals,
  'positioning drive': parts.driveSignals,
  'pulse train': parts.pulseTrainSignals,
  'speed drive': parts.driveSignals,
  tank: parts.tankSignals,
  valve: parts.valveSignals,
};

/** What a signal is, in words; its own name where there are none. */
export function signalName(kind: string, signal: string): string {
  return SIGNALS[kind]?.[signal]?.[language.value === 'de' ? 0 : 1] ?? signal;
}
