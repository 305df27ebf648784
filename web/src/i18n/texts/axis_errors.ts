import type { Texts } from '..';

/** STATUS and JOB_STAT of SFB 44 and SFB 46: what is wrong, and what to do (technology manual 3.8.2, 4.8.2). */
export const axisStatus = {
  '2001': ['Falscher SFB: SFB 46 verwenden', 'Wrong SFB: use SFB 46'],
  '2002': ['Falscher SFB: SFB 44 verwenden', 'Wrong SFB: use SFB 44'],
  '2004': ['Falsche Kanalnummer: CHANNEL muss 0 sein', 'Wrong channel number: CHANNEL must be 0'],
  '3001': [
    'Fahrauftrag nicht angenommen, weil der Auftrag im selben Aufruf fehlerhaft ist: JOB_STAT auswerten',
    'The run was not accepted because the job in the same call is faulty: see JOB_STAT',
  ],
  '3002': [
    'MODE_IN während der Fahrt geändert: das Ende der Fahrt abwarten',
    'MODE_IN was changed during a run: wait for its end',
  ],
  '3003': ['Unbekannte Betriebsart: zulässig sind 1, 3, 4 und 5', 'Unknown operating mode: 1, 3, 4 and 5 are possible'],
  '3004': [
    'Mehr als eine Startanforderung: nur eines von START, DIR_P und DIR_M setzen',
    'More than one start request: set only one of START, DIR_P and DIR_M',
  ],
  '3005': [
    'START nur bei „Schrittmaßfahrt absolut“: sonst mit DIR_P oder DIR_M starten',
    'START is for absolute runs only: start others with DIR_P or DIR_M',
  ],
  '3006': [
    'Linearachse: „Schrittmaßfahrt absolut“ mit START starten, nicht mit DIR_P oder DIR_M',
    'Linear axis: start an absolute run with START, not with DIR_P or DIR_M',
  ],
  '3007': [
    'Achse nicht synchronisiert: Referenzpunktfahrt oder Bezugspunkt setzen',
    'The axis is not synchronised: do a reference-point run or set the reference point',
  ],
  '3008': [
    'Arbeitsbereich verlassen: nur Tippen zurück in den Arbeitsbereich ist möglich',
    'The working range has been left: only jogging back into it is possible',
  ],
  '3101': [
    'Keine Startfreigabe, Achse nicht parametriert: das Submodul „Positionieren“ parametrieren und laden',
    'No start enable, the axis is not parameterised: set the parameters of the sub-module and load them',
  ],
  '3102': ['Keine Startfreigabe: Antriebsfreigabe DRV_EN setzen', 'No start enable: set the drive enable DRV_EN'],
  '3103': ['Keine Startfreigabe: STOP zurücksetzen', 'No start enable: reset STOP'],
  '3104': [
    'Keine Startfreigabe, die Achse fährt: das Ende der Fahrt abwarten (WORKING)',
    'No start enable, a run is in progress: wait for its end (WORKING)',
  ],
  '3105': [
    'Keine Startfreigabe, Externfehler nicht quittiert: Ursache beheben, mit ERR_A quittieren',
    'No start enable, an external error is not acknowledged: remove its cause, acknowledge with ERR_A',
  ],
  '3201': ['SPEED falsch: Schleichgang (0) oder Eilgang (1)', 'SPEED wrong: creep (0) or rapid (1)'],
  '3202': [
    'SPEED falsch: Schleichgeschwindigkeit bis Maximalgeschwindigkeit',
    'SPEED wrong: from the creep speed to the maximum speed',
  ],
  '3203': ['ACCEL falsch: 1 bis 100 000 Impulse/s²', 'ACCEL wrong: 1 to 100,000 pulses/s²'],
  '3204': ['DECEL falsch: 1 bis 100 000 Impulse/s²', 'DECEL wrong: 1 to 100,000 pulses/s²'],
  '3206': ['SPEED muss mindestens die Referenziergeschwindigkeit sein', 'SPEED must be at least the reference speed'],
  '3301': [
    'Um- oder Abschaltdifferenz zu groß: 0 bis 100 000 000 Impulse',
    'Changeover or cut-off difference wrong: 0 to 100,000,000 pulses',
  ],
  '3303': [
    'Umschaltdifferenz zu klein: mindestens die Abschaltdifferenz',
    'Changeover difference too small: at least the cut-off difference',
  ],
  '3304': [
    'Abschaltdifferenz zu klein: mindestens der halbe Zielbereich',
    'Cut-off difference too small: at least half the target range',
  ],
  '3305': [
    'Umschaltdifferenz zu klein: mindestens der halbe Zielbereich',
    'Changeover difference too small: at least half the target range',
  ],
  '3401': [
    'Ziel außerhalb des Arbeitsbereichs: zwischen den Softwareendschaltern wählen',
    'Target outside the working range: choose it between the software limit switches',
  ],
  '3402': ['Ziel falsch: 0 bis Rundachsenende − 1', 'Target wrong: 0 to the end of the rotary axis − 1'],
  '3403': ['Weg falsch: TARGET darf nicht negativ sein', 'Distance wrong: TARGET must not be negative'],
  '3404': ['Ziel falsch: es muss größer als −500 000 000 sein', 'Target wrong: it must be above −500,000,000'],
  '3405': ['Ziel falsch: es muss kleiner als 500 000 000 sein', 'Target wrong: it must be below 500,000,000'],
  '3406': [
    'Der Zielbereich muss innerhalb des Arbeitsbereichs liegen',
    'The target range must lie within the working range',
  ],
  '3501': [
    'Weg zu groß: Ziel und Restweg zusammen liegen unter −500 000 000',
    'Distance too long: target and distance to go together are below −500,000,000',
  ],
  '3502': [
    'Weg zu groß: Ziel und Restweg zusammen liegen über 500 000 000',
    'Distance too long: target and distance to go together are above 500,000,000',
  ],
  '3503': [
    'Weg in Richtung Plus zu klein: größer als die Abschaltdifferenz wählen',
    'Distance in plus direction too short: more than the cut-off difference',
  ],
  '3504': [
    'Weg in Richtung Minus zu klein: größer als die Abschaltdifferenz wählen',
    'Distance in minus direction too short: more than the cut-off difference',
  ],
  '3505': [
    'Endschalter Plus zu nah oder überfahren: in Richtung Minus fahren',
    'The limit in plus direction is too close or passed: travel in minus direction',
  ],
  '3506': [
    'Endschalter Minus zu nah oder überfahren: in Richtung Plus fahren',
    'The limit in minus direction is too close or passed: travel in plus direction',
  ],
  '4001': ['Achse nicht parametriert', 'The axis is not parameterised'],
  '4002': ['Auftrag nicht möglich, die Achse fährt', 'The job is not possible during a run'],
  '4004': ['Unbekannter Auftrag: JOB_ID 1 oder 2', 'Unknown job: JOB_ID 1 or 2'],
  '4101': [
    'Koordinate außerhalb des Arbeitsbereichs: JOB_VAL zwischen den Softwareendschaltern wählen',
    'Coordinate outside the working range: choose JOB_VAL between the software limit switches',
  ],
  '4102': [
    'Koordinate falsch: mit dem Restweg liegt sie unter −500 000 000',
    'Coordinate wrong: with the distance to go it is below −500,000,000',
  ],
  '4103': [
    'Koordinate falsch: mit dem Restweg liegt sie über 500 000 000',
    'Coordinate wrong: with the distance to go it is above 500,000,000',
  ],
  '4104': [
    'Koordinate falsch: mit dem Weg zum Startpunkt liegt sie unter −500 000 000',
    'Coordinate wrong: with the way to the start point it is below −500,000,000',
  ],
  '4105': [
    'Koordinate falsch: mit dem Weg zum Startpunkt liegt sie über 500 000 000',
    'Coordinate wrong: with the way to the start point it is above 500,000,000',
  ],
  '4106': ['Koordinate falsch: 0 bis Rundachsenende − 1', 'Coordinate wrong: 0 to the end of the rotary axis − 1'],
} satisfies Texts;

/** Bits of ERR, external errors. */
export const axisErrors = {
  '2': [
    'Fehlimpuls (Nullmarke): Impulse gehen verloren, oder der Geber ist gestört',
    'Missing pulse (zero mark): pulses are lost, or the encoder is faulty',
  ],
  '11': ['Verfahrbereich verlassen', 'Traversing range left'],
  '12': [
    'Arbeitsbereich verlassen: quittieren und in den Arbeitsbereich zurücktippen',
    'Working range left: acknowledge, jog back into it',
  ],
  '13': [
    'Istwert: die Achse bewegt sich nicht in der vorgegebenen Richtung',
    'Actual value: the axis does not move in the given direction',
  ],
  '14': [
    'Zieleinlauf: der Zielbereich wurde in der Überwachungszeit nicht erreicht',
    'Target approach: the target range was not reached within the monitoring time',
  ],
  '15': ['Zielbereich: die Achse hat ihn wieder verlassen', 'Target range: the axis has left it again'],
} satisfies Texts;
