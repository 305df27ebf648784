import type { Component } from 'svelte';
import type { Text } from '../i18n';
import { plc } from '../state/plc.svelte';

export interface View {
  /** Its name in the address line. */
  id: string;
  title: Text;
  /** Fetched when the view is opened for the first time. */
  load: () => Promise<{ default: Component }>;
  /** What F1 says about it. */
  help: Text;
  /** Whether it has something to show; always, if there is no such question. */
  used?: () => boolean;
}

/** The views in the order of the work: define a project, hardware, symbols, program, test, look for causes. */
export const views: View[] = [
  {
    id: 'projects',
    title: ['Projekt', 'Project'],
    load: () => import('../projects/Projects.svelte'),
    help: [
      'Beispiele öffnen, ein neues Projekt anlegen, Projekte importieren und herunterladen, Bausteine laden, vergleichen und zurückholen. Dateien lassen sich überall auf der Seite ablegen.',
      'Open examples, create a project, import and download projects, load, compare and upload blocks. Files can be dropped anywhere on the page.',
    ],
  },
  {
    id: 'hardware',
    title: ['Hardware', 'Hardware'],
    load: () => import('../hardware/Hardware.svelte'),
    help: [
      'Der Aufbau als Bild: Baugruppen, Adressen, Klemmen, Eigenschaften; Störungen werden hier eingestellt.',
      'The racks as a picture: modules, addresses, terminals, properties; inject faults here.',
    ],
  },
  {
    id: 'symbols',
    title: ['Symbole', 'Symbols'],
    load: () => import('../symbols/Symbols.svelte'),
    help: [
      'Die Symboltabelle: Symbol, Operand, Datentyp, Kommentar; jedes Symbol nur einmal.',
      'The symbol table: symbol, operand, data type, comment; each symbol only once.',
    ],
  },
  {
    id: 'program',
    title: ['Programm', 'Program'],
    load: () => import('../editor/Program.svelte'),
    help: [
      'Bausteine in AWL, KOP oder FUP schreiben, prüfen, laden; Programmstatus und Haltepunkte.',
      'Write, check and load blocks in STL, LAD or FBD; program status and breakpoints.',
    ],
  },
  {
    id: 'io',
    title: ['E/A', 'I/O'],
    load: () => import('../io/InputsOutputs.svelte'),
    help: [
      'Kacheln für Ein- und Ausgänge, Merker, Zeiten, Zähler und Datenwörter. Ein Klick auf ein Bit schaltet es.',
      'Tiles for inputs, outputs, flags, timers, counters and data words. A click on a bit toggles it.',
    ],
  },
  {
    id: 'variables',
    title: ['Variablen', 'Variables'],
    load: () => import('../variables/Variables.svelte'),
    help: [
      'Die Variablentabelle: beobachten, steuern, forcen. Ein rotes F kennzeichnet geforcte Operanden.',
      'The variable table: monitor, modify, force. A red F marks forced operands.',
    ],
  },
  {
    id: 'process',
    title: ['Anlage', 'Process'],
    load: () => import('../process/Process.svelte'),
    help: [
      'Das Modell der Anlage, das die SPS steuert; ein Klick stellt eine Störung ein. Eine Achse wird hier Schritt für Schritt in Betrieb genommen.',
      'The model of the plant that the PLC controls; click to inject a fault. An axis is commissioned here, step by step.',
    ],
  },
  {
    id: 'trends',
    title: ['Kurven', 'Trends'],
    load: () => import('../trends/Trends.svelte'),
    help: ['Variablen über der Zeit, anhalten, vergrößern, exportieren.', 'Variables over time, pause, zoom, export.'],
  },
  {
    id: 'diagnosis',
    title: ['Diagnose', 'Diagnosis'],
    load: () => import('../diagnosis/Diagnosis.svelte'),
    help: [
      'Diagnosepuffer, Stacks und Baugruppenzustand; „Baustein öffnen“ führt zur Ursache.',
      'Diagnostic buffer, stacks and module information; “open block” leads to the cause.',
    ],
  },
  {
    id: 'nc',
    title: ['NC', 'NC'],
    load: () => import('../nc/Nc.svelte'),
    help: [
      'Was die NC neben der SPS hat: Achsen, Kanäle, Spindeln, Alarme, R-Parameter, Werkzeuge, Verschiebungen, Maschinendaten; jeder Wert lässt sich ändern.',
      'What the NC beside the PLC has: axes, channels, spindles, alarms, R parameters, tools, offsets, machine data; each value can be changed.',
    ],
    used: () => plc.can('nc'),
  },
  {
    id: 'serial',
    title: ['Seriell', 'Serial'],
    load: () => import('../serial/Serial.svelte'),
    help: [
      'Die Zeichen auf der Leitung von X27 mit Zeit und Bedeutung, ihr Zustand, und der Partner am anderen Ende, der sendet und antwortet.',
      'The characters on the line of X27 with time and meaning, its state, and the partner at the other end, which sends and answers.',
    ],
    used: () => plc.project?.serial === true,
  },
  {
    id: 'pictures',
    title: ['Bilder', 'Pictures'],
    load: () => import('../hmi/Pictures.svelte'),
    help: [
      'Bilder der eigenen Anlage zeichnen, an Operanden binden und bedienen; Vollbild zeigt nur das Bild.',
      'Draw pictures of your own plant, bind them to operands and operate them; full screen shows only the picture.',
    ],
    // Reached from the process.
    used: () => false,
  },
  {
    id: 'compare',
    title: ['Vergleich', 'Comparison'],
    load: () => import('../compare/Compare.svelte'),
    help: [
      'Projekt, CPU oder ein anderes Projekt nebeneinander: Bausteine mit ihren Quellen, Symbole, Hardware. F7 geht zum nächsten Unterschied.',
      'Project, CPU or another project side by side: blocks with their sources, symbols, hardware. F7 goes to the next difference.',
    ],
    // Reached from project and program.
    used: () => false,
  },
  {
    id: 'stations',
    title: ['Netz', 'Network'],
    load: () => import('../stations/Stations.svelte'),
    help: [
      'Alle Stationen des Projekts mit ihren Subnetzen: Zustände, Globaldaten, gezogene Stecker; ein Klick auf eine Station öffnet sie. Neue Stationen und Verbindungen.',
      'All stations of the project with their subnets: states, global data, pulled plugs; a click on a station opens it. New stations and connections.',
    ],
    used: () => !!plc.project?.network,
  },
];
