// The keys that hold in the whole program view, whichever of its parts has the keyboard.

export type Command = 'save' | 'load' | 'enter';

const commands: Record<string, Command> = { s: 'save', l: 'load', r: 'enter' };

export function commandOf(
  event: Pick<KeyboardEvent, 'key' | 'ctrlKey' | 'metaKey' | 'altKey' | 'shiftKey'>,
): Command | undefined {
  if (!(event.ctrlKey || event.metaKey) || event.altKey || event.shiftKey) return undefined;
  return commands[event.key.toLowerCase()];
}
