// Characters on the serial line: what is shown of them, counted, exported, and sent.

/** 0: X27 has sent it; 1: its partner. Instants in seconds of virtual time. */
export interface Character {
  number: number;
  from: 0 | 1;
  value: number;
  name: string;
  meaning: string;
  begin: number;
  end: number;
}

/** BREAK begins and ends, without a character. */
export const isBreak = ({ name }: Pick<Character, 'name'>): boolean => name === 'BREAK';

export const hex = (value: number): string => value.toString(16).toUpperCase().padStart(2, '0');

/** What goes wrong says so in English whatever the language of the page is. */
const BAD = /wrong|refused|breaks off|unexpected|disturbs|neither|conflict|error|too short|fault|overrun|BREAK/;
export const isBad = ({ meaning }: Character): boolean => BAD.test(meaning.replace('no error', ''));

export interface Counts {
  sent: [number, number];
  acknowledged: number;
  bad: number;
}

export function count(all: readonly Character[]): Counts {
  const counts: Counts = { sent: [0, 0], acknowledged: 0, bad: 0 };
  for (const one of all) {
    if (!isBreak(one)) counts.sent[one.from] += 1;
    if (one.meaning === 'block acknowledged') counts.acknowledged += 1;
    if (isBad(one)) counts.bad += 1;
  }
  return counts;
}

/** Those that are on the line in this time: they come in the order of their ends. */
export function between(all: readonly Character[], from: number, to: number): Character[] {
  return all.filter((one) => one.end >= from && one.begin <= to);
}

/** As `merker monitor serial --csv` writes it; German spreadsheets want semicolons. */
export function csv(all: readonly Character[], german: boolean, say: (text: string) => string): string {
  const quoted = (text: string) => `"${text.replace(/"/g, '""')}"`;
  const seconds = (time: number) => (german ? time.toFixed(6).replace('.', ',') : time.toFixed(6));
  const head = german
    ? ['Beginn [s]', 'Ende [s]', 'von', 'Zeichen', 'Name', 'Bedeutung']
    : ['begin [s]', 'end [s]', 'from', 'character', 'name', 'meaning'];
  const rows = all.map((one) => [
    seconds(one.begin),
    seconds(one.end),
    one.from === 0 ? 'X27' : german ? 'Partner' : 'partner',
    isBreak(one) ? '' : hex(one.value),
    quoted(one.name),
    quoted(say(one.meaning)),
  ]);
  return [head, ...rows].map((cells) => `${cells.join(german ? ';' : ',')}\r\n`).join('');
}

/** What a user types, as a step of a scenario has it: "ABC" CR, 02 41. */
export function bytesOf(text: string, kind: 'text' | 'hex', ending: string): string {
  if (kind === 'hex') return text.trim();
  const parts: string[] = [];
  for (const one of text.match(/[ !#-~]+|[^]/gu) ?? []) {
    const code = one.codePointAt(0)!;
    const plain = /^[ !#-~]+$/.test(one);
    if (plain) parts.push(`"${one}"`);
    else if (code < 256) parts.push(hex(code));
    else return '';
  }
  return [...parts, ending].filter(Boolean).join(' ');
}
