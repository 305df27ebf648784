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
    '{count} {count|Stelle|Stellen} in {files} {files|Datei|Dateien} ersetzt, noch nicht gespeichert.',
    '{count} {count|place|places} in {files} {files|file|files} replaced, not yet saved.',
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
