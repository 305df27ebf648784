// What the page knows of each kind of plant: where its signals stand in the drawing, what a person operates, what is counted.
import type { Component } from 'svelte';
import { language, type Text, type Texts } from '../i18n';
import { axis } from '../i18n/texts/axis';
import { kinds } from '../i18n/texts/parts';
import type { Axis as AxisRow } from '../connection/protocol';
import type { Points } from './axis/points';
import Axis from './drawings/Axis.svelte';
import GarageDoor from './drawings/GarageDoor.svelte';
import Lift from './drawings/Lift.svelte';
import SortingPlant from './drawings/SortingPlant.svelte';
import Temperature from './drawings/Temperature.svelte';
import TrafficLight from './drawings/TrafficLight.svelte';
import Vessel from './drawings/Vessel.svelte';

/** In units of the drawing, which is 960 wide. */
export interface Place {
  signal: string;
  x: number;
  y: number;
}

/** A signal that is stuck, by the name that the fault has in the plant. */
export interface KindFault {
  signal: string;
  /** What it is stuck at; without: what it has. */
  at?: number;
  title: Text;
}

/** What the CPU wants of its axis. */
export interface Scene {
  axis: AxisRow | null;
  shown: Record<string, number>;
  points?: Points;
}

export interface Drawn {
  values: Record<string, number>;
  name: string;
  parameters: Record<string, number>;
  scene: Scene;
  /** Whether a terminal has the signal. */
  wired: (signal: string) => boolean;
}

export interface Kind {
  title: Text;
  height: number;
  drawing: Component<Drawn>;
  /** Sensors and actuators in the drawing. */
  tags: Place[];
  /** Those of them that a plant with these parameters does not have. */
  without?: (parameters: Record<string, number>) => string[];
  /** Those that nothing is drawn of as long as they are at no terminal. */
  ifWired?: string[];
  faults?: KindFault[];
  /** Buttons in the drawing that are 1 while they are pressed. */
  pushes: Place[];
  /** Below the drawing. */
  toggles: string[];
  ranges: string[];
  /** How well it goes, and what must not happen. */
  good: string[];
  bad: string[];
}

const nothing = { pushes: [], toggles: [], ranges: [], good: [], bad: [] };

const KINDS: Record<string, Kind> = {
  'sorting plant': {
    ...nothing,
    title: ['Sortieranlage für Raaco-Kästen', 'Sorting plant for boxes'],
    height: 420,
    drawing: SortingPlant,
    tags: [
      { signal: 'BARRIER_LARGE', x: 372, y: 62 },
      { signal: 'BARRIER_MIDDLE', x: 372, y: 102 },
      { signal: 'BARRIER_SMALL', x: 372, y: 142 },
      { signal: 'SLIDER_SMALL', x: 508, y: 42 },
      { signal: 'SLIDER_MIDDLE', x: 633, y: 42 },
      { signal: 'SLIDER_LARGE', x: 758, y: 42 },
    ],
    pushes: [
      { signal: 'NEW_SMALL', x: 66, y: 370 },
      { signal: 'NEW_MIDDLE', x: 166, y: 370 },
      { signal: 'NEW_LARGE', x: 266, y: 370 },
    ],
    toggles: ['AUTO', 'BELT'],
    ranges: ['SPEED'],
    good: ['GOOD'],
    bad: ['WRONG'],
  },
  vessel: {
    ...nothing,
    title: ['Behälter', 'Vessel'],
    height: 420,
    drawing: Vessel,
    tags: [
      { signal: 'INLET', x: 262, y: 88 },
      { signal: 'MAX', x: 672, y: 104 },
      { signal: 'MIN', x: 672, y: 300 },
      { signal: 'OUTLET', x: 580, y: 402 },
      { signal: 'LAMP', x: 868, y: 106 },
      { signal: 'START_CONTACT', x: 868, y: 166 },
      { signal: 'STOP_CONTACT', x: 868, y: 262 },
    ],
    pushes: [
      { signal: 'START', x: 868, y: 206 },
      { signal: 'STOP', x: 868, y: 302 },
    ],
    toggles: ['HAND_FILL'],
  },
  'garage door': {
    ...nothing,
    title: ['Garagentor', 'Garage door'],
    height: 420,
    drawing: GarageDoor,
    tags: [
      { signal: 'OPEN', x: 742, y: 112 },
      { signal: 'CLOSED', x: 742, y: 352 },
      { signal: 'BARRIER', x: 218, y: 322 },
      { signal: 'UP', x: 402, y: 74 },
      { signal: 'DOWN', x: 558, y: 74 },
      { signal: 'LAMP', x: 190, y: 116 },
      { signal: 'CONTACT', x: 868, y: 182 },
    ],
    pushes: [{ signal: 'BUTTON', x: 868, y: 232 }],
    toggles: ['OBSTACLE'],
    bad: ['HITS', 'BOTH'],
  },
  'traffic light': {
    ...nothing,
    title: ['Fußgängerampel', 'Pedestrian crossing'],
    height: 420,
    drawing: TrafficLight,
    tags: [
      { signal: 'CARS_RED', x: 228, y: 82 },
      { signal: 'CARS_AMBER', x: 228, y: 152 },
      { signal: 'CARS_GREEN', x: 228, y: 222 },
      { signal: 'WALK_RED', x: 732, y: 117 },
      { signal: 'WALK_GREEN', x: 732, y: 187 },
      { signal: 'WAIT', x: 480, y: 62 },
      { signal: 'LEFT_CONTACT', x: 100, y: 322 },
      { signal: 'RIGHT_CONTACT', x: 860, y: 322 },
    ],
    pushes: [
      { signal: 'LEFT', x: 100, y: 370 },
      { signal: 'RIGHT', x: 860, y: 370 },
    ],
    bad: ['DANGER'],
  },
  lift: {
    ...nothing,
    title: ['Aufzug mit drei Etagen', 'Lift with three floors'],
    height: 520,
    drawing: Lift,
    tags: [
      ...[1, 2, 3].flatMap((floor) => [
        { signal: `FLOOR${floor}`, x: 660, y: 560 - 160 * floor },
        { signal: `CALL${floor}_CONTACT`, x: 200, y: 545 - 160 * floor },
        { signal: `LAMP${floor}`, x: 200, y: 583 - 160 * floor },
        { signal: `GO${floor}_CONTACT`, x: 908, y: 430 - 80 * floor },
      ]),
      { signal: 'DOOR', x: 764, y: 420 },
      { signal: 'DOOR_OPEN', x: 764, y: 459 },
      { signal: 'DOOR_CLOSED', x: 764, y: 498 },
      { signal: 'UP', x: 420, y: 22 },
      { signal: 'DOWN', x: 540, y: 22 },
    ],
    pushes: [1, 2, 3].flatMap((floor) => [
      { signal: `CALL${floor}`, x: 90, y: 560 - 160 * floor },
      { signal: `GO${floor}`, x: 786, y: 430 - 80 * floor },
    ]),
    bad: ['FAULTS'],
  },
  temperature: {
    ...nothing,
    title: ['Ofen mit Heizung und Kühlung', 'Furnace with heating and cooling'],
    height: 420,
    drawing: Temperature,
    tags: [
      { signal: 'HEAT', x: 150, y: 302 },
      { signal: 'COOL', x: 150, y: 122 },
      { signal: 'PV', x: 470, y: 62 },
    ],
    ranges: ['LMN', 'DISTURBANCE', 'AMBIENT'],
  },
  axis: {
    ...nothing,
    title: ['Achse mit Antrieb und Geber', 'Axis with drive and encoder'],
    height: 400,
    drawing: Axis,
    tags: [
      ...['SETPOINT', 'ENABLE', 'DIRECTION'].map((signal, index) => ({ signal, x: 88, y: 38 + index * 38 })),
      ...['Q0', 'Q1', 'Q2', 'Q3'].map((signal, index) => ({ signal, x: 88, y: 30 + index * 33 })),
      ...['A', 'B', 'N'].map((signal, index) => ({ signal, x: 738, y: 38 + index * 38 })),
      ...['LOW_SWITCH', 'WORKPIECE', 'REFERENCE', 'HIGH_SWITCH'].map((signal, index) => ({
        signal,
        x: [130, 370, 600, 830][index]!,
        y: 338,
      })),
    ],
    without: ({ contactors, direction_signal }) =>
      contactors
        ? ['SETPOINT', 'ENABLE', 'DIRECTION']
        : ['Q0', 'Q1', 'Q2', 'Q3', ...(direction_signal ? [] : ['DIRECTION'])],
    ifWired: ['WORKPIECE'],
    ranges: ['HAND', 'LOST'],
    toggles: ['BLOCKED', 'EMERGENCY_STOP', 'SWAPPED'],
    faults: [
      { signal: 'A', at: 0, title: axis.brokenA },
      { signal: 'B', at: 0, title: axis.brokenB },
      { signal: 'N', at: 0, title: axis.brokenN },
      { signal: 'REFERENCE', title: axis.stuckReference },
      { signal: 'ENABLE', at: 0, title: axis.noEnable },
    ],
  },
};

export interface KindView extends Omit<Kind, 'title'> {
  title: string;
}

/** Null: there is no drawing of this kind, its signals are a table. */
export function kindView(kind: string): (Omit<KindView, 'drawing'> & { drawing: Kind['drawing'] | null }) | null {
  const known = KINDS[kind];
  const side = language.value === 'de' ? 0 : 1;
  if (known) return { ...known, title: known.title[side] };
  const part: Text | undefined = (kinds as Texts)[kind];
  return { ...nothing, title: part?.[side] ?? kind, height: 0, drawing: null, tags: [] };
}
