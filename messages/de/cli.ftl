# Notes and errors of every command.
cli-more-time = { $cure }; mehr Zeit: --time-limit S
cli-verb-renamed = Hinweis: `seamwright { $former }` heißt jetzt `seamwright { $present }`
cli-unknown-language = Hinweis: die Sprache `{ $language }` gibt es nicht, daher Englisch; verfügbar: { $known }
cli-error = Fehler: { $error }
cli-option = { $option }: { $fault }
cli-not-allowed = nicht zulässig
cli-with-cure =
    { $failure }
    { "   " }{ $cure }
cli-range = { $from } bis { $to }
cli-plus = +{ $value }
cli-wrote = geschrieben: { $files }
cli-no-such-axis = diese Achse gibt es nicht
cli-cycle-ended-early = der Thread des Zyklus endete vorzeitig
cli-jobs-unreadable = nicht jeder Auftrag war lesbar
cli-no-notices = die Lizenzen der Pakete Dritter sind nicht in diesem Programm: { $why }
cli-at-least-two = mindestens zwei
cli-standard-input = Standardeingabe

# Progress.
cli-progress-planning = Planung
cli-progress-rows = Zeilen
cli-schedule-done = { $weldable } von { $rows } Zeilen können wie verlangt geschweißt werden; { $kept } wurden nicht neu geplant
cli-progress-draws = Ziehungen
cli-study-done = { $draws } Ziehungen von { $job } auf { $machine }; { $kept } Pläne stammen aus einem früheren Lauf
cli-study-weldable = schweißbar: { $percent } % (95-%-Intervall { $low } bis { $high } %)
cli-study-first-error = erster Fehler: { $error }
cli-progress-pass = Lage { $pass } von { $passes }: { $stage }
cli-progress-simulating = Schweißen in der Simulation
cli-progress-machine = Prüfung der Maschine
cli-progress-tuning = Einstellen der Achsen
cli-progress-cycles = Zyklen
cli-progress-pulses = Impulse
cli-progress-set-points = Sollwerte
cli-progress-teaching = Teachen
cli-progress-faults = Störungen
cli-progress-frames = simulierte Bilder
cli-progress-welds = simulierte Schweißungen

# Labels of the summary of a weld.
cli-label-machine = Maschine
cli-label-seam = Naht
cli-label-speed = Geschwindigkeit
cli-label-time = Zeit
cli-label-energy = Energie
cli-label-clearance = Abstand
cli-label-passes = Lagen
cli-label-pass = Lage { $pass }
cli-label-takes = Verbrauch
cli-label-waits = Warten
cli-label-duty = Brennzeit
cli-label-cost = Kosten
cli-label-transfers = Leerfahrten
cli-label-wrote = geschrieben
cli-label-welded = geschweißt
cli-label-path-error = Bahnabweichung
cli-label-tip-speed = TCP-Geschw.
cli-label-axis = Achse { $axis }

# Summary of a weld.
cli-summary-seam = { $length }, davon geschweißt { $weld }
cli-summary-takes-energy = { $energy } Lichtbogenenergie
cli-summary-takes-wire = { $wire } Draht
cli-summary-takes-metal = { $mass } Schweißgut
cli-summary-takes-gas = { $gas } Schutzgas
cli-summary-takes-flux = { $mass } Pulver
cli-summary-waits = { $time } zwischen den Lagen, bis die Naht abgekühlt ist
cli-summary-duty = { $part } der Zeit, { $duty } der höchsten 10 Minuten
cli-summary-cost = { $total } { $currency }
cli-summary-cost-incomplete = { $total } { $currency }, ohne: { $without }
cli-summary-transfers = { $time }, von Grundstellung zu Grundstellung { $total }
cli-summary-speed = { $from } bis { $to } geplant, { $asked-from } bis { $asked-to } verlangt
cli-summary-time = { $travel } Fahrt, { $arc } mit Lichtbogen, { $total } insgesamt
cli-summary-passes = { $passes }, { $length } insgesamt
cli-summary-clearance = Abstand { $clearance }
cli-summary-arc-energy = Streckenenergie { $energy }
cli-summary-heat-input = Wärmeeinbringung { $heat }
cli-clearance-between = { $distance }: { $first } und { $second }
cli-clearance-none = { $distance }: nichts Überwachtes kommt näher
cli-summary-not-welded = nichts davon (simuliert)
cli-summary-path-error = { $max } maximal, { $rms } RMS (simuliert)
cli-summary-tip-speed = { $from } bis { $to }, RMS-Abweichung { $rms } (simuliert)
cli-summary-too-short = die Schweißung ist zu kurz für ein Urteil
cli-summary-following-error = Schleppfehler { $error }, RMS { $rms }
cli-summary-tracked = { $p99 } von der Fuge auf 99 % der Schweißung, höchstens { $max }; ohne Nachführung { $plain-p99 } und { $plain-max }
cli-summary-untracked = { $p99 } von der Fuge auf 99 % der Schweißung, höchstens { $max }; ohne Nachführung
cli-summary-stopped = angehalten bei { $at }
cli-summary-alarm = bei { $at }: { $alarm }
cli-summary-beam = abgelenkt um bis zu { $deflection } von { $range }, Kanone mitgeführt um { $carried }; Strahl { $away } der Zeit anderswo, höchstens { $longest }
cli-summary-beam-replayed = nachgefahren: { $beam }
cli-summary-beam-fit = { $beam }; 90 % von { $points ->
        [one] { $points } Punkt
       *[other] { $points } Punkten
    } innerhalb { $distance } um die gespeicherten Abweichungen

# Positions along the seam.
cli-no-such-angle = diese Naht hat diesen Winkel nicht
cli-angle-not-welded = dieser Winkel liegt nicht auf dem geschweißten Teil
cli-too-many-points = zu viele Punkte
cli-at-least-step = mindestens { $step }: { $points } Punkte
cli-section-no-joint = der Auftrag hat keine Fuge, also keinen Schnitt
cli-section-joint = ein [joint] mit seiner Vorbereitung

# Lists.
cli-list-machine = Maschine
cli-list-axes = Achsen
cli-list-example = Beispiel
cli-list-procedure = Schweißanweisung
cli-list-process = Verfahren
cli-list-title = Titel
cli-no-machine = { $name }: diese Maschine gibt es nicht
cli-no-example = { $name }: dieses Beispiel gibt es nicht
cli-no-procedure = { $name }: diese Schweißanweisung gibt es nicht

# Lateness of the cycle.
cli-latency-cycles = { $cycles ->
        [one] { $cycles } Zyklus
       *[other] { $cycles } Zyklen
    } von { $period }, { $missed } versäumt
cli-latency-late = { $part } beginnen höchstens { $late } zu spät

# Moves from point to point.
cli-motions-up-to-two-hours = Bewegungen von bis zu zwei Stunden
cli-move-set-points = { $count } Sollwerte
cli-longer-period = bis { $max }, mit einer längeren Periode
cli-move-done = { $time }, { $count ->
        [one] { $count } Sollwert
       *[other] { $count } Sollwerte
    }; { $clearance }
cli-axis-value-of = ACHSE=WERT mit Achse { $axes }
cli-any-number-of = eine beliebige Zahl von { $unit }
cli-axis-twice = Achse { $axis } ist zweimal angegeben
cli-each-axis-once = jede Achse einmal
cli-axis-position-not-a-number = die Position der Achse { $axis } ist keine Zahl
cli-axis-outside = außerhalb des Bereichs der Achse { $axis }
cli-move-no-shapes = keine Kollisionsprüfung: die Maschinendatei hat keine Formen, die sich treffen könnten
cli-move-min-distance = kleinster Abstand { $distance } bei { $time }: { $first } und { $second }
cli-move-clear = nichts kommt näher als { $distance }
cli-move-impossible = die Bewegung ist so nicht möglich: { $findings ->
        [one] { $findings } Befund
       *[other] { $findings } Befunde
    }
cli-move-times = t = { $from } bis { $to }
cli-move-in-parts = das Hindernis in mehreren Bewegungen umfahren

# Part programs.
cli-as-far-as-axes-reach = ein Abstand, den die Achsen erreichen
cli-post-differs = das Teileprogramm weicht vom Plan ab und wird nicht geschrieben:
cli-too-coarse = zu grob
cli-finer-than-decimals = feiner als die sechs Dezimalen der Wörter
cli-no-such-blocks = diese Steuerung hat solche Sätze nicht
cli-interpolations = pvt, spline1, linear bei PMAC; linear, poly bei Sinumerik; linear bei LinuxCNC und grblHAL
cli-too-far = zu weit
cli-up-to-pass-tolerance = bis { $max }, die Toleranz einer Lage
cli-import = { $file }: Programm für { $dialect }, { $moves ->
        [one] { $moves } Bewegung
       *[other] { $moves } Bewegungen
    }, { $time } mit ihren Vorschüben; Lagen: { $passes }
cli-import-left-out = ausgelassen: { $place }: { $words }: { $why }

# Points to lines and arcs, and interpolators.
cli-cure-line-or-column = die Zeile berichtigen, oder eine Spalte, die keine Achse ist, aus der Datei entfernen
cli-cure-line-in-mm = die Zeile berichtigen; Koordinaten sind in mm
cli-cure-line-per-point = je Punkt eine Zeile mit Zahlen, unter der Kopfzeile
cli-too-far-away = zu weit entfernt
cli-points-found = { $points ->
        [one] { $points } Punkt
       *[other] { $points } Punkte
    }
cli-reduced = { $points ->
        [one] { $points } Punkt
       *[other] { $points } Punkte
    }; Geraden: { $lines }, Bögen: { $arcs }; größter Fehler { $error }; kleinste Zahl von Abschnitten: { $min }
cli-not-a-point = kein Punkt
cli-point-form = x,y in mm, wie { $example }
cli-too-many-to-draw = { $method } hat mehr als { $max } Punkte zu zeichnen
cli-coarser-or-no-drawing = ein gröberer Impuls oder eine längere Periode, oder keine Zeichnung

# Edits of a program file.
cli-edit-no-operation = keine Operation ist angegeben, oder mehrere
cli-edit-operations = eine Operation, undo, redo, history oder --script OPS.json; siehe `seamwright edit --help`
cli-edit-new-history = Hinweis: { $file } wurde seit der letzten Bearbeitung von Hand geändert: eine neue Historie beginnt
cli-edit-of-operation = Operation { $number }: { $why }
cli-edit-job = { $file }: das ist ein Auftrag; bearbeitet werden Programme
cli-edit-plan-first = erst planen: seamwright plan { $file }; dann { $program } bearbeiten
cli-edit-by-hand = { $file }: die Datei wurde seit der letzten Bearbeitung von Hand geändert
cli-edit-force = --force, soweit es geht
cli-edit-nothing-to-undo = { $file }: nichts zum Zurücknehmen
cli-edit-nothing-to-redo = { $file }: nichts zum Wiederholen
cli-edit-see-history = siehe `history`
cli-edit-undone = zurückgenommen: { $edit }
cli-edit-redone = wiederholt: { $edit }
cli-edit-unchanged = { $edit } (nichts geändert)
cli-edit-undone-entry = { $edit } (zurückgenommen)
cli-edit-by-hand-since = die Datei wurde seitdem von Hand geändert
cli-edit-none = keine Bearbeitungen
cli-edit-value = eine Zahl, oder zwei für eine Rampe
cli-edit-see-schema = siehe `seamwright schema operation`

# Records of welds.
cli-no-data-folder = es gibt keinen Datenordner
cli-data-folder = --data DIR, oder SEAMWRIGHT_DATA
cli-record-backup = { $file }: { $size } MB
cli-record-restored = { $folder }: wiederhergestellt; prüfen mit `seamwright records verify`
cli-recovered = Schweißung { $weld } ({ $part }): { $rows ->
        [one] { $rows } Zeile
       *[other] { $rows } Zeilen
    } wiederhergestellt, { $result }
cli-recovered-unread = Schweißung { $weld } ({ $part }): { $rows ->
        [one] { $rows } Zeile
       *[other] { $rows } Zeilen
    } wiederhergestellt, { $unread } am Ende nicht gelesen, { $result }
cli-nothing-to-recover = nichts wiederherzustellen
cli-recorded = aufgezeichnet: Schweißung { $weld }
cli-record-weld-note = Hinweis: Schweißung { $weld }: { $note }
cli-record-heading = Schweißung { $weld }: { $title }
cli-label-part = Teil
cli-label-result = Ergebnis
cli-label-begun = begonnen
cli-label-ended = beendet
cli-label-welder = Schweißer
cli-label-procedure = WPS
cli-label-job = Auftrag
cli-label-program = Programm
cli-label-heat-input = Wärmeeinbringung
cli-label-deviation = Abweichung
cli-label-note = Hinweis
cli-label-alarm = Alarm
cli-label-event = Ereignis
cli-label-file = Datei
cli-record-simulated = { $result }, simuliert
cli-record-version = { $name }, Version { $version }
cli-record-heat-input = { $min } bis { $max }, Mittel { $mean }
cli-record-deviation = höchstens { $max }, bei s = { $at }
cli-record-value = { $name } { $from } bis { $to }
cli-record-value-allowed = { $value } ({ $min } bis { $max } erlaubt)
cli-record-value-outside = { $value } ({ $min } bis { $max } erlaubt, { $time } außerhalb)
cli-record-with-cause = { $alarm }: { $cause }
cli-record-at = { $alarm } bei s = { $at }
cli-record-file = { $file }, { $size }, SHA-256 { $hash }
cli-record-table = { $file }, { $size }, { $rows ->
        [one] { $rows } Zeile
       *[other] { $rows } Zeilen
    }, SHA-256 { $hash }
cli-verified = { $welds ->
        [one] { $welds } Schweißung
       *[other] { $welds } Schweißungen
    }, { $files ->
        [one] { $files } Datei
       *[other] { $files } Dateien
    } wie aufgezeichnet, { $entries ->
        [one] { $entries } Protokolleintrag
       *[other] { $entries } Protokolleinträge
    }: in Ordnung
cli-verified-problems = { $welds ->
        [one] { $welds } Schweißung
       *[other] { $welds } Schweißungen
    }, { $files ->
        [one] { $files } Datei
       *[other] { $files } Dateien
    } wie aufgezeichnet, { $entries ->
        [one] { $entries } Protokolleintrag
       *[other] { $entries } Protokolleinträge
    }: nicht in Ordnung
cli-problem = Problem: { $problem }

# Position of the work in the machine.
cli-place-more-points = mehr Punkte, über die angetasteten Elemente verteilt, oder eine andere --method
cli-place-side-unknown = die Seite, auf der der Taster einen einzelnen Punkt berührte, ist nicht bekannt
cli-place-radius-with-three-points = 0 bei three-point, oder eine andere --method
cli-place-undetermined = die Punkte bestimmen die Lage des Teils nicht
cli-place-no-seam = das Programm hat keine Naht, deren Flächen angetastet sein könnten
cli-place-no-nozzle = die Naht hat keinen Stutzen, also keinen Rundlauffehler
cli-place-nozzle = [seam.nozzle], oder eine andere --method
cli-place-no-redundancy = es gibt nicht mehr Punkte als Unbekannte: ein schlechter fiele nicht auf
cli-place-radius-unknown = die Punkte bestimmen den Radius nicht: der Nennradius wird verwendet
cli-place-radius-off = der Radius weicht um { $deviation } vom Nennradius ab: Rohr und Taster prüfen
cli-place-no-rotary-axis = die Maschine hat keine Drehachse um die Nennachse des Stutzens: der Rundlauffehler bezieht sich auf die Nennachse
cli-place-unchangeable = { $file }: lässt sich nicht ändern: { $why }
cli-place-touch-again = ein Residuum ist größer als { $max }: die Punkte erneut antasten; die Seiten zeigen, welcher falsch ist. Ist das Teil nicht besser, mit --largest-mm mehr zulassen
cli-place-touch-again-round = ein Residuum ist größer als { $max }: die Punkte mit den größten Residuen erneut antasten und prüfen, ob das Rohr rund ist. Ist das Teil nicht besser, mit --largest-mm mehr zulassen
cli-place-touch-again-features = ein Residuum ist größer als { $max }: die Punkte mit den größten Residuen erneut antasten; ihre Elemente, den Tasterradius und die ungefähre Lage des Teils im Auftrag prüfen. Ist das Teil nicht besser, mit --largest-mm mehr zulassen
cli-label-method = Verfahren
cli-label-offset = Versatz
cli-label-residuals = Residuen
cli-label-sides = Seiten
cli-label-run-out = Rundlauffehler
cli-label-tilt = Neigung
cli-label-uncertainty = Unsicherheit
cli-label-free = unbestimmt
cli-label-warning = Warnung
cli-place-method = { $method }, { $points ->
        [one] { $points } Punkt
       *[other] { $points } Punkte
    }
cli-place-offset = { $name }: { $offset }
cli-place-residuals = { $rms } RMS, größtes { $max }
cli-place-sides = 1-2 { $first }, 2-3 { $second }, 3-1 { $third } länger als nominal
cli-place-run-out = { $eccentricity } { $vector } bei { $at } mm
cli-place-run-out-radius = { $run-out }, Radius { $deviation }
cli-place-tilt = { $angle } in Richtung { $direction }
cli-place-uncertainty = { $xyz } mm, { $turn } Grad um x, y, z bei { $at } mm
cli-place-free = { $motion }: bleibt wie im Auftrag
cli-place-moved = verschoben { $vector } mm
cli-place-turned = gedreht { $angle } um { $axis }, dann verschoben { $vector } mm
cli-place-column-line = Zeile
cli-place-column-feature = Element
cli-place-column-residual = Residuum, mm
cli-place-outlier = Ausreißer
cli-place-not-accepted = nicht angenommen: { $cure }
cli-place-for-job = # für die Auftragsdatei, `offset` an ihren Anfang
cli-at-line = { $file }:{ $line }: { $fault }
cli-no-column = in `{ $header }` gibt es keine Spalte `{ $column }`
cli-touched-header = eine Kopfzeile mit { $columns }, oder den Achsen der Maschine { $axes }
cli-touched-feature-column = eine Spalte feature mit { $features }
cli-touched-nominal-columns = Spalten { $columns } mit der Nennposition jedes Punkts im Koordinatensystem des Teils
cli-touched-unknown-feature = feature = `{ $feature }` ist diesem Verfahren nicht bekannt
cli-touched-not-a-number = { $column } = `{ $value }` ist keine Zahl, die hier passt
cli-finite-up-to = eine endliche Zahl bis { $max }

# Tuning of the axes.
cli-tune-heading = Einstellung von { $machine }: offener Kreis jedes Lageregelkreises, gemessen in Fahrt der Achse
cli-tune-axis = Achse
cli-tune-velocity-loop = Drehzahlregler
cli-tune-notches = Sperrfilter
cli-tune-resonance = Resonanz
cli-tune-crossover = Durchtritt
cli-tune-bandwidth = Bandbreite
cli-tune-gain-margin = Amplitudenres.
cli-tune-phase-margin = Phasenres.
cli-tune-following = Schleppfehler
cli-tune-load = Last
cli-tune-counts = Inkremente
cli-label-not-tuned = nicht eingestellt
cli-label-assumed = angenommen
cli-tune-refused = { $axis }: { $why }
cli-tune-assumed = { $axis }: die Maschinendatei beschreibt keinen Antrieb
cli-tune-bode = Lageregelkreis der Achse { $axis }, gemessen bei { $speed }

# Registers of devices, kinematics.
cli-io-no-device = die Maschine `{ $machine }` hat kein Gerät mit Registern
cli-io-machine = eine Maschinendatei mit [devices.NAME.modbus]
cli-no-such-head = diesen Kopf gibt es nicht
cli-pose-out-of-reach = keine Achspositionen erreichen die Pose

# The joint in images.
cli-image-whole-file = eine vollständige PNG-, JPEG- oder PNM-Datei
cli-image-size = { $width } x { $height } Pixel
cli-image-at-least = mindestens { $min } Pixel je Seite
cli-image-saturated = das Bild ist übersteuert, ganz weiß
cli-image-exposure = eine Belichtung, bei der das Metall grau bleibt: weniger Licht, Zeit oder Verstärkung
cli-finite-numbers = { $n ->
        [one] { $n } endliche Zahl
       *[other] { $n } endliche Zahlen
    }, durch Kommas getrennt
cli-joint-zone = links < rechts innerhalb 0 bis { $right }, oben < unten innerhalb 0 bis { $bottom }
cli-outside-zone = außerhalb des Suchbereichs
cli-outside-image = außerhalb des Bildes
cli-joint-start = x von { $left } bis { $right }, y von { $top } bis { $bottom }
cli-joint-none-at-start = keine Fuge am Start: ein anderes --start, --direction-deg oder --width-px versuchen
cli-stripe-neither = weder ein Bild noch Text
cli-stripe-formats = PNG, JPEG oder PNM, oder CSV mit den Spalten y_mm,z_mm
cli-not-a-position = keine Position
cli-stripe-position = eine Zahl innerhalb 1e7 mm um 0, oder nichts, wo sie fehlt
cli-stripe-profile-in-mm = ein Profil ist schon in mm
cli-stripe-image-options = --machine, --mm-per-px und --overlay mit einem Bild
cli-stripe-sensor-size = { $width } x { $height }, wie der Sensor
cli-stripe-no-sensors = die Maschine hat keine: [sensors.NAME]
cli-stripe-no-such-sensor = { $machine } hat diesen Sensor nicht
cli-stripe-sees-none = dieser Sensor sieht keine Linie
cli-stripe-kind = ein Sensor mit kind = "stripe"
cli-stripe-hint = Tipp: auf dem Kopf ist die Fuge da: das Bild um 180 Grad drehen oder spiegeln, sodass oben von den Blechen weg zeigt
cli-scan-at = bei s = { $s }: { $why }
cli-scan-no-profile = kein Profil
cli-scan-kind = Profile zeigen die Maße dieser Fuge nicht
cli-scan-needs-scale = ein Bild braucht eine Abbildung von Pixeln auf mm
cli-scan-scales = --machine und --sensor, oder --mm-per-px
cli-scan-mirrored = die Profile zeigen die Fuge seitenverkehrt
cli-scan-with-mirrored = mit --mirrored
cli-scan-without-mirrored = ohne --mirrored
cli-scan-same-position = eine andere Zeile hat diese Position
cli-scan-one-profile = ein Profil je Position
cli-scan-beside-seam = die Position liegt { $distance } neben der Naht
cli-scan-not-measured = kein Profil zeigt die Fuge von s = { $from } bis { $to }: mehr als { $bridge }
cli-stripe-no-joint = keine Fuge: { $why }
cli-stripe-unsure = die Konfidenz { $confidence } liegt unter { $min }, daher ist der Fuge nicht zu folgen
cli-stripe-unsure-because = die Konfidenz { $confidence } liegt unter { $min }, daher ist der Fuge nicht zu folgen: { $why }

# Step and direction pulses.
cli-pulses-not-vcd = kein Value Change Dump
cli-pulses-vcd = ein Name, der auf .vcd endet
cli-pulses-no-stepper = keine Achse von { $machine } hat einen Schrittmotor
cli-pulses-machine = eine Maschine mit [drives.<axis>.stepper] in ihrer Datei, wie torch-5axis
cli-pulses-ticks = eine Periode von { $period } ist { $ticks } Takte von { $tick }
cli-pulses-whole-ticks = eine ganze Zahl von Takten, bis 1e11; siehe --period-ms und --tick-ns
cli-pulses-lost-steps = der Motor der Achse { $axis } verliert { $steps ->
        [one] { $steps } Vollschritt
       *[other] { $steps } Vollschritte
    }, ab t = { $time }
cli-cure-lost-steps = eine kleinere Geschwindigkeit oder Beschleunigung, oder ein Motor mit mehr Drehmoment
cli-pulses-too-fast = { $asked } Impulse in der Sekunde sind bei { $microsteps ->
        [one] { $microsteps } Mikroschritt
       *[other] { $microsteps } Mikroschritten
    } nötig, { $max } ist das Maximum
cli-cure-pulses-too-fast = eine kleinere Geschwindigkeit, weniger `microsteps` oder ein größeres `max_pulse_hz` des Treibers, oder ein feineres --tick-ns
cli-cure-pulses-crowded = ein längeres --period-ms, eine kleinere Beschleunigung oder Geschwindigkeit
cli-cure-fewer-microsteps = weniger Mikroschritte
cli-pulses-crowded = Achse { $axis } bei t = { $time }: { $fault }
cli-pulses-crowded-in-transfer = Achse { $axis } bei t = { $time }, in einer Leerfahrt: { $fault }
cli-pulses-bound-frequency = mehr bräuchten über { $max } Impulse in der Sekunde
cli-pulses-bound-driver = der Treiber hat keine feinere Einstellung
cli-pulses-bound-none = selbst diese sind zu schnell
cli-pulses-resolution = Achse { $axis } fährt { $resolution } je Impuls mit { $microsteps ->
        [one] { $microsteps } Mikroschritt
       *[other] { $microsteps } Mikroschritten
    }, gewünscht { $wanted }: { $why }
cli-pulses-note = Hinweis (Auflösung): { $note }
cli-pulses-by-resolution = Auflösung
cli-pulses-by-frequency = Frequenz
cli-pulses-by-driver = Treiber
cli-pulses-axis = { $axis }: { $microsteps } Mikroschritte nach { $bound }, { $resolution } je Impuls ({ $wanted } gewünscht), { $pulses } Impulse von { $start } bis { $end } Schritten, bis { $highest } von { $max }
cli-pulses-axis-loses = { $axis }, Motor verliert { $steps ->
        [one] { $steps } Vollschritt
       *[other] { $steps } Vollschritte
    }
cli-pulses-heading = { $job }: { $time } in Perioden von { $period }, Takte von { $tick }
cli-pulses-without-stepper = ohne Schrittmotor, also ohne Impulse: { $axes }

# Set-points under an operator's commands.
cli-command-time = eine Zahl von Sekunden von { $from } bis { $to }: die Zeilen sind nach der Zeit geordnet
cli-not-a-command = kein Befehl
cli-command-value = passt nicht zu { $command }
cli-command-without-speed = kann bei einem Override von 0 nicht weitergehen
cli-command-override-first = davor ein Override von mindestens { $min }
cli-command-percent = 0 bis 150 Prozent
cli-command-step = eine endliche Zahl von mm, mindestens 0,001
cli-command-nothing = nichts
cli-motion-coarse = { $parts } Perioden von { $period }
cli-motion-whole-multiple = ein ganzes Vielfaches der Periode, bis 1e6-fach
cli-motion-period-with-commands = mit --commands nicht zulässig
cli-motion-held = Hinweis (angehalten): Lage { $pass } wartet bei s = { $at }, und kein Befehl ist übrig
cli-cure-commands-or-speed = die Befehle oder die Geschwindigkeit des Auftrags ändern

# Points followed at constant speed.
cli-follow-too-few = weniger als zwei verschiedene Punkte
cli-follow-done = { $time }, { $way }, höchstens { $speed }
cli-follow-slower = die verlangten { $speed } werden nie erreicht: die Grenzen der Achsen oder die Länge des Wegs lassen es nicht zu
cli-follow-stops = { $stops ->
        [one] { $stops } Halt
       *[other] { $stops } Halte
    } zum Vorausplanen: ein längeres --window-s vermiede sie
cli-no-length = hat keine Länge
cli-direction = eine Richtung
cli-follow-too-near = { $first } kommt { $second } zu nahe
cli-follow-something-too-near = etwas kommt zu nahe
cli-follow-point = der Punkt in Zeile { $line }: { $why }
cli-cure-follow = die Punkte, die Lage des Werkstücks oder die Maschine ändern; die Bewegung endet vor diesem Punkt

# A running cell.
cli-run-rights = Hinweis: der Zyklus läuft ohne Echtzeitrechte: { $footing }
cli-run-missed = Hinweis: { $missed } von { $cycles ->
        [one] { $cycles } Zyklus
       *[other] { $cycles } Zyklen
    } zu { $period } wurden versäumt: der schlimmste begann { $late } zu spät
cli-run-missed-cure = besser: ein längeres servo_period_ms, oder weniger, was nebenher läuft; `seamwright machine latency` misst es
cli-run-nothing-left = es bleibt nichts zu schweißen
cli-run-passes-up-to = Lagen 1 bis { $passes }
cli-run-up-to-in-pass = bis { $length } in dieser Lage
cli-run-outputs-unsafe = Gerät `{ $device }`: seine Ausgänge sind nicht als sicher bestätigt: { $why }
cli-run-not-asked = es wurde nicht gefragt
cli-run-look-at-once = sofort prüfen, ob Lichtbogen und Gas aus sind
cli-two-lines =
    { $first }
    { "   " }{ $second }
cli-run-hangs = beendet durch { $cause }, aber der Zyklus endet nicht innerhalb { $time }: prüfen, dass Lichtbogen, Gas und Antriebe aus sind
cli-run-record-later = die Aufzeichnung vervollständigt das nächste `seamwright records recover`
cli-run-state = Betriebsart { $mode }, Lage { $pass }, s { $s }, Eingänge { $inputs }
cli-run-cleared = { $alarm } steht nicht mehr an
cli-run-refused = { $order }: { $why }
cli-run-alarm = { $alarm }: { $reaction }; { $action }
cli-run-alarm-at = { $alarm } bei { $at }: { $reaction }; { $action }
cli-run-alarm-action = { $alarm }: { $action }
cli-run-stopped-by = das Programm wurde angehalten durch { $cause }; alles ist aus
cli-run-stopped-by-alarm = das Programm wurde durch einen Alarm angehalten: { $alarm }
cli-run-trace-lost = die Aufzeichnung lässt sich nicht schreiben
cli-fault-never-came = Hinweis: { $fault } trat nie ein: alles war bei { $time } vorbei
cli-order-number = `{ $word }` in `{ $line }`; erlaubt ist eine Zahl von { $min } bis { $max }
cli-order-mode = die Betriebsart `{ $mode }` gibt es nicht; erlaubt sind { $modes }, N s, N mm
cli-order-unknown = `{ $line }` ist kein Befehl; erlaubt sind { $orders }, override PERCENT, wait MODE, wait N s, wait N mm, ?

# Teaching by camera.
cli-teach-frames = ein Ordner, tcp://HOST:PORT, simulated
cli-teach-source = entweder --frames oder --semi-manual
cli-teach-not-here = hier nicht zulässig
cli-teach-only-with = nur mit { $source }
cli-teach-new-frames = Bildern, die nicht schon in einem Ordner sind
cli-teach-beside = das ist der Name einer Datei neben dem Programm
cli-teach-file = eine Datei, wie taught.toml
cli-teach-camera-machine = eine Maschine mit einer Kamera: [sensors.<name>] mit kind = "camera" in ihrer Datei
cli-teach-no-such-camera = { $machine } hat diese Kamera nicht
cli-teach-no-camera = { $machine } hat keine Kamera
cli-teach-several-cameras = { $machine } hat mehrere Kameras: eine mit --sensor wählen
cli-teach-numbers = { $n ->
        [one] { $n } Zahl
       *[other] { $n } Zahlen
    }
cli-teach-three-numbers = drei, X,Y,Z
cli-teach-start-off-seam = der Start { $start } liegt nicht bei der Nennnaht
cli-teach-start-near = --start innerhalb 15 mm davon, im Werkstück-Koordinatensystem der Maschine
cli-direction-without-length = die Richtung hat keine Länge
cli-three-finite-numbers = drei endliche Zahlen, die nicht alle 0 sind
cli-teach-answers = X,Y,Z (mm, Werkstück-Koordinaten) oder X,Y,Z,DX,DY,DZ, um dort, in dieser Richtung, weiterzugehen; end: die Fuge endet hier; stop: aufgeben
cli-teach-lost = verloren nach { $way }, bei { $point }: { $why }
cli-teach-seen = letztes Bild: { $file }
cli-teach-bad-answer = weder drei oder sechs Zahlen noch end oder stop
cli-teach-point-off-seam = der Punkt liegt nicht innerhalb 15 mm der Nennnaht
cli-teach-by-points = die Nennnaht, an die Punkte des Bedieners gelegt
cli-teach-done = { $ended } nach { $way }, { $frames ->
        [one] { $frames } Bild
       *[other] { $frames } Bilder
    } in { $time }; { $points ->
        [one] { $points } Punkt
       *[other] { $points } Punkte
    }
cli-teach-closes = schließt sich auf { $gap }
cli-teach-asked = gefragt: { $why }
cli-teach-spline = ein Spline aus { $pieces ->
        [one] { $pieces } Stück
       *[other] { $pieces } Stücken
    }
cli-teach-lines-and-arcs = { $lines ->
        [one] { $lines } Gerade
       *[other] { $lines } Geraden
    } und { $arcs ->
        [one] { $arcs } Bogen
       *[other] { $arcs } Bögen
    }
cli-teach-program = Programm: { $curves } innerhalb { $error } um die geteachte Linie
cli-teach-program-of-raw = Programm: { $curves } innerhalb { $error } um die geteachte Linie, { $raw } um jeden Rohpunkt
cli-teach-truth = tatsächlich { $across } RMS neben der Naht, höchstens { $across-max }; { $height } RMS darüber oder darunter, höchstens { $height-max }
cli-teach-no-address = keine Adresse
cli-teach-address = tcp://HOST:PORT, ein Port von 1 bis 65535
cli-teach-no-frames = keine Bilder
cli-teach-not-a-camera = der Sensor { $sensor } ist keine Kamera
cli-teach-not-three-numbers = nicht drei Zahlen
cli-teach-distortion = SHIFT,TURN,BEND in mm, Grad, mm
cli-teach-shift = Verschiebung { $value }
cli-teach-turn = Drehung { $value }
cli-teach-bend = Biegung { $value }
cli-teach-tack = FROM,TO in mm entlang der Naht, FROM vor TO

# The server.
cli-serve-data = --data { $folder }: lässt sich nicht anlegen: { $why }
cli-serve-no-job = diesen Auftrag gibt es nicht
cli-serve-jobs = eine Datei, ein Auftrag in { $folder }, oder ein Beispiel: { $examples }
cli-serve-other-job = der Datenordner hat einen anderen Auftrag dieses Namens
cli-serve-other-name = eine Datei anderen Namens, oder --job { $name } von dort
cli-serve-no-token = in der Datei steht kein Token
cli-serve-tokens = eine Zeile mit mindestens { $min } Buchstaben, Ziffern und Zeichen

# Acceptance benchmarks.
cli-bench-not-shipped = die Maschine { $machine } wird nicht mitgeliefert
cli-bench-half-ring = der Halbring lässt sich nicht planen

# Drawings.
cli-draw-points-as-spans = Punkte als Geraden und Bögen
cli-draw-seen-along = Gesehen entlang { $axis }
cli-draw-points = Punkte
cli-draw-lines = Geraden
cli-draw-arcs = Bögen
cli-draw-ends = Enden
cli-draw-spline = Spline
cli-draw-taught-line = Die geteachte Linie
cli-draw-from-nominal = Von der Nennnaht
cli-draw-distance = Abstand
cli-draw-across = quer
cli-draw-above = darüber
cli-draw-tolerance = Toleranz
cli-draw-raw-from-program = Rohpunkte vom Programm
cli-draw-raw-points = Rohpunkte
cli-draw-frame-against-frame = Bild gegen Bild
cli-draw-overlap = Überlappung
cli-draw-confidence-title = Konfidenz
cli-draw-confidence = Konfidenz
cli-draw-interpolation = Interpolationsverfahren nebeneinander
cli-draw-true-curve = wahre Kurve
cli-draw-paths = Bahnen, gesehen entlang z
cli-draw-close = Impuls für Impuls, um die Mitte der Bahn
cli-draw-steps = Gerade Strecke je Periode, gegen Geschwindigkeit x Periode
cli-draw-angle = zurückgelegter Winkel
cli-draw-deviation = Abweichung
cli-draw-max-distance = Größter Abstand der Punkte von der wahren Kurve

# Results of recorded welds.
cli-result-running = läuft
cli-result-good = gut
cli-result-deviating = abweichend
cli-result-stopped = angehalten
cli-result-interrupted = unterbrochen

# Units in the table of tuning.
cli-tune-hz = Hz
cli-tune-per-s = 1/s
cli-tune-ms = ms
cli-tune-db = dB
cli-stopped = gestoppt in Zyklus { $cycle }
cli-no-cell-runs = dort läuft keine Zelle
cli-data-of-running-cell = der Datenordner eines laufenden Panels
cli-stop-unanswered = der Stopp ist nicht bestätigt: { $why }

# Machine files of arms.
cli-arm-note = Hinweis: { $note }
cli-arm-next = prüfen: seamwright machine check { $file }
cli-arm-home = die Grundstellung von Achse `{ $axis }` liegt außerhalb ihres Bereichs
cli-no-configurations = die Maschine ist kein Arm, dessen Konfigurationen Namen haben
cli-no-arm-angle = die Maschine ist kein Arm mit sieben Achsen
# Roboterprogramme.
cli-not-for-robots = nicht für Roboter
cli-options-of-robots = --tolerance-mm, --speed-percent, --retract-mm
cli-servo-not-here = nur URScript hat einen Strom von Sollwerten
cli-servo-language = zusammen mit --dialect urscript
cli-servo-alone = die Option gehört zu einem Strom von Sollwerten, und --servo-ms fehlt
cli-servo-with-period = zusammen mit --servo-ms
cli-servo-period = { $step } bis { $max } in Schritten von { $step }

# Search for placements of the work.
cli-progress-reach = Suche nach Aufstellungen
cli-label-judged = geprüft
cli-label-budget = Zeitrahmen
cli-label-present = jetzt
cli-label-best = beste
cli-label-entry = Eintrag
cli-reach-judged = Aufstellungen: { $placements }, schweißbar: { $weldable }
cli-reach-cut-off = { $budget } beendeten die Suche: --budget gibt ihr mehr
cli-reach-interrupted = Strg-C beendete die Suche: das Ergebnis ist die bisher beste Aufstellung
cli-label-moved = verschoben
cli-reach-moves-work = das Werkstück, im Werkstückkoordinatensystem
cli-reach-moves-base = die Maschinenbasis, in ihrem eigenen Koordinatensystem
cli-reach-base-entry = { $file }: { $key } = { $entry }
cli-reach-supplied = die Maschine gehört zum Programm, und es gibt keine Datei zum Schreiben
cli-reach-own-machine = eine Maschinendatei; `seamwright machine show { $name } > machines/{ $name }.toml` neben dem Auftrag erzeugt eine
cli-reach-at = x { $x }, y { $y }, z { $z } von der jetzigen Aufstellung, gedreht { $turn }
cli-reach-margin = Achse { $axis } behält { $margin } ihres Bereichs frei (Lage { $pass }, s = { $s })
cli-reach-free = schweißbar; keine Achse hat einen Bereich
cli-reach-fails = nicht schweißbar bei Lage { $pass }, s = { $s }: { $reason }
cli-reach-not-planned = { $placement }: der Planer lehnt sie ab: { $reason }
cli-reach-none = keine Aufstellung ist schweißbar und geplant
cli-reach-entry = { $key }: move_mm = { $vector }, Winkel { $angle }
cli-reach-form = VON,BIS oder VON,BIS,ZELLEN mit VON bis BIS und 1 oder mehr Zellen, etwa -300,300,9
cli-reach-ends = Enden von { $min } bis { $max }
cli-reach-reversed = der Bereich beginnt über seinem Ende
cli-reach-too-many-cells = das Gitter hat { $cells } Plätze
cli-reach-cells-allowed = insgesamt bis zu { $max } Plätze
cli-reach-no-file = es gibt keine solche Datei zum Schreiben
cli-reach-job-file = eine Auftrags- oder Programmdatei; `seamwright examples NAME > job.toml` erzeugt eine
cli-reach-changed = { $file } wurde während der Suche geändert: nichts wurde geschrieben
cli-label-planned = geplant
cli-reach-planned = Achse { $axis } behält im Plan { $margin } ihres Bereichs frei
cli-allowed-spark = eine Adresse von Spark Connect, etwa sc://host:15002
