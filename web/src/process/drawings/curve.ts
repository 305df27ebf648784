export interface Sample {
  /** Seconds of virtual time. */
  time: number;
  value: number;
}

const SPAN = 120;
const STEP = 0.2;

/** The samples of the last two minutes with a new one; from the beginning when time goes back. */
export function shownSpan(history: Sample[], sample: Sample): Sample[] {
  const last = history[history.length - 1];
  if (!last || sample.time < last.time) return [sample];
  if (sample.time - last.time < STEP) return history;
  return [...history.filter((one) => one.time >= sample.time - SPAN), sample];
}
