# Findings at the command line.
project-weld-possible = die Schweißung ist wie verlangt möglich
project-weld-possible-with-remarks = die Schweißung ist möglich, mit Hinweisen
project-weld-impossible = die Schweißung ist so nicht möglich: { $findings ->
        [one] { $findings } Befund
       *[other] { $findings } Befunde
    }
project-finding = { $severity } ({ $kind }): { $finding }
project-severity-error = Befund
project-severity-warning = Warnung
project-severity-note = Hinweis
project-where = wo: { $places }
project-cure = Abhilfe: { $cure }
project-pass = Lage { $pass }
project-passes = Lagen { $first } bis { $last }
project-place = { $passes }, s = { $s }
project-place-range = { $passes }, s = { $from } bis { $to }
project-places = { $first }; { $then }
project-more-places = { $places ->
        [one] { $places } weitere Stelle
       *[other] { $places } weitere Stellen
    }

project-angles-of-another-plan = die Brennerwinkel gehören zu einem anderen Plan
project-long-stick-out = der Brenner ist nur mit einem freien Drahtende von { $found } frei: über { $usual } fällt der Strom bei gleichem Drahtvorschub, und das Schutzgas wird dünn
project-cure-long-stick-out = einen Brenner verwenden, der besser in die Fuge passt, oder eine Schweißanweisung, deren stick_out_mm ihn deckt

# Failures.
project-with-allowed =
    { $message }
    { "   " }{ $allowed }
project-with-hint =
    { $message }
    { "   " }{ $hint }
project-or = { $first } oder { $second }
project-note = Hinweis: { $note }
project-planning-cancelled = die Planung wurde abgebrochen
project-failed = es ist fehlgeschlagen
project-standard-input = Standardeingabe: { $why }
project-in-machine-file = Maschinendatei: { $why }
project-in-file = { $file }: { $why }
project-document-fault = { $file }:{ $line }: { $key }: { $message }

# Files.
project-unreadable = { $file }: nicht lesbar: { $why }
project-not-writable = { $file }: nicht schreibbar: { $why }
project-writable = ein Ordner oder eine Datei, in die Sie schreiben dürfen
project-no-such-folder = diesen Ordner gibt es nicht
project-permission-denied = keine Berechtigung
project-not-a-folder = es ist kein Ordner
project-is-a-folder = es ist ein Ordner
project-file-too-large = { $file }: die Datei ist zu groß
project-up-to-1-gib = bis 1 GiB
project-other-file-there = { $file }: eine andere Datei steht dort, wo die Kopie von { $from } hin soll
project-other-folder = ein anderer Ausgabeordner
project-files-written = { $files ->
        [one] { $files } Datei
       *[other] { $files } Dateien
    } nach { $folder }: { $names }
project-files-written-more = { $files ->
        [one] { $files } Datei
       *[other] { $files } Dateien
    } nach { $folder }: { $names } und { $more } weitere
project-file-outside = der Name führt aus dem Ordner der Aufträge hinaus
project-link-outside = ein Link führt aus dem Ordner der Aufträge hinaus
project-not-a-plain-file = es ist keine gewöhnliche Datei
project-file-above = sie ist größer als { $max }

# Tables.
project-csv-value = { $file }:{ $line }: { $column } = `{ $value }`: { $fault }
project-not-a-finite-number = keine endliche Zahl
project-no-column = { $file }:1: es gibt keine Spalte `{ $column }` in `{ $header }`
project-header-line = eine Kopfzeile mit { $columns }, dann Zahlen
project-header-line-with-commas = eine Kopfzeile mit { $columns }, dann Zahlen, durch Kommas getrennt
project-table-too-long = { $file }: die Tabelle ist zu lang
project-up-to-points = bis { $max } Punkte
project-file-from-job = eine vorhandene Datei, ihr Pfad vom Ordner des Auftrags aus

# Jobs and machines.
project-no-such-file = { $file }: diese Datei gibt es nicht
project-copy-example = es gibt ein Beispiel `{ $name }`; zum Kopieren: seamwright examples { $name } > { $name }.toml
project-job-or-example = eine Auftrags- oder Programmdatei, oder der Name eines Beispiels: { $names }
project-program-without-seam = das Programm hat keine Naht
project-job-or-seam = ein Auftrag, oder ein Programm mit [seam]
project-no-machine = es gibt keine Maschine `{ $name }`
project-shipped-machine-or-file = eine mitgelieferte Maschine, oder der Pfad einer Maschinendatei
project-no-machine-or-file = diese Maschine gibt es nicht, und keine Datei { $file }
project-no-such-machine = { $name }: diese Maschine gibt es nicht, und diese Datei auch nicht
project-machine-names = { $names } oder der Pfad einer Maschinendatei
project-machine-refused = Maschine `{ $name }`: { $why }
project-machine-among-jobs = der Name einer mitgelieferten Maschine, oder eine Maschinendatei bei den Aufträgen
project-machine-without-file = die Maschine `{ $name }` hat keine Datei
project-not-a-table = `{ $table }` ist keine Tabelle
project-process-value-is-axis = der Prozesswert `{ $name }` heißt wie eine Achse der Maschine
project-one-head = { $machine } hat einen Kopf: er kann nicht beide Kehlnähte zugleich schweißen
project-no-recording-machine = es gibt keine Maschine `{ $name }`, die sie aufgezeichnet haben könnte
project-machine-as-recorded = `machine` wie bei der Aufzeichnung
project-positions-for-axes = { $positions ->
        [one] { $positions } Position
       *[other] { $positions } Positionen
    }, und { $machine } hat { $axes ->
        [one] { $axes } Achse
       *[other] { $axes } Achsen
    }
project-within-axis-ranges = Positionen innerhalb der Bereiche der Achsen
project-option-tolerance = --tolerance-mm { $value }: { $why }

# Planning.
project-part-not-checked = kein Werkstück ist beschrieben: Kollisionen werden nur mit Maschine und Vorrichtungen geprüft
project-cure-describe-part = das Werkstück mit [[part.solids]] beschreiben, oder mit der [seam], aus der es gemacht wird
project-part-replaced = das aus der Naht gemachte Werkstück ist ersetzt: Kollisionen werden nur mit den Körpern von [part] geprüft
project-period-too-long = eine Periode von { $period } ist länger als die Fahrt von Lage { $pass }
project-period-within-travel = bis { $max }, die Zeit der Fahrt
project-too-many-set-points = die Bewegung dauert { $time }, { $set-points } Sollwerte zu { $period }
project-up-to-set-points = bis { $max } Sollwerte; höhere Geschwindigkeit, kürzere Zeiten oder längere Periode
project-tracking-with-devices = Lagen werden mit simulierten Sensoren verfolgt, aber die Maschinendatei hat eigene Geräte
project-no-devices-or-tracking = eine Maschinendatei ohne [devices], oder keine Verfolgung

# Devices.
project-register-too-small = Lage { $pass } verlangt { $value } als `{ $name }`; das Register ({ $register }) des Geräts `{ $device }` kann diesen Wert nicht aufnehmen
project-register-range = { $min } bis { $max }, oder eine andere Skalierung oder ein anderer Typ in der Maschinendatei
project-register-or-no-value = ein Register `{ $value }` in [devices.{ $device }.modbus.set] der Maschinendatei, oder ein Auftrag ohne diesen Wert
project-check-modbus = Kabel, Adresse, Gerätenummer und Register prüfen; `seamwright machine io MACHINE` liest sie einzeln
project-check-robot = Kabel und Adressen auf beiden Seiten prüfen, und ob das Programm von `seamwright machine robot-program { $protocol }` auf der Steuerung läuft
project-period-of-no-cell = Maschine `{ $machine }`: keine Zelle läuft mit einer servo_period_ms von { $period }
project-periods = { $min } bis { $max }, ohne Angabe 1 ms; `seamwright machine latency` misst, was dieser Rechner kann
project-linuxcnc-needs-linux = Antriebe über LinuxCNC gibt es nur unter Linux
project-simulated = simuliert: { $devices }
project-drives = Antriebe
project-process-source = Stromquelle
project-inputs = Eingänge
project-pulses-end = { $file }: { $why }: die Pulse enden hier

# Welds that were interrupted.
project-journal-damaged = { $folder }: beide Dateien des Positionsjournals sind beschädigt: eine Schweißung kann an unbekannter Position abgebrochen sein
project-look-and-choose = das Werkstück ansehen, dann mit --from PASS,MM dort fortsetzen oder mit --from 1,0 neu schweißen
project-weld-left = Schweißung { $weld } wurde durch einen Ausfall von Strom oder Programm unterbrochen: Lage { $pass }, geschweißt bis { $welded }, der Brenner bei { $torch }
project-grind-and-continue = das Ende der Raupe ansehen, schleifen, dann --from { $from }; oder --from 1,0, um neu zu schweißen
project-journal-thread-failed = der Thread des Journals ist ausgefallen

# Teaching by camera.
project-no-taught-program = aus der gefundenen Linie wird kein Programm: { $why }
project-teach-machine-limit = die Maschine kann nicht weiter: { $why }
project-teach-joint-too-long = die Fuge ist länger als die doppelte Sollnaht
project-teach-joint-lost = die Fuge ist verloren
project-teach-no-joint = keine Fuge gefunden
project-teach-no-more-frames = die Bilder enden vor der Fuge
project-cure-teach = von dort mit --start weiter teachen, ein größeres --longest-tack-mm erlauben oder die Punkte von Hand aufnehmen
project-goes-on = geht in Lage { $pass } ab { $from } weiter

# Search for placements.
project-reach-axes = Lage { $pass } ist durch Achspositionen gegeben: keine Aufstellung verschiebt sie
project-reach-axes-allowed = Lagen entlang einer Naht oder durch Punkte des Brenners
