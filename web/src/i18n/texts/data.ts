import type { Texts } from '..';

export const data = {
  view: ['Datensicht', 'Data view'],
  viewHelp: [
    'Datensicht: Variablen mit Anfangs- und Aktualwert statt der Quelle',
    'Data view: variables with initial and actual values instead of the source',
  ],
  dataOf: ['Daten von {block}', 'Data of {block}'],
  instance: ['Instanz von {block}', 'Instance of {block}'],
  modify: ['Steuern', 'Modify'],
  modifyValue: ['Steuerwert', 'Modify value'],
  modifyOf: ['Steuerwert von {name}', 'Modify value of {name}'],
  take: ['Aktualwerte übernehmen', 'Take over actual values'],
  takeHelp: [
    'Die Aktualwerte der CPU in die Quelle schreiben (BEGIN): Mit ihnen beginnt der Baustein nach dem nächsten Laden.',
    'Write the actual values of the CPU into the source (BEGIN): the block begins with them after the next download.',
  ],
  taken: [
    '{block}: {count} {count|Aktualwert steht|Aktualwerte stehen} in der Quelle. Speichern und laden, damit der Baustein mit ihnen beginnt.',
    '{block}: {count} actual {count|value is|values are} in the source. Save and load, so that the block begins with them.',
  ],
  without: [
    '{block}: {names} {count|behält seinen|behalten ihren} Anfangswert, denn für {count|den Aktualwert|die Aktualwerte} gibt es keine Konstante.',
    '{block}: {names} {count|keeps its|keep their} initial {count|value|values}, because no constant says the actual {count|one|ones}.',
  ],
  andMore: ['{names} und {count} weitere', '{names} and {count} more'],
  noBegin: ['{block} hat kein BEGIN in seiner Quelle.', '{block} has no BEGIN in its source.'],
  fold: ['Alles zuklappen', 'Fold all'],
  unfold: ['Alles aufklappen', 'Unfold all'],
  notLoaded: [
    'Der Baustein ist nicht in der CPU: Werte des Projekts.',
    'The block is not in the CPU: values of the project.',
  ],
  other: [
    'Die CPU hat einen anderen Aufbau dieses Bausteins: Werte des Projekts.',
    'The CPU has another structure of this block: values of the project.',
  ],
  more: [
    '{count} weitere {count|Variable steht|Variablen stehen} im Maschinencode.',
    '{count} more {count|variable stands|variables stand} in the machine code.',
  ],
} satisfies Texts;
