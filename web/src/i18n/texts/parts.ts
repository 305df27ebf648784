import type { Texts } from '..';

// Parts of plants that have no drawing of their own: their kinds, and what their signals are.

export const kinds = {
  'bouncing switch': ['Prellender Schalter', 'Bouncing switch'],
  encoder: ['Inkrementalgeber', 'Incremental encoder'],
  'first order': ['Strecke erster Ordnung', 'First-order process'],
  generator: ['Signalgenerator', 'Signal generator'],
  'pulse train': ['Impulsgeber', 'Pulse generator'],
  tank: ['Tank', 'Tank'],
  valve: ['Stellventil mit Motor', 'Motorised valve'],
} satisfies Texts;

export const bouncingSwitchSignals = {
  PRESSED: ['Gedrückt', 'Pressed'],
  CONTACT: ['Kontakt', 'Contact'],
} satisfies Texts;

export const encoderSignals = {
  SPEED: ['Drehzahl', 'Speed'],
  AXIS: ['Achse', 'Axis'],
  POSITION: ['Stellung', 'Position'],
  A: ['Spur A', 'Track A'],
  B: ['Spur B', 'Track B'],
} satisfies Texts;

export const firstOrderSignals = {
  LMN: ['Stellwert', 'Manipulated value'],
  DISTURBANCE: ['Störgröße', 'Disturbance'],
  OFFSET: ['Arbeitspunkt', 'Offset'],
  PV: ['Istwert', 'Process value'],
} satisfies Texts;

export const generatorSignals = {
  TARGET: ['Zielwert', 'Target'],
  SLOPE: ['Steigung', 'Slope'],
  AMPLITUDE: ['Amplitude', 'Amplitude'],
  PERIOD: ['Periode', 'Period'],
  VALUE: ['Wert', 'Value'],
} satisfies Texts;

export const pulseTrainSignals = {
  FREQUENCY: ['Frequenz', 'Frequency'],
  DUTY: ['Tastverhältnis', 'Duty cycle'],
  PULSES: ['Impulse', 'Pulses'],
} satisfies Texts;

export const tankSignals = {
  INFLOW: ['Zufluss', 'Inflow'],
  OUTFLOW: ['Abfluss', 'Outflow'],
  FILL: ['Füllen', 'Fill'],
  DRAIN: ['Entleeren', 'Drain'],
  LEVEL: ['Füllstand', 'Level'],
  FULL: ['Voll', 'Full'],
  EMPTY: ['Leer', 'Empty'],
} satisfies Texts;

export const valveSignals = {
  UP: ['Motor auf', 'Motor open'],
  DOWN: ['Motor zu', 'Motor close'],
  STUCK: ['Klemmt', 'Jammed'],
  POSITION: ['Stellung', 'Position'],
  LMNR_HS: ['Endlage offen', 'End switch open'],
  LMNR_LS: ['Endlage geschlossen', 'End switch closed'],
  BOTH: ['Beide Richtungen zugleich', 'Both directions at once'],
} satisfies Texts;
