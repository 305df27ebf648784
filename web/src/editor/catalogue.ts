// What the completion, the symbolic display and the right-click list know about the project (program.completion).
import { sameOperand, type Mnemonics } from './mnemonics';

export interface SymbolEntry {
  name: string;
  operand: string;
  type: string;
  comment: string;
}

export interface BlockEntry {
  id: string;
  symbol: string;
  title: string;
  /** Of a data block: its function block. */
  instanceOf?: string;
}

export type MnemonicRow = readonly [word: string, operands: string, id: string];

export interface Catalogue {
  symbols: SymbolEntry[];
  blocks: BlockEntry[];
  mnemonics: Record<Mnemonics, MnemonicRow[]>;
  /** Which numbers blocks of this CPU can have: the OBs it has, of the others the first and the last; null until it is known. */
  numbers: BlockNumbers | null;
}

export interface BlockNumbers {
  OB: number[];
  FB: [number, number];
  FC: [number, number];
  DB: [number, number];
}

export const emptyCatalogue = (): Catalogue => ({
  symbols: [],
  blocks: [],
  mnemonics: { german: [], international: [] },
  numbers: null,
});

/** Symbols by operand and by name, each found however it is written. */
export class SymbolIndex {
  private readonly byOperand = new Map<string, SymbolEntry>();
  private readonly byName = new Map<string, SymbolEntry>();

  constructor(symbols: readonly SymbolEntry[]) {
    for (const symbol of symbols) {
      this.byOperand.set(sameOperand(symbol.operand), symbol);
      this.byName.set(symbol.name.toUpperCase(), symbol);
    }
  }

  ofOperand(operand: string): SymbolEntry | undefined {
    return this.byOperand.get(sameOperand(operand));
  }

  /** With or without its quotation marks. */
  ofName(name: string): SymbolEntry | undefined {
    return this.byName.get(name.replace(/^"|"$/g, '').toUpperCase());
  }
}
