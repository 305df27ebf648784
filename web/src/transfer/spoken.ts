// A line of an import's report in the language of the page.
import type { ReportRow } from '../connection/protocol';
import { said, told } from '../i18n';

/** The sentence of a problem that the line quotes is told by its code. */
export const spoken = ({ text, quoted }: ReportRow): string =>
  said(quoted ? text.replace(quoted.text, () => told(quoted)) : text);
