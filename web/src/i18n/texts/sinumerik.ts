import type { Texts } from '..';

/** What a view says that has nothing to show for a STEP 5 program of a SINUMERIK. */
export const sinumerik = {
  hardware: [
    'Die PLC einer SINUMERIK 810/820 hat keinen konfigurierbaren Baugruppenträger. Maschinendaten, Alarmtexte und NC-Werte werden in merker.toml angegeben.',
    'The PLC of a SINUMERIK 810/820 has no rack to configure. Machine data, alarm texts and values of the NC are in merker.toml.',
  ],
  openText: ['merker.toml als Text', 'merker.toml as text'],
  blocks: [
    'Die Bausteine sind in den Dateien. „Laden“ übersetzt alle und startet die PLC neu.',
    'The blocks are in the files. “Load” compiles all of them and restarts the PLC.',
  ],
  blockName: ['Baustein, z. B. PB 1, FB 1, DB 10', 'Block, e.g. PB 1, FB 1, DB 10'],
  blockNameWrong: [
    'Für einen Baustein OB, PB, SB, FB oder DB mit Nummer eingeben, für eine Variablentabelle VAT.',
    'Enter OB, PB, SB, FB or DB with a number for a block, VAT for a variable table.',
  ],
  load: [
    'Alles speichern, übersetzen und die PLC damit neu starten',
    'Save and compile everything and restart the PLC with it',
  ],
} satisfies Texts;
