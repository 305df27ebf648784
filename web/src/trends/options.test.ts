import { expect, test } from 'vitest';
import type uPlot from 'uplot';
import type { Curve } from './curves';
import { axisSize, chartOptions } from './options';

const curve = (operand: string, bits: number, type?: string): Curve => ({
  operand,
  address: operand,
  symbol: '',
  unit: '',
  bits,
  type,
});

test('whole numbers have whole steps, REAL has others', () => {
  const steps = (...curves: Curve[]) => (chartOptions(curves, 500, 300).axes![1]!.incrs as number[] | undefined) ?? [];
  expect(steps(curve('MW 2', 16, 'INT'), curve('T 1', 16, 'TIMER')).every(Number.isInteger)).toBe(true);
  expect(steps(curve('MW 2', 16, 'INT'))[0]).toBe(1);
  expect(steps(curve('MW 2', 16, 'INT'), curve('MD 4', 32, 'REAL'))).toEqual([]);
  expect(steps(curve('plant.Belt.SPEED', 0))).toEqual([]);
});

test('beside the lanes of bits there are no numbers, ticks and lines', () => {
  const { axes } = chartOptions([curve('M 0.0', 1, 'BOOL'), curve('MW 2', 16, 'INT')], 500, 300);
  const axis = axes![1]!;
  const plot = { scales: { 'unit ': { min: 0, max: 100 } } } as unknown as uPlot;
  for (const filter of [axis.filter, axis.ticks!.filter, axis.grid!.filter])
    expect(filter!(plot, [0, 10, 20, 50], 1, 1, 1)).toEqual([null, null, 20, 50]);
  const texts = axis.values as (plot: uPlot, splits: (number | null)[]) => string[];
  expect(texts(plot, [null, 20, 50])).toEqual(['', '20', '50']);
});

test('an axis has room for its longest number', () => {
  const plot = {} as uPlot;
  expect(axisSize(plot, null)).toBe(60);
  expect(axisSize(plot, ['', '-5'])).toBe(60);
  expect(axisSize(plot, ['0', '1000000000'])).toBeGreaterThanOrEqual(10 * 7.2 + 8);
});
