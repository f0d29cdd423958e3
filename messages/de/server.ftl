# Start und Ende des Servers.
server-syslog-receiver = kein Syslog-Empfänger: { $text }; erlaubt: udp://HOST:PORT oder tcp://HOST:PORT, ein Port von 1 bis 65535 (ohne Angabe 514), IPv6-Adressen in Klammern
server-bind = { $option }: { $why }
server-bind-free = eine Adresse und ein freier Port
server-bind-plain = andere Rechner erreichen diese Adresse, und nichts ist verschlüsselt
server-bind-encrypted = mit --tls, oder --cert und --key; 127.0.0.1, [::1]
server-bind-no-admin = andere Rechner erreichen diese Adresse, und noch niemand hat ein Passwort
server-bind-local-first = 127.0.0.1 oder [::1], um dort zuerst einen Administrator mit Passwort anzulegen
server-bind-no-name = der Name dieses Rechners fehlt
server-bind-named = mit --host NAME, oder eine einzelne Adresse
server-certificate-failed = das Zertifikat lässt sich nicht erstellen: { $why }
server-certificate-files = { $options }: { $why }
server-pem-files = PEM-Dateien eines Zertifikats und seines privaten Schlüssels
server-panicked = Fehler des Programms (panic): die Zelle wurde angehalten, ihre Geräte erhielten den Befehl zum Ausschalten
server-library-open = die Bibliothek lässt sich nicht schließen: nichts wurde wiederhergestellt
server-look-at-once = sofort prüfen, ob Lichtbogen und Gas aus sind

# Requests.
server-failed = es ist misslungen; nichts wurde geändert
server-program-fault = durch einen Fehler des Programms abgebrochen: bitte melden
server-no-thread = ein Thread lässt sich nicht starten: { $why }
server-panel-ends = das Panel wird beendet
server-slow-down = zu viele Anfragen dieser Art: gleich noch einmal versuchen
server-too-many-requests = zu viele Anfragen auf einmal: einen Moment warten
server-request-late = die Anfrage kam zu langsam an
server-request-too-large = die Anfrage ist zu groß; erlaubt: bis { $max } KiB
server-too-many-pages = zu viele Seiten sind offen: eine schließen
server-cell-ended = die Zelle ist beendet
server-cell-silent = die Zelle antwortet nicht: noch einmal versuchen
server-no-machine = es gibt keine Maschine
server-no-machine-named = es gibt keine Maschine „{ $name }“
server-no-axis = es gibt keine Achse „{ $axis }“; erlaubt: { $allowed }
server-no-language = es gibt keine Sprache „{ $language }“; { $allowed }
server-file-trouble = { $file }: { $why }
server-file-unreadable = { $file } ist nicht lesbar: { $why }

# Log-in and permissions.
server-unknown-host = dieses Panel ist nicht als „{ $host }“ bekannt; erlaubt: { $allowed }
server-other-origin = Anfragen von Seiten anderer Herkunft werden abgewiesen
server-not-logged-in = nicht angemeldet, oder die Sitzung ist zu Ende: anmelden
server-session-over = die Sitzung ist zu Ende: anmelden
server-role = die Rolle { $role } erlaubt das nicht ({ $action })
server-role-from = die Rolle { $role } erlaubt das nicht ({ $action }); erlaubt: ab { $needed }
server-header = die Kopfzeile „{ $header }“ muss „{ $value }“ sein
server-token = die Kopfzeile „{ $header }“ muss das Token der Sitzung enthalten
server-content-type = der Inhaltstyp „{ $kind }“ wird nicht angenommen; erlaubt: { $allowed }
server-wrong-passwords = zu viele falsche Passwörter: { $wait } warten
server-login-too-long = Name oder Passwort ist zu lang; erlaubt: bis { $max }
server-login-wrong = Name oder Passwort ist falsch, oder der Startlink ist veraltet
server-no-random = keine Zufallszahlen: { $why }

# Users.
server-own-password = dazu ist Ihr eigenes Passwort nötig, und es ist falsch
server-user-exists = den Benutzer „{ $user }“ gibt es schon
server-no-user = es gibt keinen Benutzer „{ $user }“
server-user-name = unzulässiger Benutzername; erlaubt: Buchstaben, Ziffern, - _ . und Leerzeichen dazwischen, bis { $max }
server-user-owner = „{ $user }“ ist dem Startlink vorbehalten: einen anderen Namen wählen
server-password-length = unzulässige Länge des Passworts; erlaubt: { $min } bis { $max } Zeichen
server-password-needed = ein neuer Benutzer braucht ein Passwort
server-password-hash = das Passwort lässt sich nicht hashen: { $why }
server-too-many-users = zu viele Benutzer; erlaubt: { $max }
server-last-admin = es bliebe kein Administrator: zuerst einen anderen freigegebenen Benutzer zum Administrator machen

# Jobs.
server-job-name = unzulässiger Name eines Auftrags: „{ $name }“; erlaubt: Buchstaben, Ziffern, - _ . ( ) + und Leerzeichen, bis { $max }, am Ende .toml
server-no-job = es gibt keinen Auftrag „{ $job }“
server-no-own-job = es gibt keinen eigenen Auftrag „{ $job }“
server-jobs-unreadable = der Ordner der Aufträge ist nicht lesbar: { $why }
server-template-name = „{ $job }“ heißt eine Vorlage: den Auftrag unter anderem Namen speichern
server-other-text = unter „{ $job }“ ist ein anderer Text gespeichert
server-search-too-long = Suchtext zu lang; erlaubt: bis zu { $max } Zeichen
server-too-many-jobs = zu viele Aufträge; erlaubt: { $max }
server-job-not-deleted = { $job } lässt sich nicht löschen: { $why }
server-too-many-operations = zu viele Schritte; erlaubt: bis { $max } auf einmal
server-operation = Schritt { $n }: { $why }
server-at-key = { $key }: { $what }
server-at-value = { $key } = { $value }: { $what }
server-and-allowed = { $what }; erlaubt: { $allowed }
server-and-help = { $what }; { $help }

# Planning.
server-superseded = abgebrochen oder durch eine neuere Anfrage ersetzt
server-planning-time = die Planung dauert länger als { $max }; weniger Lagen, Raupen oder Punkte verwenden
server-planning-memory = die Planung braucht mehr als { $max } GiB Speicher; weniger Lagen, Raupen oder Punkte verwenden
server-plan-too-large = der Plan ist zu groß zum Anzeigen; erlaubt: bis { $max }
server-no-process = ein Prozess zum Planen lässt sich nicht starten: { $why }
server-no-pipes = ein Prozess zum Planen lässt sich nicht starten: ihm fehlen die Pipes
server-planning-failed = die Planung ist misslungen; die Zelle ist nicht betroffen: { $why }
server-no-dialect = es gibt keinen Dialekt „{ $name }“; erlaubt: { $allowed }

# Loading.
server-part-number = unzulässige Werkstücknummer; erlaubt: bis { $max } sichtbare Zeichen
server-machine-moves = die Maschine bewegt sich oder ist angehalten: zuerst stoppen
server-other-devices = die Maschinendatei des Auftrags nennt andere Geräte als die, mit der das Panel gestartet wurde; erlaubt: dieselben [devices] oder keine
server-devices-held = die Geräte werden nicht freigegeben: das Panel neu starten
server-devices-not-connected = die Geräte lassen sich nicht verbinden
server-needs-other-devices = der Auftrag ist für eine andere Maschine: zuerst die Antriebe ausschalten
server-loading = ein anderes Programm wird geladen: einen Moment warten
server-load-announced = ein Auftrag wird zum Laden geplant: warten, bis er in der Zelle ist
server-overlap = unzulässige Überlappung von { $value }; erlaubt: bis { $max }
server-nothing-to-weld = Lage { $pass }, { $s }: nichts bleibt zu schweißen; erlaubt: eine Lage von 1 bis { $passes }, innerhalb ihrer Länge
server-finished-pass = Werkstück „{ $part }“ ist bis Lage { $pass }, { $s } geschweißt: dieser Start würde es noch einmal schweißen; dort fortsetzen oder bestätigen
server-finished-part = Werkstück „{ $part }“ ist fertig geschweißt (Schweißung { $weld }): dieser Start würde es noch einmal schweißen; bestätigen oder ein anderes Werkstück nennen

# Commands over the socket.
server-message-invalid = ungültige Nachricht: { $why }
server-unknown-command = unbekannter Befehl „{ $name }“; erlaubt: { $allowed }
server-no-control = diese Seite hat die Bedienung nicht: zuerst die Bedienung nehmen
server-control-jogs = die bedienende Seite tippt gerade Achsen: warten, bis die Taste losgelassen ist
server-control-held = { $user } hat die Bedienung, auf Seite { $page }
server-replayed = Befehl { $n } kam schon; erlaubt: größer als { $last }
server-busy = zu viele Befehle auf einmal
server-at-rest = es bewegt sich nichts
server-override-range = Override { $value }; erlaubt: 0 bis 1
server-no-alarm = es gibt keinen Alarm { $number }; erlaubt: 1 bis { $max }
server-step-range = Schritt von { $value }; erlaubt: bis { $max } in beide Richtungen
server-positions-unknown = die Positionen der Achsen sind unbekannt
server-no-such-axis = diese Achse gibt es nicht
server-tip-directions = die Spitze bewegt sich nur längs x, y und z
server-axis-count = { $n } Achsen; erlaubt: { $allowed }
server-axes-moving = die Achsen bewegen sich noch: einen Moment warten
server-not-homed = Achse { $axis } ist nicht referenziert: zuerst referenzieren
server-shelve-time = { $minutes } min; erlaubt: bis { $max }
server-alarm-not-listed = dieser Alarm steht nicht auf der Liste
server-alarm-reacts = „{ $alarm }“ hat eine Reaktion ({ $reaction }); zurückstellen lassen sich nur reine Meldungen

# Set-up.
server-no-job-loaded = kein Auftrag ist geladen: zuerst einen dieser Maschine laden
server-axis-not-in-file = die Achse steht nicht in ihrer Datei
server-no-parameter = es gibt keinen Parameter „{ $key }“; erlaubt: { $allowed }
server-other-kind-of-axis = „{ $key }“ gehört zu einer anderen Art von Achse
server-no-head = es gibt keinen Kopf { $head }; erlaubt: 0 bis { $max }
server-too-many-touches = { $n } Antastungen; erlaubt: bis { $max }
server-touch = unzulässige Antastung { $touch }; erlaubt: { $n } Positionen, mm oder Grad, bis 1000000
server-more-touches = { $why }; einen Punkt dreimal oder öfter antasten, den Brenner dazwischen um 20 Grad oder mehr geneigt
server-tip-far = tip_mm { $tip }; erlaubt: bis { $max }
server-no-camera = „{ $sensor }“ ist keine Kamera; erlaubt: ein Sensor mit `map.heights`
server-grid = unzulässiges Raster: Abstand { $pitch }, Höhe { $z }; erlaubt: ein Abstand größer als 0
server-no-sensor = es gibt keinen Sensor „{ $sensor }“; erlaubt: { $allowed }
server-not-simulated = nicht simuliert; erlaubt: simulierte Geräte, bis { $max } Pixel
server-scale-differs = der Maßstab weicht um { $difference } ab: Abstand und Höhe prüfen
server-picture-size = das Bild hat { $pixels } Pixel; erlaubt: { $allowed }
server-no-sensor-key = es gibt kein „{ $key }“; erlaubt: { $allowed }
server-number-count = „{ $key }“ hat { $n } Zahlen; erlaubt: { $allowed }
server-too-many-planes = { $n } Ebenen; erlaubt: bis { $max }

# Placing the part by touching.
server-probe-radius = Tastradius { $value }; erlaubt: 0 bis { $max }
server-too-many-points = { $n } Punkte; erlaubt: bis { $max }
server-feature = Punkt { $point }: unbekanntes Element „{ $feature }“; erlaubt: { $allowed }
server-point-far = Punkt { $point } ist zu weit entfernt; erlaubt: bis { $max }
server-more-points = { $why }; mehr Punkte, über die Flächen verteilt, oder ein anderes Verfahren verwenden
server-more-points-round = { $why }; mehr Punkte verwenden, über die Stirnfläche und rundum verteilt
server-no-surfaces = der Auftrag hat keine Naht, deren Flächen sich antasten lassen: einen Auftrag mit Naht verwenden
server-not-determined = nicht bestimmt: { $what }; unverändert
server-turn-about-axis = die Drehung um die Achse
server-no-spare-points = nicht mehr Punkte als Unbekannte: ein schlechter Punkt fiele nicht auf
server-three-points-plane = Ebene: nur drei Punkte; ein schlechter fiele nicht auf
server-three-points-face = Stirnfläche: nur drei Punkte; ein schlechter fiele nicht auf
server-three-points-round = Umfang: nur drei Punkte; ein schlechter fiele nicht auf
server-round-diameter = Durchmesser am Umfang: { $diameter }
server-no-position = die Punkte bestimmen keine Lage
server-offsets-no-table = `offsets` ist keine Tabelle; erlaubt: [offsets.NAME]

# Records and backup.
server-query = { $name }: { $why }
server-too-many-values = { $columns } Spalten mit { $rows } Zeilen sind zu viel; erlaubt: bis { $max-columns } Spalten, { $max-values } Werte
server-row-count = most={ $value }; erlaubt: { $min } bis { $max }
server-no-column = es gibt keine Spalte „{ $column }“; erlaubt: { $allowed }
server-not-off = die Maschine ist nicht aus: zuerst die Antriebe ausschalten
server-archive-too-large = das Archiv ist zu groß; erlaubt: bis { $max }; größere nimmt `seamwright records restore`
server-archive-broke-off = die Übertragung des Archivs wurde unterbrochen
server-archive-no-admin = im Archiv gibt es keinen Administrator: danach könnte niemand das Panel benutzen
server-no-archive = kein Archiv wurde geprüft: zuerst eines senden
server-record-being-written = das Protokoll einer Schweißung wird noch geschrieben: warten
server-backup-runs = eine Sicherung wird erstellt oder geprüft: warten, bis sie fertig ist

# Teaching by camera.
server-no-image = es gibt noch kein Bild
server-teach-point = ein Pixel und eine Position; erlaubt: eines davon oder keines
server-teach-no-work = dort zeigt das Bild kein Werkstück
server-teach-range = { $key } { $value }; erlaubt: { $min } bis { $max }
server-teach-above = { $key } { $value }; erlaubt: über 0, bis { $max }
server-teach-method = unbekanntes Verfahren „{ $method }“; erlaubt: { $allowed }
server-teach-nothing = noch nichts wurde geteacht
server-teach-tack = unzulässige Heftstelle; erlaubt: der Anfang vor dem Ende, beide endlich
server-teach-order = unzulässige Anweisung
server-teach-real-devices = die Geräte der Maschine sind echt, und ihre Datei nennt keine `frames` einer Kamera: von Hand teachen
server-teach-no-program = kein Programm ist geladen: seine Naht gibt die Sollfuge vor
server-teach-is-open = eine Sitzung ist offen: zuerst beenden
server-teach-not-open = keine Sitzung ist offen
server-teach-not-asked = die Position der Fuge wird jetzt nicht gebraucht
server-teach-not-paused = nichts ist unterbrochen
server-teach-far = die Position liegt nicht an der Sollnaht; erlaubt: bis 15 mm davon
server-teach-start-far = der Anfang liegt nicht an der Sollnaht
server-teach-other-machine = { $job } ist für { $machine }, nicht für diese Zelle
server-teach-no-frames = die Geräte der Maschine sind echt, und sensors.{ $sensor } hat keine `frames`
server-teach-no-camera = { $machine } hat keine Kamera; erlaubt: eine Maschine mit [sensors.NAME] und kind = "camera" in ihrer Datei
server-teach-sensor-no-camera = { $sensor } ist keine Kamera
server-teach-blocked = die Zelle hat die Achsen unterwegs angehalten: siehe Alarme
server-camera-address = die Maschinendatei nennt eine Kamera unter { $address }, mit der sich diese Zelle nicht verbindet; erlaubt: dieser Rechner; weitere mit `seamwright serve --camera HOST:PORT`
server-camera-address-list = die Maschinendatei nennt eine Kamera unter { $address }, mit der sich diese Zelle nicht verbindet; erlaubt: dieser Rechner, { $allowed }; weitere mit `seamwright serve --camera HOST:PORT`

# Audit log: where from, what, and result.
server-audit-panel = Panel
server-audit-panel-number = Panel { $number }
server-audit-panel-at = Panel auf { $address }
server-audit-save-job = Auftrag { $job } speichern
server-audit-delete-job = Auftrag { $job } löschen
server-audit-load = { $job } laden
server-audit-change-user = Benutzer { $user } ändern
server-audit-delete-user = Benutzer { $user } löschen
server-audit-own-password = eigenes Passwort
server-audit-log-in = anmelden
server-audit-log-out = abmelden
server-audit-backup = Sicherung herunterladen
server-audit-restore = wiederherstellen
server-audit-check-archive = Sicherung prüfen
server-audit-set-axis = Achse { $name } in { $file } ändern
server-audit-set-tool = Werkzeug { $name } in { $file } ändern
server-audit-set-sensor = Sensor { $name } in { $file } ändern
server-audit-shelve = Alarm { $alarm } { $detail } für { $minutes } min zurückstellen
server-audit-override = Override { $override }
server-audit-acknowledge = quittieren: { $alarm }
server-audit-weld = Schweißung { $weld }, Werkstück „{ $part }“
server-audit-others = weitere
server-audit-teach = Teachen: { $order }
server-audit-teach-open = Kamera starten: Schritt { $step }, Lücken bis { $tacks }, Startwert { $seed }
server-audit-teach-open-tack = Kamera starten: Schritt { $step }, Lücken bis { $tacks }, Startwert { $seed }, eine Heftstelle von { $from } bis { $to }
server-audit-teach-pixel = Fuge ist hier: Pixel { $x }, { $y }
server-audit-teach-point = Fuge ist hier: X { $x } Y { $y } Z { $z }
server-audit-teach-middle = Fuge ist am Kreuz der Kamera
server-audit-teach-end = Fuge endet hier
server-audit-teach-pause = unterbrechen
server-audit-teach-resume = fortsetzen
server-audit-teach-stop = beenden
server-audit-accepted = angenommen
server-audit-saved = gespeichert
server-audit-deleted = gelöscht
server-audit-changed = geändert
server-audit-kept = gespeichert
server-audit-begun = begonnen
server-audit-checked = geprüft
server-audit-loaded = geladen
server-audit-logged-in = angemeldet
server-audit-logged-out = abgemeldet
server-audit-refused = abgelehnt
server-audit-refused-role = abgelehnt: Rolle erlaubt es nicht
server-audit-reweld = Fertiges darf wieder geschweißt werden
server-audit-raised-again = wieder ausgelöst
server-audit-several = mehrere Anfragen
server-audit-kind = { $command }: { $result } ({ $n })
server-audit-refused-sum = { $n } abgelehnte Anfragen, die erste { $first }, die letzte { $last }: { $kinds }
server-audit-repeated-sum = { $n } wiederholte Anfragen, die erste { $first }, die letzte { $last }: { $kinds }
server-audit-left-out = { $n } Einträge wurden ausgelassen, zwischen { $first } und { $last }

# Events.
server-event-left = Lage { $pass } wurde verlassen, geschweißt bis { $s }
server-event-mode = { $from } -> { $to }
server-event-order = { $order }
server-event-refused = { $order }: { $reason }
server-event-alarm = { $alarm }: { $reaction }
server-event-alarm-of = { $alarm } ({ $object }): { $reaction }
server-event-alarm-before = { $alarm } vom { $time } wurde vor dem Ende nicht quittiert
server-event-cleared = { $alarm } ist vorbei
server-event-cleared-of = { $alarm } ({ $object }) ist vorbei
server-event-pass-ends = Lage { $pass } endet bei { $s }
server-event-left-before = Schweißung { $weld } wurde durch Ausfall von Strom oder Programm verlassen: vor dem Fortsetzen das Raupenende ansehen
server-event-stopped-by = Die Zelle wurde gestoppt durch { $cause }
server-event-cycles-missed = { $cycles } Takte wurden ausgelassen, bis zu { $longest } am Stück
server-event-no-realtime = Der Takt läuft ohne Echtzeitrechte: { $reason }
server-event-safe-by-panel = { $device }: das Panel hat die sicheren Ausgänge geschrieben, Lichtbogen oder Strahl zuerst, weil die Zelle schweigt
server-event-safe-unconfirmed = { $device }: Sichere Ausgänge sind nicht bestätigt: { $reason }
server-event-journal-damaged = Das Positionsjournal ist beschädigt: Eine durch Stromausfall abgebrochene Schweißung wäre nicht bekannt; Werkstück prüfen, dann referenzieren
server-event-weld-lost = Schweißung { $weld } hat Dateien, steht aber nicht in der Bibliothek: Die Bibliothek ist beschädigt, der Eintrag ging verloren
server-event-recorded = Schweißung { $weld } aufgezeichnet: { $result }
server-event-record-not-whole = Schweißung { $weld }: das Protokoll ist unvollständig: { $reason }
server-event-record-interrupted = Schweißung { $weld } wurde unterbrochen; ihr Protokoll ist wieder vollständig
server-event-record-fails = das Protokoll kann nicht geschrieben werden: { $reason }
server-event-not-recorded = diese Schweißung wird nicht aufgezeichnet: { $reason }
server-event-audit-fails = das Bedienprotokoll kann nicht geschrieben werden: { $reason }; wartend: { $n }
server-event-audit-hangs = der Datenträger des Bedienprotokolls antwortet nicht; wartend: { $n }
server-event-audit-stored = das Bedienprotokoll wird wieder geschrieben; gewartet haben { $n } Einträge
server-event-audit-left-out = { $n } Einträge des Bedienprotokolls sind verloren: es warteten zu viele
server-event-syslog-fails = der Syslog-Empfänger { $receiver } ist nicht erreichbar: { $reason }; wartend: { $n }
server-event-syslog-sends = der Syslog-Empfänger { $receiver } ist wieder erreichbar; nicht gesendet: { $n }
server-event-restored = alle Daten wurden wiederhergestellt; was vorher da war, ist in { $folder }
server-event-control-taken = Bedienung übernommen
server-event-control-taken-over = Bedienung von anderen übernommen
server-event-control-lost = Bedienung verloren: Panel antwortet nicht
server-event-loaded = geladen: { $job }
server-event-not-loaded = nichts ist geladen: { $reason }
server-event-teach-ended = Teachen von { $job } beendet: { $result }
server-event-shelved = { $alarm } für { $minutes } min zurückgestellt
server-event-unshelved = { $alarm } ist nicht mehr zurückgestellt
server-event-machine-changed = { $subject } in { $file } geändert: wirksam, sobald ein Auftrag dieser Maschine neu geladen wird
server-event-tool-changed = Spitze von { $head } in { $file } geändert: wirksam, sobald ein Auftrag dieser Maschine neu geladen wird
server-event-sensor-changed = Sensor { $sensor } in { $file } geändert: wirksam, sobald ein Auftrag dieser Maschine neu geladen wird
server-event-cell-lost = die Zelle ist gestorben: { $reason }
server-event-cell-restarted = eine neue Zelle ist gestartet: aus, ohne Programm; ihre Geräte sind verbunden
server-event-cell-not-restarted = keine neue Zelle ließ sich starten: { $reason }
server-cell-dies-often = die Zelle ist { $n }-mal in zehn Minuten gestorben
server-event-cell-found = laufende Zelle mit Programm gefunden: { $job }

# Log.
server-log-starts = Seamwright { $version } bedient { $address }
server-log-restores = alle Daten wurden wiederhergestellt: die Zelle beginnt neu
server-log-ends = der Server wird beendet
server-log-logged-in = { $user } hat sich von { $address } angemeldet
server-log-refused = abgelehnt in { $time }: { $kind }: { $n }
server-log-worker-starts = Prozess { $pid } beginnt: { $question }
server-log-worker-ended = Prozess { $pid } endete nach { $time }: { $question }
server-log-worker-killed = Prozess { $pid } wurde nach { $time } beendet: { $question }: { $reason }
server-log-disk-slow = { $folder }: ein kleiner Schreibvorgang dauerte { $time }
server-log-ready = die Zelle ist bereit
server-log-not-ready = die Zelle ist nicht bereit: { $reasons }
server-log-cycle-hangs = der Takt kommt nicht zum Ende: prüfen, ob Lichtbogen, Gas und Antriebe aus sind
server-log-record-open = das Protokoll der letzten Schweißung wurde nicht geschlossen: der nächste Start vervollständigt es
server-log-certificate-fails = das Zertifikat wird nicht erneuert: { $reason }
server-log-authority = die Zertifizierungsstelle der Zelle gilt bis { $until }: { $file } in Browsern installieren
server-log-browsers-unknown = { $file }: { $reason }: Browser werden neu gemerkt
server-log-browsers-not-kept = bekannte Browser werden nicht gespeichert: { $reason }
server-log-left-out = { $n } Protokollzeilen wurden ausgelassen

# Readiness and monitoring.
server-not-ready-cell-starts = die Zelle startet
server-not-ready-cell = die Zelle hat seit { $age } nicht geantwortet
server-not-ready-disk-silent = die Platte von { $folder } hat seit { $age } nicht geantwortet
server-not-ready-disk-unknown = die Platte von { $folder } wird geprüft
server-not-ready-disk-full = die Platte von { $folder } hat nur { $free } frei; nötig sind { $needed }
server-not-ready-library = die Bibliothek der Protokolle kann nicht geschrieben werden: { $reason }
server-monitor-login = anmelden, das Token von `--monitor-token` senden oder von diesem Rechner aus fragen
server-log-cycle-failed = der Zyklus der Zelle ist ausgefallen
server-log-entry-refused = die Bibliothek weist einen Eintrag des Prüfprotokolls ab: { $reason }: { $entry }
server-log-waiting-file = wartende Einträge des Prüfprotokolls sind gespeichert, aber ihre Datei lässt sich nicht leeren: { $reason }
