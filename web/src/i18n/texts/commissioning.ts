import type { Texts } from '..';

/** Commissioning of an axis: the steps of the technology manual 3.5.4 and 4.5.4. */
export const commissioning = {
  view: ['Ansicht der Achse', 'View of the axis'],
  picture: ['Anlage', 'Plant'],
  title: ['Inbetriebnahme', 'Commissioning'],
  steps: ['Schritte der Inbetriebnahme', 'Steps of the commissioning'],
  todo: ['Was ist zu tun?', 'What to do'],
  seen: ['Was ist zu sehen?', 'What must be seen'],
  causes: ['Wenn nicht', 'If not'],
  next: ['Weiter', 'Next'],
  open: ['offen', 'open'],
  good: ['in Ordnung', 'good'],
  bad: ['nicht in Ordnung', 'not good'],
  warning: [
    'Paralleles Steuern aus dem Programm und von hier kann zu Konflikten führen: Eingänge, die der CALL versorgt, überschreibt das Programm in jedem Zyklus. Dann dort steuern.',
    'Control from the program and from here at the same time may conflict: inputs that the CALL supplies are overwritten by the program in each cycle. Control them there.',
  ],
  noAxis: [
    'Die CPU hat noch keine parametrierte Achse: in der Hardware das Submodul „Positionieren“ (Steckplatz 2.5) parametrieren, die Station speichern und laden.',
    'The CPU has no axis with parameters yet: set the parameters of the sub-module “Positioning” (slot 2.5) in the hardware, save and load the station.',
  ],
  toHardware: ['Zur Hardware', 'To the hardware'],
  noBlock: [
    'Kein Instanz-DB eines SFB {number}: im OB 1 „CALL SFB {number}, DB …“ programmieren und laden.',
    'No instance DB of an SFB {number}: program “CALL SFB {number}, DB …” in OB 1 and load it.',
  ],
  block: ['Instanz-DB', 'Instance DB'],

  prepare: ['Voraussetzungen', 'Requirements'],
  prepareTodo: [
    'Submodul „Positionieren“ parametrieren, SFB {number} im Anwenderprogramm aufrufen, Projekt laden, CPU in RUN bringen.',
    'Set the parameters of the sub-module “Positioning”, call SFB {number} in the program, load the project, switch the CPU to RUN.',
  ],
  cpuRuns: ['CPU in RUN', 'CPU in RUN'],
  parameterised: ['Achse parametriert (PARA)', 'Axis parameterised (PARA)'],
  called: ['SFB {number} wird aufgerufen', 'SFB {number} is called'],
  callCause: [
    'Der SFB ist nicht aufgerufen, LADDR ist nicht die Adresse des Submoduls (BIE = 0), oder die CPU steht in STOP.',
    'The SFB is not called, LADDR is not the address of the sub-module (BR = 0), or the CPU is in STOP.',
  ],

  wiring: ['Überprüfen der Verdrahtung', 'Check of the wiring'],
  wiringAnalog: [
    'Die Verschaltung der Ausgänge (Analogausgang, Freigabe CONV_EN) und der Eingänge des Gebers überprüfen.',
    'Check the wiring of the outputs (analog output, enable CONV_EN) and of the inputs of the encoder.',
  ],
  wiringDigital: [
    'Die Verschaltung der Ausgänge Q0 bis Q3 und der Eingänge des Gebers überprüfen.',
    'Check the wiring of the outputs Q0 to Q3 and of the inputs of the encoder.',
  ],
  wired: ['{operand}', '{operand}'],
  wiredTo: ['{operand} statt {wanted}', '{operand} instead of {wanted}'],
  unwired: ['nicht verdrahtet, gehört an {wanted}', 'not wired, belongs to {wanted}'],
  brokenWire: ['{operand}, klemmt bei {value}', '{operand}, stuck at {value}'],
  wiringCause: [
    'In merker.toml unter [plant.wire] die Klemme eintragen; einen Drahtbruch in der Ansicht „Anlage“ beheben.',
    'Enter the terminal in merker.toml under [plant.wire]; clear a wire break in the view “Plant”.',
  ],

  movement: ['Überprüfen der Achsbewegung', 'Check of the movement'],
  movementTodo: [
    'In der Betriebsart „Tippen“ mit Schleichgeschwindigkeit in Richtung Plus oder Minus fahren: DRV_EN setzen, Taste halten.',
    'Travel in mode “Jog” with creep speed in plus or minus direction: set DRV_EN, hold the button.',
  ],
  movementSeen: [
    'Die tatsächliche Bewegungsrichtung DIR stimmt mit der geforderten überein, ACT_POS läuft mit.',
    'The actual direction of movement DIR is the one that was commanded, ACT_POS follows.',
  ],
  plusRun: ['Richtung Plus', 'Plus direction'],
  minusRun: ['Richtung Minus', 'Minus direction'],
  notTried: ['noch nicht gefahren', 'not tried yet'],
  moveGood: ['richtig', 'right'],
  moveStands: ['die Achse bewegt sich nicht', 'the axis does not move'],
  moveNotCounted: ['die Achse fährt, gezählt wird nichts', 'the axis moves, nothing is counted'],
  moveReversedCount: ['ACT_POS läuft verkehrt herum', 'ACT_POS runs the wrong way'],
  moveReversedDrive: ['der Antrieb fährt verkehrt herum', 'the drive turns the wrong way'],
  causeStands: [
    'Kein Start: DRV_EN, STATUS und ERR ansehen. Sonst: Freigabe CONV_EN fehlt, Not-Halt, Hardwareendschalter, Achse blockiert; oder die Schleichgeschwindigkeit überwindet das Haltemoment nicht.',
    'No start: see DRV_EN, STATUS and ERR. Otherwise: enable CONV_EN missing, emergency stop, hardware limit switch, axis blocked; or the creep speed does not overcome the stiction.',
  ],
  causeNotCounted: [
    'Drahtbruch der Spuren A oder B, Geber nicht an DI 0 und DI 1; nach der Überwachungszeit meldet die Istwertüberwachung 2000H.',
    'Wire break of track A or B, encoder not at DI 0 and DI 1; after the monitoring time the actual-value monitoring reports 2000H.',
  ],
  causeReversedCount: [
    'Spuren A und B vertauscht oder Geber gegenläufig: den Baugruppenparameter „Zählrichtung“ (Maske Geber) ändern.',
    'Tracks A and B swapped, or the encoder turns the other way: change the module parameter “Count direction” (page Encoder).',
  ],
  causeReversedDrive: [
    'Sollwert umgepolt, Richtungssignal CONV_DIR oder Ansteuerart passt nicht zum Leistungsteil (Schütze vertauscht).',
    'Set-point with wrong polarity; direction signal CONV_DIR or control type does not fit the power section (contactors swapped).',
  ],

  causeStandsDigital: [
    'Kein Start: DRV_EN, STATUS und ERR ansehen. Sonst: die Schütze an Q0 bis Q3 passen nicht zur Ansteuerart, Not-Halt, Hardwareendschalter, Achse blockiert.',
    'No start: see DRV_EN, STATUS and ERR. Otherwise: the contactors at Q0 to Q3 do not fit the control type, emergency stop, hardware limit switch, axis blocked.',
  ],
  causeReversedDriveDigital: [
    'Die Schütze an Q0 bis Q3 sind vertauscht, oder die Ansteuerart passt nicht zu ihnen.',
    'The contactors at Q0 to Q3 are swapped, or the control type does not fit them.',
  ],
  causeTooFastDigital: [
    'Umschaltdifferenz CHGDIFF_{direction} vergrößern, bis der Antrieb sichtbar im Schleichgang zum Abschaltpunkt fährt.',
    'Enlarge the changeover difference CHGDIFF_{direction} until the drive visibly creeps to the cut-off point.',
  ],

  synchronise: ['Synchronisieren der Achse', 'Synchronisation of the axis'],
  synchroniseTodo: [
    'Den Auftrag „Bezugspunkt setzen“ (JOB_ID 1) ausführen: die Koordinate der aktuellen Position als JOB_VAL eintragen, JOB_REQ setzen.',
    'Execute the job “Set reference point” (JOB_ID 1): enter the coordinate of the present position as JOB_VAL, set JOB_REQ.',
  ],
  synchroniseSeen: [
    'Die Koordinate steht als Lageistwert in ACT_POS, das Synchronisierbit SYNC ist gesetzt.',
    'The coordinate is shown as actual position in ACT_POS, the bit SYNC is set.',
  ],
  synchroniseCause: [
    'JOB_ERR gesetzt: JOB_STAT auswerten, die Koordinate korrigieren, den Auftrag wiederholen. SYNC geht verloren durch STOP, Fehlimpuls oder Verlassen des Verfahrbereichs.',
    'JOB_ERR is set: see JOB_STAT, correct the coordinate, repeat the job. SYNC gets lost by STOP, a missing pulse or leaving the traversing range.',
  ],

  differences: ['Überprüfen der Um- und Abschaltdifferenzen', 'Check of the changeover and cut-off differences'],
  differencesTodo: [
    'In „Schrittmaßfahrt“ relativ oder absolut mit Arbeitsgeschwindigkeit (Eilgang) zu einem Ziel fahren, das weiter entfernt ist als die Umschaltdifferenz. Die Phasen beobachten: Beschleunigung, Konstantfahrt, Verzögerung, Zieleinlauf.',
    'Do a relative or absolute incremental run with working speed (rapid) to a target that is farther away than the changeover difference. Watch the phases: acceleration, constant travel, deceleration, target approach.',
  ],
  differencesSeen: [
    'Am Abschaltpunkt ist die Schleichgeschwindigkeit erreicht; die Achse bleibt im Zielbereich stehen (POS_RCD).',
    'Creep speed is reached at the cut-off point; the axis stops within the target range (POS_RCD).',
  ],
  lastRun: ['Letzte Fahrt', 'Last run'],
  noRun: ['noch keine Fahrt zu einem Ziel', 'no run to a target yet'],
  untilChangeover: ['Bis zum Umschaltpunkt', 'Until the changeover point'],
  untilCutOff: ['Schleichgang bis zum Abschaltpunkt', 'Creep until the cut-off point'],
  untilRest: ['Auslauf bis Stillstand', 'Coasting until standstill'],
  speedAtCutOff: ['Geschwindigkeit am Abschaltpunkt', 'Speed at the cut-off point'],
  rest: ['Restweg im Stillstand', 'Distance to go at standstill'],
  seconds: ['{value} s', '{value} s'],
  runGood: ['Zielbereich erreicht', 'target range reached'],
  runAborted: ['abgebrochen, bevor der Abschaltpunkt kam', 'aborted before the cut-off point'],
  runTooFast: ['schneller als Schleichgeschwindigkeit abgeschaltet', 'cut off above creep speed'],
  runShort: ['vor dem Zielbereich stehen geblieben', 'stopped short of the target range'],
  runOver: ['Zielbereich überfahren', 'overran the target range'],
  runTooShortPath: [
    'der Weg war kürzer als die Umschaltdifferenz',
    'the way was shorter than the changeover difference',
  ],
  causeGood: [
    'Optimieren: die Umschaltdifferenz kann um etwa {spare} Impulse kleiner sein; die Abschaltdifferenz dabei lassen.',
    'Optimise: the changeover difference can be about {spare} pulses smaller; keep the cut-off difference.',
  ],
  causeTight: [
    'Die Umschaltdifferenz ist so klein, wie sie sein kann.',
    'The changeover difference is as small as it can be.',
  ],
  causeAborted: [
    'ERR und STATUS ansehen, Ursache beheben, mit ERR_A quittieren.',
    'See ERR and STATUS, remove the cause, acknowledge with ERR_A.',
  ],
  causeTooFast: [
    'Umschaltdifferenz CHGDIFF_{direction} vergrößern, bis der Antrieb sichtbar im Schleichgang zum Abschaltpunkt fährt; oder DECEL vergrößern.',
    'Enlarge the changeover difference CHGDIFF_{direction} until the drive visibly creeps to the cut-off point; or enlarge DECEL.',
  ],
  causeShort: [
    'Abschaltdifferenz CUTOFFDIFF_{direction} verkleinern (um etwa {rest} Impulse) und die Fahrt wiederholen.',
    'Make the cut-off difference CUTOFFDIFF_{direction} smaller (by about {rest} pulses) and repeat the run.',
  ],
  causeOver: [
    'Abschaltdifferenz CUTOFFDIFF_{direction} vergrößern (um etwa {rest} Impulse) und die Fahrt wiederholen.',
    'Enlarge the cut-off difference CUTOFFDIFF_{direction} (by about {rest} pulses) and repeat the run.',
  ],
  causeTooShortPath: [
    'Ein Ziel wählen, das weiter entfernt ist als die Umschaltdifferenz.',
    'Choose a target that is farther away than the changeover difference.',
  ],

  operate: ['Achse steuern', 'Control of the axis'],
  driveEnable: ['Antriebsfreigabe DRV_EN', 'Drive enable DRV_EN'],
  jogMinus: ['Tippen −', 'Jog −'],
  jogPlus: ['Tippen +', 'Jog +'],
  referenceMinus: ['Referenzpunktfahrt −', 'Reference run −'],
  referencePlus: ['Referenzpunktfahrt +', 'Reference run +'],
  relativeMinus: ['Relativ −', 'Relative −'],
  relativePlus: ['Relativ +', 'Relative +'],
  absolute: ['Absolut', 'Absolute'],
  absoluteMinus: ['Absolut −', 'Absolute −'],
  absolutePlus: ['Absolut +', 'Absolute +'],
  stop: ['STOP', 'STOP'],
  acknowledge: ['Quittieren ERR_A', 'Acknowledge ERR_A'],
  setReference: ['Bezugspunkt setzen', 'Set reference point'],
  deleteDistance: ['Restweg löschen', 'Delete distance to go'],
  rapid: ['Eilgang (SPEED)', 'Rapid (SPEED)'],
  values: ['Werte der Achse', 'Values of the axis'],
  status: ['Fehler der Betriebsart STATUS {code}', 'Mode error STATUS {code}'],
  jobStatus: ['Auftragsfehler JOB_STAT {code}', 'Job error JOB_STAT {code}'],
  external: ['Externfehler ERR {code}', 'External error ERR {code}'],
} satisfies Texts;
