// The properties of a module, by the words of the server or the keys of merker.toml, in the language of the page.
import { said, translator } from '../i18n';
import { planWords } from '../i18n/texts/hardware_plan';
import { modules } from '../i18n/texts/modules';

export type Property = [name: string, value: string];

const word = translator({ ...planWords, ...modules });
const known = (text: string): text is keyof typeof planWords | keyof typeof modules =>
  Object.hasOwn(modules, text) || Object.hasOwn(planWords, text);
const worded = (text: string): string => (known(text) ? word(text) : said(text));

/** "interval" of "OB 35 interval". */
export function propertyName(name: string): string {
  const [, owner, key] = /^(OB \d+) (.+)$/.exec(name) ?? [];
  return owner && key ? `${owner}: ${worded(key)}` : worded(name);
}

/** A choice that means something else elsewhere has words of its own. */
export function propertyValue([name, value]: Property): string {
  const own = `${name}: ${value}`;
  return worded(known(own) ? own : value);
}

export const propertyText = (property: Property): string => `${propertyName(property[0])}: ${propertyValue(property)}`;
