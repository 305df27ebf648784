import type { Texts } from '..';

export const newPlant = {
  open: ['Anlage hinzufügen …', 'Add a plant …'],
  title: ['Simulierte Anlage hinzufügen', 'Add a simulated plant'],
  kind: ['Art', 'Kind'],
  name: ['Name', 'Name'],
  signal: ['Signal', 'Signal'],
  meaning: ['Bedeutung', 'Meaning'],
  terminal: ['Klemme', 'Terminal'],
  terminalOf: ['Klemme von {signal}', 'Terminal of {signal}'],
  free: ['nicht verdrahtet', 'not wired'],
  wiring: [
    'Die Signale der Anlage werden mit Klemmen der Baugruppen verdrahtet. Eine Achse ist so verdrahtet, wie es das Handbuch vorgibt.',
    'The signals of the plant are wired to terminals of the modules. An axis is wired as the manual says.',
  ],
  noAxis: [
    'Die CPU positioniert noch keine Achse: In der Ansicht Hardware bei 2.5 (Positionieren) zuerst die Ansteuerung einstellen.',
    'The CPU does not position an axis yet: first choose the drive at 2.5 (positioning) in the hardware view.',
  ],
  later: ['Weitere Parameter der Anlage stehen in {file}.', 'Further parameters of the plant are in {file}.'],
  stops: [
    'Die Anlage wird mit der Hardware-Konfiguration geladen. Die CPU geht dafür in STOP.',
    'The plant is downloaded with the hardware configuration. The CPU goes to STOP for it.',
  ],
  noFile: [
    'Das Projekt hat keine Datei {file}. Ein neues Projekt hat eine.',
    'The project has no file {file}. A new project has one.',
  ],
  cancel: ['Abbrechen', 'Cancel'],
  add: ['Hinzufügen und laden', 'Add and download'],
  added: ['Anlage {name} hinzugefügt', 'Plant {name} added'],
} satisfies Texts;
