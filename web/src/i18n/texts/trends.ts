import type { Texts } from '..';

export const trends = {
  title: ['Kurven', 'Trends'],
  chart: [
    'Kurven über der Zeit: + und − vergrößern und verkleinern, Pfeile verschieben',
    'Curves over time: + and − zoom, arrows move',
  ],
  curves: ['Aufgezeichnete Kurven', 'Recorded curves'],
  operand: ['Operand, Symbol oder Wert einer Anlage', 'Operand, symbol or value of a plant'],
  example: ['MW 10, "Symbol", plant.…', 'MW 10, "symbol", plant.…'],
  add: ['Dazu', 'Add'],
  remove: ['{name} nicht mehr aufzeichnen', 'Stop recording {name}'],
  none: [
    'Noch keine Kurven: einen Operanden oder einen Wert der Anlage eingeben.',
    'No curves yet: enter an operand or a value of the plant.',
  ],
  span: ['Zeitraum', 'Span'],
  rate: ['Abtastung', 'Sampling'],
  everyCycle: ['jeder Zyklus', 'every cycle'],
  pause: ['Anhalten', 'Pause'],
  clear: ['Leeren', 'Clear'],
  hint: [
    'Ziehen vergrößert einen Ausschnitt, Doppelklick zeigt wieder alles. CSV und PNG enthalten den sichtbaren Teil.',
    'Drag to zoom in, double-click to see everything again. CSV and PNG contain the visible part.',
  ],
} satisfies Texts;
