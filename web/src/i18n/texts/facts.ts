import type { Texts } from '..';

/** Names of the module information. */
export const facts = {
  model: ['Baugruppe', 'Module'],
  mode: ['Betriebszustand', 'Operating state'],
  stopReason: ['STOP-Ursache', 'Reason for STOP'],
  clock: ['Uhr', 'Clock'],
  cycles: ['Zyklen', 'Cycles'],
  instructions: ['Anweisungen', 'Instructions'],
  cycle: ['Zykluszeit (ms)', 'Cycle time (ms)'],
  lastMs: ['aktuell', 'current'],
  shortestMs: ['kürzeste', 'shortest'],
  longestMs: ['längste', 'longest'],
  monitoringMs: ['Überwachungszeit', 'Monitoring time'],
  memory: ['Speicher (Byte)', 'Memory (bytes)'],
  loadMemory: ['Ladespeicher belegt', 'Load memory used'],
  workMemory: ['Arbeitsspeicher', 'Work memory'],
  workMemoryUsed: ['Arbeitsspeicher belegt', 'Work memory used'],
  localData: ['Lokaldaten je Prioritätsklasse', 'Local data per priority class'],
  limits: ['Leistungsdaten', 'Limits'],
  inputs: ['Eingänge (Byte)', 'Inputs (bytes)'],
  outputs: ['Ausgänge (Byte)', 'Outputs (bytes)'],
  flags: ['Merker (Byte)', 'Flags (bytes)'],
  timers: ['Zeiten', 'Timers'],
  counters: ['Zähler', 'Counters'],
  blocks: ['Bausteine (Anzahl)', 'Blocks (number)'],
} satisfies Texts;
