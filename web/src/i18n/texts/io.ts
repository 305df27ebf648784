import type { Texts } from '..';

export const io = {
  title: ['Ein- und Ausgänge', 'Inputs and outputs'],
  add: ['Hinzufügen', 'Add'],
  addLabel: ['Kachel für Operand', 'Tile for operand'],
  addExample: ['EB 0, MW 10, T 1, Z 1, DB1.DBW 0', 'IB 0, MW 10, T 1, C 1, DB1.DBW 0'],
  addWrong: [
    '„{text}“ ist kein Operand für eine Kachel. Möglich sind EB, AB, MB, PEB (auch W, D), T, Z, DBn.DBW.',
    '“{text}” is not a valid operand for a tile. Allowed: IB, QB, MB, PIB (also W, D), T, C, DBn.DBW.',
  ],
  addTwice: ['Für {operand} gibt es schon eine Kachel.', 'There is already a tile for {operand}.'],
  remove: ['{operand} entfernen', 'Remove {operand}'],
  forced: ['geforct', 'forced'],
  format: ['Format von {operand}', 'Format of {operand}'],
  value: ['Wert für {operand}', 'Value for {operand}'],
  slider: ['Schieber für {operand}', 'Slider for {operand}'],
  write: ['Schreiben', 'Write'],
  reset: ['Rücksetzen', 'Reset'],
  empty: [
    'Noch keine Kachel. Oben einen Operanden eingeben, zum Beispiel EB 0.',
    'No tile yet. Enter an operand above, for example IB 0.',
  ],
  registers: ['Register', 'Registers'],
  defaults: ['Aus den Symbolen', 'From the symbols'],
  moreTiles: [
    'Die ersten {most} Kacheln aus den Symbolen; {more} weitere lassen sich oben eingeben.',
    'The first {most} tiles of the symbols; enter {more} more above.',
  ],
} satisfies Texts;
