import { namesOf, shownValue, type Curve } from './curves';
import { colour, tokenOf } from './look';

/** Gives the user a file. */
export function download(name: string, content: Blob): void {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(content);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 1000);
}

/** The chart as a picture, with its curves named above it. */
export function picture(chart: HTMLCanvasElement, curves: Curve[], values: (number | null)[]): Promise<Blob | null> {
  const scale = window.devicePixelRatio;
  const line = 22 * scale;
  const margin = 12 * scale;
  const canvas = document.createElement('canvas');
  canvas.width = chart.width + 2 * margin;
  canvas.height = chart.height + curves.length * line + 2 * margin;
  const pen = canvas.getContext('2d')!;
  pen.fillStyle = colour('--raised');
  pen.fillRect(0, 0, canvas.width, canvas.height);
  pen.font = `${13 * scale}px sans-serif`;
  pen.textBaseline = 'middle';
  curves.forEach((curve, index) => {
    const y = margin + (index + 0.5) * line;
    pen.fillStyle = colour(tokenOf(index));
    pen.fillRect(margin, y - 2 * scale, 20 * scale, 4 * scale);
    pen.fillStyle = colour('--ink');
    const { name, others } = namesOf(curve);
    pen.fillText(`${[name, ...others].join('  ')}   ${shownValue(curve, values[index])}`, margin + 30 * scale, y);
  });
  pen.drawImage(chart, margin, margin + curves.length * line);
  return new Promise((done) => canvas.toBlob(done, 'image/png'));
}
