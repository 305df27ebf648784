import { expect, test } from 'vitest';
import { language } from '../i18n';
import { onPaper, propertyText } from './properties';

test('what is set on a module, an organization block, a channel, in the language of the page', () => {
  const texts = () =>
    (
      [
        ['on_stop', 'keep'],
        ['OB 35 interval', '50ms'],
        ['input 1 range', 'off'],
        ['output 0 substitute', '4mA'],
        ['channel 1 mode', 'periodic'],
        ['channel 1 interrupts', 'overflow, comparator'],
      ] as const
    ).map(([name, value]) => propertyText([name, value]));
  language.value = 'de';
  expect(texts()).toEqual([
    'Verhalten in STOP: letzten Wert halten',
    'OB 35: Zeittakt: 50ms',
    'Kanal E 1: Messbereich: aus',
    'Kanal A 0: Ersatzwert: 4mA',
    'Kanal 1: Betriebsart: Periodisch zählen',
    'Kanal 1: Prozessalarm: Überlauf, Erreichen des Vergleichers',
  ]);
  language.value = 'en';
  expect(texts()).toEqual([
    'Outputs in STOP: keep',
    'OB 35: Interval: 50ms',
    'Channel I 1: Range: off',
    'Channel Q 0: Substitute value: 4mA',
    'Channel 1: Operating mode: Count periodically',
    'Channel 1: Hardware interrupt: Overflow, Reaching the comparator',
  ]);
});

test('on paper a channel has a line of its own, and no column is repeated', () => {
  language.value = 'de';
  expect(
    onPaper([
      ['type', 'Count'],
      ['slot', '2.4'],
      ['interrupts', 'process'],
      ['channel 0 mode', 'endless'],
      ['channel 0 hysteresis', '3'],
      ['channel 1 mode', 'none'],
    ]),
  ).toEqual([
    'Alarme: Prozess',
    'Kanal 0: Betriebsart: Endlos zählen; Hysterese: 3',
    'Kanal 1: Betriebsart: nicht parametriert',
  ]);
});
