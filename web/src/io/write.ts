import { connection, Refused } from '../connection';
import { operandText, told } from '../i18n';
import { messages } from '../state/messages.svelte';

/** Writes one operand as a user typed it; a problem is shown with its operand. True if the CPU took it. */
export async function writeValue(operand: string, value: string, format: string): Promise<boolean> {
  try {
    await connection.ask('variables.write', { items: [{ operand, value, format }] });
    return true;
  } catch (error) {
    if (error instanceof Refused) tell(operandText(operand), told(error.problems[0]!));
    return false;
  }
}

function tell(operand: string, reason: string): void {
  messages.problem({ text: reason.includes(operand) ? reason : `${operand}: ${reason}` }, 'variables.write');
}
