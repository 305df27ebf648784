// Where a variable table monitors and modifies (S7-MGR-16).

export const POINTS = ['now', 'begin', 'end', 'stop'] as const;
export type Point = (typeof POINTS)[number];

export interface Trigger {
  point: Point;
  once: boolean;
}

export const atOnce: Trigger = { point: 'now', once: false };

/** How the line of a table's file begins that names them. */
export const TRIGGERS = '// trigger:';

/** The line of a table's file that says it; none where everything happens at once. */
export function printTriggers(monitor: Trigger, modify: Trigger): string {
  const text = ({ point, once }: Trigger) => `${point} ${once ? 'once' : 'every'}`;
  if (monitor.point === 'now' && modify.point === 'now') return '';
  return `${TRIGGERS} monitor ${text(monitor)}; modify ${text(modify)}`;
}

export function parseTriggers(text: string): { monitor: Trigger; modify: Trigger } {
  const trigger = (what: string): Trigger => {
    const line = /^\/\/ trigger:.*$/m.exec(text)?.[0] ?? '';
    const found = new RegExp(`\\b${what} (now|begin|end|stop) (once|every)\\b`).exec(line);
    return found ? { point: found[1] as Point, once: found[2] === 'once' } : { ...atOnce };
  };
  return { monitor: trigger('monitor'), modify: trigger('modify') };
}
