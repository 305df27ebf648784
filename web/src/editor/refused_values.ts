// Which of several modify values a refusal of the CPU means: none of them has been written.

interface Item {
  operand: string;
  value: string;
}

/** The problem names the operand or the value, in the words of the user; who names neither means all. */
export function refusedItems<T extends Item>(items: readonly T[], problem: { arguments: readonly string[] }): T[] {
  const named = (of: (item: T) => string) => items.filter((item) => problem.arguments.includes(of(item).trim()));
  const found = [named((item) => item.operand), named((item) => item.value)].find((some) => some.length > 0);
  return found ?? [...items];
}
