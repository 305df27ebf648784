// Where a variable table monitors and modifies (S7-MGR-16).

export const POINTS = ['now', 'begin', 'end', 'stop'] as const;
export type Point = (typeof POINTS)[number];

export interface Trigger {
  point: Point;
  once: boolean;
}

export const atOnce: Trigger = { point: 'now', once: false };

/** The line of a table's file that says it; none where everything happens at once. */
export function printTriggers(monitor: Trigger, modify: Trigger): string {
  const text = ({ point, once }: Trigger) => `${point} ${once ? 'once' : 'every'}`;
  if (monitor.point === 'now' && modify.point === 'now') return '';
  return `// trigger: monitor ${text(monitor)}; modify ${text(modify)}`;
}

const part = (what: string): string =>
  String.raw`${what} (?<${what}Point>now|begin|end|stop) (?<${what}Often>once|every)`;
const whole = new RegExp(String.raw`^// trigger: ${part('monitor')}; ${part('modify')}$`);

/** The first line that says them; any other one is a comment. */
export const triggerLine = (lines: readonly string[]): string | undefined =>
  lines.map((line) => line.trim()).find((line) => whole.test(line));

export function parseTriggers(text: string): { monitor: Trigger; modify: Trigger } {
  const found = whole.exec(triggerLine(text.split('\n')) ?? '')?.groups;
  if (!found) return { monitor: { ...atOnce }, modify: { ...atOnce } };
  const trigger = (what: string): Trigger => ({
    point: found[`${what}Point`] as Point,
    once: found[`${what}Often`] === 'once',
  });
  return { monitor: trigger('monitor'), modify: trigger('modify') };
}
