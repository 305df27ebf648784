import type { Texts } from '..';

// Parts of plants that have no drawing of their own: their kinds, and what their signals are.

export const kinds = {
  axis: ['Achse mit Antrieb und Geber', 'Axis with drive and encoder'],
  'bouncing switch': ['Prellender Schalter', 'Bouncing switch'],
  encoder: ['Inkrementalgeber', 'Incremental encoder'],
  'first order': ['Strecke erster Ordnung', 'First-order process'],
  generator: ['Signalgenerator', 'Signal generator'],
  'pulse train': ['Impulsgeber', 'Pulse generator'],
  tank: ['Tank', 'Tank'],
  valve: ['Stellventil mit Motor', 'Motorised valve'],
} satisfies Texts;

export const axisSignals = {
  SETPOINT: ['Sollwert', 'Set-point'],
  ENABLE: ['Freigabe Leistungsteil', 'Enable of the power section'],
  DIRECTION: ['Richtungssignal', 'Direction signal'],
  Q0: ['Schütz Q0', 'Contactor Q0'],
  Q1: ['Schütz Q1', 'Contactor Q1'],
  Q2: ['Schütz Q2', 'Contactor Q2'],
  Q3: ['Schütz Q3', 'Contactor Q3'],
  HAND: ['Handrad', 'Hand wheel'],
  BLOCKED: ['Achse blockiert', 'Axis blocked'],
  EMERGENCY_STOP: ['Not-Halt', 'Emergency stop'],
  A: ['Spur A', 'Track A'],
  B: ['Spur B', 'Track B'],
  N: ['Nullmarke N', 'Zero mark N'],
  REFERENCE: ['Referenzpunktschalter', 'Reference point switch'],
  WORKPIECE: ['Werkstück am Messtaster', 'Workpiece at the length sensor'],
  LOW_SWITCH: ['Endschalter Minus', 'Limit switch minus'],
  HIGH_SWITCH: ['Endschalter Plus', 'Limit switch plus'],
  POSITION: ['Stellung', 'Position'],
  SPEED: ['Geschwindigkeit', 'Speed'],
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
