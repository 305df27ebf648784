import { expect, test } from 'vitest';
import { operandAt } from './hover';

test.each([
  ['      U     E 0.0;', 12, 'E 0.0'],
  ['M1:   =     "My motor"; // E 1.0', 15, '"My motor"'],
  ['      U     E 0.0; // E 1.0', 24, undefined],
  ['      U     E 0.0;', 6, undefined],
])('%s at %i is %s', (line, column, word) => expect(operandAt(line, column)?.text).toBe(word));
