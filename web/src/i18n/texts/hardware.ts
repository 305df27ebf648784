import type { Texts } from '..';

export const hardware = {
  title: ['Hardware', 'Hardware'],
  rack: ['Baugruppenträger {number}', 'Rack {number}'],
  asi: ['AS-Interface am CP auf Steckplatz {number}', 'AS-Interface of the CP in slot {number}'],
  profibus: ['PROFIBUS-DP, Slave mit Adresse {number}', 'PROFIBUS-DP, slave with address {number}'],
  slot: ['Steckplatz {slot}', 'Slot {slot}'],
  none: ['Dieses Projekt hat keinen Aufbau.', 'This project has no hardware.'],
  properties: ['Eigenschaften', 'Properties'],
  terminals: ['Klemmen', 'Terminals'],
  terminal: ['Klemme', 'Terminal'],
  operand: ['Operand', 'Operand'],
  symbol: ['Symbol', 'Symbol'],
  value: ['Wert', 'Value'],
  faults: ['Störungen', 'Faults'],
  faulty: ['gestört', 'faulty'],
  pulled: ['gezogen', 'pulled'],
  noTerminals: ['Diese Baugruppe hat keine Klemmen.', 'This module has no terminals.'],
  noFaults: ['Für diese Baugruppe gibt es keine Störungen.', 'There are no faults for this module.'],
} satisfies Texts;
