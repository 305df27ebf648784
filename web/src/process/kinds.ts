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
  /** Its name is in the drawing or on the button beside it. */
  beside?: boolean;
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
      { signal: 'BARRIER_LARGE', x: 372, y: 28 },
      { signal: 'BARRIER_MIDDLE', x: 372, y: 84 },
      { signal: 'BARRIER_SMALL', x: 372, y: 140 },
      { signal: 'SLIDER_SMALL', x: 508, y: 42 },
      { signal: 'SLIDER_MIDDLE', x: 633, y: 42 },
      { signal: 'SLIDER_LARGE', x: 758, y: 42 },
    ],
    pushes: [
      { signal: 'NEW_SMALL', x: 66, y: 370 },
      { signal: 'NEW_MIDDLE', x: 194, y: 370 },
      { signal: 'NEW_LARGE', x: 322, y: 370 },
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
      { signal: 'INLET', x: 240, y: 92 },
      { signal: 'MAX', x: 698, y: 104 },
      { signal: 'MIN', x: 698, y: 300 },
      { signal: 'OUTLET', x: 460, y: 378 },
      { signal: 'LAMP', x: 862, y: 80 },
      { signal: 'START_CONTACT', x: 862, y: 146 },
      { signal: 'STOP_CONTACT', x: 862, y: 274 },
    ],
    pushes: [
      { signal: 'START', x: 862, y: 202 },
      { signal: 'STOP', x: 862, y: 330 },
    ],
    toggles: ['HAND_FILL'],
  },
  'garage door': {
    ...nothing,
    title: ['Garagentor', 'Garage door'],
    height: 420,
    drawing: GarageDoor,
    tags: [
      { signal: 'OPEN', x: 768, y: 112 },
      { signal: 'CLOSED', x: 768, y: 336 },
      { signal: 'BARRIER', x: 200, y: 322 },
      { signal: 'UP', x: 402, y: 68 },
      { signal: 'DOWN', x: 558, y: 68 },
      { signal: 'LAMP', x: 188, y: 124 },
      { signal: 'CONTACT', x: 868, y: 182 },
    ],
    pushes: [{ signal: 'BUTTON', x: 868, y: 242 }],
    toggles: ['OBSTACLE'],
    bad: ['HITS', 'BOTH'],
  },
  'traffic light': {
    ...nothing,
    title: ['Fußgängerampel', 'Pedestrian crossing'],
    height: 420,
    drawing: TrafficLight,
    tags: [
      { signal: 'CARS_RED', x: 204, y: 82 },
      { signal: 'CARS_AMBER', x: 204, y: 152 },
      { signal: 'CARS_GREEN', x: 204, y: 222 },
      { signal: 'WALK_RED', x: 764, y: 117 },
      { signal: 'WALK_GREEN', x: 764, y: 187 },
      { signal: 'WAIT', x: 480, y: 58 },
      { signal: 'LEFT_CONTACT', x: 100, y: 306 },
      { signal: 'RIGHT_CONTACT', x: 860, y: 306 },
    ],
    pushes: [
      { signal: 'LEFT', x: 100, y: 366 },
      { signal: 'RIGHT', x: 860, y: 366 },
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
        { signal: `FLOOR${floor}`, x: 596, y: 570 - 160 * floor },
        { signal: `CALL${floor}_CONTACT`, x: 204, y: 552 - 160 * floor },
        { signal: `LAMP${floor}`, x: 198, y: 610 - 160 * floor },
        { signal: `GO${floor}_CONTACT`, x: 886, y: 260 - 64 * floor, beside: true },
      ]),
      ...['DOOR', 'DOOR_OPEN', 'DOOR_CLOSED'].map((signal, index) => ({
        signal,
        x: 748,
        y: 290 + index * 60,
        beside: true,
      })),
      { signal: 'UP', x: 340, y: 28 },
      { signal: 'DOWN', x: 500, y: 28 },
    ],
    pushes: [1, 2, 3].flatMap((floor) => [
      { signal: `CALL${floor}`, x: 68, y: 580 - 160 * floor },
      { signal: `GO${floor}`, x: 758, y: 260 - 64 * floor },
    ]),
    bad: ['FAULTS'],
  },
  temperature: {
    ...nothing,
    title: ['Ofen mit Heizung und Kühlung', 'Furnace with heating and cooling'],
    height: 420,
    drawing: Temperature,
    tags: [
      { signal: 'HEAT', x: 138, y: 302 },
      { signal: 'COOL', x: 138, y: 122 },
      { signal: 'PV', x: 470, y: 48 },
    ],
    ranges: ['LMN', 'DISTURBANCE', 'AMBIENT'],
  },
  axis: {
    ...nothing,
    title: ['Achse mit Antrieb und Geber', 'Axis with drive and encoder'],
    height: 510,
    drawing: Axis,
    tags: [
      ...['SETPOINT', 'ENABLE', 'DIRECTION'].map((signal, index) => ({ signal, x: 92, y: 55 + index * 64 })),
      ...['Q0', 'Q1', 'Q2', 'Q3'].map((signal, index) => ({ signal, x: 92, y: 38 + index * 54 })),
      ...['A', 'B', 'N'].map((signal, index) => ({ signal, x: 743, y: 55 + index * 64 })),
      ...['LOW_SWITCH', 'WORKPIECE', 'REFERENCE', 'HIGH_SWITCH'].map((signal, index) => ({
        signal,
        x: [130, 370, 600, 830][index]!,
        y: 446,
      })),
    ].map((place) => ({ ...place, beside: true })),
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
