// The properties of a module, by the words of the server or the keys of merker.toml, in the language of the page.
import { operandText, said, translator } from '../i18n';
import { hardwarePlan, planWords } from '../i18n/texts/hardware_plan';
import { modules } from '../i18n/texts/modules';

export type Property = [name: string, value: string];

const word = translator({ ...planWords, ...modules });
const known = (text: string): text is keyof typeof planWords | keyof typeof modules =>
  Object.hasOwn(modules, text) || Object.hasOwn(planWords, text);
const worded = (text: string): string => (known(text) ? word(text) : said(text));

const t = translator(hardwarePlan);
const ownerText = (owner: string): string =>
  /^[ioc]/.test(owner)
    ? `${t('channel')} ${operandText(owner.replace('input', 'E').replace('output', 'A').replace('channel ', ''))}`
    : owner;

/** "interval" of "OB 35 interval", "range" of "input 1 range", which is of a channel; "count.mode" of "channel 1 mode", which
 * is of a counting one. */
function parts(name: string): [owner: string, key: string] {
  const [, owner = '', key = name] = /^((?:OB|input|output|channel) \d+) (.+)$/.exec(name) ?? [];
  return [owner, owner.startsWith('channel') ? `count.${key}` : key];
}

export function propertyName(name: string): string {
  const [owner, key] = parts(name);
  return owner ? `${ownerText(owner)}: ${worded(key)}` : worded(key);
}

/** A choice that means something else elsewhere has words of its own. */
export function propertyValue([name, value]: Property): string {
  const [, key] = parts(name);
  const one = (choice: string) => worded(known(`${key}: ${choice}`) ? `${key}: ${choice}` : choice);
  return value.split(', ').map(one).join(', ');
}

export const propertyText = (property: Property): string => `${propertyName(property[0])}: ${propertyValue(property)}`;

/** Not where the columns beside say it already. */
const SAID = ['type', 'order number', 'slot'];

type Words = [name: string, value: string];

/** Those of the module under '', then those of each channel and organization block. */
export function grouped(properties: Property[]): [owner: string, words: Words[]][] {
  const groups = new Map<string, Words[]>([['', []]]);
  for (const property of properties) {
    const [owner, key] = parts(property[0]);
    groups.set(owner, [...(groups.get(owner) ?? []), [worded(key), propertyValue(property)]]);
  }
  return [...groups].map(([owner, words]) => [owner && ownerText(owner), words]);
}

/** One line for the module, one for each channel: "Kanal 0: Betriebsart: Endlos zählen; Hysterese: 3". */
export const onPaper = (properties: Property[]): string[] =>
  grouped(properties.filter(([name]) => !SAID.includes(name)))
    .filter(([, words]) => words.length > 0)
    .map(([owner, words]) => (owner ? `${owner}: ` : '') + words.map((pair) => pair.join(': ')).join('; '));
