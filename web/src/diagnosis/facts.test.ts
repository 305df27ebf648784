import { expect, test } from 'vitest';
import { sections } from './facts';

test('plain values stand first, objects become sections', () => {
  expect(sections({ model: 'CPU', memory: { work: 49152, used: null }, leds: ['SF', 'RUN'] })).toEqual([
    {
      name: '',
      facts: [
        { name: 'model', value: 'CPU' },
        { name: 'leds', value: 'SF, RUN' },
      ],
    },
    {
      name: 'memory',
      facts: [
        { name: 'work', value: '49152' },
        { name: 'used', value: '–' },
      ],
    },
  ]);
});
