import type { Texts } from '..';

export const io = {
  title: ['Eingänge und Ausgänge', 'Inputs and outputs'],
} satisfies Texts;
