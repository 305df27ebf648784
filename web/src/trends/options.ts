import type uPlot from 'uplot';
import { laneShare, scaleOf, type Curve } from './curves';
import { colour, dashOf, tokenOf } from './look';

const FONT = '12px "Liberation Mono", "DejaVu Sans Mono", monospace';

/** Virtual time on the axis: 1:02:03.4. */
export function clock(seconds: number): string {
  const whole = Math.floor(seconds);
  const rest = seconds - whole;
  const two = (value: number) => String(value).padStart(2, '0');
  const text = `${Math.floor(whole / 3600)}:${two(Math.floor(whole / 60) % 60)}:${two(whole % 60)}`;
  return rest > 0.0005 ? `${text}.${rest.toFixed(3).slice(2).replace(/0+$/, '')}` : text;
}

const axisLook = () => ({
  stroke: () => colour('--ink-soft'),
  font: FONT,
  grid: { stroke: () => colour('--line'), width: 1 },
  ticks: { stroke: () => colour('--line-strong'), width: 1, size: 4 },
});

/** The range of numbers leaves the lower part of the chart to the lanes of the bits. */
function numbers(share: number): uPlot.Scale.Range {
  return (_, low, high) => {
    const lowest = low ?? 0;
    const highest = high ?? 1;
    const span = highest - lowest || Math.abs(highest) || 1;
    const bottom = lowest - span * 0.05;
    const top = highest + span * 0.05;
    return [bottom - ((top - bottom) * share) / (1 - share), top];
  };
}

function laneAxis(curves: Curve[], right: boolean): uPlot.Axis {
  const names = curves.filter((curve) => curve.bits === 1).map((curve) => curve.symbol || curve.address);
  return {
    ...axisLook(),
    scale: 'bits',
    side: right ? 1 : 3,
    size: 150,
    splits: () => names.map((_, lane) => names.length - lane - 0.5),
    values: () => names.map((name) => (name.length > 18 ? `${name.slice(0, 17)}…` : name)),
    grid: { show: false },
    ticks: { show: false },
  };
}

export function chartOptions(curves: Curve[], width: number, height: number): uPlot.Options {
  const share = laneShare(curves);
  const bits = curves.filter((curve) => curve.bits === 1).length;
  const units = [...new Set(curves.filter((curve) => curve.bits !== 1).map(scaleOf))];
  const scales: uPlot.Scales = { x: { time: false } };
  if (bits) scales.bits = { range: [0, bits / share] };
  for (const unit of units) scales[unit] = { range: numbers(share) };
  const axes: uPlot.Axis[] = [{ ...axisLook(), values: (_, splits) => splits.map(clock), space: 90 }];
  units.forEach((unit, index) =>
    axes.push({
      ...axisLook(),
      scale: unit,
      side: index % 2 ? 1 : 3,
      size: 60,
      label: unit === 'unit ' ? undefined : unit.slice(5).replace('degC', '°C'),
      labelFont: FONT,
      labelSize: 18,
      grid: index ? { show: false } : axisLook().grid,
    }),
  );
  if (bits) axes.push(laneAxis(curves, units.length > 0));
  return {
    width,
    height,
    scales,
    axes,
    legend: { show: false },
    cursor: { drag: { x: true, y: false, setScale: false }, points: { size: 7 } },
    series: [{}, ...curves.map((curve, index) => series(curve, index))],
  };
}

function series(curve: Curve, index: number): uPlot.Series {
  return {
    label: curve.symbol || curve.address,
    scale: scaleOf(curve),
    stroke: () => colour(tokenOf(index)),
    width: 1.75,
    dash: dashOf(index),
    points: { show: false },
    // A bit and a whole number hold their value until the next sample.
    paths: curve.bits ? steps : undefined,
  };
}

let steps: uPlot.Series.PathBuilder | undefined;
export function useSteps(builder: uPlot.Series.PathBuilder): void {
  steps = builder;
}
