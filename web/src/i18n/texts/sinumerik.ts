import type { Texts } from '..';

/** What there is not, or not in the same way, where the project is a STEP 5 program of a SINUMERIK. */
export const sinumerik = {
  hardware: [
    'Die PLC einer SINUMERIK 810/820 hat keinen Baugruppenträger, der sich aufbauen ließe. Maschinendaten, Alarmtexte und NC-Werte stehen in merker.toml.',
    'The PLC of a SINUMERIK 810/820 has no rack to configure. Machine data, alarm texts and values of the NC are in merker.toml.',
  ],
  openText: ['merker.toml als Text', 'merker.toml as text'],
  symbols: [
    'Ein STEP-5-Programm hat hier keine Symboltabelle: Es wird mit absoluten Operanden geschrieben.',
    'A STEP 5 program has no symbol table here: it is written with absolute operands.',
  ],
  blocks: [
    'Die Bausteine stehen in den Dateien. „Laden“ übersetzt alle und startet die PLC neu.',
    'The blocks are in the files. “Load” compiles all of them and starts the PLC anew.',
  ],
  stacks: [
    'Stacks zeigt die Seite nur von einer SIMATIC S7. Alarme und Meldungen stehen im Diagnosepuffer.',
    'The page shows stacks of a SIMATIC S7 only. Alarms and messages are in the diagnostic buffer.',
  ],
} satisfies Texts;
