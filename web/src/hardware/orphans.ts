// Parameters that have no meaning beside another value of one parameter: they leave merker.toml with the change.
import type { Parameter } from './plan.svelte';

type Value = Parameter['value'];

/** In the order in which they go: creep speed is at most the maximum speed. */
const ANALOG = ['creep_speed', 'max_speed', 'cut_off_delay', 'voltage'];
const DIGITAL = ['control_type'];
const LINEAR = ['report_working_range', 'monitor_working_range', 'low_limit', 'high_limit'];
const ROTARY = ['rotary_end'];
/** Of the serial interface: what only ASCII has, the procedures, all but RK 512, and only RK 512. */
const ASCII = ['flow_control', 'mode', 'preset', 'xon', 'xoff', 'xon_wait', 'length', 'pause']
  .concat(['end_characters', 'check_characters', 'sending', 'end'])
  .map((key) => `serial.${key}`);
const PROCEDURE = ['priority', 'acknowledge_delay', 'setup_attempts', 'transmission_attempts'].map(
  (key) => `serial.${key}`,
);
const BUFFER = ['telegrams', 'whole_buffer', 'clear_at_start', 'prevent_overwriting'].map((key) => `serial.${key}`);
/** Of ASCII: what belongs to one end of telegrams, and to XON/XOFF. */
const OF_END: Record<string, string[]> = {
  count: ['serial.length', 'serial.pause'],
  characters: ['serial.end_characters', 'serial.check_characters', 'serial.sending'],
};
const FLOW_CONTROL = ['serial.xon', 'serial.xoff', 'serial.xon_wait'];
const ALWAYS = ['name', 'input', 'output', 'drive'];

/** Keys of a module that go when one of its parameters takes a value. */
export function orphansOf(key: string, value: Value, all: Parameter[]): string[] {
  const keys = all.map((one) => one.key);
  if (key === 'on_stop') return value === 'substitute' ? [] : ['substitute'].filter((one) => keys.includes(one));
  if (key === 'drive') return ofDrive(value, keys);
  if (key === 'axis') return (value === 'rotary' ? LINEAR : ROTARY).filter((one) => keys.includes(one));
  if (key === 'interrupts' && value === 'none') return keys.filter((one) => one.startsWith('report_'));
  if (key.startsWith('serial.')) return ofSerial(key, value, keys).filter((one) => keys.includes(one));
  if (key.startsWith('monitor_') && value === false) {
    const report = key.replace('monitor_', 'report_');
    return keys.filter((one) => one === report);
  }
  return [];
}

function ofDrive(value: Value, keys: string[]): string[] {
  if (value === 'analog') return DIGITAL.filter((one) => keys.includes(one));
  if (value === 'digital') return ANALOG.filter((one) => keys.includes(one));
  return keys.filter((one) => !ALWAYS.includes(one)).sort((a, b) => rank(a) - rank(b));
}

// The shortest times differ, and RK 512 has 8 data bits.
function ofSerial(key: string, value: Value, keys: string[]): string[] {
  if (key === 'serial.whole_buffer') return value === true ? ['serial.telegrams'] : [];
  if (key === 'serial.end') return Object.entries(OF_END).flatMap(([end, some]) => (end === value ? [] : some));
  if (key === 'serial.flow_control') return value === 'none' ? FLOW_CONTROL : [];
  if (key === 'serial.mode')
    return value === 'RS422' ? ['serial.preset'] : ['serial.preset', 'serial.flow_control', ...FLOW_CONTROL];
  if (key !== 'serial.protocol') return [];
  if (value === 'ASCII') return ['serial.character_delay', 'serial.block_check', ...PROCEDURE];
  const fromAscii = keys.includes('serial.end') ? ['serial.character_delay', ...ASCII] : [];
  return [...fromAscii, ...(value === 'RK512' ? [...BUFFER, 'serial.data_bits'] : ['serial.block_check'])];
}

/** First what needs another one, last the choice that others need. */
const rank = (key: string) => (key === 'creep_speed' || key.startsWith('report_') ? 0 : key === 'axis' ? 2 : 1);
