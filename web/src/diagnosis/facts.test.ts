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

test('the order is that of a person, not of the alphabet; a cycle below a millisecond is not nothing', () => {
  const [cycle] = sections({ cycle: { cycles: 7, lastMs: 0, longestMs: 2, monitoringMs: 150, shortestMs: 0 } });
  expect(cycle!.facts.map((fact) => `${fact.name} ${fact.value}`)).toEqual([
    'lastMs < 1',
    'shortestMs < 1',
    'longestMs 2',
    'monitoringMs 150',
    'cycles 7',
  ]);
});

test('a CPU that never ran has no cycle times', () => {
  const [cycle] = sections({ cycle: { cycles: 0, lastMs: 0, longestMs: 0, monitoringMs: 150, shortestMs: 0 } });
  expect(cycle!.facts.map((fact) => fact.value)).toEqual(['–', '–', '–', '150', '0']);
});

test('what a machine does not have is not shown as zero', () => {
  const [memory, cycle] = sections({
    clock: '',
    memory: { loadMemory: 0, workMemory: 4096, localData: 0 },
    cycle: { lastMs: 0, shortestMs: 0, longestMs: 0, monitoringMs: 0, cycles: 7 },
  });
  expect(memory!.facts).toEqual([{ name: 'workMemory', value: '4096' }]);
  expect(cycle!.facts).toEqual([{ name: 'cycles', value: '7' }]);
});
