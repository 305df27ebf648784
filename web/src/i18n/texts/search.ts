import type { Texts } from '..';

export const search = {
  title: ['Suchen', 'Find'],
  text: ['Text, auch ein Teil eines Wortes', 'Text, also a part of a word'],
  matchCase: ['Groß/klein', 'Match case'],
  wholeWord: ['Ganzes Wort', 'Whole word'],
  replacement: ['Ersetzen durch', 'Replace with'],
  preview: ['Vorschau', 'Preview'],
  replace: ['{count} ersetzen', 'Replace {count}'],
  replaceHere: ['Ersetzen in {place}', 'Replace in {place}'],
  replaced: [
    '{count} {count|Stelle|Stellen} in {files} {files|Datei|Dateien} ersetzt.',
    '{count} {count|place|places} in {files} {files|file|files} replaced.',
  ],
  unsaved: ['Noch nicht gespeichert.', 'Not yet saved.'],
  undo: ['Rückgängig', 'Undo'],
  undone: ['{files} {files|Datei|Dateien} wie vor dem Ersetzen.', '{files} {files|file|files} as before replacing.'],
  changedSince: [
    'Seit dem Ersetzen geändert und so gelassen: {files}',
    'Changed since the replacement and left as they are: {files}',
  ],
  saveAll: ['{count} {count|Datei|Dateien} speichern', 'Save {count} {count|file|files}'],
  saved: ['Alles gespeichert.', 'Everything saved.'],
  count: [
    '{count} {count|Stelle|Stellen} in {files} {files|Datei|Dateien}, {blocks} {blocks|Baustein|Bausteine}',
    '{count} {count|place|places} in {files} {files|file|files}, {blocks} {blocks|block|blocks}',
  ],
  results: ['Gefundene Stellen', 'Places found'],
  nothing: ['Nichts gefunden.', 'Nothing found.'],
  hint: [
    'Quellen, Symbole, Kommentare, Daten und Bausteine: ab zwei Zeichen wird gesucht.',
    'Sources, symbols, comments, data and blocks: two characters start the search.',
  ],
  unread: ['Nicht lesbar: {files}', 'Cannot be read: {files}'],
} satisfies Texts;
