# Numbered parts of a page, results and findings.
report-table = Tabelle { $number }.
report-figure = Bild { $number }.
report-in-order = In Ordnung
report-not-in-order = Nicht in Ordnung
report-severity-note = Hinweis
report-severity-warning = Warnung
report-severity-error = Fehler
report-finding-place = Wo: { $place }
report-finding-cure = Abhilfe: { $cure }
report-no-findings = Keine Befunde.
report-heading-notes = Hinweise
report-heading-findings = Befunde
report-more-places = { $n ->
        [one] 1 weitere Stelle
       *[other] { $n } weitere Stellen
    }

# Places, ranges and pairs of values.
report-range = { $from } bis { $to }
report-at = s = { $s }
report-at-range = s = { $from } bis { $to }
report-pass-at = Lage { $pass }, { $place }
report-passes-at = Lagen { $first } bis { $last }, { $place }
report-pair = { $first } und { $second }
report-pass-named = Lage { $pass }: { $name }
report-curve-of-head = { $curve }, Kopf { $head }
report-part-of = { $value } von { $whole }
report-more-than = mehr als { $value }

# Charts.
report-no-data = keine Daten
report-limit-above = { $limit }, darüber
report-limit-below = { $limit }, darunter
report-limit-outside = { $limit }, außen
report-limit = Grenze
report-limit-at-least = mindestens
report-limit-at-most = höchstens
report-limit-min = kleinste
report-limit-max = größte
report-label-path-length = Weglänge s
report-label-distance = Abstand
report-label-angle = Winkel
report-label-heat-input = Wärmeeinbringung
report-label-speed = Geschwindigkeit
report-label-acceleration = Beschleunigung
report-label-jerk = Ruck
report-label-position = Position
report-label-curvature = Krümmung
report-label-deviation = Abweichung
report-label-path-error = Bahnfehler
report-label-following-error = Schleppfehler
report-label-attitude-error = Stellungsfehler
report-label-along-seam = entlang der Naht
report-label-across = quer
report-label-torch-tip = Brennerspitze

# Names of views.
report-view-front = Vorn
report-view-side = Seite, von links
report-view-top = Oben
report-view-pictorial = Räumlich, nicht maßstäblich
report-seen-from-above = von oben gesehen
report-seen-from-below = von unten gesehen
report-seen-from-plus-x = von +x gesehen
report-seen-from-minus-x = von -x gesehen
report-seen-from-plus-y = von +y gesehen
report-seen-from-minus-y = von -y gesehen

# Columns of tables.
report-column-value = Größe
report-column-min = Kleinster
report-column-mean = Mittel
report-column-max = Größter
report-column-allowed = Zulässig
report-column-outside-s = Außerhalb, s
report-column-outside-mm = Außerhalb, mm
report-column-pass = Lage
report-column-name = Name
report-column-date = Datum
report-column-signature = Unterschrift
report-column-alarm = Alarm
report-column-priority = Priorität
report-column-cause = Ursache
report-column-position-mm = s, mm
report-column-time-s = t, s
report-column-first-out = Erstmeldung
report-column-acknowledged = Quittiert
report-column-time = Zeit
report-column-event = Ereignis
report-column-text = Text
report-column-version = Version
report-column-file = Datei
report-column-rows = Zeilen
report-column-bytes = Bytes
report-column-transfer-before-s = Leerfahrt davor, s
report-column-start-s = Beginnt bei, s
report-column-travel-s = Fahrt, s
report-column-arc-on-s = Lichtbogen an, s
report-column-total-s = Insgesamt, s
report-column-speed-mm-s = Geschwindigkeit, mm/s
report-column-stick-out = Freies Drahtende, mm
report-column-arc-energy = Streckenenergie, kJ/mm
report-column-heat-input = Wärmeeinbringung, kJ/mm
report-column-length-mm = Länge, mm
report-column-wire-m = Draht, m
report-column-bead = Raupe im Schnitt
report-column-toe-deg = Nahtübergangswinkel, °
report-column-weld-metal-kg = Schweißgut, kg
report-column-wait-before-s = Warten davor, s
report-column-group = Gruppe (ISO/TR 15608)
report-column-thickness = Dicke, mm
report-column-ce = CE (IIW), %
report-column-cet = CET, %
report-column-pcm = Pcm, %
report-column-preheat = Vorwärmung nach EN 1011-2, °C
report-column-work = Werkstück vor der Lage, °C
report-column-t85 = t8/5, s
report-column-heat-flow = Wärmeableitung
report-column-at-requested-speed = Mit verlangter Geschwindigkeit, %
report-column-attitude-error = Stellungsfehler, °
report-column-clearance = Kleinster Abstand, mm
report-column-between = zwischen
report-column-path-error-mm = Bahnfehler, mm
report-column-rms-mm = Effektivwert, mm
report-column-rms = Effektivwert
report-column-speed-ripple = Geschwindigkeitswelligkeit, %
report-column-position = Position
report-column-from = Von
report-column-to = Bis
report-column-slope = Neigung
report-column-rotation = Drehung
report-column-section = Abschnitt
report-column-min-speed = Kleinste Geschwindigkeit
report-column-max-speed = Größte Geschwindigkeit
report-column-binding = Was begrenzt
report-column-head = Kopf
report-column-untracked = ohne Verfolgung, 99 % (mm)
report-column-tracked = mit Verfolgung, 99 % (mm)
report-column-correction-used = von der erlaubten Korrektur
report-column-stopped-at = gestoppt bei (mm)
report-column-corrected-by = korrigiert nach
report-column-deflected = abgelenkt um bis zu (mm)
report-column-gun-carried = Kanone geführt um bis zu (mm)
report-column-away = abseits der Naht (% der Zeit)
report-column-longest = längste (ms)
report-column-stored-within = neun von zehn Punkten von den gespeicherten Abweichungen (mm)
report-column-peak-load = Spitzenlast, %
report-column-axis = Achse
report-column-unit = Einheit
report-column-range = Bereich
report-column-of = von
report-column-speed-used = Geschwindigkeit, %
report-column-acceleration-used = Beschleunigung, %
report-column-jerk-used = Ruck, %
report-column-tip-mm = Spitze, mm
report-column-linear-axis = Linearachse
report-column-rotary-axis = Drehachse
report-column-tip-speed = Geschwindigkeit der Spitze
report-column-process-value = Prozesswert

# Title blocks of pages.
report-subtitle-plan = Schweißbericht: Plan
report-subtitle-simulation = Schweißbericht: Plan und Simulation
report-subtitle-record = Schweißprotokoll { $id }
report-subtitle-record-simulated = Schweißprotokoll { $id }, simuliert: es wurde kein Metall geschweißt
report-meta-part = Werkstück
report-meta-welder = Schweißer
report-meta-machine = Maschine
report-meta-procedure = Schweißanweisung
report-meta-started = Begonnen
report-meta-ended = Beendet
report-not-yet = noch nicht
report-none = keine
report-meta-page-made = Seite erstellt
report-meta-made-by = Erstellt mit

# Headings.
report-heading-values = Schweißanweisung und Istwerte
report-heading-deviations = Abweichungen
report-heading-alarms = Alarme
report-heading-events = Ereignisse
report-heading-record = Protokoll
report-heading-procedure = Schweißanweisung
report-heading-program = Programm
report-heading-signatures = Unterschriften
report-heading-errors = Fehler
report-heading-map = Schweißplan und Zeitplan
report-heading-process = Prozess entlang der Naht
report-heading-materials = Werkstoffe, Vorwärmung und Abkühlung
report-heading-cut = Rohrschnitt
report-heading-source = Text des Auftrags
report-heading-passes = Lagen
report-heading-checks = Prüfungen
report-heading-curves = Anhang: Kurven
report-heading-seam = Naht und Brenner
report-heading-joint = Fuge
report-heading-taught = Geteachte Abschnitte
report-heading-tracking = Nahtverfolgung
report-heading-simulated = Simulierte Schweißung
report-heading-axes = Achsen
report-heading-programs = Teileprogramme
report-heading-job = Anfang und Ende der Lagen
report-heading-released = Freigegeben
report-heading-pass-curves = Lage { $pass } ({ $name }): Kurven

# Record of a weld: result.
report-result-good = Bis zum Ende geschweißt, innerhalb der Toleranz.
report-result-deviating = Bis zum Ende geschweißt, aber nicht durchweg wie verlangt.
report-result-stopped = Vor dem Ende gestoppt.
report-result-interrupted = Unterbrochen: Programm oder Stromversorgung fiel aus.
report-result-running = Nicht beendet: die Schweißung läuft, oder das Programm ist abgestürzt.
report-windows-without-procedure = Es gibt keine Schweißanweisung zum Vergleich.
report-windows-within = Alle Werte innerhalb der Bereiche der Schweißanweisung.
report-windows-outside = Außerhalb der Bereiche der Schweißanweisung: { $values }.
report-value-outside-at = { $value } in Lage { $pass }, s = { $from } bis { $to }
report-value-outside = { $value } in Lage { $pass }
report-record-note = Bemerkung: { $note }.
report-tile-arc-on = Lichtbogenbrennzeit
report-tile-deviation = Abweichung
report-tile-mean = Mittel; { $from } bis { $to }
report-tile-max-at = größte, bei s = { $s }

# Record of a weld: tables.
report-caption-by-hand = Von Hand auszufüllen
report-inspector = Prüfer
report-welding-engineer = Schweißingenieur
report-caption-actual-values = Istwerte während der Fahrt des Brenners, ohne Halte, Anfänge und Enden, verglichen mit den Bereichen der Schweißanweisung
report-no-values = Keine Werte aufgezeichnet.
report-not-limited = nicht begrenzt
report-outside = außerhalb
report-within = innerhalb
report-allowed = zulässig
report-no-alarms = Keine Alarme.
report-caption-alarms = Alarme in der Reihenfolge, in der sie kamen
report-first-out = erste
report-no = nein
report-caption-events = Ereignisse in der Reihenfolge, in der sie kamen
report-caption-sources = Texte dieser Schweißung, in der Bibliothek aufbewahrt; SHA-256 des Programms { $sha256 }
report-caption-files = Dateien des Protokolls

# Record of a weld: charts.
report-heat-input-unknown = Unbekannt: ohne Schweißanweisung ist die Leistung nicht bestimmt.
report-chart-heat-input = Wärmeeinbringung entlang der Naht
report-caption-heat-input-bins = Energie je Weg der Brennerspitze, auf je { $bin }.
report-chart-tip-off-path = Abweichung der Brennerspitze von der geplanten Bahn
report-caption-tip-off-path = Abstand der tatsächlichen Brennerspitze von der Naht, senkrecht zu ihr, auf je { $bin } der größte Wert.
report-chart-weld-off-joint = Abweichung der Naht von der Fuge
report-caption-weld-off-joint = Abweichung der Naht von der Fuge, seitlich und in der Höhe, auf je { $bin } der größte Wert.
report-curves-shown = { $shown } von { $all } Kurven; alle stehen in der Aufzeichnung.

# Plan: checks and verdict.
report-no-findings-plan = Keine: die Naht kann auf dieser Maschine wie verlangt geschweißt werden.
report-checked = Geprüft: Reichweite, Bereiche, Geschwindigkeiten, Beschleunigungen und Rucke der Achsen; dass die Brennerachse von beiden Flächen frei bleibt; die Abstände voneinander von { $objects }, entlang der Lagen und auf den Leerfahrten, soweit die Dateien ihre Formen angeben. Nicht geprüft: Objekte, die in dieser Liste fehlen, Werkstücke jenseits der Längen im Auftrag, Kabel und Schläuche.
report-checked-without-shapes = Geprüft: Reichweite, Bereiche, Geschwindigkeiten, Beschleunigungen und Rucke der Achsen, und dass die Brennerachse von beiden Flächen frei bleibt. Kollisionen sind nicht geprüft: die Maschinendatei hat keine Körper.
report-verdict-planned = Geplant: alle Achsen innerhalb ihrer Grenzen, die verlangte Geschwindigkeit vom Anlauf bis zum Auslauf.
report-verdict-planned-slowed = Geplant: alle Achsen innerhalb ihrer Grenzen, auf { $speed } verlangsamt, wo eine Achse es braucht.
report-verdict-within = Innerhalb von { $procedure }.
report-verdict-outside = Außerhalb von { $procedure }: { $n ->
        [one] 1 Befund
       *[other] { $n } Befunde
    }.
report-verdict-findings = Befunde: { $errors } zu beheben, { $warnings } zu prüfen.
report-verdict-simulated = Simuliert: Bahnfehler höchstens { $error } von { $allowed } erlaubten, Geschwindigkeit auf { $ripple } genau ({ $ripple_allowed } erlaubt).
report-verdict-simulated-short = Simuliert: Bahnfehler höchstens { $error } von { $allowed } erlaubten, zu kurz, um die Geschwindigkeit zu beurteilen.

# Plan: key figures.
report-tile-weld-length = Schweißlänge
report-seam-length = Naht { $length }
report-length-of-passes = { $of }; { $n } Lagen, zusammen { $length }
report-through-points = durch Punkte
report-tile-weld-time = Schweißzeit
report-travel = Fahrt von Stillstand zu Stillstand
report-travel-of-passes = Fahrt aller { $n } Lagen von Stillstand zu Stillstand
report-tile-path-error = Bahnfehler, simuliert
report-path-error-rms = größter; RMS { $rms }
report-tile-speed-ripple = Geschwindigkeitswelligkeit, simuliert
report-speed-range = { $from } bis { $to }, RMS { $rms }
report-too-short = Naht zu kurz zum Beurteilen
report-tile-attitude-error = Stellungsfehler
report-attitude-error-of-plan = größter, des Plans
report-tile-arc-energy = Streckenenergie
report-arc-energy-range = größte; kleinste { $min }; U I / v
report-tile-wire = Draht
report-wire-length = { $length } bei brennendem Lichtbogen
report-tile-weld-metal = Schweißgut
report-tile-gas = Schutzgas
report-gas-time = von Vor- bis Nachströmung
report-tile-flux = Pulver
report-tile-energy = Energie des Lichtbogens
report-mains = { $energy } aus dem Netz
report-tile-heat-input = Wärmeeinbringung
report-heat-input-range = größte; kleinste { $min }
report-tile-total = Gesamtzeit
report-total-parts = von Grundstellung zu Grundstellung; Leerfahrten { $transfer }
report-total-parts-waiting = von Grundstellung zu Grundstellung; Leerfahrten { $transfer }, Warten { $wait }
report-duty = { $part } der Gesamtzeit; Einschaltdauer { $duty } in 10 Minuten
report-tile-cost = Kosten
report-cost-labour = Lohn
report-cost-machine = Maschine
report-cost-wire = Draht
report-cost-gas = Gas
report-cost-flux = Pulver
report-cost-energy = Energie
report-cost-incomplete = unvollständig: eine Menge ist unbekannt
report-wire-with-arc = solange der Lichtbogen brennt

# Plan: order of welding.
report-caption-order = Lagen in der Reihenfolge des Schweißens nummeriert. Gestrichelt: Leerfahrten, gerade vom Ende zum Anfang gezeichnet.
report-chart-order = Schweißfolge: { $n } Lagen, { $view }
report-order-key = Punkt: Anfang. Pfeil: Schweißrichtung. Gestrichelt: Leerfahrten, gerade gezeichnet.
report-order-key-tacks = Orange, Nummern außen: Heftstellen.
report-order-lines = { $title }: { $n } Linien der Reihe nach
report-caption-map = Schweißplan: die Naht abgewickelt, eine Zeile je Raupe in der Reihenfolge des Schweißens.
report-chart-map = Schweißplan auf der abgewickelten Naht
report-map-key = Punkt: Anfang. Strich: Ende. Pfeil: Schweißrichtung. Nummern: Lagen.
report-map-copies = Die erste von { $n } Nähten.
report-map-label = { $title }: { $n } Zeilen, { $length }
report-caption-order-table = Zeitplan: Lagen in der Reihenfolge des Schweißens
report-all-from-home = alles, von Grundstellung zu Grundstellung

# Plan: passes.
report-caption-passes = Werte jeder Lage, wie geplant
report-all-passes = alle Lagen
report-caption-checks = Prüfungen jeder Lage
report-caption-materials = Grundwerkstoffe und Schweißgut mit Kohlenstoffäquivalenten: CE des IIW, CET der EN 1011-2, Pcm nach Ito und Bessyo.
report-materials-decisive = Für die Vorwärmung zählt CET { $cet } mit { $hydrogen } ml Wasserstoff in 100 g.
report-caption-heat = Vorwärmung nach Verfahren B und Abkühlzeit von 800 auf 500 °C nach EN 1011-2, für { $thickness }: von der kleinsten Wärmeeinbringung auf dem kältesten zur größten auf dem wärmsten Werkstück.
report-no-preheat = keine
report-weld-metal = Schweißgut
report-material-group = Gruppe { $group }
report-caption-simulated-passes = Ergebnisse jeder simulierten Lage
report-about-curves = Kurven je einer Lage jeder Art: einer mit einem Fehler, sonst der längsten. `plan --plots` schreibt die aller Lagen.

# Plan: seam, torch and process.
report-caption-seam = Naht mit der verlangten Brennerachse, im Koordinatensystem des Auftrags, Projektionsmethode 1.
report-curve-bead = Raupe
report-curve-seam = Naht
report-curve-path = Bahn
report-curve-torch-axis = Brennerachse
report-mark-start = Anfang
report-mark-end = Ende
report-mark-end-of-overlap = Ende der Überlappung
report-chart-torch-angles = Brennerwinkel und Fuge
report-curve-work-angle = Arbeitswinkel (gegen die Winkelhalbierende)
report-curve-travel-angle = Schlepp-/Stechwinkel (+ schleppend, − stechend)
report-curve-half-dihedral = halber Flächenwinkel
report-caption-torch-angles = Arbeitswinkel gegen die Winkelhalbierende der Flächen (positiv zum ersten Teil hin), Schlepp-/Stechwinkel und der halbe Winkel zwischen den Flächen.
report-chart-process-values = Prozesswerte wie verlangt
report-caption-process-values = Prozesswerte entlang der Lage, wo sie sich ändern; ohne die Rampen an ihren Enden.
report-chart-weave = Pendelbahn der Spitze auf den ersten { $length }
report-curve-tip = Spitze
report-curve-beam = Strahl
report-first-part = erstes Teil
report-second-part = zweites Teil
report-caption-weave = Die verlangte Pendelbahn, längs des Brenners gesehen, die Naht gerade gelegt, längs und quer im selben Maßstab; der Brenner fährt nach rechts.
report-chart-oscillation = Bahn des Strahls auf dem Werkstück über { $n } Perioden: { $advance } je Periode bei { $speed }
report-caption-oscillation = Bahn des abgelenkten Strahls auf dem Werkstück, längs und quer im selben Maßstab; oscillation.csv enthält eine Periode der Ablenkung.
report-caption-cut = Abwicklung des geschnittenen Rohrendes; cut.svg zeigt sie in wahrer Größe, von außen gesehen, zum Umwickeln des Rohrs, und cut.csv enthält ihre Punkte.
report-chart-cut = Schablone des Schnitts
report-cut-outside = außen: Radius { $radius }, Umfang { $around }, Schnitt { $from } bis { $to } entlang der Achse, Rand bei { $edge }
report-cut-inside = innen: Radius { $radius }, Umfang { $around }, Schnitt { $from } bis { $to } entlang der Achse, Rand bei { $edge }
report-sections = { $title }: { $n ->
        [one] 1 Querschnitt
       *[other] { $n } Querschnitte
    }
report-section-note = Winkel { $dihedral }, Fläche { $area }
report-section-toes = , Übergangswinkel { $second } und { $first }
report-area-with-cap = { $groove } + { $cap }
report-section-torch = Brenner: Arbeitswinkel { $work }, Schlepp-/Stechwinkel { $travel }
report-caption-sections = Querschnitte entlang der Naht, alle in einem Maßstab, die Fläche des zweiten Teils waagerecht oder die Oberseite des Stumpfstoßes oben: Raupen in der Reihenfolge des Schweißens und wohin der Draht in jeder zeigt; die Fläche ist die der Fuge und der Überhöhung darüber.

# Plan: welding procedure.
report-caption-heat-input = Wärmeeinbringung bei der geplanten Geschwindigkeit zwischen Anlauf und Auslauf, mit ihrem Bereich; schattiert, wo sie außerhalb liegt.
report-caption-positions = Schweißposition (ISO 6947) nach Neigung der Naht und Drehung der Nahtoberfläche, so wie die Achsen der Maschine das Werkstück drehen.
report-too-high = zu hoch
report-too-low = zu niedrig
report-chart-positions = Schweißposition
report-curve-slope = Neigung (+ steigend)
report-curve-rotation = Drehung der Oberfläche (0 oben, 180 unten)
report-run = Eintrag { $run }
report-no-run = kein Eintrag darin gilt für diese Lage
report-procedure = { $number } ({ $title }), { $run }. Prozess { $process }: { $process_name }. Die Wärmeeinbringung ist { $efficiency } mal die Leistung durch die geplante Geschwindigkeit. Die Positionen sind die einer { $joint ->
        [fillet] Kehlnaht
       *[butt] Stumpfnaht
    }.
report-caption-plan-values-of = Der Plan gegen die Schweißanweisung, Lage { $passes }
report-unbounded = ohne Grenze
report-to-be-measured = zu messen
report-unknown-see-findings = nicht bekannt: siehe Befunde
report-outside-at = außerhalb: s = { $from } bis { $to }
report-outside-pass = außerhalb: Lage { $passes }
report-outside-at-more = außerhalb: s = { $from } bis { $to } und { $n ->
        [one] 1 weitere Strecke
       *[other] { $n } weitere Strecken
    }
report-caption-positions-any = Schweißpositionen (mm, Grad); die Schweißanweisung erlaubt jede
report-caption-positions-allowed = Schweißpositionen (mm, Grad); die Schweißanweisung erlaubt { $positions }
report-not-allowed = nicht zulässig

# Plan: taught spans.
report-chart-taught = Geteachter Abschnitt { $number }
report-caption-taught = Geschweißte Naht und Sollnaht; an beiden Anschlüssen stimmen Ort, Richtung und Krümmung überein.
report-taught = geteacht
report-chart-off-nominal = Abstand von der Sollnaht
report-curve-as-welded = die geschweißte Naht
report-curve-nominal = Sollnaht
report-curve-taught-points = geteachte Punkte
report-chart-direction-off-nominal = Richtung gegen die der Sollnaht
report-chart-curvature = Krümmung
report-chart-tip-speed = Geschwindigkeit der Brennerspitze
report-curve-planned = geplant
report-shorter = kürzer
report-longer = länger
report-taught-span = Abschnitt { $number }: s = { $from } bis { $to } ({ $length } { $change } als die Sollnaht dort), { $n } geteachte Punkte; bis zu { $distance } neben der Sollnaht und { $angle } neben ihrer Richtung.

# Plan: clearance.
report-caption-clearance = Kleinster Abstand von Brenner, Gliedern, Werkstück, Vorrichtungen und Zonen voneinander und seine untere Schranke entlang der ganzen Lage.
report-chart-clearance = Kleinster Abstand (angegeben bis { $limit })
report-curve-clearance = kleinster Abstand
report-curve-clearance-bound = bewiesene untere Schranke zwischen den Stützstellen

# Plan: speed.
report-speed-reached = Verlangt: { $requested }. Zwischen Anlauf und Auslauf erreicht: { $reached }. Auf { $part } der Länge so schnell wie verlangt.
report-caption-speed = Geschwindigkeit der Spitze entlang der Naht, gegen das Werkstück; schattiert, wo sie kleiner ist als verlangt, mit der Grenze, die sie bestimmt.
report-chart-speed = Geschwindigkeit der Brennerspitze entlang der Naht
report-curve-tip-simulated = tatsächliche Brennerspitze, simuliert
report-acceleration-phase = Anlauf
report-deceleration-phase = Auslauf
report-section-weld = Naht
report-axis = Achse { $axis }
report-torch-tip = Brennerspitze
report-requested-speed = verlangte Geschwindigkeit
report-binding = { $owner }: { $what }, { $limit }
report-no-binding = nichts: so schnell wie verlangt
report-caption-binding = Was die Geschwindigkeit begrenzt (mm, mm/s)
report-caption-binding-first = Was die Geschwindigkeit begrenzt (mm, mm/s): die ersten { $n } Strecken, { $more } weitere in report.json
report-caption-deviation = Abweichung der simulierten Geschwindigkeit zwischen Anlauf und Auslauf; am Anfang schwingen die Antriebe ein.
report-chart-deviation = Geschwindigkeit der tatsächlichen Brennerspitze gegen die geplante

# Plan: tracking.
report-part-displaced = Das Werkstück liegt anders als geplant.
report-tracking-without-alarms = Die Nahtverfolgung meldete keine Alarme.
report-welded-as-planned = Es wurde wie geplant geschweißt.
report-to-be-checked = Zu prüfen: { $alarms }.
report-alarm-at = { $head } bei { $s }: { $alarm }
report-caption-tracking = Tatsächliche Lage der Fuge gegen die geplante Bahn, Abweichung der Naht von der Fuge und Unsicherheit der verfolgten Fuge.
report-chart-tracking = Fuge und Naht
report-chart-joint = Fuge gegen die geplante Bahn (Abweichung einer Naht ohne Verfolgung)
report-chart-weld = Naht gegen die Fuge
report-chart-correction = seitliche Korrektur: Ablenkung des Strahls; gestrichelt die von den Achsen geführte Kanone
report-chart-sigma = Unsicherheit der Fugenlage (Standardabweichung)
report-curve-lateral = seitlich
report-curve-height = Höhe
report-curve-deflection = Ablenkung
report-curve-gun = von den Achsen geführte Kanone
report-curve-sigma = Sigma
report-not-welded = nichts geschweißt
report-not-tracked = nicht verfolgt
report-caption-tracked-lateral = Abstand der Naht von der Fuge, seitlich: ein Strahl hat keine Höhe
report-caption-tracked = Abstand der Naht von der Fuge, seitlich und Höhe zusammen
report-stored-points = { $value } ({ $n ->
        [one] 1 Punkt
       *[other] { $n } Punkte
    })
report-stored-deviations = gespeicherte Abweichungen
report-seen-by-beam = Messung durch den Strahl
report-caption-beam = Korrekturen des Strahls

# Plan: simulation.
report-simulation = Jede Achse in ihrem Lageregelkreis im Servotakt, mit Trägheit, Reibung, Rastmoment, Geberschritten und Stromgrenze (Startwert { $seed }). Es ist das Sollwerkstück: kein Versatz, kein Verzug, kein Fügefehler, kein Drahtdrall. Die Geschwindigkeitswelligkeit ist die größte Abweichung der Geschwindigkeit der Spitze von der geplanten, von einer halben Sekunde nach dem Anlauf bis zum Auslauf.
report-highest-load = Der am höchsten belastete Antrieb ist { $axis }: { $load } seiner Spitzenlast.
report-assumed-drives = Die Maschinendatei beschreibt keinen Antrieb für { $axes }: die Simulation nimmt einen an.
report-caption-path-error = Abstand der tatsächlichen Brennerspitze von der Naht, senkrecht zu ihr.
report-chart-path-error = Abstand der tatsächlichen Brennerspitze von der Naht
report-curve-normal-to-seam = senkrecht zur Naht
report-caption-following = Sollposition minus Istposition jeder Achse.
report-chart-following = Schleppfehler jeder Achse
report-caption-following-table = Schleppfehler bei brennendem Lichtbogen
report-caption-attitude = Winkel zwischen der tatsächlichen und der verlangten Brennerrichtung.
report-chart-attitude = Abweichung der tatsächlichen Brennerrichtung von der verlangten

# Plan: axes.
report-continuous = durchgehend
report-caption-axes = Geplante Position, Geschwindigkeit und Beschleunigung jeder Achse gegen ihre Grenzen.
report-caption-jerks = Geplanter Ruck jeder Achse gegen seine Grenze.
report-chart-axes = Achsen gegen ihre Grenzen
report-chart-jerks = Ruck der Achsen gegen seine Grenzen
report-caption-ranges = Positionen der Achsen gegen ihre Bereiche
report-caption-uses = Größte Nutzung der Grenzen jeder Achse

# Plan: part programs.
report-program = { $file } für { $dialect }: { $n } Bewegungen, zurückgelesen, nach den Regeln der Steuerung für Interpolation und Vorschübe ausgeführt, durch die Vorwärtskinematik der Maschine geführt und mit dem Plan verglichen; erlaubt sind { $tolerance }.
report-as-in-program = wie im Programm
report-caption-program = Größte Abweichungen von { $file }

# Plan: job data.
report-caption-job = Zeiten und Werte vor und nach der Fahrt
report-row-seam = Naht
report-row-seam-length = Nahtlänge
report-row-acceleration-phase = Anlauf
report-row-deceleration-phase = Auslauf
report-row-start-angle = Anfangswinkel
report-row-direction = Schweißrichtung
report-row-dihedral = Flächenwinkel
report-row-preparation = Nahtvorbereitung
report-counter-clockwise = gegen den Uhrzeigersinn
report-clockwise = im Uhrzeigersinn
report-row-overlap = Überlappung
report-row-preflow = Gasvorströmung
report-row-travel-delay = Lichtbogen vor der Fahrt
report-row-upslope = Anstieg von: { $value }
report-row-upslope-time = Anstieg: Zeit
report-row-downslope = Absenkung auf: { $value }
report-row-downslope-time = Absenkung: Zeit
report-row-crater = Kraterfüllen
report-row-postflow = Gasnachströmung

# Check of a machine: page.
report-check-subtitle = Prüfung der Maschinendatei
report-check-made-by = Seamwright { $version }, Startwert { $seed }
report-check-heading-failed = Nicht bestandene Prüfungen
report-check-remarks = Anmerkungen
report-check-heading-kinematics = Kinematik
report-check-singular = Singuläre Stellungen
report-check-heading-reach = Reichweite
report-check-heading-file = Maschinendatei
report-check-remark-count = { $n ->
        [0] keine Anmerkungen
        [one] 1 Anmerkung
       *[other] { $n } Anmerkungen
    }
report-check-passed = Jede Pose wird aus ihren eigenen Positionen wiedergefunden, und die Jacobi-Matrix stimmt mit Differenzen überein; { $remarks }.
report-check-failed = { $failures }; { $remarks }.
report-check-axis-count = { $rotary } rotatorisch, { $linear } linear
report-check-tip-error = Rundlauf, Spitze
report-check-tip-error-note = größter aus { $n } zufälligen Posen je Kopf
report-check-jacobian = Jacobi-Matrix
report-check-jacobian-note = größte relative Abweichung
report-check-singular-note = innerhalb der Bereiche
report-check-remarks-note = ungewöhnliche Werte
report-check-caption-machine = Maschine in Grundstellung in ihrem Basiskoordinatensystem, Projektionsmethode 1. Pfeile zeigen die positive Richtung dessen, was jede Achse bewegt: auf der Werkzeugseite den Brenner, auf der Werkstückseite das Werkstück; Drehungen folgen der Rechte-Hand-Regel. Symbole, die sich überdecken würden, stehen nebeneinander.
report-check-no-remarks = Keine: Grenzen, Bereiche und Antriebe haben übliche Größen und passen zueinander.
report-check-remark = { $key }: { $why }
report-check-remark-value = { $key } = { $value }: { $why }
report-check-line = { $file }, Zeile { $line }
report-check-typical = Eine typische Naht läuft mit { $speed } um eine Biegung von { $radius }; der Brenner dreht sich dabei mit { $rate }.
report-check-too-fast = In { $part } der Bereiche verlangt eine typische Naht mehr Geschwindigkeit, als eine Drehachse hat.
report-check-fast-enough = Jede typische Naht liegt in den ganzen Bereichen innerhalb der Geschwindigkeit der Drehachsen.
report-check-no-singular = Kopf { $head }: keine singulären Stellungen innerhalb der Bereiche. Die am schlechtesten konditionierte Position ist { $position } (Kondition { $worst }; { $best } an der besten Position).
report-check-reach = Kopf { $head }: von der Spitze im Werkstücksystem { $kind ->
        [volume] erreichtes Volumen
        [area] erreichte Fläche
       *[length] erreichte Länge
    }: { $size }, { $part } der umschließenden Box. Der Brenner neigt sich, vom Werkstück aus gesehen, bis zu { $tilt } gegen seine Richtung in Grundstellung.
report-check-no-volume = keines: die Spitze bleibt auf einer Fläche oder Linie
report-check-point = ein Punkt
report-check-size = { $value } ± { $deviation }
report-check-position = { $axis } { $position }

# Check of a machine: tables.
report-check-column-letter = Buchstabe
report-check-column-kind = Art
report-check-column-moves = Bewegt
report-check-column-home = Grundstellung
report-check-column-speed = Geschwindigkeit, /s
report-check-column-acceleration = Beschleunigung, /s²
report-check-column-jerk = Ruck, /s³
report-check-column-time = Bis zur Geschwindigkeit, s
report-check-caption-axes = Achsen; lineare in mm, rotatorische in Grad. Die letzte Spalte ist die Zeit vom Stillstand bis zur größten Geschwindigkeit.
report-check-linear = linear
report-check-rotary = rotatorisch
report-check-torch = Brenner
report-check-work = Werkstück
report-check-no-end-stops = ohne Endanschläge
report-check-column-result = Ergebnis
report-check-column-poses = Posen
report-check-column-direction = Richtung, °
report-check-column-axes = Achsen, mm oder °
report-check-column-near-singular = Nahe singulär
report-check-column-unsolved = Ungelöst
report-check-column-branch-missing = Eigener Zweig fehlt
report-check-both-heads = beide Köpfe
report-check-off-centre = { $unsolved } (und { $n } mit Schlitten außer Mitte)
report-check-caption-results = Rundlauf: zufällige Positionen, ihre Pose, alle Positionen für diese Pose und wieder deren Posen. Größte Abweichungen; die der Achsen abseits singulärer Stellungen.
report-check-result-passed = bestanden
report-check-result-failed = nicht bestanden
report-check-column-inverse = Inverse
report-check-column-difference = Abweichung
report-check-column-worst-axis = Schlechteste Achse
report-check-caption-structure = Verfahren, das zu einer Pose die Positionen findet, und die Jacobi-Matrix im Vergleich mit zentralen Differenzen: größte Abweichung bezogen auf ihre Spalte.
report-check-margin = { $distance } (näher ist { $axis } zu langsam)
report-check-caption-singular = Singuläre Stellungen von Kopf { $head } innerhalb der Bereiche und der Abstand, den eine typische Naht von ihnen braucht.
report-check-column-configuration = Stellung
report-check-column-distance = Nötiger Abstand
report-check-column-box = Box von
report-check-tip-in-work = Spitze im Werkstücksystem
report-check-tip-in-base = Spitze im Basissystem
report-check-caption-reach = Umschließende Box aller Positionen, die eine Spitze erreicht, mm.

# Check of a machine: text.
report-check-text-result = Ergebnis
report-check-text-failure = Fehler
report-check-text-head = Kopf
report-check-text-inverse = Inverse
report-check-text-round-trip = Rundlauf
report-check-text-errors = { $n } Posen: Spitze { $tip }, Richtung { $direction }, Achsen { $axes } (mm oder °); { $near } nahe singulär
report-check-text-jacobian = Abweichung { $difference } bezogen auf eine Spalte
report-check-text-singular = singulär
report-check-text-margin = { $place }; näher als { $distance } ist { $axis } zu langsam für { $speed } auf { $radius }
report-check-text-no-singular = keine innerhalb der Bereiche
report-check-text-reach = Reichweite
report-check-text-box = x { $x }, y { $y }, z { $z } mm im Werkstücksystem
report-check-text-tilt = { $size }; bis zu { $tilt } gegen die Grundstellung
report-check-text-pair = { $n } Posen: Spitzen { $tip }, Richtungen { $direction }; { $off } mit Schlitten außer Mitte sind ohne Lösung
report-check-text-remark = Anmerkung
report-check-text-line = Zeile { $line }: { $remark }
report-check-text-cure = Abhilfe: { $cure }

# Drawings without a title, for screen readers.
report-three-views = drei Ansichten
report-charts = Diagramme
report-machine = Maschine

# Drawing of a machine.
report-machine-title = { $machine }: Achsen in Grundstellung, im Basissystem
report-machine-moves-torch = positiv bewegt den Brenner
report-machine-moves-work = positiv bewegt das Werkstück
report-machine-beam = Strahl oder Draht, endet an der Spitze
report-machine-links = Glieder und Körper
report-machine-towards = positiv auf Sie zu
report-machine-away = positiv von Ihnen weg
report-machine-stroke = Hub, der Pfeil an der größten Position
report-machine-cut = geht weiter
report-machine-home = Grundstellung
report-machine-base = Basis
report-machine-work = Werkstück
report-machine-up = oben

# Bode plots.
report-bode-frequency = Frequenz
report-bode-magnitude = Amplitude des offenen Kreises
report-bode-phase = Phase des offenen Kreises
report-bode-crossover = Durchtritt
report-bode-open-loop = offener Kreis
report-bode-gain-margin = Amplitudenreserve { $margin } bei { $frequency }
report-bode-gain-unbounded = Amplitudenreserve: unbegrenzt
report-bode-phase-margin = Phasenreserve { $margin } bei { $frequency }
report-bode-phase-unbounded = Phasenreserve: unbegrenzt

# Search for placements.
report-reach-subtitle = Aufstellungen des Werkstücks
report-reach-subtitle-base = Aufstellungen der Maschinenbasis
report-reach-title = Erreichbarkeit von { $machine }
report-reach-key = Zahl: kleinster Abstand einer Achse von einem Ende ihres Bereichs, % des Bereichs
report-reach-label = { $title }: Karte der Aufstellungen
report-reach-shade = { $from } bis { $to } %
report-reach-shade-above = über { $from } %
report-reach-fails = nicht schweißbar
report-reach-present = jetzige Aufstellung
report-reach-best = beste Aufstellung
report-reach-judged = geprüfte Aufstellungen
report-reach-weldable = schweißbar
report-reach-clearance = Abstand bei der besten
report-reach-kind-reach = außer Reichweite
report-reach-kind-range = Bereich einer Achse
report-reach-kind-jump = keine stetige Bewegung
report-reach-kind-speed = Geschwindigkeit einer Achse
report-reach-kind-position = Schweißposition
report-reach-found = beste Aufstellung: x { $x }, y { $y }, z { $z }, gedreht { $turn }; geplant
report-reach-none = keine Aufstellung ist schweißbar und geplant
report-reach-heading-map = Karte
report-reach-heading-best = Beste Aufstellungen
report-reach-heading-reasons = Gründe des Scheiterns
report-reach-heading-method = Verfahren
report-reach-method = Verschiebungen gelten im Werkstückkoordinatensystem von der jetzigen Aufstellung aus; gedreht wird um die Senkrechte durch die Mitte der Naht. Jede Zelle zeigt die beste Aufstellung des Gitters mit diesem x und y, bei Scheitern die Achse oder die Art des Grundes. Die beste Aufstellung wurde ganz geplant, mit Abständen und Verfahrwegen; die anderen wurden nach Bereichen, Geschwindigkeiten, Schweißpositionen und stetiger Bewegung geprüft.
report-reach-method-base = Verschiebungen sind die der Maschinenbasis im Basiskoordinatensystem von der jetzigen Aufstellung aus; gedreht wird um die Senkrechte durch dessen Ursprung. Alles auf der Basis geht mit. Jede Zelle zeigt die beste Aufstellung des Gitters mit diesem x und y, bei Scheitern die Achse oder die Art des Grundes. Die beste Aufstellung wurde ganz geplant, mit Abständen und Verfahrwegen; die anderen wurden nach Bereichen, Geschwindigkeiten, Schweißpositionen und stetiger Bewegung geprüft.
report-reach-caption-map = Aufstellungen entlang x und y
report-reach-caption-best = Die besten geprüften Aufstellungen
report-reach-caption-reasons = Gründe, jeweils mit der am ehesten schweißbaren Aufstellung
report-reach-column-turn = gedreht, °
report-reach-column-margin = Reserve, % des Bereichs
report-reach-column-axis = Achse
report-reach-column-singular = von singulärer Stellung, %
report-reach-column-speed = genutzte Achsgeschwindigkeit, %
report-reach-column-kind = Grund
report-reach-column-count = Aufstellungen
report-reach-column-pass = Lage
report-reach-column-s = s, mm
report-reach-column-reason = nächster Fall
