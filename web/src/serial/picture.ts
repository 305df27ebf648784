// The picture of the line: two lanes over time, a box for each character.
import { clock } from '../trends/options';
import { colour } from '../trends/look';
import { between, hex, isBad, type Character } from './characters';

export const AXIS = 24; // px below the lanes
const NAMES = 76; // px beside them
const GAP = 8;

/** Steps of the time axis: 1, 2, 5 times a power of ten, at least `least` wide. */
export function stepOf(least: number): number {
  const power = 10 ** Math.floor(Math.log10(least));
  return ([1, 2, 5].find((one) => one * power >= least * 0.999_999) ?? 10) * power;
}

/** Texts of the axis with as many digits as the step needs. */
export function timeText(seconds: number, step: number): string {
  if (step >= 0.001) return clock(seconds);
  const digits = Math.min(6, Math.ceil(-Math.log10(step)));
  return `${clock(Math.floor(seconds))}.${(seconds % 1).toFixed(digits).slice(2)}`;
}

export interface Window {
  from: number;
  to: number;
}

/** Seconds to pixels. */
export const scale = (width: number, { from, to }: Window) => {
  const inner = Math.max(width - NAMES, 1);
  return {
    x: (time: number) => NAMES + ((time - from) / (to - from)) * inner,
    time: (x: number) => from + ((x - NAMES) / inner) * (to - from),
  };
};

interface Look {
  width: number;
  height: number;
  names: [string, string];
  hexadecimal: boolean;
}

const FONT = '12px "Liberation Mono", "DejaVu Sans Mono", monospace';

/** What stands in a box: the name, else the character itself. */
const label = (one: Character, hexadecimal: boolean) =>
  hexadecimal || !one.name ? hex(one.value) : one.name.replace(/^'(.)'$/, '$1');

export function draw(pen: CanvasRenderingContext2D, all: readonly Character[], window: Window, look: Look): void {
  const { width, height } = look;
  const lane = (height - AXIS) / 2;
  const to = scale(width, window);
  pen.clearRect(0, 0, width, height);
  pen.font = FONT;
  pen.textBaseline = 'middle';
  axis(pen, window, look);
  look.names.forEach((name, index) => {
    pen.textAlign = 'left';
    pen.fillStyle = colour('--ink');
    pen.fillText(name, GAP, lane * (index + 0.5), NAMES - 2 * GAP);
  });
  pen.save();
  pen.beginPath();
  pen.rect(NAMES, 0, width - NAMES, height);
  pen.clip();
  pen.textAlign = 'center';
  for (const one of between(all, window.from, window.to)) {
    const left = to.x(one.begin);
    const wide = Math.max(to.x(one.end) - left, 1);
    const top = lane * one.from + GAP;
    pen.fillStyle = colour(isBad(one) ? '--danger' : one.meaning ? '--accent' : '--curve-3');
    pen.fillRect(left, top, Math.max(wide - 1, 1), lane - 2 * GAP);
    const text = label(one, look.hexadecimal);
    if (pen.measureText(text).width + 4 > wide) continue;
    pen.fillStyle = colour('--raised');
    pen.fillText(text, left + wide / 2, top + lane / 2 - GAP);
  }
  pen.restore();
}

function axis(pen: CanvasRenderingContext2D, window: Window, { width, height }: Look): void {
  const bottom = height - AXIS;
  const to = scale(width, window);
  const step = stepOf(((window.to - window.from) * 110) / Math.max(width - NAMES, 1));
  pen.textAlign = 'center';
  // The line begins with the PLC: before that there is no time.
  for (let number = Math.ceil(Math.max(window.from, 0) / step); number * step <= window.to; ++number) {
    const x = Math.round(to.x(number * step));
    pen.fillStyle = colour('--line');
    pen.fillRect(x, 0, 1, bottom + 4);
    pen.fillStyle = colour('--ink-soft');
    pen.fillText(timeText(number * step, step), x, bottom + AXIS / 2 + 2);
  }
  pen.fillStyle = colour('--line-strong');
  pen.fillRect(NAMES, bottom, width - NAMES, 1);
  pen.fillRect(NAMES, Math.round(bottom / 2), width - NAMES, 1);
}
