import type { Text } from '.';

/** What F1 says about a view beyond its first sentence: how its work is done. */
export const help: Record<string, readonly Text[]> = {
  projects: [
    [
      'Ein Beispiel wird als Kopie geöffnet; „Neue Kopie“ gibt es, wie es war.',
      'An example opens as a copy; “New copy” gives it as it was.',
    ],
    [
      '„Weitere SPS …“ öffnet ein zweites Projekt, während dieses läuft; jede SPS hat ihre eigene Adresse.',
      '“Another PLC …” opens a second project while this one runs; each PLC has its own address.',
    ],
    [
      'In der Tabelle „Projekt und CPU“ werden Bausteine gewählt, geladen und zurückgeholt; ≠ führt zum Vergleich.',
      'In the table “Project and CPU” blocks are selected, loaded and uploaded; ≠ leads to the comparison.',
    ],
  ],
  hardware: [
    [
      'Im Betrieb: eine Baugruppe anklicken, rechts stehen ihre Klemmen mit Werten, links ihre Störungen zum Einschalten.',
      'In operation: click a module; on the right are its terminals with values, on the left the faults it can have.',
    ],
    [
      'Konfigurieren: eine Baugruppe aus dem Katalog auf den Steckplatz ziehen, oder beide nacheinander wählen.',
      'Configure: drag a module from the catalogue to a slot, or select one after the other.',
    ],
    [
      'Alt ↑ und Alt ↓ verschieben die Baugruppe, Entf entfernt sie; ⚠ kennzeichnet Steckplätze mit Hinweisen.',
      'Alt ↑ and Alt ↓ move the module, Del removes it; ⚠ marks slots with remarks.',
    ],
    ['Geladen wird nur im STOP.', 'The configuration is loaded in STOP only.'],
  ],
  symbols: [
    [
      'Höchstens 24 Zeichen, Kommentar 80; Datenworte haben ihre Namen im Datenbaustein, nicht hier.',
      'At most 24 characters, 80 of a comment; data words have their names in the data block, not here.',
    ],
    [
      'Enter geht eine Zeile tiefer, in der letzten entsteht eine neue; ein Klick auf den Kopf sortiert.',
      'Enter goes one row down and makes a new one at the end; a click on the heading sorts.',
    ],
    [
      'Solange eine Zeile falsch ist, wird nichts gespeichert und nichts geht verloren.',
      'While a row is wrong nothing is saved, and nothing is lost.',
    ],
  ],
  program: [
    [
      'Speichern mit Strg S, laden mit Strg L; in RUN lehnt die CPU das Laden ab, in RUN-P und STOP nicht.',
      'Save with Ctrl S, load with Ctrl L; the CPU refuses in RUN, not in RUN-P and STOP.',
    ],
    [
      '„Status“ zeigt VKE, STA und AKKU 1 neben jeder Anweisung; unter „Spalten“ stehen weitere, und der Wert am Operanden.',
      '“Status” shows RLO, STA and ACCU 1 beside each statement; “Columns” has more, and the value beside the operand.',
    ],
    [
      '„Datensicht“ zeigt einen Datenbaustein mit Anfangs- und Aktualwerten; Enter steuert einen Wert.',
      '“Data view” shows a data block with initial and actual values; Enter modifies a value.',
    ],
    [
      'Unten: Fehler, Beobachten, Suchen, Referenzdaten, Maschinencode, Vergleich; die Kanten lassen sich ziehen.',
      'Below: problems, monitor, find, reference data, machine code, comparison; the edges can be drawn.',
    ],
  ],
  io: [
    [
      'Ein Klick auf ein Bit eines Eingangs setzt seine Klemme; ein anderes Format ändert nur die Anzeige.',
      'A click on a bit of an input sets its terminal; another format changes the display only.',
    ],
    [
      'Weitere Kacheln: EB 0, MW 10, T 1, Z 1 oder DB1.DBW 0 eingeben.',
      'More tiles: enter IB 0, MW 10, T 1, C 1 or DB1.DBW 0.',
    ],
  ],
  variables: [
    [
      'Ein Bereich (MW 10..20, E 0.0-E 0.7), Zeilen einer Tabellenkalkulation und „Aus den Symbolen …“ füllen viele Zeilen auf einmal.',
      'A range (MW 10..20, I 0.0-I 0.7), lines of a spreadsheet and “From the symbols …” fill many rows at once.',
    ],
    [
      'Enter im Operanden geht zur nächsten Zeile, ↑ und ↓ zur vorigen und nächsten, Strg Ende zur letzten.',
      'Enter in the operand goes to the next row, ↑ and ↓ to the previous and next one, Ctrl End to the last.',
    ],
    [
      '„Steuern“ schreibt alle Steuerwerte gemeinsam; „Trigger …“ bestimmt, an welcher Stelle des Zyklus.',
      '“Modify” writes all modify values together; “Trigger …” says where in the cycle.',
    ],
    [
      'Geforct werden nur Ein- und Ausgänge; die Liste rechts hebt es auf.',
      'Only inputs and outputs are forced; the list on the right releases them.',
    ],
  ],
  process: [
    [
      'Die Schilder zeigen Operand und Wert; ein Klick lässt den Geber oder das Stellglied hängen.',
      'The plates show operand and value; a click makes the sensor or actuator stick.',
    ],
    [
      'Taster wirken, solange Zeiger oder Leertaste sie halten.',
      'Buttons act as long as the pointer or the space bar holds them.',
    ],
    [
      '„Bilder …“ sind selbst gezeichnete Bedienbilder, auch als eigene Seite.',
      '“Pictures …” are operating pictures of your own, also as a page of their own.',
    ],
  ],
  trends: [
    [
      'Ziehen oder + und - vergrößern, ein Doppelklick zeigt wieder die Gegenwart.',
      'Drag, or + and -, to zoom; a double click shows the present again.',
    ],
    ['„Pause“ hält das Bild an, aufgezeichnet wird weiter.', '“Pause” keeps the picture while recording goes on.'],
  ],
  diagnosis: [
    [
      'Der Puffer beginnt mit dem neuesten Ereignis; die Hilfe rechts sagt, was zu tun ist, und führt zu Baustein oder Baugruppe.',
      'The buffer begins with the newest event; the help beside it says what to do and leads to block or module.',
    ],
    [
      'B-, U- und L-Stack gelten im STOP und HALT; die Lokaldaten stehen mit ihren Namen da.',
      'B, I and L stack are those of STOP and HALT; local data have their names.',
    ],
  ],
  nc: [
    [
      'Einen Wert eintippen und mit Eingabe schreiben; das Programm liest ihn mit FB 56, 57, 58 oder 61, Signale ab dem nächsten Zyklus in MB 17 bis MB 24.',
      'Type a value and write it with Enter; the program reads it by FB 56, 57, 58 or 61, signals from the next cycle on in MB 17 to MB 24.',
    ],
    [
      'Dieselben Werte heißen in Variablentabellen, Kurven und Szenarien nc.position 1, nc.R 50, nc.tool 5.2.',
      'In variable tables, trends and scenarios the same values are called nc.position 1, nc.R 50, nc.tool 5.2.',
    ],
  ],
  serial: [
    [
      'Oben sendet X27, unten ihr Partner; ein Kästchen ist so lang wie das Zeichen dauert.',
      'Above X27 sends, below its partner; a box is as long as its character takes.',
    ],
    [
      'Der Partner des Simulators sendet Text oder Bytes (02 41 03 BCC) und beantwortet, was für ihn eingetragen ist.',
      'The partner of the simulator sends text or bytes (02 41 03 BCC) and answers what is entered for it.',
    ],
  ],
  pictures: [
    [
      '„Bearbeiten“: ein Symbol einfügen, ziehen oder mit den Pfeiltasten schieben, mit ⇧ die Größe ändern, Entf löscht.',
      '“Edit”: insert a symbol, drag it or move it with the arrow keys, with ⇧ change its size, Del deletes.',
    ],
    [
      'Mehrere Symbole: Strg- oder ⇧-Klick, ein Rahmen mit der Maus, Strg A; mit der Tastatur hält die Leertaste eines fest, Tab geht weiter, Esc wählt wieder nur eines. Sie werden zusammen verschoben, ausgerichtet, kopiert, gelöscht.',
      'Several symbols: Ctrl or ⇧ click, a frame drawn with the mouse, Ctrl A; with the keyboard the space bar keeps one, Tab goes on, Esc chooses only one again. They are moved, aligned, copied and deleted together.',
    ],
    ['Jede Änderung steht sofort in der Datei des Bildes.', 'Each change is in the file of the picture at once.'],
  ],
  compare: [
    [
      'Links und rechts wählen, womit verglichen wird; „nur Text“ heißt gleicher Code aus anderem Text.',
      'Choose on the left and right what is compared; “text only” is the same code from another text.',
    ],
  ],
  stations: [
    [
      'Eine Station anklicken öffnet sie: alle anderen Ansichten handeln dann von ihr.',
      'A click on a station opens it: all other views are about it then.',
    ],
    [
      'Leitungen lassen sich in der Tabelle der Subnetze unterbrechen und verzögern, Stecker an den Stationen ziehen.',
      'Lines are broken and delayed in the table of subnets, plugs pulled at the stations.',
    ],
  ],
};
