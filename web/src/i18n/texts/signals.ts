import type { Text, Texts } from '..';

const floors = (german: string, english: string, name: (floor: number) => string): Record<string, Text> =>
  Object.fromEntries([1, 2, 3].map((floor) => [name(floor), [`${german} ${floor}`, `${english} ${floor}`] as const]));

// What the signals of each kind of plant are.

export const sortingPlantSignals = {
  SLIDER_SMALL: ['Schieber klein', 'Slider small'],
  SLIDER_MIDDLE: ['Schieber mittel', 'Slider middle'],
  SLIDER_LARGE: ['Schieber groß', 'Slider large'],
  BARRIER_SMALL: ['Lichtschranke klein', 'Light barrier small'],
  BARRIER_MIDDLE: ['Lichtschranke mittel', 'Light barrier middle'],
  BARRIER_LARGE: ['Lichtschranke groß', 'Light barrier large'],
  BELT: ['Band läuft', 'Belt runs'],
  SPEED: ['Geschwindigkeit', 'Speed'],
  AUTO: ['Kästen kommen von selbst', 'Automatic supply of boxes'],
  NEW_SMALL: ['Klein', 'Small'],
  NEW_MIDDLE: ['Mittel', 'Middle'],
  NEW_LARGE: ['Groß', 'Large'],
  GOOD: ['Richtig sortiert', 'Sorted correctly'],
  WRONG: ['Falsch sortiert', 'Sorted incorrectly'],
  BIN_SMALL: ['Fach klein', 'Bin small'],
  BIN_MIDDLE: ['Fach mittel', 'Bin middle'],
  BIN_LARGE: ['Fach groß', 'Bin large'],
} satisfies Texts;

export const vesselSignals = {
  INLET: ['Einlassventil', 'Inlet valve'],
  OUTLET: ['Auslassventil', 'Outlet valve'],
  LAMP: ['Lampe Entleeren', 'Lamp emptying'],
  HAND_FILL: ['Von Hand füllen', 'Fill manually'],
  START: ['Start', 'Start'],
  STOP: ['Stopp', 'Stop'],
  LEVEL: ['Füllstand', 'Level'],
  MIN: ['Sensor unten', 'Lower sensor'],
  MAX: ['Sensor oben', 'Upper sensor'],
  START_CONTACT: ['Taster Start (Schließer)', 'Button start (normally open)'],
  STOP_CONTACT: ['Taster Stopp (Öffner)', 'Button stop (normally closed)'],
} satisfies Texts;

export const garageDoorSignals = {
  UP: ['Motor auf', 'Motor up'],
  DOWN: ['Motor zu', 'Motor down'],
  LAMP: ['Warnlampe', 'Warning lamp'],
  BUTTON: ['Tor', 'Door'],
  OBSTACLE: ['Jemand steht unter dem Tor', 'Person under the door'],
  POSITION: ['Stellung', 'Position'],
  OPEN: ['Endschalter offen', 'End switch open'],
  CLOSED: ['Endschalter geschlossen', 'End switch closed'],
  BARRIER: ['Lichtschranke', 'Light barrier'],
  CONTACT: ['Taster', 'Button'],
  BOTH: ['Beide Richtungen zugleich', 'Both directions at once'],
  HITS: ['Jemanden getroffen', 'Person hit'],
} satisfies Texts;

export const trafficLightSignals = {
  CARS_RED: ['Autos rot', 'Cars red'],
  CARS_AMBER: ['Autos gelb', 'Cars amber'],
  CARS_GREEN: ['Autos grün', 'Cars green'],
  WALK_RED: ['Fußgänger rot', 'Pedestrians red'],
  WALK_GREEN: ['Fußgänger grün', 'Pedestrians green'],
  WAIT: ['Bitte warten', 'Please wait'],
  LEFT: ['Links', 'Left'],
  RIGHT: ['Rechts', 'Right'],
  LEFT_CONTACT: ['Taster links', 'Button left'],
  RIGHT_CONTACT: ['Taster rechts', 'Button right'],
  DANGER: ['Autos und Fußgänger zugleich grün', 'Cars and pedestrians green at once'],
} satisfies Texts;

export const liftSignals = {
  UP: ['Motor auf', 'Motor up'],
  DOWN: ['Motor ab', 'Motor down'],
  DOOR: ['Tür öffnen', 'Open door'],
  HEIGHT: ['Höhe', 'Height'],
  DOORWAY: ['Türöffnung', 'Doorway'],
  DOOR_OPEN: ['Tür offen', 'Door open'],
  DOOR_CLOSED: ['Tür geschlossen', 'Door closed'],
  FAULTS: ['Gefährliche Bewegungen', 'Dangerous movements'],
  ...floors('Lampe', 'Lamp', (floor) => `LAMP${floor}`),
  ...floors('Ruf', 'Call', (floor) => `CALL${floor}`),
  ...floors('Nach', 'Go to', (floor) => `GO${floor}`),
  ...floors('Etagensensor', 'Floor sensor', (floor) => `FLOOR${floor}`),
  ...floors('Ruftaster', 'Call button', (floor) => `CALL${floor}_CONTACT`),
  ...floors('Kabinentaster', 'Car button', (floor) => `GO${floor}_CONTACT`),
} satisfies Texts;

export const temperatureSignals = {
  LMN: ['Stellwert', 'Manipulated value'],
  HEAT: ['Heizung', 'Heating'],
  COOL: ['Kühlung', 'Cooling'],
  DISTURBANCE: ['Störung', 'Disturbance'],
  AMBIENT: ['Raumtemperatur', 'Room temperature'],
  PV: ['Temperatur', 'Temperature'],
} satisfies Texts;

export const axisSignals = {
  SETPOINT: ['Sollwert', 'Set-point'],
  ENABLE: ['Freigabe Leistungsteil', 'Enable power section'],
  DIRECTION: ['Richtungssignal', 'Direction signal'],
  Q0: ['Schütz Q0', 'Contactor Q0'],
  Q1: ['Schütz Q1', 'Contactor Q1'],
  Q2: ['Schütz Q2', 'Contactor Q2'],
  Q3: ['Schütz Q3', 'Contactor Q3'],
  HAND: ['Handrad', 'Hand wheel'],
  BLOCKED: ['Achse blockiert', 'Axis blocked'],
  EMERGENCY_STOP: ['Not-Halt', 'Emergency stop'],
  SWAPPED: ['Spuren vertauscht', 'Tracks swapped'],
  LOST: ['Verlorene Impulse', 'Lost pulses'],
  A: ['Spur A', 'Track A'],
  B: ['Spur B', 'Track B'],
  N: ['Nullmarke N', 'Zero mark N'],
  REFERENCE: ['Referenzpunktschalter', 'Reference point switch'],
  WORKPIECE: ['Werkstück am Messtaster', 'Workpiece at the length sensor'],
  LOW_SWITCH: ['Endschalter Minus', 'Limit switch minus'],
  HIGH_SWITCH: ['Endschalter Plus', 'Limit switch plus'],
  POSITION: ['Stellung', 'Position'],
  SPEED: ['Geschwindigkeit', 'Speed'],
  ENCODER: ['Stellung des Gebers', 'Position of the encoder'],
} satisfies Texts;
