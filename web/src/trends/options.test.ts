import { expect, test } from 'vitest';
import type uPlot from 'uplot';
import { axisSize } from './options';

test('an axis has room for its longest number', () => {
  const plot = {} as uPlot;
  expect(axisSize(plot, null)).toBe(60);
  expect(axisSize(plot, ['', '-5'])).toBe(60);
  expect(axisSize(plot, ['0', '1000000000'])).toBeGreaterThanOrEqual(10 * 7.2 + 8);
});
