// Words of merker.toml as the page says them: a key is a field, a value of a choice what the field offers.
import type { Problem } from '../connection';
import { language, told, translator } from '../i18n';
import { planWords } from '../i18n/texts/hardware_plan';

const word = translator(planWords);
const known = (text: string): text is keyof typeof planWords => Object.hasOwn(planWords, text);

/** `family`: before its words where the same key means something else elsewhere: "count". */
export function fieldWord(text: string, family = ''): string {
  const own = `${family}.${text}`;
  return known(own) ? word(own) : known(text) ? word(text) : text;
}

/** A choice that means something else elsewhere has words of its own. */
export function choiceWord(key: string, choice: string, family = ''): string {
  const own = `${key}: ${choice}`;
  return fieldWord(known(own) || known(`${family}.${own}`) ? own : choice, family);
}

/** `interrupts = "process"` is of the module, whatever the channel calls its own. */
const assignment = /'?\b([a-z_.]+) = "([^"]*)"'?/g;
const quoted = /[„']([a-z_.]+)[“']/g;
const chosen = /^([a-z_.]+) "([^"]*)"/;

/** The sentence of a refusal with the fields of the page in place of the keys of the file, in the language of the page. */
export function inFields(problem: Problem, family = ''): Problem {
  const text = told(problem)
    .replace(assignment, (_, key: string, value: string) => `“${fieldWord(key)}: ${choiceWord(key, value)}”`)
    .replace(
      chosen,
      (_, key: string, value: string) => `“${fieldWord(key, family)}: ${choiceWord(key, value, family)}”`,
    )
    .replace(quoted, (whole, key: string) => {
      const field = fieldWord(key, family);
      return field === key ? whole : `“${field}”`;
    });
  const mended: Problem = { ...problem, text: language.value === 'de' ? text.replace(/“([^“”„]*)”/g, '„$1“') : text };
  // It is told already.
  delete (mended as Partial<Problem>).arguments;
  return mended;
}
