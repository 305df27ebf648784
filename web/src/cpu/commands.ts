import { connection, type FieldsOf } from '../connection';
import { attempt } from '../state/messages.svelte';
import type { SwitchPosition } from '../state/plc.svelte';

export const turnSwitch = (position: SwitchPosition) => void attempt(connection.ask('cpu.switch', { position }));
export const power = (on: boolean, battery = true) => void attempt(connection.ask('cpu.power', { on, battery }));
export const start = (kind: 'warm' | 'cold') => void attempt(connection.ask('cpu.start', { kind }));
export const trigger = (ob: number, going = false) => void attempt(connection.ask('cpu.trigger', { ob, going }));
export const engine = (name: FieldsOf<'cpu.engine'>['engine']) =>
  void attempt(connection.ask('cpu.engine', { engine: name }));
export const pace = (mode: FieldsOf<'time.pace'>['mode'], factor: number) =>
  void attempt(connection.ask('time.pace', { mode, factor }));
export const step = (cycles = 1) => void attempt(connection.ask('time.step', { cycles }));
