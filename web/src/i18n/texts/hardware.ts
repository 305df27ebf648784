import type { Texts } from '..';

export const hardware = {
  title: ['Hardware', 'Hardware'],
  rack: ['Baugruppenträger {number}', 'Rack {number}'],
  slot: ['Steckplatz {slot}', 'Slot {slot}'],
  none: ['Dieses Projekt hat keinen Aufbau.', 'This project has no hardware.'],
  choose: [
    'Eine Baugruppe wählen, um ihre Klemmen und Eigenschaften zu sehen.',
    'Choose a module to see its terminals and properties.',
  ],
  properties: ['Eigenschaften', 'Properties'],
  terminals: ['Klemmen', 'Terminals'],
  terminal: ['Klemme', 'Terminal'],
  operand: ['Operand', 'Operand'],
  symbol: ['Symbol', 'Symbol'],
  value: ['Wert', 'Value'],
  faults: ['Störungen', 'Faults'],
  faultOn: ['{fault}: besteht', '{fault}: present'],
  faultOff: ['{fault}: besteht nicht', '{fault}: not present'],
  order: ['Bestellnummer', 'Order number'],
  inputs: ['Eingänge', 'Inputs'],
  outputs: ['Ausgänge', 'Outputs'],
  bytes: ['{first} bis {last}', '{first} to {last}'],
  pulled: ['gezogen', 'pulled'],
  noTerminals: ['Diese Baugruppe hat keine Klemmen.', 'This module has no terminals.'],
  noFaults: ['Für diese Baugruppe gibt es keine Störungen.', 'There are no faults for this module.'],
} satisfies Texts;
