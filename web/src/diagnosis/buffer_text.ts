// The diagnostic buffer as a text, as "Save as" of STEP 7 writes it: event by event, newest first.
import type { DiagnosticEntry } from '../connection/protocol';
import { filled, said } from '../i18n';
import { duration } from '../state/numbers';

export type Label = 'number' | 'timeOfDay' | 'date' | 'elapsed' | 'event' | 'text' | 'module' | 'place' | 'helpText';
export interface Head {
  title: string;
  /** Project, CPU, and when the text was made. */
  lines: readonly string[];
  label: (name: Label) => string;
  moduleAt: string;
  moduleNone: string;
}

const LINE_END = '\r\n';
const ARRANGED = 2;

export function bufferText(entries: readonly DiagnosticEntry[], head: Head): string {
  const top = [head.title, ...head.lines.filter(Boolean)];
  const parts = entries.map((entry) => block(fieldsOf(entry, head)));
  return [top.join(LINE_END), ...parts].join(LINE_END + LINE_END) + LINE_END;
}

type Field = [label: string, value: string];

function fieldsOf(entry: DiagnosticEntry, { label, ...words }: Head): Field[] {
  const [date = '', time = ''] = entry.clock.split(' ');
  const fields: Field[] = [[label('number'), String(entry.number)]];
  // A PLC without a clock has the time since its start.
  if (entry.clock) fields.push([label('timeOfDay'), time], [label('date'), date]);
  else fields.push([label('elapsed'), duration(entry.time)]);
  fields.push([label('text'), said(entry.text)]);
  if (entry.event !== '0') fields.push([label('event'), entry.event]);
  if (entry.module) fields.push([label('module'), moduleOf(entry.module, words)]);
  if (entry.block) fields.push([label('place'), placeOf(entry)]);
  if (entry.help) fields.push([label('helpText'), said(entry.help)]);
  return fields;
}

function moduleOf(at: NonNullable<DiagnosticEntry['module']>, words: Pick<Head, 'moduleAt' | 'moduleNone'>): string {
  const { address, rack = 0, slot } = at;
  if (!slot) return filled(words.moduleNone, { address });
  return filled(words.moduleAt, { name: said(at.name ?? ''), rack, slot, address });
}

const placeOf = ({ block, file, line }: DiagnosticEntry): string => (file ? `${block}, ${file}:${line}` : block!);

/** The values stand below each other, those of several lines as well. */
function block(fields: readonly Field[]): string {
  const width = Math.max(...fields.map(([label]) => label.length)) + 1 + ARRANGED;
  const row = ([label, value]: Field) =>
    `${label}:`.padEnd(width) + value.split(/\r?\n/).join(LINE_END + ' '.repeat(width));
  return fields.map(row).join(LINE_END);
}
