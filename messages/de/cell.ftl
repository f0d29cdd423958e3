# Modes.
cell-mode-off = Aus
cell-mode-idle = nicht referenziert
cell-mode-homing = Referenzfahrt
cell-mode-ready = bereit
cell-mode-jog = Tippbetrieb
cell-mode-teach = Teachen
cell-mode-dry-run = Probelauf
cell-mode-weld = Schweißen
cell-mode-hold = Halt
cell-mode-fault = Störung

# Events that change the mode.
cell-trigger-switch-on = Einschalten
cell-trigger-switch-off = Ausschalten
cell-trigger-home = Referenzfahrt
cell-trigger-homed = referenziert
cell-trigger-jog = Tippen
cell-trigger-teach = Teachen
cell-trigger-dry-run = Probelauf
cell-trigger-weld = Schweißen
cell-trigger-hold = Halt
cell-trigger-finish = Ende
cell-trigger-abort = Abbruch
cell-trigger-trip = Auslösung
cell-trigger-reset = Zurücksetzen
cell-refused = „{ $event }“ ist im Zustand „{ $mode }“ nicht möglich: erlaubt in: { $modes }

# Commands.
cell-ask-switch-on = einschalten
cell-ask-switch-off = ausschalten
cell-ask-home = referenzieren
cell-ask-home-axis = eine Achse in Grundstellung
cell-ask-start-jog = Tippbetrieb beginnen
cell-ask-start-teach = Teachen beginnen
cell-ask-jog = tippen
cell-ask-start-dry-run = Probelauf starten
cell-ask-arm = Prozess freigeben
cell-ask-start-weld = Schweißen starten
cell-ask-hold = Halt
cell-ask-resume = weiter
cell-ask-reverse = rückwärts
cell-ask-stop = Stopp
cell-ask-override = Override { $override }
cell-ask-reset = Störung zurücksetzen
cell-ask-acknowledge = alle Alarme quittieren
cell-ask-acknowledge-one = einen Alarm quittieren
cell-ask-why = warum nicht
cell-ask-load = Programm laden
cell-ask-quit = beenden

# Missing permissives.
cell-missing-rest = die Achsen bewegen sich noch: kurz warten
cell-missing-references = die Referenz von { $axes } ist unbekannt: zuerst referenzieren
cell-missing-homes-first = Achse { $axis } muss laut Maschinendatei zuerst in Grundstellung
cell-missing-power = die Antriebe haben noch keine Spannung: kurz warten
cell-missing-answer = keine Antwort: { $device }; Kabel und Gerät prüfen
cell-missing-interlock = Verriegelung „{ $interlock }“ ist nicht erfüllt
cell-missing-acknowledgement = Alarm „{ $alarm }“: { $action }, dann quittieren
cell-missing-arming = der Prozess ist nicht freigegeben: freigeben, dann innerhalb einer Minute starten
cell-missing-source = die Prozessquelle ist nicht bereit
cell-missing-start = Achse { $axis } steht nicht am Anfang der Anfahrt
cell-missing-program = kein Programm ist geladen
cell-missing-value = die Zahl liegt außerhalb des erlaubten Bereichs
cell-missing-motion = diese Bewegung ist jetzt nicht möglich
cell-device-drives = Antriebe
cell-device-inputs = Eingänge
cell-device-source = Prozessquelle

# Events and notes of a weld.
cell-event-mode = { $from } → { $to }
cell-event-missed =
    { $n ->
        [one] { $n } Zyklus
       *[other] { $n } Zyklen
    } verpasst, bis zu { $gap } am Stück
cell-event-pass-ends = Lage { $pass } endet bei { $at }
cell-event-pass-left = Lage { $pass } wurde verlassen, geschweißt bis { $at }
cell-event-without-rights = ohne Echtzeitrechte: { $rights }
cell-right-priority = Priorität
cell-right-memory = gesperrter Speicher
cell-right-cpu = CPU
cell-note-stopped = gestoppt durch: { $cause }
cell-note-left = in Lage { $pass } verlassen, geschweißt bis { $at }
cell-note-not-finished = nicht bis zum Ende geschweißt
cell-note-nothing-welded = nichts wurde geschweißt
cell-shutdown-signal = Signal { $signal }
cell-shutdown-panic = ein Programmfehler (panic)
cell-shutdown-end = das Ende des Programms
cell-shutdown-cycle-stopped = der Zyklus ist stehen geblieben und kommt nicht wieder

# Real-time rights.
cell-realtime-granted = Echtzeitpriorität, Speicher gesperrt
cell-realtime-degraded = eingeschränkt: { $missing }
cell-realtime-no-priority = keine Echtzeitpriorität ({ $why }; mit `ulimit -r` oder CAP_SYS_NICE erlauben)
cell-realtime-memory-not-locked = Speicher nicht gesperrt ({ $why }; mit `ulimit -l` oder CAP_IPC_LOCK erlauben)
cell-realtime-no-cpu = nicht auf der gewünschten CPU ({ $why })
cell-no-such-cpu = CPU { $cpu } gibt es nicht
cell-only-on-linux = nur unter Linux
cell-cycle-failed = der Zyklus ist ausgefallen (Programmfehler); seine Geräte wurden abgeschaltet

# A cell that cannot run.
cell-invalid-drive = Antrieb von Achse { $axis }: { $why }
cell-too-many-process-values =
    das Programm hat { $n ->
        [one] { $n } Prozesswert
       *[other] { $n } Prozesswerte
    }
       erlaubt: bis { $max }
cell-no-stepper = die Achse hat keinen Schrittmotor
cell-microsteps-too-coarse = die feinste Mikroschritt-Einstellung des Treibers erreicht die Auflösung nicht

# Tracking.
cell-no-cross-slide = Kopf { $head } der Maschine { $machine } hat keinen Kreuzschlitten: zwei eigene Linearachsen
cell-no-stripe-sensor = Maschine { $machine } hat keinen Lichtschnittsensor für Kopf { $head }: die Nahtverfolgung braucht einen vor dem Brenner; erlaubt ist [sensors.<name>] mit kind = "stripe" in der Maschinendatei
cell-sensor-not-leading = Sensor { $sensor } von { $machine } läuft Kopf { $head } in dieser Lage nicht voraus: sein Vorlauf ändert sich von { $min } bis { $max }; erlaubt ist ein auf ein Zehntel konstanter Vorlauf, wie bei einem Sensor, der sich mit der Naht dreht
cell-off-line-two-torches = Lage `{ $pass }` pendelt mit zwei Brennern: ein verschobenes Werkstück lässt sich nur simulieren, wenn der Brenner der Nahtlinie folgt; erlaubt ist eine Lage ohne verschliffene Ecken, gependelt höchstens von einem Brenner, oder keine Abweichungsdatei
cell-off-line-beam = Lage `{ $pass }` pendelt mit einem Strahl: ein verschobenes Werkstück lässt sich nur simulieren, wenn der Strahl der Nahtlinie folgt; erlaubt ist eine Lage ohne verschliffene Ecken und ohne Pendeln oder keine Abweichungsdatei
cell-off-line-blends = Lage `{ $pass }` hat verschliffene Ecken: ein verschobenes Werkstück lässt sich nur simulieren, wenn der Brenner der Nahtlinie folgt; erlaubt ist eine Lage ohne verschliffene Ecken, gependelt höchstens von einem Brenner, oder keine Abweichungsdatei
cell-slides-aside = die Kreuzschlitten von Kopf { $head } der Maschine { $machine } können den Brenner nicht nach allen Seiten dieser Naht bewegen; erlaubt sind zwei [[heads.steps]], deren `move` quer zur Naht in verschiedene Richtungen weist
cell-no-beam-camera = Maschine { $machine } hat keine Kamera, die durch ihren Strahl blickt; erlaubt ist [sensors.<name>] mit kind = "camera" in der Maschinendatei
cell-no-replay = Maschine { $machine } kann gespeicherte Abweichungen nicht wiedergeben: sie hat keinen ablenkbaren Strahl; erlaubt sind Maschinen mit torch.deflection in ihrer Datei
cell-gun-not-carried = die Achsen können die Kanone nicht zur Seite führen: { $why }
cell-alarm-with-cause = { $alarm }: { $cause }
cell-alarm-of-head = { $alarm }, Kopf { $head }
cell-joint-not-seen = die Fuge wurde vor dem Schweißen nicht gesehen
cell-sighting-cut-short = die Bewegung zum Sehen des Anfangs ist verkürzt
cell-sighting-length = { $clear } von { $wanted }, { $why }
cell-end-of-reach = die Achsen sind am Ende ihrer Reichweite
cell-too-close = { $a } und { $b } kommen sich zu nahe
cell-something-too-close = zwei Körper kommen sich zu nahe

# Distortion file.
cell-empty-range = leerer Bereich: von { $from } bis { $to }
cell-allowed-range = `to` größer als `from`
cell-no-head = diesen Kopf gibt es nicht
cell-allowed-heads = 1 oder 2
cell-empty-displacement = die Verschiebung ist leer
cell-turn-missing = die Achse zu diesem Winkel fehlt
cell-allowed-turn = turn = [x, y, z], die Achse

# Teaching.
cell-camera-out-of-reach = die Achsen können die Kamera nicht dorthin bringen: { $remaining } fehlen
cell-no-points = keine Punkte; mindestens einen auf der Fuge angeben
cell-point-off-seam = Punkt { $point } liegt weiter als { $max } von der Sollnaht entfernt
cell-points-coincide = Punkte { $first } und { $second } liegen an derselben Stelle der Naht

# Frames of cameras.
cell-frame-io = { $what }: { $why }
cell-frames-missing =
    { $what }: { $why }
       erlaubt: ein vorhandener Ordner mit Bildern und frames.csv
cell-frame-list =
    { $file }:{ $line }: { $why }
       erlaubt: { $allowed }
cell-frame-header =
    Bild { $frame }: ungültig ({ $field }): { $found }
       erlaubt: { $allowed }
cell-frame-magic = erste Bytes
cell-frame-version = Version
cell-frame-depth = Pixeltiefe
cell-frame-width = Breite
cell-frame-height = Höhe
cell-frame-axes = Anzahl der Achsen
cell-frame-reserved = Bytes 18 bis 23
cell-frame-work-height = Höhe des Werkstücks
cell-frame-position = Achsposition
cell-frame-depth-allowed = 8 oder 16 Bit pro Pixel
cell-frame-position-allowed = eine endliche Zahl in mm oder Grad
cell-frame-work-height-allowed = eine endliche Zahl in mm oder NaN
cell-frame-machine-axes = { $n }, die Achsen der Maschine
cell-frame-header-truncated = Bild { $frame }: der Datenstrom endet nach { $found } der { $wanted } des Kopfs
cell-frame-axes-truncated = Bild { $frame }: der Datenstrom endet nach { $found } der { $wanted } der Achspositionen
cell-frame-pixels-truncated = Bild { $frame }: der Datenstrom endet nach { $found } der { $wanted } der Pixel
cell-frame-time = Bild { $frame }: ungültige Zeit { $time }; Zeiten müssen endlich sein und zunehmen
cell-frame-time-order = Bild { $frame }: ungültige Zeit { $time } nach einem Bild bei { $before }; Zeiten müssen endlich sein und zunehmen
cell-frame-shape = Bild { $frame }: { $why }
cell-frame-late = Bild { $frame } kam nicht rechtzeitig
cell-frame-size = das Bild hat { $size } Pixel; erlaubt: size_px des Sensors, { $allowed }
cell-camera-closed = die Kamera hat die Verbindung geschlossen
cell-no-frame-in-time = kein Bild kam rechtzeitig
cell-image-format = unbekanntes Bildformat; erlaubt: PNG, JPEG, PNM
cell-image-broken = unlesbares Bild: { $why }
cell-jpeg-truncated = die JPEG-Datei endet vor ihrem Bild
cell-pixel-count = die Anzahl der Pixel passt nicht zum Bild
cell-file-too-large = die Datei hat { $size }; erlaubt sind bis { $max }
cell-list-no-text = keine Textdatei
cell-list-columns = die Spalten sind { $columns }
cell-list-columns-allowed = { $columns }, wahlweise { $optional }
cell-list-cells =
    { $n ->
        [one] { $n } Zelle
       *[other] { $n } Zellen
    }
cell-list-cells-allowed = { $n }, eine pro Spalte
cell-list-file = ungültiger Dateiname "{ $name }"
cell-list-file-allowed = der Name eines Bildes in diesem Ordner
cell-list-number = { $column }: "{ $value }" ist keine Zahl
cell-list-time = t_s: { $time } liegt nicht nach { $before } in der Zeile davor
cell-list-time-allowed = zunehmende Zeiten
cell-list-empty = die Liste hat keine Bilder
cell-list-empty-allowed = eine Zeile pro Bild

# Devices on Modbus.
cell-modbus-unreachable = Gerät `{ $device }` an { $address }: { $why }
cell-modbus-no-register = Gerät `{ $device }` hat kein Register, das den Prozesswert `{ $value }` des Auftrags setzt
cell-modbus-refused = das Gerät weist { $what } zurück ({ $code })
cell-modbus-registers = { $table } { $from } bis { $to }
cell-modbus-named = { $registers }: { $names }
cell-modbus-cells = { $table } { $at }: { $asked } Zellen angefordert, { $answered } erhalten
cell-modbus-no-connection = keine Verbindung innerhalb von { $time }
cell-modbus-no-answer = keine Antwort innerhalb von { $time }
cell-modbus-no-heartbeat = kein Lebenszeichen seit { $time }
cell-modbus-closed = die Verbindung wurde geschlossen
cell-modbus-not-connected = nicht verbunden
cell-modbus-second-connection = { $why }, auf einer zweiten Verbindung; falls das Gerät nur eine annimmt: connections = 1

# LinuxCNC's HAL.
cell-hal-not-installed =
    LinuxCNC ist nicht installiert: Programm `{ $program }` fehlt
       erlaubt: das Debian-Paket linuxcnc-uspace (apt install linuxcnc-uspace)
cell-hal-running =
    HAL von LinuxCNC läuft bereits: { $owner }
       erlaubt: nur eines zur selben Zeit; das andere beenden oder mit `halrun -U` entfernen
cell-hal-of-seamwright = das von Seamwright, Prozess { $process }
cell-hal-foreign = das eines anderen Programms
cell-hal-refused = LinuxCNC weist { $file } zurück: { $why }
cell-hal-own-commands = unsere eigenen Befehle
cell-hal-too-slow = es dauert länger als { $time }; { $said }
cell-hal-no-start = HAL von LinuxCNC startet nicht: { $why }
cell-hal-no-samples = HAL von LinuxCNC läuft nicht, es sendet keine Abtastwerte: { $why }
cell-hal-output = { $sampler }; { $keeper }
cell-hal-no-output = keine Ausgabe
cell-hal-not-run = HAL von LinuxCNC kann nicht laufen: { $why }
cell-hal-refuses-root = HAL lehnt root ab, und den Benutzer `nobody` gibt es nicht; als anderer Benutzer starten
cell-hal-no-pipes = seine Ströme haben keine Pipes
cell-hal-program-ended = { $program } ist beendet
cell-hal-no-data = sein Echtzeitprogramm sendet nichts
cell-hal-ended = HAL von LinuxCNC ist beendet: { $why }; es wird ohne Spannung neu gestartet
cell-hal-runs-again = HAL von LinuxCNC läuft wieder: quittieren, zurücksetzen, einschalten, referenzieren
cell-hal-retried =
    { $error }
       neuer Versuch alle { $time }

# Fault injection.
cell-fault-form = ungültiger Fehler; erlaubt ist DEVICE:KIND@TIME[+DURATION], wie drives:silent@12.5 oder inputs:disconnect@3+0.5
cell-fault-no-device = Gerät `{ $name }` gibt es nicht; erlaubt sind { $names }
cell-fault-no-kind = Fehler `{ $name }` gibt es nicht; erlaubt sind { $names }
cell-fault-no-time = ungültige Zeit `{ $text }`; erlaubt ist eine Zahl in Sekunden, 0 oder größer
cell-fault-injection-summary =
    { $kept } von { $all } Fällen enden wie gefordert ({ $faults } in Störung); Prozess aus nach höchstens { $cycles ->
        [one] { $cycles } Zyklus
       *[other] { $cycles } Zyklen
    }; längster Anhalteweg { $stop }, höchstens { $bound } seiner Grenze
cell-violation = { $time }: { $what }
cell-violation-no-restart = die Zelle lässt sich nicht wieder einschalten
cell-violation-no-rest = die Achsen kommen nicht zum Stillstand
cell-violation-process-on = der Prozess ist im Zustand „{ $mode }“ an
cell-violation-process-after-alarm = der Prozess ist nach dem Alarm an
cell-violation-stop = der Anhalteweg ist { $length }; erlaubt sind { $max }
cell-violation-jump = Achse { $axis }: der Sollwert liegt { $distance } von der Istposition entfernt
cell-violation-limits = Achse { $axis }: Geschwindigkeit { $speed }, Beschleunigung { $acceleration } über den Grenzen
cell-program-damaged = das Programm kam beschädigt an: { $why }
cell-program-changed = { $job } oder eine darin genannte Datei wurde nach der Planung geändert: neu laden
cell-program-panicked = ein Thread der Zelle endete durch einen Programmfehler
cell-socket = keine Sockets in { $folder }: { $why }
cell-already-runs = es läuft schon eine Zelle mit Sockets in { $folder }
cell-no-process = der Prozess der Zelle lässt sich nicht starten: { $why }
cell-process-ended-early = der Prozess der Zelle endete ohne Meldung
cell-process-silent = der Prozess der Zelle antwortete nicht und wurde beendet
cell-process-signal = ihr Prozess wurde durch Signal { $signal } beendet
cell-process-code = ihr Prozess endete mit Code { $code }
cell-safe-not-asked = es wurde nicht gefragt
cell-outputs-unconfirmed = Gerät { $device }: seine Ausgänge sind nicht als sicher bestätigt: { $why }
cell-record-not-saved = die letzten Zeilen der Schweißung { $weld } wurden nicht rechtzeitig geschrieben
cell-does-not-end = der Zyklus kommt nicht zum Ende: prüfen, ob Lichtbogen, Gas und Antriebe aus sind
cell-program-too-large = die geplante Bewegung hat { $size }, mehr als die { $max }, die eine Zelle annimmt

# Robotersteuerungen, die Sollwerte annehmen.
cell-robot-unusable = Gerät `{ $device }` ({ $protocol }) an { $address }: { $why }
cell-robot-lost = keine Verbindung: { $why }
cell-robot-port-in-use = ein anderes Programm hört auf diesem Port
cell-robot-not-listening = dieser Rechner kann dort nicht hören: { $why }
cell-robot-no-reports = die Steuerung sendet nichts; Programm der Steuerung starten und deren Zieladresse prüfen
cell-robot-closed = die Steuerung hat die Verbindung geschlossen
cell-robot-malformed = die Steuerung sendet Bytes, die keine Nachricht dieses Protokolls sind
cell-robot-version = die Steuerung lehnt Version 2 von RTDE ab
cell-robot-unknown-fields = die Steuerung kennt { $fields } nicht
cell-robot-fields-in-use = ein anderes Programm benutzt { $fields }
cell-robot-not-started = die Steuerung beginnt ihre Meldungen nicht
cell-robot-joints = die Steuerung meldet { $reported } Gelenke, die Maschinendatei braucht { $needed }
cell-robot-not-stopped = der Roboter hat seinen Halt nicht bestätigt
cell-robot-motors-off = die Motoren des Roboters sind aus
cell-robot-protective-stop = Schutzstopp des Roboters
cell-robot-safeguard-stop = Schutzeinrichtungs-Stopp des Roboters
cell-robot-emergency-stop = Not-Halt des Roboters
cell-robot-safety-fault = das Sicherheitssystem des Roboters meldet einen Fehler
cell-robot-program-stopped = das Programm auf der Robotersteuerung läuft nicht
cell-robot-other-program = auf der Robotersteuerung läuft ein anderes Programm
cell-robot-control-error = die Bewegungsschnittstelle der Robotersteuerung meldet einen Fehler
cell-robot-starved = Sollwerte für den Roboter fehlten
cell-robot-jump = ein Sollwert liegt zu weit von der Stellung des Roboters
cell-robot-disconnected = die Verbindung mit dem Roboter ist verloren
