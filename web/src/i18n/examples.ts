/** German title and description of each example, by its folder. The English ones are in its README. */
export const examples: Record<string, readonly [title: string, description: string]> = {
  '03-hardware': [
    'Hardware (Kapitel 2.2, 3.4, 3.5, 4.1.2)',
    'Eine Abfüllstation auf zwei Baugruppenträgern: welche Baugruppe wo steckt, steht in merker.toml.',
  ],
  '06-first-program': [
    'Erstes Programm (Kapitel 6.2, 6.3)',
    'Ein Netzwerk mit vier Anweisungen: die Lampe A 3.0 leuchtet, wenn beide Schalter E 0.0 und E 0.1 ein sind oder wenn A 1.0 ein ist.',
  ],
  '08-addressing': [
    'Adressierung (Kapitel 5.4, 7, 8, 11)',
    'Bits, Bytes, Worte und Doppelworte sind Sichten auf denselben Speicher. Das Byte mit der niedrigeren Nummer ist das höherwertige; ein Wort mit ungerader Nummer überlappt beide Nachbarn.',
  ],
  '09-symbols': [
    'Symbole (Kapitel 4.1.4, 9)',
    'Programme lesen sich mit Namen leichter als mit Adressen. Die Symboltabelle gibt Eingängen, Ausgängen, Merkern, Zeiten und Bausteinen Namen; im Programm stehen sie in Anführungszeichen.',
  ],
  '10-logic': [
    'Binäre Verknüpfungen (Kapitel 10.1 bis 10.9)',
    'Jeder Abschnitt des Kapitels ist eine Funktion. Das Eingangsbyte EB 1 wählt, welche läuft, denn alle schreiben wie im Kurs dieselbe Lampe A 0.0.',
  ],
  '10-set-reset': [
    'Setzen und Rücksetzen (Kapitel 10.10)',
    'Zwei Speicher mit denselben Tastern. Sie unterscheiden sich nur, wenn beide gedrückt sind: Vorrang Setzen und Vorrang Rücksetzen.',
  ],
  '12-load-transfer': [
    'Laden und Transferieren (Kapitel 11, 12)',
    'L bringt einen Wert in AKKU 1; was dort stand, kommt nach AKKU 2. T schreibt AKKU 1 in ein Byte, Wort oder Doppelwort. Beides wirkt in jedem Zyklus, unabhängig vom VKE.',
  ],
  '13-function': [
    'Eine Funktion und ihre Parameter (Kapitel 13.4)',
    'OB 1 ruft FC 1 mit drei Parametern auf, einem von jeder Art: Eingang, Ausgang, Durchgang.',
  ],
  '14-function-block': [
    'Ein Funktionsbaustein und seine Instanz (Kapitel 14.4)',
    'FB 1 vergleicht zwei Werte, merkt sich das Ergebnis in einer statischen Variablen und gibt 8 (größer oder gleich) oder 15 (kleiner) aus. Seine Variablen liegen im Instanz-Datenbaustein DB 1.',
  ],
  '15-counters': [
    'Zähler (Kapitel 15)',
    'Ein Zähler Z zählt steigende Flanken von 0 bis 999. Das Eingangsbyte EB 2 wählt den Abschnitt, denn alle verwenden Z 1.',
  ],
  '16-timers': [
    'Zeiten (Kapitel 16)',
    'Die fünf Arten von S7-Zeiten, jede mit E 0.0 als Start und 5 s. EB 2 wählt den Abschnitt, denn alle verwenden T 1 und A 0.0.',
  ],
  '18-startup': [
    'Anlauf und Betriebszustände (Kapitel 18)',
    'OB 100 schreibt im Anlauf 7 nach MW 50; OB 1 kopiert den Wert in seinem ersten Zyklus nach MW 52. Den ersten Zyklus erkennt er an der Startinformation OB1_SCAN_1.',
  ],
  'error-handling': [
    'Fehlerbehandlung',
    'Eine Presse, deren Programm nach manchen Fehlern weiterläuft und nach anderen in STOP geht: das hängt davon ab, welche Fehler-OBs geladen sind.',
  ],
  'garage-door': [
    'Garagentor',
    'Ein Taster für alles: auf, halt, zu, halt, auf. Zwei Endschalter halten den Motor an, eine Lichtschranke kehrt das schließende Tor um, eine Lampe blinkt während der Fahrt.',
  ],
  lift: [
    'Aufzug mit drei Etagen',
    'Ruftaster auf jeder Etage und in der Kabine, ein Sensor je Etage, eine Tür. Der Aufzug fährt in seiner Richtung weiter, solange dort jemand wartet, hält unterwegs und kehrt dann um.',
  ],
  'networks/as-interface': [
    'AS-Interface',
    'Ein CP 343-2 mit vier AS-i-Slaves. Der CP hat 16 Eingangs- und 16 Ausgangsbytes; jeder von bis zu 31 Slaves hat vier Bits davon. Der E/A-Code seines Profils sagt, was Eingang und was Ausgang ist. Fällt ein Slave aus, meldet es der CP mit einem Diagnosealarm.',
  ],
  'networks/connections': [
    'S7-Verbindungen: PUT, GET und BSEND zwischen Stationen',
    'Eine Leitstation gibt einem Band über MPI die Geschwindigkeit vor und holt seine Stückzahl; die CPU des Bandes hat dafür keinen Baustein, auf ihre Variablen wird zugegriffen. Meldungen von 300 Bytes gehen über Ethernet an eine Verwaltung, wo ein Baustein sie annimmt. Die [[connection]] stehen in merker.toml; Bausteine nennen sie mit ID.',
  ],
  'networks/intelligent-slave': [
    'Linie und Presse',
    'Zwei CPUs 314C-2 DP an PROFIBUS: die Presse ist ein intelligenter Slave der Linie. Ein Byte geht zur Presse, vier Bytes kommen zurück: was hier ein Ausgang ist, ist dort ein Eingang, mit eigener Adresse. Die Linie bestellt einen Hub, solange ihr Taster gedrückt und die Presse bereit ist; die Presse zählt ihre Hübe für die Linie.',
  ],
  'networks/laboratory': [
    'Das Labor, Topologie 1 (Kapitel 2.3)',
    'Acht Stationen bilden ein MPI-Subnetz und ein Segment. Die Station des Lehrers sendet die Nummer der Aufgabe als Globaldaten an alle Plätze, ein Paket für sieben Empfänger. Ein Platz meldet mit SFC 68 X_PUT, ob die Hand oben ist: eine CPU empfängt höchstens vier Pakete Globaldaten, sieben Plätze könnten so nicht antworten.',
  ],
  'networks/laboratory-2': [
    'Das Labor, Topologie 2 (Kapitel 2.3)',
    'Vier Stationen bilden ein MPI-Subnetz, vier ein PROFIBUS-Subnetz. Die Brücke, eine CPU 314C-2 DP, ist an beiden: sie ist der DP-Master von drei Plätzen, die intelligente Slaves sind, und nimmt an den Globaldaten der Station des Lehrers teil. Die Aufgabe geht an alle Plätze, von PROFIBUS kommen die Hände zurück.',
  ],
  'networks/positioning-drive': [
    'Positionierantrieb',
    'Ein Antrieb als Slave an PROFIBUS-DP, der das Standardtelegramm 9 von PROFIdrive spricht: Steuerwort, Zielposition und Geschwindigkeit gehen mit SFC 15 hinaus, Zustandswort und Lageistwert kommen mit SFC 14 zurück. Das Programm schaltet ihn ein, lässt ihn referenzieren und schickt ihn von Position zu Position. Der Antrieb hat die Zustandsmaschine des Profils und eine Achse mit Endschaltern und Referenznocken.',
  ],
  'networks/production-line': [
    'Fertigungslinie',
    'Fünf Stationen: eine Presse macht Teile, ein Band mit einem PROFIdrive-Antrieb trägt sie, eine Sortierung mit AS-i-Slaves schiebt sie in eine Kiste, ein Lager zählt sie, gesteuert von einem Bedienpult. MPI, PROFIBUS und Ethernet verbinden die Stationen, die Maschinen sind an den Klemmen mehrerer von ihnen verdrahtet.',
  ],
  'networks/profibus': [
    'PROFIBUS-DP',
    'Eine CPU 314C-2 DP als Master von zwei Slaves: eine Ventilinsel, die ihre GSD-Datei beschreibt, und eine ET 200M mit Baugruppen des Katalogs. Das Programm benutzt ihre Ein- und Ausgänge wie die der CPU, liest und schreibt mit SFC 14 und SFC 15 acht Bytes, die zusammengehören, liest mit SFC 13 die Diagnose eines Slaves und läuft weiter, wenn eine Station ausfällt: OB 86 zählt die Ausfälle, OB 122 die Zugriffe auf das, was fehlt.',
  ],
  'networks/recipes': [
    'Rezepte: zwei Stationen mit SFC 65 bis 68',
    'Ein Mischer holt sein Rezept aus einem Lager, schreibt die Zahl seiner Chargen dorthin und sendet zu jeder Charge eine Meldung. Das Programm des Lagers hat einen Aufruf, X_RCV; Rezept und Zahl werden ohne ihn gelesen und geschrieben.',
  ],
  'networks/send-receive': [
    'Senden und Empfangen',
    'AG_SEND und AG_RECV (FC 5, FC 6) zweier Stationen mit je einem CP 343-1: Meldungen als Datenblöcke über ISO-on-TCP, Messwerte als Strom über TCP, ein Lebenszeichen über UDP. Die Szenarien zeigen, was geschieht, wenn niemand liest und wenn der Stecker gezogen ist.',
  ],
  'networks/token-ring': [
    'Token-Ring: fünf Stationen mit Globaldaten',
    'Fünf Zellen mit je einer Presse, die so viel Strom braucht, dass nur eine arbeiten darf. Jede sendet ihre Nummer MW 102 als Globaldaten an die nächste, die letzte an die erste. Die erste Zelle hat das Token, solange sie ihre eigene Nummer empfängt, jede andere, solange sie eine andere als die eigene empfängt; das Token ist kein Telegramm, das verloren gehen könnte (E. W. Dijkstra, 1974). So findet ein Ring, in dem mehrere Zellen es zu haben glauben, von selbst zu einem Token zurück.',
  ],
  'networks/web-and-mail': [
    'Webseiten und E-Mails',
    'Ein CP 343-1 IT zeigt einen Tank im Browser und sendet eine E-Mail, wenn er voll ist: Seiten mit Werten des Programms, die Seite der CPU mit Betriebszustand, LEDs und Diagnosepuffer, eine E-Mail-Verbindung für AG_SEND. Ohne Mail-Server meldet AG_SEND 8304h.',
  ],
  'ring-buffer': [
    'Ringpuffer: Zeiger und indirekte Adressierung',
    'Ein Datenbaustein merkt sich die letzten Werte in der Reihenfolge, in der sie kamen. Vier Funktionen arbeiten damit, jede zeigt eine Art der indirekten Adressierung.',
  ],
  'sorting-plant': [
    'Sortieranlage',
    'Im Wareneingang kommen Kleinteile in Kästen dreier Größen auf ein Band. Die Anlage sortiert sie: drei Lichtschranken sehen, wie hoch ein Kasten ist, drei Schieber schieben jede Größe an ihren Platz.',
  ],
  'sorting-plant-plain': [
    'Sortieranlage, einfach',
    'Dieselbe Sortieranlage, so geschrieben, wie man anfängt: ein Organisationsbaustein, Merker und Zeiten, sonst nichts. 70 Anweisungen, von oben nach unten leicht zu verfolgen.',
  ],
  'star-delta': [
    'Stern-Dreieck-Anlauf',
    'Ein großer Motor läuft im Stern mit einem Drittel des Stroms an und schaltet nach fünf Sekunden auf Dreieck um. Ein Funktionsbaustein in internationaler Mnemonik: ein zweiter Motor ist ein zweiter Aufruf.',
  ],
  'step5/05-organization-blocks': [
    'STEP 5: Organisationsbausteine (Kapitel 5)',
    'Anlauf, Zyklus und Alarmebene. Ein Projekt, weil merker.toml ein Maschinendatum setzt: das Eingangsbyte 3 ist das Alarmbyte.',
  ],
  'step5/06-nc-data': [
    'STEP 5: Daten der NC (Kapitel 6.3)',
    'Die residenten Makros, die Daten der NC lesen und schreiben. Was die NC am Anfang enthält, steht in merker.toml.',
  ],
  'step5/09-formal-operands': [
    'STEP 5: Formaloperanden (Kapitel 9.4.1 bis 9.4.6)',
    'FB 203 bis FB 206 mit ihren Aufrufen, wie sie in den Tabellen des Handbuchs stehen, und die kurzen Beispiele FB 201 und FB 202. Der Kommentar hinter einer Anweisung sagt, was ausgeführt wird.',
  ],
  'step5/09-memory-access': [
    'STEP 5: Speicherzugriff (Kapitel 9.4.13)',
    'Die beiden Beispiele des Handbuchs: LIR liest ein Wort des Anwenderdatensegments (6), TIR schreibt eines. Sie laufen, weil merker.toml MD 2003 Bit 4 setzt; sonst geht die PLC mit Alarm 6115 in STOP.',
  ],
  'step5/coupled-pair/line': [
    'STEP 5: zwei gekoppelte Steuerungen, die Leit-PLC',
    'Die Leit-PLC einer Linie. Sie tauscht über FB 190 Wörter mit der Presse aus.',
  ],
  'step5/coupled-pair/press': [
    'STEP 5: zwei gekoppelte Steuerungen, die Presse',
    'Die Steuerung einer Presse mit ihrer Leit-PLC als Partner: FB 190, der Ausfall des Partners, eine gestörte Schnittstelle.',
  ],
  'step5/machine-values': [
    'STEP 5: Werte der Maschine',
    'Ein Szenario bewegt die NC: Drehzahl, Bahnvorschub, Positionen, Werkzeuge. Dazu ein Netzausfall und eine gezogene Baugruppe.',
  ],
  'step5/tool-changer': [
    'STEP 5: Werkzeugwechsler',
    'Ein Kettenmagazin mit acht Plätzen an einer Fräsmaschine mit SINUMERIK 810.',
  ],
  'technology/axis-first-steps': [
    'Erste Schritte mit einer Achse',
    'Eine Achse mit Servoantrieb am Analogausgang und SFB 44 ANALOG: was das Handbuch Inbetriebnahme nennt. Das Programm ist ein Aufruf und eine Fehlerauswertung; alles wird im Instanz-Datenbaustein DB 20 eingestellt, mit der Variablentabelle oder in einem Szenario.',
  ],
  'technology/axis-first-steps-contactors': [
    'Erste Schritte mit einer Achse an Schützen',
    'Eine Achse mit polumschaltbarem Motor an vier Schützen und SFB 46 DIGITAL: was das Handbuch Inbetriebnahme nennt (4.5). Das Programm ist ein Aufruf und eine Fehlerauswertung; alles wird im Instanz-Datenbaustein DB 22 eingestellt, mit der Inbetriebnahme des Programms, der Variablentabelle oder in einem Szenario.',
  ],
  'technology/blending-control': [
    'Mischungsregelung',
    'Drei Komponenten in festen Anteilen an einer Gesamtmenge, für jede ein Regelkreis (CONT_C, SFB 41). Die Anteile müssen zusammen 1 ergeben; sonst ist M 0.0 = 1 und alles schließt.',
  ],
  'technology/cascade-control': [
    'Kaskadenregelung',
    'Eine Heizung hinter einem Ventil mit zwei Reglern: der Temperaturregler (CONT_C, SFB 41) gibt vor, wie das Ventil stehen soll, der Stellungsregler (CONT_S, SFB 42 mit TI = 0) fährt es dorthin.',
  ],
  'technology/comparator': [
    'Vergleicher mit Hysterese',
    'Ein Inkrementalgeber (250 Striche, vierfache Auswertung) gibt die Stellung einer Achse an Kanal 0; dessen Digitalausgang ist ab Stellung 1000 gleich 1. Mit der Hysterese 20 schaltet er erst um, wenn der Zählwert den Bereich 981 bis 1019 verlassen hat.',
  ],
  'technology/drilling-gantry': [
    'Bohrportal',
    'Ein Portal mit Schützen fährt im Eilgang und Schleichgang zu drei Bohrungen und bohrt: SFB 46 DIGITAL mit Ansteuerart 1. Der erste Start nach einem Neustart beginnt mit einer Referenzpunktfahrt.',
  ],
  'technology/fan-frequency': [
    'Frequenz eines Lüfters',
    'Kanal 1 misst alle 200 ms die Impulse eines Lüfters, zwei je Umdrehung (SFB 48). Außerhalb von 40 Hz bis 60 Hz ist sein Digitalausgang 1, und die erste Messung außerhalb löst einen Prozessalarm aus. MD 10 ist die Frequenz in mHz, MD 14 die Drehzahl.',
  ],
  'technology/barcode-scanner': [
    'Barcodeleser',
    'Ein Leser an der seriellen Schnittstelle X27 sendet jeden Code mit CR am Ende. Der ASCII-Treiber wartet auf dieses Endezeichen, SFB 61 RCV_PTP übergibt den Code. Angenommen werden Codes, die mit 40 beginnen.',
  ],
  'technology/label-printer': [
    'Etikettendrucker',
    'Jede Flanke von E 124.0 druckt ein Etikett: PART und eine Nummer. Der ASCII-Treiber hängt CR LF an und beachtet XON/XOFF: der Drucker hält ihn an, solange er keinen Platz hat; A 124.0 zeigt, dass er innerhalb von 5 s nicht weitergemacht hat.',
  ],
  'technology/rs485-drive': [
    'Antrieb an RS 485',
    'Die CPU ist Master eines Zweidrahtbusses: alle 50 ms sendet sie ein Telegramm in der Form von USS (STX, Länge, Adresse, Steuerwort, Sollwert, Blockprüfzeichen) und bekommt eines zurück. Der ASCII-Treiber fügt nichts hinzu, das Programm berechnet das Blockprüfzeichen.',
  ],
  'technology/s5-host': [
    'Host mit RK 512',
    'Ein Host, früher eine SIMATIC S5, liest Zahlen der CPU (FETCH) und schickt ihr Aufträge (SEND) über die Rechnerkopplung RK 512. SFB 65 SERVE_RK beantwortet beides. Der Koppelmerker M 100.6 sperrt einen Auftrag, bis das Programm ihn übernommen hat.',
  ],
  'technology/two-stations/filling': [
    'Zwei Stationen mit RK 512: die Abfüllstation',
    'Zwei CPUs 314C-2 PtP, X27 an X27. Die Abfüllstation holt ihr Rezept aus dem Lager (SFB 64 FETCH_RK) und meldet jede Charge (SFB 63 SEND_RK); im Lager beantwortet SFB 65 SERVE_RK beides. Der Koppelmerker M 100.6 sperrt eine Meldung, bis das Lager sie übernommen hat.',
  ],
  'technology/two-stations/store': [
    'Zwei Stationen mit RK 512: das Lager',
    'Das Lager hält das Rezept in DB 10 und nimmt Meldungen in DB 11 entgegen, beides über SFB 65 SERVE_RK. Es läuft allein mit einem Partner, für den ein Szenario spricht, und mit der Abfüllstation am anderen Ende von X27.',
  ],
  'technology/weighing-scale': [
    'Waage',
    'Die CPU fragt eine Waage nach ihrem Gewicht, die Waage antwortet mit fünf Ziffern; beide sprechen die Prozedur 3964R. SFB 60 SEND_PTP endet mit DONE, wenn die Waage das Telegramm quittiert hat, SFB 61 RCV_PTP nimmt die Antwort.',
  ],
  'technology/light-barrier': [
    'Teile zählen mit einer Lichtschranke',
    'Kanal 0 des integrierten Zählers (SFB 47) zählt die Teile auf einem Band: periodisch, Hauptzählrichtung vorwärts, Endwert 9. Mit dem neunten Teil meldet er Überlauf als Prozessalarm, und OB 40 zählt die vollen Kartons.',
  ],
  'technology/pwm-heater': [
    'Heizung mit Pulsweitenmodulation',
    'Kanal 2 macht aus einer Leistung in Promille (MW 10) Impulse seines Digitalausgangs (SFB 49): Periode 1 s, Impulse und Pausen mindestens 20 ms. Der Ausgang heizt eine Platte, die so träge ist, dass sie nur die Leistung sieht.',
  ],
  'technology/ratio-control': [
    'Verhältnisregelung',
    'Zwei Durchflüsse in festem Verhältnis, zwei Regelkreise (CONT_C, SFB 41). Der Sollwert des zweiten ist der Istwert des ersten mal einem Faktor: das Verhältnis bleibt, auch wenn der erste Durchfluss sich ändert.',
  ],
  'technology/rotary-table': [
    'Rundtisch',
    'Ein Tisch mit acht Plätzen und Servoantrieb: SFB 44 ANALOG mit einer Rundachse von 8000 Impulsen. START ohne Richtung nimmt den kürzesten Weg, auch über das Ende der Achse.',
  ],
  'technology/temperature-control': [
    'Temperaturregelung',
    'Ein Ofen, der geheizt und gekühlt wird. CONT_C (SFB 41) bildet aus Sollwert und Temperatur einen Stellwert von -100 % bis 100 %, PULSEGEN (SFB 43) macht daraus Impulse zweier Ausgänge. OB 35 kommt alle 20 ms.',
  ],
  'technology/valve-control': [
    'Ventilregelung',
    'Ein Ventil mit Motor, das nur „auf“ und „zu“ kennt. CONT_S (SFB 42) regelt den Prozess dahinter ohne Stellungsrückmeldung: er zählt, wie lange der Motor gelaufen ist. Impuls und Pause dauern mindestens 500 ms.',
  ],
  'traffic-light': [
    'Fußgängerampel',
    'Ein Überweg mit einem Taster auf jeder Seite, als Schrittkette in internationaler Mnemonik: A für U, SD für SE, JC für SPB, JL für SPL, Eingänge I, Ausgänge Q.',
  ],
  'two-hand-control': [
    'Zweihandschaltung',
    'Eine Presse darf nur fahren, während beide Hände auf den Tastern liegen. Beide müssen innerhalb einer halben Sekunde gedrückt werden; lässt eine Hand los, steht die Presse, und vor dem nächsten Hub müssen beide losgelassen haben.',
  ],
  'unit-tests': [
    'Tests für SPS-Funktionen',
    'Eine Bibliothek von Funktionen und eine zweite Datei, die jede davon prüft: ohne Hardware, mit einem Befehl.',
  ],
  'vessel-emptying': [
    'Behälter entleeren',
    'Ein Behälter mit zwei Füllstandssensoren und einem Ventil im Auslauf. Start öffnet das Ventil; es schließt, wenn der untere Sensor trocken fällt oder jemand Stopp drückt. Die klassische erste Übung mit Selbsthaltung und Öffner.',
  ],
};
