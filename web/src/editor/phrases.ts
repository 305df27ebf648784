// The editor's own words in German; in English they are as they come.
import { EditorState, type Extension } from '@codemirror/state';
import { language } from '../i18n';

const german: Record<string, string> = {
  'Go to line': 'Gehe zu Zeile',
  go: 'gehe',
  Find: 'Suchen',
  Replace: 'Ersetzen',
  next: 'nächste',
  previous: 'vorige',
  all: 'alle',
  'match case': 'Groß/klein',
  regexp: 'Ausdruck',
  'by word': 'ganzes Wort',
  replace: 'ersetzen',
  'replace all': 'alle ersetzen',
  close: 'schließen',
  'current match': 'aktueller Treffer',
  'replaced $ matches': '$ Treffer ersetzt',
  'replaced match on line $': 'Treffer in Zeile $ ersetzt',
  'on line': 'in Zeile',
  Completions: 'Vorschläge',
  '$ unchanged lines': '$ gleiche Zeilen',
  Diagnostics: 'Fehler',
  'No diagnostics': 'Keine Fehler',
};

export const phrases = (): Extension => (language.value === 'de' ? EditorState.phrases.of(german) : []);
