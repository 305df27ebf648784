// What the program says, in the language of the page.
import { examples } from './examples';
import { language } from './language.svelte';
import { phrase, problemText } from './phrases';

/** A text of the program: an event, a reason, the name of a property. */
export const said = (text: string): string => (language.value === 'de' ? phrase(text) : text);

/** A figure with its unit, as the program writes it: "187.5 kbit/s". */
export const figure = (text: string): string => (language.value === 'de' ? text.replace('.', ',') : text);

interface Told {
  code: string;
  text: string;
  arguments?: string[];
}
/** The sentence of a problem. */
export const told = (problem: Told): string =>
  language.value === 'de' ? problemText(problem.code, problem.arguments, problem.text) : problem.text;

interface Described {
  id: string;
  title: string;
  description: string;
}
/** Title and description of an example; those of its README where it has no German ones. */
export function described(example: Described): { title: string; description: string } {
  const [title, description] = (language.value === 'de' && examples[example.id]) || [];
  return { title: title ?? example.title, description: description ?? example.description };
}
