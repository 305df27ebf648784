// Times as the clock of a CPU is set: "2005-09-01 08:00:00.000".

const two = (number: number): string => String(number).padStart(2, '0');

/** The local time of this computer, for a CPU that knows no time zones. */
export function clockOf(now: Date): { date: string; time: string; parts: string } {
  return {
    date: `${now.getFullYear()}-${two(now.getMonth() + 1)}-${two(now.getDate())}`,
    time: `${two(now.getHours())}:${two(now.getMinutes())}:${two(now.getSeconds())}`,
    parts: String(now.getMilliseconds()).padStart(3, '0'),
  };
}

/** "24.12.2024", as a German date is written. */
const german = /^(\d{1,2})\.(\d{1,2})\.(\d{4})$/;

/** What was typed; seconds can be left out. Whether there is such a time the server says. */
export function clockText(date: string, time: string): string {
  const short = /^\s*\d{1,2}:\d\d\s*$/.test(time);
  const day = date.trim().replace(german, (_, day, month, year) => `${year}-${two(Number(month))}-${two(Number(day))}`);
  return `${day} ${time.trim()}${short ? ':00' : ''}`;
}
