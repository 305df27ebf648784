import type { Texts } from '..';

/** What there is not, or not in the same way, where the project is a STEP 5 program of a SINUMERIK. */
export const sinumerik = {
  hardware: [
    'Die PLC einer SINUMERIK 810/820 hat keinen konfigurierbaren Baugruppenträger. Maschinendaten, Alarmtexte und NC-Werte werden in merker.toml angegeben.',
    'The PLC of a SINUMERIK 810/820 has no rack to configure. Machine data, alarm texts and values of the NC are in merker.toml.',
  ],
  openText: ['merker.toml als Text', 'merker.toml as text'],
  symbols: [
    'Ein STEP-5-Programm hat hier keine Symboltabelle: Es verwendet absolute Operanden.',
    'A STEP 5 program has no symbol table here: it uses absolute operands.',
  ],
  blocks: [
    'Die Bausteine sind in den Dateien. „Laden“ übersetzt alle und startet die PLC neu.',
    'The blocks are in the files. “Load” compiles all of them and restarts the PLC.',
  ],
  stacks: [
    'Stacks gibt es hier nur bei einer SIMATIC S7. Alarme und Meldungen sind im Diagnosepuffer.',
    'Stacks are available for a SIMATIC S7 only. Alarms and messages are in the diagnostic buffer.',
  ],
} satisfies Texts;
