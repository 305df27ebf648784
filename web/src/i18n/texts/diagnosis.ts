import type { Texts } from '..';

export const diagnosis = {
  title: ['Diagnose', 'Diagnosis'],
} satisfies Texts;
