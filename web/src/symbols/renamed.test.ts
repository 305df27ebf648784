import { describe, expect, it } from 'vitest';
import { renamed, withNewNames } from './renamed';
import type { SymbolRow } from './rows';

const row = (symbol: string, operand: string): SymbolRow => ({ symbol, operand, type: 'BOOL', comment: '' });

describe('symbols that have another name', () => {
  it('are those whose operand has stayed', () => {
    const before = [row('Pump', 'A 1.0'), row('Valve', 'A 1.1'), row('Gone', 'A 1.2'), row('', '')];
    const after = [row('Valve', 'A  1.1'), row('Pump 1', 'A1.0'), row('New', 'A 1.3'), row('x', '')];
    expect(renamed(before, after)).toEqual([{ from: 'Pump', to: 'Pump 1' }]);
  });

  it('are not those in other letters: a symbol is found however it is written', () => {
    expect(renamed([row('Pump', 'A 1.0')], [row('PUMP', 'A 1.0')])).toEqual([]);
  });

  it('get their new names where they are used, however they are written there', () => {
    const text = 'U "Pump";\n= "PUMP"; // Pump, "Pump 2", 5" "Pump"';
    expect(withNewNames(text, [{ from: 'Pump', to: 'P$1' }])).toEqual({
      text: 'U "P$1";\n= "P$1"; // Pump, "Pump 2", 5" "P$1"',
      count: 3,
    });
  });

  it('change their names with each other', () => {
    const swapped = renamed([row('A', 'M 1.0'), row('B (x)', 'M 1.1')], [row('B (x)', 'M 1.0'), row('A', 'M 1.1')]);
    expect(withNewNames('U "A"; = "B (x)";', swapped).text).toBe('U "B (x)"; = "A";');
  });

  it('have no uses where nothing has another name', () => {
    expect(withNewNames('U "";', [])).toEqual({ text: 'U "";', count: 0 });
  });
});
