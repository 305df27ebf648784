import type { Texts } from '..';

// Parts of plants that have no drawing of their own: their kinds, and what their signals are.

export const kinds = {
  'bouncing switch': ['Prellender Schalter', 'Bouncing switch'],
  encoder: ['Inkrementalgeber', 'Incremental encoder'],
  'first order': ['Strecke erster Ordnung', 'First-order process'],
  generator: ['Signalgenerator', 'Signal generator'],
  'positioning drive': ['Positionierantrieb', 'Positioning drive'],
  'pulse train': ['Impulsgeber', 'Pulse generator'],
  'speed drive': ['Drehzahlantrieb', 'Speed drive'],
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

export const driveSignals = {
  BUS: ['Master da', 'Master there'],
  STW1: ['Steuerwort 1', 'Control word 1'],
  NSOLL_A: ['Drehzahlsollwert', 'Speed setpoint'],
  SATZANW: ['Satzanwahl', 'Block selection'],
  MDI_TARPOS: ['Zielposition', 'Target position'],
  MDI_VELOCITY: ['Geschwindigkeit', 'Velocity'],
  MDI_ACC: ['Beschleunigungsoverride', 'Acceleration override'],
  MDI_DEC: ['Verzögerungsoverride', 'Deceleration override'],
  MDI_MOD: ['Positioniermodus', 'Positioning mode'],
  BLOCKED: ['Blockiert', 'Blocked'],
  EXTERNAL: ['Externe Störung', 'External fault'],
  ZSW1: ['Zustandswort 1', 'Status word 1'],
  NIST_A: ['Drehzahlistwert', 'Actual speed'],
  AKTSATZ: ['Aktueller Satz', 'Active block'],
  XIST_A: ['Lageistwert', 'Actual position'],
  STATE: ['Zustand S1 bis S5', 'State S1 to S5'],
  FAULT: ['Störung', 'Fault'],
  WARNING: ['Warnung', 'Warning'],
  POSITION: ['Ort der Achse', 'Place of the axis'],
  SPEED: ['Geschwindigkeit der Achse', 'Speed of the axis'],
  LOW_SWITCH: ['Endschalter minus', 'Limit switch minus'],
  HIGH_SWITCH: ['Endschalter plus', 'Limit switch plus'],
  CAM: ['Referenznocken', 'Reference cam'],
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
