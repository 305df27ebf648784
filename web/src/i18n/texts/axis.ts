import type { Texts } from '..';

/** The picture of an axis, its curves, its faults. */
export const axis = {
  pulses: ['{count} {count|Impuls|Impulse}', '{count} {count|pulse|pulses}'],
  perSecond: ['{count} Impulse/s', '{count} pulses/s'],
  encoder: ['Geber {count} Impulse', 'encoder {count} pulses'],
  pitch: ['mm je Geberumdrehung', 'mm per encoder revolution'],
  pitchHint: [
    'Nur für dieses Bild: die SFBs rechnen in Impulsen.',
    'Of this picture only: the SFBs calculate in pulses.',
  ],
  faults: ['Störungen', 'Faults'],
  brokenA: ['Drahtbruch Spur A', 'Wire break of track A'],
  brokenB: ['Drahtbruch Spur B', 'Wire break of track B'],
  brokenN: ['Drahtbruch Nullmarke N', 'Wire break of zero mark N'],
  stuckReference: ['Referenzpunktschalter klemmt', 'Reference point switch stuck'],
  noEnable: ['Freigabe fehlt', 'Enable missing'],
  curves: ['Kurven der Achse', 'Curves of the axis'],
  overTime: ['Über der Zeit', 'Over time'],
  overWay: ['Über dem Weg', 'Over distance'],
  time: ['Zeit [s]', 'Time [s]'],
  position: ['Position [Impulse]', 'Position [pulses]'],
  speed: ['Geschwindigkeit [Impulse/s]', 'Speed [pulses/s]'],
  setpoint: ['Sollwert [Impulse/s]', 'Set-point [pulses/s]'],
  target: ['Ziel', 'Target'],
  changeover: ['Umschaltpunkt', 'Changeover point'],
  cutOff: ['Abschaltpunkt', 'Cut-off point'],
  span: ['Zeitraum', 'Span'],
  hold: ['Anhalten', 'Pause'],
  toTrends: ['In „Kurven“ aufzeichnen', 'Record in “Trends”'],
} satisfies Texts;
