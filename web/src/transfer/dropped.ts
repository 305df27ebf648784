// What lies in a drop: files, and folders with all that is in them.

export interface Dropped {
  path: string;
  file: File;
}

/** A name that starts with a dot is hidden; what a path must not contain becomes "_". */
export function pathOf(parts: readonly string[]): string | undefined {
  if (parts.some((part) => part === '' || part.startsWith('.'))) return undefined;
  // eslint-disable-next-line no-control-regex
  return parts.map((part) => part.replace(/[\\:\u0000-\u001F\u007F]/g, '_')).join('/');
}

async function entriesOf(folder: FileSystemDirectoryEntry): Promise<FileSystemEntry[]> {
  const reader = folder.createReader();
  const all: FileSystemEntry[] = [];
  for (;;) {
    const some = await new Promise<FileSystemEntry[]>((done, failed) => reader.readEntries(done, failed));
    if (some.length === 0) return all;
    all.push(...some);
  }
}

async function collect(entry: FileSystemEntry, above: readonly string[], found: Dropped[]): Promise<void> {
  const parts = [...above, entry.name];
  const path = pathOf(parts);
  if (path === undefined) return;
  if (entry.isDirectory) {
    for (const one of await entriesOf(entry as FileSystemDirectoryEntry)) await collect(one, parts, found);
  } else {
    const file = await new Promise<File>((done, failed) => (entry as FileSystemFileEntry).file(done, failed));
    found.push({ path, file });
  }
}

/** The entries have to be taken before anything is waited for. */
export async function droppedFiles(data: DataTransfer): Promise<Dropped[]> {
  const entries = [...data.items].map((item) => item.webkitGetAsEntry()).filter((entry) => entry !== null);
  if (entries.length === 0) return chosenFiles([...data.files]);
  const found: Dropped[] = [];
  for (const entry of entries) await collect(entry, [], found);
  return found;
}

export function chosenFiles(files: readonly File[]): Dropped[] {
  return files.flatMap((file) => {
    const path = pathOf([file.name]);
    return path === undefined ? [] : [{ path, file }];
  });
}
