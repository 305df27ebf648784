// The blocks and networks of a STEP 5 listing (docs/formats/listing.md), read from its text while it is being typed.
import { outline, type BlockOutline } from './outline';

export const isListing = (path: string): boolean => path.toLowerCase().endsWith('.s5');

export const outlineOf = (path: string, text: string): BlockOutline[] =>
  isListing(path) ? listingOutline(text) : outline(text);

// "FB 5   VENTIL   BIB=14050"; "PB: EB 2" is a parameter.
const head = /^\s*(OB|PB|SB|FB|DB)\s*(\d+)\b(?!\s*:)\s*(.*)$/i;
const network = /^\s*(?:NETZWERK|NETWORK|SEGMENT)\s+\d+\s*(.*)$/i;
const name = /^\s*NAME\s*:\s*(\S+)/i;
const comment = /\s*(?:\/\/|;|!(?!=)).*$/;

export function listingOutline(text: string): BlockOutline[] {
  const blocks: BlockOutline[] = [];
  let justBegun = false;
  text.split('\n').forEach((written, index) => {
    const line = written.replace(comment, '');
    const begun = head.exec(line);
    if (begun) blocks.push(blockOf(begun, index + 1));
    const block = blocks.at(-1);
    if (!block) return;
    block.end = index + 1;
    if (line.trim() === '') return;
    // Behind a call NAME is that of the called block.
    if (justBegun) block.title ||= name.exec(line)?.[1] ?? '';
    justBegun = begun !== null;
    const title = network.exec(line)?.[1];
    if (title !== undefined) block.networks.push({ line: index + 1, title });
  });
  return blocks;
}

function blockOf([, kind = '', number = '', rest = '']: RegExpExecArray, line: number): BlockOutline {
  const keyword = kind.toUpperCase();
  return {
    keyword,
    name: `${keyword} ${Number(number)}`,
    title: keyword === 'FB' ? rest.replace(/\b(?:BIB|LAE)\s*=.*$/i, '').trim() : '',
    hasCode: keyword !== 'DB',
    declares: false,
    line,
    end: line,
    begin: 0,
    sections: [],
    declarations: [],
    networks: [],
    labels: [],
  };
}
