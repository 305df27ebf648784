// A plant beside the CPU: where its signals can go, and what an axis brings along.
import type { PlantKind } from '../connection/protocol';
import type { PlannedRack, PlannedSlot } from '../hardware/plan.svelte';

export type Wires = Record<string, string>;

const AXIS = '2.5';
/** Technology manual 3.1.3 and 4.1.3: the terminals that the CPU takes for its axis. */
const ENCODER: Wires = { A: '2.2.DI0', B: '2.2.DI1', N: '2.2.DI2', WORKPIECE: '2.2.DI3', REFERENCE: '2.2.DI4' };
const ANALOG: Wires = { SETPOINT: '2.3.AO0', ENABLE: '2.2.DO6' };
const WITH_DIRECTION: Wires = { DIRECTION: '2.2.DO7' };
const DIGITAL: Wires = { Q0: '2.2.DO8', Q1: '2.2.DO9', Q2: '2.2.DO10', Q3: '2.2.DO11' };

const axisOf = (racks: PlannedRack[]): PlannedSlot | undefined =>
  racks.flatMap((rack) => rack.slots).find((slot) => slot.slot === AXIS && slot.parameters);

const valueOf = (slot: PlannedSlot, key: string): unknown =>
  slot.parameters!.find((parameter) => parameter.key === key)?.value;

/** Whether the CPU is set to position an axis. */
export function positions(racks: PlannedRack[]): boolean {
  const slot = axisOf(racks);
  return slot !== undefined && ['analog', 'digital'].includes(String(valueOf(slot, 'drive')));
}

/** An axis is wired as the manual says; of others nothing is known. */
export function usualWires(kind: string, racks: PlannedRack[]): Wires {
  const slot = kind === 'axis' ? axisOf(racks) : undefined;
  if (!slot || !positions(racks)) return {};
  if (valueOf(slot, 'drive') === 'digital') return { ...DIGITAL, ...ENCODER };
  return { ...ANALOG, ...(valueOf(slot, 'voltage') === '0..10V' ? WITH_DIRECTION : {}), ...ENCODER };
}

/** What the axis has in common with the parameters of the CPU: its encoder, its speed, its power section. */
export function usualParameters(kind: string, racks: PlannedRack[]): Record<string, number | boolean> {
  const slot = kind === 'axis' ? axisOf(racks) : undefined;
  if (!slot || !positions(racks)) return {};
  const number = (key: string) => Number(valueOf(slot, key));
  const common = {
    increments: number('increments'),
    ...(valueOf(slot, 'axis') === 'rotary' ? { revolution: number('rotary_end') } : {}),
  };
  if (valueOf(slot, 'drive') === 'digital') return { contactors: number('control_type'), ...common };
  return { speed: number('max_speed'), direction_signal: valueOf(slot, 'voltage') === '0..10V', ...common };
}

/** Terminals that a signal can go to: the inputs of a plant are outputs of the CPU. */
export function terminalsFor(signal: PlantKind['signals'][number], racks: PlannedRack[]): string[] {
  const kind = `${signal.binary ? 'D' : 'A'}${signal.input ? 'O' : 'I'}`;
  return racks.flatMap((rack) =>
    rack.slots.flatMap((slot) =>
      slot.terminals.filter((one) => one.text.startsWith(kind)).map((one) => `${slot.slot}.${one.text}`),
    ),
  );
}

/** "Axis", then "Axis2": names in scenarios are one word. */
export function freeName(kind: string, taken: string[]): string {
  const name = kind.replace(/(^| )(.)/g, (_, __, letter: string) => letter.toUpperCase());
  let free = name;
  for (let number = 2; taken.includes(free); ++number) free = name + number;
  return free;
}
