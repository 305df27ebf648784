import type uPlot from 'uplot';
import { isWhole, laneShare, scaleOf, titleOf, type Curve } from './curves';
import { inNumbers } from '../i18n';
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

/** Steps between the numbers of whole values: 1, 2, 5, 10 … */
const WHOLE = Array.from({ length: 10 }, (_, power) => [1, 2, 5].map((one) => one * 10 ** power)).flat();

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
    const pad = highest > lowest ? (highest - lowest) * 0.05 : Math.abs(highest) * 0.1 || 1;
    const bottom = lowest - pad;
    const top = highest + pad;
    return [bottom - ((top - bottom) * share) / (1 - share), top];
  };
}

/** Beside the lanes there are no numbers, ticks and lines. */
function aboveLanes(share: number, unit: string): uPlot.Axis.Filter {
  return (plot, splits) => {
    const { min = 0, max = 1 } = plot.scales[unit] ?? {};
    return splits.map((value) => (value < min! + share * (max! - min!) ? null : value));
  };
}

function numberTexts(unit: string): uPlot.Axis.Values {
  return (plot, splits) => {
    const { min = 0, max = 1 } = plot.scales[unit] ?? {};
    const digits = Math.max(0, Math.min(6, 1 - Math.floor(Math.log10((max! - min!) / 5 || 1))));
    const text = (value: number) => inNumbers(String(Number(value.toFixed(digits))));
    return splits.map((value) => (value === null ? '' : text(value)));
  };
}

/** As wide as its longest number. A letter of the narrow script is 7.2 px wide. */
export const axisSize = (_: uPlot, texts: (string | null)[] | null): number =>
  Math.max(60, 16 + 7.3 * Math.max(0, ...(texts ?? []).map((text) => (text ?? '').length)));

type Drawn = (plot: uPlot) => void;
const laneFloor = (plot: uPlot, lanes: number, lane: number): number =>
  plot.valToPos(lanes - lane - 1 + 0.125, 'bits', true);

function lineLanes(lanes: number): Drawn {
  return (plot) => {
    plot.ctx.fillStyle = colour('--line-strong');
    for (let lane = 0; lane < lanes; lane++)
      plot.ctx.fillRect(plot.bbox.left, Math.round(laneFloor(plot, lanes, lane)), plot.bbox.width, 1);
  };
}

/** The names of the bits stand in their lanes, over the curves, with a rim of the ground. */
function nameLanes(names: string[]): Drawn {
  return (plot) => {
    const { ctx, bbox } = plot;
    ctx.save();
    ctx.lineJoin = 'round';
    ctx.lineWidth = 5 * devicePixelRatio;
    ctx.strokeStyle = colour('--raised');
    ctx.fillStyle = colour('--ink-soft');
    ctx.font = `${12 * devicePixelRatio}px "Liberation Mono", "DejaVu Sans Mono", monospace`;
    ctx.textBaseline = 'bottom';
    ctx.textAlign = 'left'; // the axes have left another one
    names.forEach((name, lane) => {
      const y = laneFloor(plot, names.length, lane) - 3 * devicePixelRatio;
      ctx.strokeText(name, bbox.left + 6 * devicePixelRatio, y);
      ctx.fillText(name, bbox.left + 6 * devicePixelRatio, y);
    });
    ctx.restore();
  };
}

export function chartOptions(curves: Curve[], width: number, height: number): uPlot.Options {
  const share = laneShare(curves);
  const names = curves.filter((curve) => curve.bits === 1).map(titleOf);
  const bits = names.length;
  const units = [...new Set(curves.filter((curve) => curve.bits !== 1).map(scaleOf))];
  const scales: uPlot.Scales = { x: { time: false } };
  if (bits) scales.bits = { range: [0, bits / share] };
  for (const unit of units) scales[unit] = { range: numbers(share) };
  const axes: uPlot.Axis[] = [{ ...axisLook(), values: (_, splits) => splits.map(clock), space: 90 }];
  units.forEach((unit, index) => {
    const filter = aboveLanes(share, unit);
    const look = axisLook();
    axes.push({
      ...look,
      scale: unit,
      side: index % 2 ? 1 : 3,
      size: axisSize,
      values: numberTexts(unit),
      filter,
      ticks: { ...look.ticks, filter },
      ...(curves.every((curve) => scaleOf(curve) !== unit || isWhole(curve)) ? { incrs: WHOLE } : {}),
      label: unit === 'unit ' ? undefined : unit.slice(5).replace('degC', '°C'),
      labelFont: FONT,
      labelSize: 18,
      grid: index ? { show: false } : { ...look.grid, filter },
    });
  });
  return {
    width,
    height,
    scales,
    axes,
    legend: { show: false },
    hooks: bits ? { drawAxes: [lineLanes(bits)], draw: [nameLanes(names)] } : {},
    cursor: { drag: { x: true, y: false, setScale: false }, points: { size: 7 } },
    series: [{}, ...curves.map((curve, index) => series(curve, index))],
  };
}

function series(curve: Curve, index: number): uPlot.Series {
  return {
    label: titleOf(curve),
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
