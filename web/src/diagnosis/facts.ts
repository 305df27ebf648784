// Names and values of an answer as rows to show: nested objects become sections of their own.

export type Fact = { name: string; value: string };
export interface Section {
  name: string;
  facts: Fact[];
}

/** In the order in which a person looks; JSON has none. What is not named here comes last. */
const ORDER = ['model', 'mode', 'stopReason', 'clock', 'memory', 'cycle', 'limits']
  .concat(['loadMemory', 'workMemory', 'workMemoryUsed', 'localData', 'blocks'])
  .concat(['lastMs', 'shortestMs', 'longestMs', 'monitoringMs', 'cycles', 'instructions'])
  .concat(['inputs', 'outputs', 'flags', 'timers', 'counters']);
const rank = (key: string) => (ORDER.includes(key) ? ORDER.indexOf(key) : ORDER.length);

/** A machine without the first has none of the others: its zeros were not measured. */
const TOGETHER: Record<string, string[]> = {
  localData: ['loadMemory'],
  monitoringMs: ['lastMs', 'shortestMs', 'longestMs'],
};
const MEASURED = ['lastMs', 'shortestMs', 'longestMs'];
/** Of a cycle of less than a millisecond, or of none. */
const brief = (answer: Record<string, unknown>) => (answer.cycles === 0 ? '–' : '< 1');
const missing = (answer: Record<string, unknown>) =>
  Object.entries(TOGETHER).flatMap(([key, others]) => (answer[key] === 0 ? [key, ...others] : []));

export function sections(answer: Record<string, unknown>, name = ''): Section[] {
  const own: Section = { name, facts: [] };
  const below: Section[] = [];
  const left = missing(answer);
  for (const [key, value] of Object.entries(answer).sort(([a], [b]) => rank(a) - rank(b))) {
    if (value === '' || left.includes(key)) continue;
    if (isObject(value)) below.push(...sections(value, key));
    else own.facts.push({ name: key, value: MEASURED.includes(key) && value === 0 ? brief(answer) : print(value) });
  }
  return [...(own.facts.length ? [own] : []), ...below];
}

const isObject = (value: unknown): value is Record<string, unknown> =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

function print(value: unknown): string {
  if (Array.isArray(value)) return value.map(print).join(', ');
  return value === null || value === undefined ? '–' : String(value);
}
