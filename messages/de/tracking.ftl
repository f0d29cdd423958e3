# Settings.
tracking-value = { $key } = { $value }: erlaubt: { $allowed }
tracking-ages = zwei Alter in s: das kleinste, dann ein größeres größtes, höchstens 10
tracking-scan-allowed = weniger als die Periode
tracking-speeds-allowed = zwei Geschwindigkeiten größer als 0, die kleinere zuerst
tracking-notice-allowed = mehr als der Nachlauf der Schlitten, höchstens 0,02
tracking-correction-allowed = eine Bahn, auf der die Achsen den Brenner nach allen Seiten verschieben können
tracking-look-ahead-too-short = ein Vorlauf von { $distance } ist bei { $speed } zu kurz: eine Abweichung muss { $notice } vor dem Brenner bekannt sein; erlaubt sind { $min } oder mehr, oder { $max } oder weniger

# Frames of the beam.
tracking-frames-too-often = period_s = { $period }: die Schweißung darf höchstens alle { $min } unterbrochen werden; erlaubt ist das oder mehr
tracking-frame-too-long = scan_s = { $scan }: die Schweißung darf für { $max } unterbrochen werden; erlaubt ist das oder weniger
tracking-zone-outside = bei { $speed } muss die Fuge von { $from } bis { $to } voraus zu sehen sein, und das Bild endet bei { $reach }; erlaubt sind { $min } bis { $max }
tracking-zone-outside-at-any-speed = bei { $speed } muss die Fuge von { $from } bis { $to } voraus zu sehen sein, und das Bild endet bei { $reach }; mit einem solchen Bild geht keine Geschwindigkeit

# Stored deviations.
tracking-pass-not-covered = die Lage geht von { $from } bis { $to } der gespeicherten Naht, und Abweichungen sind von { $first } bis { $last } gespeichert
tracking-stored-deviation-moved = neun von zehn von { $points } Punkten liegen bis { $within } daneben (Median { $median }), erlaubt sind { $max }; diese Lage stattdessen mit Nahtverfolgung schweißen
tracking-stored-deviation-unseen = { $points } Punkte in { $frames } Bildern, erlaubt sind { $min } oder mehr; nur Bilder prüfen, die die Fuge zeigen
tracking-record = { $file }:{ $line }: { $column } = `{ $value }`: { $wrong }; erlaubt: { $allowed }
tracking-record-no-column = diese Spalte fehlt in der Kopfzeile
tracking-record-not-finite = keine endliche Zahl
tracking-record-out-of-range = außerhalb des Bereichs
tracking-record-not-increasing = nicht größer als in der Zeile davor
tracking-record-too-short = weniger als zwei Zeilen
tracking-record-table = eine Kopfzeile mit s_mm,lateral_mm,height_mm,confidence, dann mindestens zwei Zeilen endlicher Zahlen
tracking-record-path-lengths = ansteigende Bahnlängen

# Faults of a sensor.
tracking-sensor-silent = der Sensor sendet keine Daten
tracking-sensor-contradictory = die Messungen des Sensors widersprechen sich
tracking-sensor-confidence = die Konfidenz des Sensors ist keine Zahl von 0 bis 1
tracking-sensor-faint = der Sensor sieht die Fuge zu schwach
tracking-sensor-out-of-field = die Fuge liegt außerhalb des Sichtfelds des Sensors
tracking-sensor-clock = die Zeitstempel des Sensors sind falsch
tracking-sensor-late = die Messungen des Sensors kommen zu spät
tracking-sensor-frozen = der Sensor wiederholt dieselbe Messung

# Alarms of tracking.
tracking-near-stroke-end = Korrektur nahe ihrer Grenze
tracking-axes-carry = über die Strahlablenkung hinaus: die Achsen führen die Kanone
tracking-slowed = langsamer wegen steiler Abweichung
tracking-blind = der Sensor sieht nichts
tracking-coasting = Brenner über den gemessenen Teil der Fuge hinaus
tracking-beyond-history = Brenner weiter zurück als die gespeicherten Messungen
tracking-fading-out = Korrektur klingt zur geteachten Bahn aus
tracking-stroke-end = Korrektur an ihrer Grenze: die Naht verfehlt die Fuge
tracking-joint-lost = Fuge verloren
tracking-slide-stuck = Schlitten folgt seinem Sollwert nicht
tracking-stored-deviation-misfit = die gespeicherte Abweichung passt nicht

# Following a joint with a camera to teach it.
tracking-crawl-not-joined = die erkannte Linie schließt nicht an die bisher gefundene an
tracking-crawl-frames-apart = zwei Bilder zeigen die Fuge { $distance } voneinander entfernt
tracking-crawl-not-seen = die Fuge ist nicht zu sehen
tracking-crawl-not-seen-further = die Fuge ist nicht weiter zu sehen
tracking-crawl-end-or-tack = die Fuge ist nicht weiter zu sehen: sie endet hier, oder eine Heftstelle über der größten Länge verdeckt sie
