// Which symbols and variables can stand at a place of a network: bits at contacts, timers above their boxes.
import type { Item } from './items';

export interface Offer {
  label: string;
  /** Of a symbol its operand and type, of a variable its declaration and type. */
  detail?: string | undefined;
  type?: string | undefined;
}

type Wanted = 'bit' | 'timer' | 'counter' | 'value' | 'block';

const byName: [name: RegExp, wanted: Wanted][] = [
  [/^(S_)|^(SI|SV|SE|SS|SA|SP|SD|SF)$/, 'timer'],
  [/^(ZAEHLER|Z_.*|S_C.*|ZV|ZR|SZ|CU|CD|SC)$/, 'counter'],
  [/^(CALL|OPN|AUF|JMPN?|SPBN?)$/, 'block'],
  [/^(SR|RS|POS|NEG|=|S|R|#|P|N|)$/, 'bit'],
];

/** What the operand of an element is; at its pins anything but a block. */
function wantedAt(item: Item, view: 'kop' | 'fup'): Wanted {
  if (item.kind === 'contact') return 'bit';
  const name = item.name.trim();
  const counter = /^S_C(UD?|D)$/.test(name);
  if (item.kind === 'coil' || item.kind === 'frame')
    return counter ? 'counter' : (byName.find(([known]) => known.test(name))?.[1] ?? 'value');
  return view === 'fup' && item.pin === 0 && !item.of ? 'bit' : 'value';
}

const words = (offer: Offer): [first: string, type: string] => {
  const [first = '', type = ''] = (offer.detail ?? '').split('  ');
  return [first, type.toUpperCase()];
};

const isTimer = (offer: Offer) => words(offer)[1] === 'TIMER' || /^T \d/.test(words(offer)[0]);
const isCounter = (offer: Offer) => words(offer)[1] === 'COUNTER' || /^[ZC] \d/.test(words(offer)[0]);
/** A structure may have bits in it. */
const isBit = (offer: Offer) => /^(BOOL|STRUCT|UDT|"|ARRAY)/.test(words(offer)[1]) || /\d+\.\d+$/.test(words(offer)[0]);
const isBlock = (offer: Offer) => offer.type === 'block' || /^(OB|S?FB|S?FC|DB|VAT|PB|SB) \d/.test(words(offer)[0]);

const fits: Record<Wanted, (offer: Offer) => boolean> = {
  bit: (offer) => !isBlock(offer) && (isBit(offer) || isTimer(offer) || isCounter(offer)),
  timer: isTimer,
  counter: isCounter,
  value: (offer) => !isBlock(offer),
  block: isBlock,
};

export const offersAt = (item: Item, view: 'kop' | 'fup', all: readonly Offer[]): Offer[] =>
  all.filter(fits[wantedAt(item, view)]);

/** "T 1", "MW10", "S5T#2S": an operand, though a name may begin like it. */
const isOperand = /^[A-Z]{1,4}\s*\d|^\d|^[A-Z0-9]+#./i;
const plain = (name: string): string => name.toLowerCase().replace(/["#]/g, '');

/** What a typed name is completed to: the offer of this name, or the only one whose name it begins. */
export function meant(text: string, found: readonly Offer[]): string | undefined {
  const typed = plain(text.trim());
  const exact = found.find(({ label }) => plain(label) === typed);
  if (exact || typed === '' || isOperand.test(typed)) return exact?.label;
  const begun = found.filter(({ label }) => plain(label).includes(typed));
  return found.length === 1 ? begun[0]?.label : undefined;
}
