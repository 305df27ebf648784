import type { Texts } from '..';

export const nearby = {
  title: ['Beobachten', 'Monitor'],
  follow: ['folgt der Schreibmarke', 'follows the cursor'],
  keep: ['In die Variablentabelle', 'To the variable table'],
  nothing: ['In diesem Netzwerk steht kein Operand.', 'There is no operand in this network.'],
  comment: ['Kommentar', 'Comment'],
  more: ['und {count} weitere', 'and {count} more'],
} satisfies Texts;
