// Names of projects and files that this page proposes.

/** Of a copy: "press" gives "press Kopie", then "press Kopie 2"; what a project may not be called becomes "_". */
export function copyName(folder: string, word: string, taken: readonly string[]): string {
  const last = folder.replace(/\/+$/, '').split('/').at(-1) ?? '';
  const stem = last.replace(/\.[^.]*$/, '').replace(/[^\p{L}\p{N} _-]/gu, '_');
  const first = `${stem} ${word}`.trim();
  let name = first;
  for (let number = 2; taken.includes(name); number++) name = `${first} ${number}`;
  return name;
}

/** Of a file on the user's disk: "sub/main.awl" is main.awl, a block of the CPU "CPU: OB 1" is OB 1.awl. */
export function fileName(path: string): string {
  const last = path.split('/').at(-1)!;
  return last.startsWith('CPU: ') ? `${last.slice(5)}.awl` : last;
}

/** The one name of a folder: what lies in the workspace goes by its way from there. */
export function nameIn(workspace: string, folder: string): string {
  const start = `${workspace.replace(/\/+$/, '')}/`;
  return workspace && folder.startsWith(start) ? folder.slice(start.length) : folder;
}
