// A project that was opened without a place shows its OB 1, or else its first source.
import { route } from '../app/route.svelte';
import { plc } from '../state/plc.svelte';
import { quiet, workspace } from './workspace.svelte';

/** As long as the calling component lives. */
export function showFirstText(openBlock: (id: string) => void): void {
  $effect(() => {
    if (workspace.current || route.params.file || route.params.block || !workspace.isOf(plc.project?.folder)) return;
    const entry = workspace.blocks.offline.find((one) => one.id === 'OB 1' && one.file);
    const first = workspace.files.find((file) => file.kind === 'source');
    // While a project gives way to another one its files may be gone: nobody asked for them.
    if (entry?.file) void workspace.open(entry.file, quiet).then((opened) => opened && openBlock(entry.id));
    else if (first && workspace.checked) void workspace.open(first.path, quiet);
  });
}
