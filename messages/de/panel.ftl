# Words of the panel, in the order of its pages.

# Words for several pages.
panel-least = Min.
panel-mean = Mittel
panel-greatest = Max.
panel-allowed = Zulässig
panel-program = Programm
panel-pass = Lage
panel-alarm = Alarm
panel-language = Sprache
panel-tabs = Reiter
panel-cancel = Abbrechen
panel-close = Schließen
panel-search = Suchen
panel-all = Alle
panel-on = ein
panel-off = aus
panel-undo = Rückgängig
panel-redo = Wiederholen
panel-set = Soll
panel-actual = Ist
panel-abort = Abbruch
panel-stop = STOP: Software-Stopp
panel-mode = Zustand
panel-armed = Freigegeben
panel-recording = Protokoll { $weld }
panel-simulated = simuliert
panel-commands = Befehle
panel-refused = Abgelehnt:
panel-why = Warum kein Start?
panel-passes = Lagen
panel-progress = Fortschritt
panel-time-left = noch { $time }
panel-readouts = Anzeigen
panel-process = Prozess
panel-gas = Gas
panel-speed = Geschwindigkeit
panel-override = Override
panel-bottom = Alarme und Kurven
panel-scene = Die Zelle in 3D
panel-clearance = Abstand
panel-section = Querschnitt der Fuge
panel-axis = Achse
panel-conditions = Bedingungen (Verriegelungen)
panel-condition = Bedingung

# Alarms.
panel-alarm-cause = Ursache
panel-alarm-state = Zustand
panel-alarm-consequence = Folge
panel-alarm-action = Was tun
panel-alarm-reaction = Reaktion
panel-alarm-priority = Priorität
panel-alarm-severity = Schwere
panel-alarm-response = Reaktionszeit
panel-alarm-shelvable = Zurückstellen
panel-alarm-chattering = FLATTERT
panel-alarm-first = ERSTER
panel-alarm-one = Diesen Alarm quittieren
panel-alarm-shelve = Zurückstellen
panel-alarm-shelve-for = Zurückstellen für
panel-alarm-minutes = { $minutes } min
panel-alarm-unshelve = Zurückholen
panel-alarm-shelved = Zurückgestellt: { $alarm }
panel-alarm-until = bis { $time }, von { $user }
panel-alarm-shelve-how = Zurückgestellt wird nur, was bloß meldet; was anhält oder stoppt, ist immer zu sehen.

# Process values.
panel-value-tip-speed = Geschwindigkeit der Spitze
panel-value-speed = Geschwindigkeit der Spitze

# States.
panel-mode-off = Aus
panel-mode-idle = Nicht referenziert
panel-mode-homing = Referenzfahrt
panel-mode-ready = Bereit
panel-mode-jog = Tippbetrieb
panel-mode-teach = Teachen
panel-mode-dry-run = Probelauf
panel-mode-weld = Schweißen
panel-mode-hold = Halt
panel-mode-fault = Störung

# Commands.
panel-do-hold = Halt
panel-do-resume = Weiter
panel-do-reverse = Rückwärts
panel-do-stop = Stopp
panel-do-switch-on = Einschalten
panel-do-switch-off = Ausschalten
panel-do-home = Referenz
panel-do-start-jog = Tippbetrieb beginnen
panel-do-start-teach = Teachen beginnen
panel-do-start-dry-run = Probelauf
panel-do-arm = Bogen freigeben
panel-do-arm-beam = Strahl freigeben
panel-do-start-weld = Schweißung starten
panel-do-start-beam = Schweißung starten
panel-do-reset = Störung zurücksetzen
panel-do-acknowledge = Alle quittieren
panel-do-override = Override ändern
panel-do-acknowledge-one = Einen Alarm quittieren
panel-do-home-axis = Eine Achse in Grundstellung

# Interlocks of supplied machines.
panel-interlock-emergency-stop-chain = Not-Halt-Kette
panel-interlock-light-curtain = Lichtvorhang
panel-interlock-shielding-gas = Schutzgas
panel-interlock-torch-coolant = Brennerkühlung
panel-interlock-doors = Türen
panel-interlock-cooling-water = Kühlwasser
panel-interlock-gun-pressure = Druck in der Kanone
panel-interlock-chamber-pressure = Kammerdruck
panel-interlock-chamber-door = Kammertür
panel-interlock-laser-interlocks = Laserverriegelung
panel-interlock-cabin-doors = Kabinentüren

# Records.
panel-record-part = Werkstück
panel-record-begun = Beginn
panel-record-machine = Maschine
panel-record-procedure = Schweißanweisung
panel-record-welder = Schweißer
panel-record-list = Protokolle
panel-record-no-hit = Keine passenden Protokolle.
panel-record-none = Noch keine Schweißungen.
panel-record-no = Nr.
panel-record-result = Ergebnis
panel-record-worst = Max. Abweichung
panel-record-outside = außerhalb auf { $length } mm
panel-record-from = Ab
panel-record-compare = Vergleichen
panel-record-report = Bericht
panel-record-facts = Übersicht
panel-record-trace = Aufzeichnung
panel-record-columns = Signale wählen
panel-record-no-values = Davon gibt es in dieser Lage keine Werte.

# Events.
panel-event-time = Zeit
panel-event-text = Ereignis
panel-event-what = Was
panel-event-mode = Zustand
panel-event-order = Befehl
panel-event-refused = Abgelehnt
panel-event-alarm = Alarm
panel-event-cleared = Behoben
panel-event-pass = Lage
panel-event-left = Verlassen
panel-event-record = Protokoll
panel-event-control = Bedienung
panel-event-work = Programm
panel-event-teach = Teachen

# Bottom.
panel-bottom-alarms = Alarme
panel-bottom-events = Ereignisse
panel-bottom-plots = Kurven
panel-bottom-tracking = Verfolgung

# Jobs.
panel-job-head = Auftrag
panel-job-list = Aufträge
panel-job-own = Meine Aufträge
panel-job-examples = Vorlagen
panel-job-example = Vorlage – als eigenen Auftrag speichern
panel-job-title = Titel
panel-job-name-how = Buchstaben A–Z, Ziffern und . _ -
panel-job-name = Name
panel-job-open = Öffnen
panel-job-use = Neu aus Vorlage
panel-job-load = Laden
panel-job-loaded = geladen
panel-job-part = Werkstücknummer (fürs Protokoll)
panel-job-part-why = Das Programm wird geplant, geprüft und in die Zelle geladen. Nichts bewegt sich.
panel-job-lies = Simulierte Fehllage
panel-job-lies-planned = keine
panel-job-lies-why = Bei Fehllage wird die Naht verfolgt.
panel-job-delete = Löschen
panel-job-delete-sure = { $job } löschen? Das lässt sich nicht rückgängig machen.
panel-job-save = Speichern
panel-job-save-as = Speichern als …
panel-job-unsaved = nicht gespeichert
panel-job-leave = Es gibt ungespeicherte Änderungen.
panel-job-discard = Änderungen verwerfen
panel-job-replace = Ersetzen
panel-job-other = Unter { $job } ist schon ein anderer Text gespeichert: der eines anderen Auftrags, oder inzwischen von jemandem geändert. Diesen an seine Stelle setzen?
panel-job-edit = Bearbeiten
panel-job-preview = Vorschau
panel-job-form = Formular
panel-job-parts = Werkstück und Vorrichtungen
panel-job-points = Punkte
panel-job-text = Text
panel-job-post = G-Code
panel-job-findings = Befunde
panel-job-section = Querschnitt
panel-job-plots = Kurven
panel-job-limits = Grenzen

# Tracking.
panel-track-lateral = Seitlich
panel-track-height = Höhe
panel-track-head = Kopf
panel-track-none = Nahtverfolgung aus
panel-track-confidence = Konfidenz
panel-track-sigma = Standardabw.
panel-track-guessed = nicht gesehen

# Pages.
panel-tab-weld = Schweißen
panel-tab-teach = Tippen · Teachen
panel-tab-jobs = Aufträge
panel-tab-records = Protokolle
panel-tab-setup = Einrichten

panel-theme-light = Hell
panel-theme-dark = Dunkel

# Connection.
panel-link-opening = Verbinde …
panel-link-open = Verbunden
panel-link-closed = Keine Verbindung
panel-link-stale = Daten { $age } s alt

# Log-in.
panel-login-user = Benutzer
panel-login-password = Passwort
panel-login-go = Anmelden
panel-login-out = Abmelden
panel-login-over = Die Sitzung ist zu Ende: geschlossen, geändert oder zu alt. Was in der Zelle läuft, läuft weiter; STOP wirkt auch hier. Neu anmelden.
panel-login-runs = In der Zelle läuft etwas, und es läuft ohne Sie weiter.
panel-login-stopped = STOP ist gesendet; Zustand in dem Moment: { $state }.
panel-login-made = Nun als dieser Benutzer anmelden. Der Startlink gilt nicht mehr.
panel-login-wrong = Benutzer oder Passwort ist falsch.
panel-login-key = Erster Start: den Startlink öffnen, den das Programm ausgegeben hat.
panel-login-owner = Eigentümer

# Control.
panel-control-mine = Bedienung: Sie
panel-control-give = Bedienung abgeben
panel-control-take = Bedienung nehmen
panel-control-free = Bedienung frei
panel-control-unknown = Bedienung unbekannt
panel-control-theirs = Bedienung: { $user } (Station { $station })
panel-control-over = { $user } hat die Bedienung. Bedienung wegnehmen?
panel-control-needed = Zum Bedienen dieser Zelle die Bedienung nehmen.

# Roles.
panel-role-viewer = Zuschauer
panel-role-operator = Bediener
panel-role-programmer = Programmierer
panel-role-service = Service
panel-role-admin = Administrator

# STOP.
panel-stop-failed = STOP HAT DIE ZELLE NICHT ERREICHT
panel-stop-emergency = Not-Halt drücken.
panel-stop-late = STOP hat die Zelle spät erreicht
panel-stop-check = Prüfen, ob die Maschine steht und der Prozess aus ist.
panel-stop-unanswered = Die Seite ist verbunden, aber die Zelle hat nicht sichtbar rechtzeitig angehalten.
panel-stop-no-connection = Keine Verbindung zur Zelle. Diese Seite versucht weiter, sie aufzubauen.
panel-stop-read = Gelesen

# Process.
panel-process-arc-on = LICHTBOGEN EIN
panel-process-beam-on = STRAHL EIN
panel-process-arc-off = Lichtbogen aus
panel-process-beam-off = Strahl aus
panel-process-ordered = EIN befohlen

# Phases of a pass.
panel-phase-held = in Ruhe
panel-phase-preflow = Gasvorströmung
panel-phase-travel-delay = Startverzögerung
panel-phase-travel = Schweißen
panel-phase-run-out = Auslauf
panel-phase-crater = Kraterfüllen
panel-phase-postflow = Gasnachströmung
panel-phase-move = Verfahrweg
panel-phase-ended = fertig

panel-timing-no-realtime = Keine Echtzeitrechte
panel-timing-missed = { $cycles } Takte ausgefallen, höchstens { $longest } ms

# Program.
panel-work-none = Kein Programm geladen
panel-work-part = Werkstück { $part }
panel-work-load-again = Von hier neu planen
panel-work-load-first = Unter „Aufträge“ ein Programm laden.

# Why can't I start?.
panel-why-for = Es fehlt für „{ $command }“
panel-why-nothing = { $command }: startbereit.
panel-why-runs = Es läuft.

# Interlocks and permissives: why a command is refused.
panel-lack-moving = Die Achsen stehen noch nicht: kurz warten.
panel-lack-lost = Die Verbindung ging verloren. Kein Befehl wird selbsttätig wiederholt.

# Roles of passes.
panel-pass-role-tack = Heftstelle
panel-pass-role-root = Wurzel
panel-pass-role-fill = Fülllage
panel-pass-role-cap = Decklage
panel-pass-role-cosmetic = Glättlage

# Unfinished welds.
panel-left-button = Lage { $pass } bei { $s } mm fortsetzen …
panel-left-elsewhere = Schweißung { $weld } ({ $title }, Werkstück { $part }) ist unvollendet: Lage { $pass }, { $s } mm. Zum Fortsetzen ihren Auftrag und ihr Werkstück laden.
panel-left-title = Fortsetzen, wo die Schweißung verlassen wurde
panel-left-of = Schweißung { $weld }: { $title }, Werkstück { $part }.
panel-left-where = Gestoppt in Lage { $pass }, geschweißt bis { $s } mm.
panel-left-overlap = Überlappung, mm
panel-left-from = Beginnt wieder in Lage { $pass } bei { $s } mm.
panel-left-ground = Krater ausgeschliffen und besichtigt
panel-left-arm = Nichts startet von selbst: danach wie üblich freigeben und starten.
panel-left-go = Von dort laden

# Welding again.
panel-again-title = Fertiges noch einmal schweißen?
panel-again-left = Um stattdessen fortzusetzen: abbrechen und „Lage { $pass } fortsetzen“ drücken (verlassen bei { $s } mm).
panel-again-go = Noch einmal schweißen

# Positions.
panel-position-tip = Werkzeugspitze (Werkstücksystem)
panel-position-tip-in = Werkzeugspitze ({ $frame })
panel-position-machine = Maschinenachsen
panel-position-unreferenced = nicht referenziert

panel-override-less = Override kleiner
panel-override-more = Override größer

# Plots.
panel-plot-path = Bahngeschwindigkeit
panel-plot-greatest = Max. Schleppfehler
panel-plot-position = Position
panel-plot-axis = Achse
panel-plot-choose = Kurven wählen
panel-plot-speed = Geschwindigkeit
panel-plot-error = Schleppfehler
panel-plot-deviation = Fugenabweichung
panel-plot-seen = gesehen
panel-plot-done = korrigiert

# State of tracking.
panel-sight-seen = Fuge gefunden
panel-sight-bridged = Fuge gefunden, Heftstelle überbrückt
panel-sight-coasted = Keine Sicht, hält Korrektur
panel-sight-fading = Keine Sicht, zurück zum Plan
panel-sight-unseen = Noch keine Sicht
panel-sight-lost = Fuge verloren

# Alarms.
panel-alarms-none = Keine Alarme
panel-alarms-unknown = Alarme unbekannt: keine aktuellen Daten
panel-alarms-more = und { $n } weitere

# Alarm state.
panel-alarm-state-unacknowledged = aktiv
panel-alarm-state-acknowledged = aktiv, quittiert
panel-alarm-state-returned = behoben, nicht quittiert
panel-alarm-state-gone = behoben, zurückgestellt

# Reactions.
panel-reaction-told = nur Meldung
panel-reaction-hold = hält an
panel-reaction-process-off-hold = Prozess aus, Halt
panel-reaction-process-off-stop-power-off = Prozess aus, Stopp, Spannung aus
panel-reaction-process-and-power-off = Prozess und Spannung aus

# Devices.
panel-device-drives = Antriebe
panel-device-source = Prozessquelle
panel-device-process-source = Prozessquelle
panel-device-inputs = Eingänge

# 3D view.
panel-scene-fails = Dieser Browser kann kein 3D zeigen (WebGL 2).
panel-scene-views = Ansichten
panel-scene-show = Anzeige
panel-scene-colour = Lagen gefärbt nach
panel-scene-cut = Schnittebene
panel-scene-measure = Messen
panel-scene-heat = Streckenenergie
panel-scene-no-heat = Streckenenergie unbekannt: Das Programm nennt weder Strom und Spannung noch Leistung.
panel-scene-no-value = Für dieses Programm nicht bekannt.
panel-scene-off-beam = Strahlabweichung
panel-scene-off-torch = Abweichung
panel-scene-measure-how = Zwei Stellen wählen.

panel-spot-span = Abschnitt
panel-spot-pass = Ganze Lage

panel-clearance-least = (min. { $min } mm)

# Views.
panel-view-fit = Einpassen
panel-view-fit-how = Die Naht; noch einmal: alles
panel-view-top = Oben
panel-view-front = Vorn
panel-view-side = Seite
panel-view-torch = Brenner

# Layers.
panel-layer-machine = Maschine
panel-layer-part = Werkstück, Vorrichtung
panel-layer-zones = Zonen
panel-layer-air = Verfahrwege
panel-layer-near = Engste Stelle
panel-layer-sensors = Sensorfelder
panel-layer-trace = Spur der Spitze

# Jogging.
panel-jog-frame = Bezug
panel-jog-joints = Achsen
panel-jog-tip = Brennerspitze
panel-jog-turn = Um die Spitze
panel-jog-turn-how = Dreht den Brenner um die ruhende Spitze.
panel-jog-speed = Tippgeschwindigkeit
panel-jog-end = Tippbetrieb beenden
panel-jog-how = Fährt, solange gedrückt. Pfeiltasten: erste zwei Zeilen, Bildtasten: dritte.
panel-jog-step = Schrittweite
panel-jog-held = stetig
panel-jog-step-how = Ein Schritt von { $step } mm oder Grad je Druck; losgelassen endet er früher.

# Go to.
panel-go-title = Fahren zu
panel-go-begin = Anfang von Lage { $pass }
panel-go-spot = Gewählter Punkt
panel-go-home = Grundstellung
panel-go-how = Alle Achsen fahren, solange gedrückt, und kommen zugleich an. Ein kollisionsfreier Weg wird nicht geplant: Die Zelle hält vor Hindernissen an.
panel-frame-title = Koordinatensystem
panel-frame-work = Werkstück
panel-frame-base = Basis
panel-frame-tool = Werkzeug
panel-frame-flange = Flansch
panel-frames-kind-base = Basis
panel-frames-kind-mount = Zwischenstück
panel-frames-kind-flange = Flansch
panel-frames-kind-adapter = Zwischenflansch
panel-frames-kind-tool = Werkzeug
panel-frames-kind-tcp = Werkzeugspitze (TCP)
panel-frames-kind-table = Positionierer
panel-frames-kind-work = Werkstück
panel-frames-within-base = in der Basis
panel-frames-within-flange = im Flansch
panel-frames-within-work = im Werkstücksystem, alle Achsen auf null
panel-frames-within-before = im System davor
panel-frames-how = Positionen in mm. Die Spitze selbst findet man unter Werkzeug. Eine Änderung steht in { $file }; der frühere Stand bleibt daneben.
panel-frames-change = Ändern
panel-frames-keep = Speichern
panel-frames-remove = Entfernen
panel-frames-was = vorher: { $frame }
panel-frames-back = Früheren Stand zurückholen
panel-frames-new = Neues Benutzersystem
panel-frames-taken = Dieser Name ist vergeben.
panel-frames-teach = Mit drei Punkten anlernen
panel-frames-teach-how = Unter Tippen die Spitze an jeden Punkt bringen und hier aufnehmen. Das System steht in der Basis.
panel-frames-point-1 = Ursprung
panel-frames-point-2 = Punkt auf der x-Achse
panel-frames-point-3 = Punkt auf der Seite von y
panel-frames-record = Aufnehmen
panel-frames-jog = Zum Aufnehmen den Tippbetrieb starten.
panel-frames-taught = Punkte { $distance } mm auseinander, { $angle }° dazwischen
panel-frames-large = Große Änderung: { $distance } mm, { $angle }°. Zum Bestätigen noch einmal speichern.
panel-rotation-title = Orientierung
panel-rotation-kept = wie sie ist
panel-rotation-xyz = RX RY RZ (feste Achsen X, Y, Z)
panel-rotation-abc = A B C (Achsen Z, Y, X, mitgedreht)
panel-rotation-quaternion = Quaternion Q1 bis Q4
panel-rotation-next = Orientierung in anderer Schreibweise zeigen
panel-rotation-none = Die Zahlen sind keine Orientierung: Die Quadrate der Zahlen einer Quaternion ergeben zusammen 1.
panel-target-title = Ziel eingeben
panel-target-present = Jetzige Position
panel-target-check = Prüfen
panel-target-go = Hinfahren (halten)
panel-target-clear = unterwegs nichts in der Nähe
panel-target-missed = Der Brenner verfehlt diese Richtung um { $angle }°: Der Maschine fehlen Achsen dafür.
panel-target-how = Prüfen zeigt Ziel, Weg und Abstand in 3D, bevor sich etwas bewegt. Im Werkzeug-System sind die Zahlen relativ.
panel-arm-title = Stellung
panel-arm-shoulder-front = Vorn
panel-arm-shoulder-back = Hinten
panel-arm-elbow-up = Ellbogen oben
panel-arm-elbow-down = Ellbogen unten
panel-arm-wrist-no-flip = Hand nicht gekippt
panel-arm-wrist-flip = Hand gekippt
panel-arm-turns = Umdr. { $turns }
panel-arm-no-turns = Umdr. 0
panel-arm-turns-how = Ganze Umdrehungen der Achsen 1 bis 6 über 180 Grad hinaus
panel-arm-near-shoulder = nahe der Schulter-Singularität
panel-arm-near-elbow = nahe der Ellbogen-Singularität
panel-arm-near-wrist = nahe der Hand-Singularität
panel-job-reach = Reichweite
panel-reach-moved = Bewegt wird
panel-reach-work = Werkstück
panel-reach-base = Maschinenfuß
panel-reach-budget = Zeit
panel-reach-search = Besten Platz suchen
panel-reach-from = von
panel-reach-to = bis
panel-reach-cells = Plätze
panel-reach-how = { $n } Plätze um den jetzigen. Die Reserve ist der kleinste Abstand einer Achse vom Ende ihres Bereichs.
panel-reach-too-many = { $n } Plätze; höchstens { $max }.
panel-reach-judged = { $done } von { $total } Plätzen beurteilt
panel-reach-refines = Bester Platz wird verfeinert und geplant
panel-reach-best = Bester Platz
panel-reach-margin = Reserve
panel-reach-apply = In den Auftrag übernehmen
panel-reach-is-best = Der jetzige Platz ist der beste.
panel-reach-none = An keinem Platz dieser Bereiche lässt sich schweißen und planen.
panel-reach-base-how = Der Maschinenfuß wird in der Maschinendatei bewegt: { $key } = { $move } mm, Drehung { $angle }°.
panel-reach-changed = Der Auftrag wurde nach der Suche geändert: noch einmal suchen.
panel-reach-cut-off = Die Zeit war um, bevor alles beurteilt war: bisher bester Platz.
panel-reach-failed = Nicht planbar bei { $place }: { $reason }
panel-reach-weldable = An { $n } von { $total } beurteilten Plätzen lässt sich schweißen.
panel-reach-map = Reserve über x und y
panel-reach-legend = Zahlen: Reserve in Prozent. Schraffiert: nicht schweißbar, mit der Achse, an der es liegt. ○ jetziger Platz, ★ bester.
panel-arm-from = ab { $s } mm
panel-schedule-title = Serien
panel-schedule-jobs = Aufträge
panel-schedule-import = Tabelle einlesen
panel-schedule-import-how = CSV oder TOML mit einer Zeile je Naht: eine Vorlage, ihre geänderten Werte und die Maschinen, die sie schweißen dürfen. Dateien in jobs/schedules des Datenordners stehen auch in der Liste.
panel-schedule-none = Noch keine Tabelle.
panel-schedule-open = Öffnen
panel-schedule-delete = Die Tabelle mit ihren Ergebnissen löschen?
panel-schedule-replace = { $name } gibt es schon. Ersetzen? Zeilen, die gleich bleiben, behalten ihre Ergebnisse.
panel-schedule-run = Alle Zeilen planen
panel-schedule-go-on = Fehlende Zeilen planen
panel-schedule-post = Teileprogramme
panel-schedule-no-post = keine
panel-schedule-limit = Zeitgrenze je Plan
panel-schedule-progress = { $done } von { $total } Zeilen
panel-schedule-kept = { $kept } waren schon geplant
panel-schedule-rate = { $rate } Zeilen/min
panel-schedule-counting = Tabelle wird gelesen
panel-schedule-other = { $name } wird gerade geplant; nur eine Tabelle auf einmal.
panel-schedule-failed = Der letzte Lauf endete vorzeitig: { $why }
panel-schedule-planned = geplant
panel-schedule-new = nicht geplant
panel-schedule-filter = Zeigen
panel-schedule-all = alle
panel-schedule-of = { $n } von { $total } Zeilen
panel-schedule-more = { $n } weitere Zeilen stehen in den Ergebnisdateien.
panel-schedule-row = Zeile
panel-schedule-name = Naht
panel-schedule-status = Ergebnis
panel-schedule-machine = Maschine
panel-schedule-count = Teile
panel-schedule-passes = Lagen
panel-schedule-time = Zeit, min
panel-schedule-arc = Lichtbogen, min
panel-schedule-wire = Draht, kg
panel-schedule-clearance = Abstand, mm
panel-schedule-reason = Befunde
panel-schedule-job = Als Auftrag öffnen
panel-schedule-parts-of = Teile auf den Maschinen
panel-schedule-gantt-how = Schraffiert: Rüsten. Ein Druck auf ein Teil zeigt seine Zeile.
panel-schedule-total = { $parts } Teile · { $weld } h Schweißen · letztes Teil nach { $end } h
panel-schedule-export = Ausgeben
panel-schedule-export-how = Die Dateien werden geschrieben, wenn alle Zeilen geplant sind.
panel-schedule-report = Bericht
panel-schedule-waiting = wartet
panel-schedule-weldable = schweißbar
panel-schedule-not-weldable = nicht schweißbar
panel-schedule-out-of-time = Zeit um
panel-schedule-invalid = ungültig
panel-schedule-invalid-table = Die Tabelle hat einen Fehler: { $why }

# Teaching by camera.
panel-teach-by = Teachen
panel-teach-by-hand = Von Hand
panel-teach-by-eye = Mit Kamera
panel-teach-open = Kamera starten
panel-teach-pause = Anhalten
panel-teach-resume = Fortsetzen
panel-teach-stop = Teachen beenden
panel-teach-here-spot = Fuge ist an der Stelle aus 3D
panel-teach-here-begin = Fuge beginnt, wo das Programm beginnt
panel-teach-here-eye = Fuge ist unter dem Kreuz
panel-teach-here-how = Fuge im Bild antippen, in 3D wählen oder das Kreuz darauf fahren. Die Maschine bewegt sich dann.
panel-teach-end-here = Die Fuge endet hier
panel-teach-picture = Kamerabild
panel-teach-no-picture = Noch kein Bild
panel-teach-way = { $done } von { $length } mm
panel-teach-confidence = Konfidenz
panel-teach-least = Min.
panel-teach-frames = Bilder
panel-teach-step = Schritt, mm
panel-teach-tack = Lücken überbrücken bis, mm
panel-teach-seed = Startwert
panel-teach-points = Geteachte Punkte
panel-teach-tolerance = Toleranz, mm
panel-teach-method = Kurven
panel-teach-greedy = Geraden, Bögen
panel-teach-fewest = wenigste Geraden, Bögen
panel-teach-spline = Spline
panel-teach-make = Kurven anpassen
panel-teach-made = { $lines } Geraden, { $arcs } Bögen, { $splines } Splinestücke; { $length } mm
panel-teach-error = Anpassungsfehler
panel-teach-from-nominal = Fuge zum Programm: quer / hoch
panel-teach-truth = Zur wahren Fuge (simuliert)

# Teach phase.
panel-teach-phase-closed = Kamera aus
panel-teach-phase-plans = Naht wird gelesen …
panel-teach-phase-places = Auf den Anfang der Fuge zeigen. Die Maschine bewegt sich.
panel-teach-phase-runs = Folgt der Fuge
panel-teach-phase-paused = Angehalten
panel-teach-phase-asks = Fuge verloren. Zeigen, wo sie weitergeht.
panel-teach-phase-ended = Beendet

# Teach pause.
panel-teach-pause-operator = vom Bediener
panel-teach-pause-hand = Achsen von Hand bewegt
panel-teach-pause-control = diese Seite hat die Bedienung verloren
panel-teach-pause-mode = die Zelle ist nicht im Tipp- oder Teachbetrieb

# Teach end.
panel-teach-end-closed = wieder am Anfang
panel-teach-end-joint-end = am Ende der Fuge
panel-teach-end-operator = vom Bediener beendet
panel-teach-end-lost = Fuge verloren
panel-teach-end-limit = die Maschine kann nicht weiter
panel-teach-end-too-long = länger, als die Sollnaht erlaubt
panel-teach-end-out-of-frames = keine Bilder mehr
panel-teach-end-stopped = gestoppt
panel-teach-end-failed = fehlgeschlagen

# Teaching by hand.
panel-taught-title = Von Hand teachen
panel-taught-record = Punkt aufnehmen
panel-taught-clear = Leeren
panel-taught-back = { $n } Punkte zurückholen
panel-taught-of = Diese Punkte sind an { $machine } aufgenommen: für diese Maschine taugen sie nicht. Löschen Sie sie, oder laden Sie ein Programm jener Maschine.
panel-taught-remove = Punkt { $point } entfernen
panel-taught-save = Als Programm speichern
panel-taught-saved = Gespeichert: { $file }. Zu finden unter „Aufträge“.

panel-lies-misplaced = 2 mm und ein halbes Grad versetzt, wellig, zwei Heftstellen
panel-lies-half-ring = 2 mm und ein halbes Grad versetzt, oval, eine Heftstelle

# Form of a job.
panel-form-add-what = Abschnitt hinzufügen
panel-form-add = Hinzufügen
panel-form-add-key = Wert hinzufügen
panel-form-values = { $n } Werte
panel-form-in-text = Im Text zeigen
panel-form-remove = Entfernen
panel-form-kind = Art der Fuge
panel-form-procedure = Schweißanweisung (WPS)
panel-form-ships = Diese Anweisung kommt mit dem Programm. Eine eigene Kopie lässt sich ändern.
panel-form-copy = Kopie anlegen
panel-form-whose = Jeder Auftrag, der diese Datei nennt, wird an ihr gemessen.
panel-form-allowed = Erlaubt: { $allowed }
panel-form-no-number = Keine Zahl. Es bleibt { $value }.
panel-form-keep = Anweisung speichern

# Limits of the speed.
panel-bound-title = Geschwindigkeit begrenzt durch
panel-bound-at-asked = Programmierte Geschwindigkeit auf { $share } % gehalten.
panel-bound-everywhere = Grenze der Maschine: { $speed } mm/s.
panel-bound-asked = programmierte Geschwindigkeit
panel-bound-speed = Geschwindigkeit
panel-bound-acceleration = Beschleunigung
panel-bound-jerk = Ruck
panel-bound-tip = Brennerspitze
panel-bound-ends = Beschleunigen oder Bremsen
panel-bound-more = { $n } weitere Strecken stehen im Bericht.
panel-bound-used = Grenzen der Achsen und was davon gebraucht wird
panel-bound-of = ≤ { $share } % von { $limit }

# Cross-section.
panel-section-where = Stelle auf der Naht
panel-section-dihedral = Zwischen den Flächen
panel-section-gap = Stegabstand
panel-section-mismatch = Kantenversatz
panel-section-area = Fläche
panel-section-beads = Raupen
panel-section-bead = Raupe
panel-section-role = Rolle
panel-section-no-beads = Keine Raupen geplant: eine Lage entlang der Naht.
panel-section-none = Der Auftrag beschreibt keine Fuge.

# Part and fixtures.
panel-parts-add = Körper hinzufügen
panel-parts-add-go = Hinzufügen
panel-parts-shape = Form
panel-parts-as = Was es ist
panel-parts-fixture = Vorrichtung
panel-parts-part = Werkstück
panel-parts-part-why = Körper des Werkstücks kommen zu dem hinzu, das aus der Naht gemacht wird.
panel-parts-replaced = Das aus der Naht gemachte Werkstück ist ersetzt (part.replace): Kollisionen werden nur mit den Körpern unten geprüft.
panel-parts-none = Der Auftrag hat keine eigenen Körper: das Werkstück entsteht aus der Naht.
panel-parts-fixed = Wird im Text geändert.
panel-parts-unnamed = ohne Namen
panel-parts-at = Ort
panel-parts-turn = Gedreht um
panel-parts-tip = An die Brennerspitze

# Shapes.
panel-shape-box = Quader
panel-shape-cylinder = Zylinder
panel-shape-sphere = Kugel
panel-shape-cone = Kegel
panel-shape-capsule = Kapsel
panel-shape-ellipsoid = Ellipsoid
panel-shape-half-space = Halbraum

# Size.
panel-size-size = Größe
panel-size-radius = Radius
panel-size-top-radius = Radius oben
panel-size-length = Länge
panel-size-semi-axes = Halbachse

# Placing the part by touching.
panel-touch-title = Werkstück durch Antasten einmessen
panel-touch-how = Unter „Tippen · Teachen“ das Werkstück mit der Spitze antasten und mindestens { $n } Punkte aufnehmen; dann stehen sie hier.
panel-touch-other = Der Auftrag ist für eine andere Maschine als die dieser Zelle.
panel-touch-method = Verfahren
panel-touch-radius = Tasterradius, mm
panel-touch-on = Punkt { $point } liegt auf
panel-touch-go = Lage berechnen
panel-touch-moved = Das Werkstück ist verschoben um
panel-touch-rms = Punkte daneben (RMS)
panel-touch-use = In den Auftrag übernehmen

# Touch method.
panel-touch-method-best-fit = Beste Einpassung
panel-touch-method-plane-line-point = Ebene, Linie, Punkt
panel-touch-method-three-points = Ebene, Ursprung, Richtung
panel-touch-method-chuck = Futterachse: Stirn und Umfang

# Features.
panel-feature-nozzle = Stutzen / erstes Teil
panel-feature-body = Körper / zweites Teil
panel-feature-plane = Ebene z = 0
panel-feature-line = Fläche y = 0
panel-feature-point = Fläche x = 0
panel-feature-origin = Ursprung
panel-feature-direction = Stelle auf x
panel-feature-face = Stirnfläche z = 0
panel-feature-round = Umfang um z

# Plan.
panel-plan-plans = Plane …
panel-plan-cancelled = Planung abgebrochen.
panel-plan-again = Neu planen
panel-plan-wrong = Auftrag hat Fehler
panel-plan-good = Schweißbar
panel-plan-report = Bericht zum Plan
panel-plan-report-with-appendix = Bericht mit Anhang
panel-plan-before = Der Auftrag hat Fehler. Das ist der Plan vor der Änderung.
panel-plan-none = Kein Plan (siehe Befunde). Gezeigt ist die Geometrie des Auftrags.
panel-plan-line = Zeile { $line }
panel-plan-whole = Die ganze Meldung
panel-plan-bad = Wie programmiert nicht schweißbar
panel-plan-time = insgesamt { $time } s

# Kinds of findings.
panel-finding-access = Brenner hat keinen Platz
panel-finding-air = Verfahrweg ist versperrt
panel-finding-attitude = Brennerwinkel außer Toleranz
panel-finding-bead = Raupe passt nicht zur Vorgabe
panel-finding-blend = Ecke überschliffen
panel-finding-clearance = Kollision oder zu wenig Abstand
panel-finding-cooling = Abkühlzeit außerhalb des Bereichs
panel-finding-drive = Antrieb an der Stromgrenze
panel-finding-hold = Achse kann dort nicht gehalten werden
panel-finding-interpass = Wartezeit zwischen Lagen
panel-finding-jump = Achse müsste springen
panel-finding-joint = Stoß außerhalb der Norm
panel-finding-least-speed = Langsamer, als die Anweisung erlaubt
panel-finding-oscillation = Oszillation lässt Lücken
panel-finding-plausible = Wert ist nicht plausibel
panel-finding-pool = Raupe zu groß für ihre Position
panel-finding-preheat = Vorwärmung zu niedrig
panel-finding-path = Weicht von der Naht ab
panel-finding-procedure = Außerhalb der WPS-Grenzen
panel-finding-range = Achse außerhalb ihres Bereichs
panel-finding-reach = Nicht erreichbar
panel-finding-retract = Brenner wird zurückgezogen
panel-finding-ripple = Geschwindigkeit ungleichmäßig
panel-finding-singular = Nahe einer Singularität
panel-finding-speed = Programmierte Geschwindigkeit nicht erreicht
panel-finding-stop = Brenner hält unterwegs an
panel-finding-stopped = Schweißung wurde gestoppt
panel-finding-time = Dauert zu lange
panel-finding-turn = Brenner würde an einer Ecke springen
panel-finding-search = Suche ohne Plan beendet
panel-finding-unchecked = Kollisionen sind nicht geprüft
panel-finding-unwind = Achse dreht zwischen den Lagen zurück

# Part programs.
panel-post-dialect = Steuerung
panel-post-make = Teileprogramm erzeugen
panel-post-save = Herunterladen
panel-post-old = Das ist das Programm eines anderen Standes des Auftrags: neu erzeugen.
panel-post-proof = Nachprüfung

# Table of points.
panel-points-point = Punkt
panel-points-along = Bewegung
panel-points-column = Spalte
panel-points-value = Wert
panel-points-insert = Danach einfügen
panel-points-delete = Löschen ({ $n })
panel-points-set = Auf { $n } { $n ->
    [one] Punkt
   *[other] Punkte
 } anwenden
panel-points-split = Hier teilen
panel-points-several = Mehrfachauswahl
panel-points-reduce = Vereinfachen
panel-points-tolerance = Toleranz beim Vereinfachen, mm
panel-points-way = Interpolation
panel-points-way-set = Interpolation setzen ({ $n })
panel-points-why-row = Punkte wählen, die aufeinander folgen, nicht den Anfang.
panel-points-why-two = Ein Bogen wird aus zwei Punkten: durch den ersten zum zweiten.
panel-points-why-place = Diese Punkte haben keinen Ort in x, y, z, wie ihn ein Bogen braucht.
panel-points-start = Anfang

# Interpolation.
panel-along-line = Gerade
panel-along-arc = Kreisbogen
panel-along-spline = Spline
panel-along-taught = geteacht
panel-along-rapid = Eilgang
panel-along-cubic = kubisch

# Columns.
panel-column-n = Satz
panel-column-time = Zeit
panel-column-speed = Geschwindigkeit

# Signals of a record.
panel-trace-welded = Geschweißt bis
panel-trace-tip-s = Position der Spitze
panel-trace-path-error = Bahnabweichung
panel-trace-attitude-error = Fehler der Stellung
panel-trace-process-state = Zustand des Prozesses
panel-trace-burning = Bogen oder Strahl ist ein
panel-trace-steady = Gleichmäßige Fahrt
panel-trace-power = Spannung der Antriebe
panel-trace-inputs = Eingänge (Bits)
panel-trace-true = Wahrer Ort
panel-trace-deviation = Fugenabweichung
panel-trace-correction = Korrektur
panel-trace-miss = Abweichung von der Fuge
panel-trace-rows = Kurve auf { $shown } von { $samples } Werten ausgedünnt; Spitzen bleiben erhalten.
panel-trace-move = Pfeiltasten bewegen den Cursor.

# Results.
panel-result-good = gut
panel-result-deviating = außer Toleranz
panel-result-stopped = gestoppt
panel-result-interrupted = unterbrochen
panel-result-running = läuft

# Set-up.
panel-setup-machine = Maschine
panel-setup-devices = Ein- und Ausgänge
panel-setup-tuning = Einstellung
panel-setup-alarms = Alarmkatalog
panel-setup-users = Benutzer
panel-setup-audit = Bedienprotokoll
panel-setup-backup = Sicherung herunterladen
panel-setup-data = Sicherung
panel-setup-timing = Zeiten und Geräte
panel-setup-period = Takt
panel-setup-missed = Verpasste Takte
panel-setup-lost = Nicht aufgezeichnete Takte
panel-setup-age = Alter der Daten
panel-setup-status-age = Alter des Zustands
panel-setup-answers = Antwortzeit ({ $devices }): Median / max.
panel-setup-station = Station
panel-setup-sensors = Sensoren
panel-setup-parameters = Achsen und Antriebe
panel-setup-tool = Werkzeug
panel-setup-frames = Koordinatensysteme
panel-setup-pages = Seiten der Einrichtung
panel-setup-diagnostics = Diagnose

# Backup.
panel-data-backup-how = Alle Schweißungen, Aufträge, Benutzer und Protokolle als eine Datei. Schlüssel verschlüsselter Verbindungen sind nicht darin.
panel-data-restore = Wiederherstellen
panel-data-restore-how = Ersetzt alle Daten durch eine Sicherung. Die Datei wird zuerst geprüft; bis zur Bestätigung ändert sich nichts. Die jetzigen Daten bleiben in einem Ordner daneben.
panel-data-off = Zuerst die Maschine ausschalten.
panel-data-file = Sicherungsdatei (.tar)
panel-data-check = Senden und prüfen
panel-data-checks = Wird gesendet und geprüft …
panel-data-whole = Sicherung vollständig:
panel-data-welds = Schweißungen
panel-data-newest = Neueste Schweißung
panel-data-jobs = Aufträge
panel-data-users = Benutzer
panel-data-audit = Einträge im Bedienprotokoll
panel-data-replace = Alle Daten ersetzen
panel-data-sure = Alle Daten dieser Zelle werden durch die Sicherung ersetzt. Das Panel startet neu, und alle müssen sich als einer ihrer Benutzer anmelden.
panel-data-begins = Das Panel startet neu mit den wiederhergestellten Daten. Gleich neu anmelden.

# Inputs and outputs.
panel-io-signal = Signal
panel-io-kind = Art
panel-io-safe = Sicher
panel-io-place = Register
panel-io-unit = Gerät
panel-io-watchdog = Ausgänge sicher nach { $time } s
panel-io-polls = Abfragen
panel-io-missed = ausgelassen
panel-io-failed = gescheitert
panel-io-connections = Verbindungen
panel-io-away = Getrennt
panel-io-round = Abfrage: Median / 99,9 % / max.
panel-io-trouble = Letzte Störung:
panel-io-wants = muss { $state } sein

# Io name.
panel-io-name-gas = Gasventil
panel-io-name-on = Bogen oder Strahl ein
panel-io-name-watchdog = Lebenszeichen der Zelle
panel-io-name-ready = Quelle ist bereit
panel-io-name-burning = Bogen oder Strahl ist ein
panel-io-name-stuck = Draht oder Elektrode klebt
panel-io-name-fault = Störung der Quelle (Code; 0: keine)
panel-io-name-heartbeat = Lebenszeichen des Geräts

# Io kind.
panel-io-kind-input = Eingang
panel-io-kind-output = Ausgang
panel-io-kind-set = Sollwert
panel-io-kind-report = Meldung
panel-io-kind-actual = Istwert

# Tuning.
panel-tune-go = Einstellen und messen
panel-tune-waits = Misst …
panel-tune-how = Der Lageregler am simulierten Antrieb; nichts bewegt sich, nichts wird geändert.
panel-tune-assumed = Die Maschinendatei beschreibt keinen Antrieb: ein angenommener wurde eingestellt.
panel-tune-gain = Verstärkung des offenen Kreises
panel-tune-phase = Phase des offenen Kreises
panel-tune-gain-margin = Amplitudenreserve
panel-tune-phase-margin = Phasenreserve
panel-tune-take = Diese Einstellung übernehmen

# Audit log.
panel-audit-command = Befehl
panel-audit-values = Werte
panel-audit-newest = Die neuesten { $n } Einträge; es gibt ältere.
panel-audit-whole = { $n } { $n ->
    [one] Eintrag
   *[other] Einträge
 }
panel-audit-none = Kein Eintrag hat diesen Text.
panel-audit-older = Ältere zeigen
panel-audit-english = Gesucht wird in Codes, Namen und Werten der Einträge.

# Axes.
panel-axis-current = Strom
panel-axis-range = Bereich
panel-axis-max-speed = Höchstgeschw.
panel-axis-fault = Störung
panel-axis-limit = Endschalter
panel-axis-referenced = referenziert
panel-axis-home = Achse { $axis } in Grundstellung
panel-axis-home-how = Fährt eine Achse in Grundstellung. Referenziert werden alle Achsen zusammen.

# Condition.
panel-condition-for = Nötig für
panel-condition-met = erfüllt
panel-condition-unmet = nicht erfüllt

# Level.
panel-level-power = Spannung
panel-level-motion = Bewegung
panel-level-process = Prozess

# Users.
panel-user-role = Rolle
panel-user-enabled = Darf sich anmelden
panel-user-password = Neues Passwort (mindestens 10 Zeichen)
panel-user-own-password = Ihr eigenes Passwort
panel-user-first-run = Noch ist kein Passwort gesetzt. Ein Administratorkonto anlegen.
panel-user-deleted = Gelöscht: { $user }.
panel-user-saved = Gespeichert: { $user }.
panel-user-password-again = Neues Passwort noch einmal
panel-user-password-differs = Die beiden Passwörter sind verschieden.
panel-user-new = Neuer Benutzer
panel-user-edits = Benutzer { $user } ändern
panel-user-exists = Den Benutzer { $user } gibt es schon.
panel-user-over = Ihn ändern? Rolle: { $role }, darf sich anmelden: { $enabled }. Das Passwort bleibt.
panel-user-over-password = Ihn ändern? Rolle: { $role }, darf sich anmelden: { $enabled }. Das Passwort wird das neue.
panel-user-change = Ändern

# Parameters.
panel-par-how = Werte der Maschinendatei. Sie werden gemeinsam geprüft und in { $file } gespeichert; die alte Datei bleibt daneben. Grau = Standardwert.
panel-par-pending = Gespeichert, wirksam nach Neuladen: Antriebe ausschalten und den Auftrag neu laden.
panel-par-reload = Auftrag neu laden
panel-par-keep = Speichern
panel-par-kept = Gespeichert in { $file }
panel-par-wild = Große Änderung – bitte bestätigen:
panel-par-wrong = Keine Zahl: { $value }
panel-par-no-drive = Die Maschinendatei beschreibt keinen Antrieb dieser Achse.
panel-par-notches = Kerbfilter
panel-par-notch = { $frequency } Hz, Breite { $width } Hz, Verstärkung { $gain }
panel-par-group-axis = Achse
panel-par-group-loop = Lageregler und Antrieb
panel-par-group-feedforward = Kompensation
panel-par-group-mechanics = Mechanik und Maßstab
panel-par-group-pose = Wo er sitzt
panel-par-group-map = Pixel zu mm
panel-par-group-timing = Zeiten und Rauschen
panel-par-home = Grundstellung
panel-par-max-speed = Max. Geschwindigkeit
panel-par-max-acceleration = Max. Beschleunigung
panel-par-max-jerk = Max. Ruck
panel-par-velocity-bandwidth = Bandbreite des Drehzahlreglers
panel-par-kp = Proportionalverstärkung (kp)
panel-par-ki = Integralverstärkung (ki)
panel-par-kd = Differentialverstärkung (kd)
panel-par-kvff = Geschwindigkeitsvorsteuerung
panel-par-kaff = Beschleunigungsvorsteuerung
panel-par-limit = Grenze von Kraft oder Moment
panel-par-current-time-constant = Zeitkonstante des Stromreglers
panel-par-current-delay = Totzeit des Stroms
panel-par-friction-compensation = Reibungskompensation
panel-par-friction-smoothing = … Glättungsgeschwindigkeit
panel-par-backlash-compensation = Spielausgleich
panel-par-backlash-time = … Ausgleichszeit
panel-par-encoder-counts = Geberschritte je Einheit
panel-par-inertia = Bewegte Masse oder Trägheit
panel-par-peak = Spitzenkraft oder -moment
panel-par-friction = Reibung
panel-par-viscous = Viskose Reibung
panel-par-resonance = Resonanz
panel-par-load-ratio = Trägheit Last zu Motor
panel-par-bandwidth = Bandbreite des Lagereglers
panel-par-measured-at = Gemessen bei
panel-par-following-counts = Schleppfehler, Geberschritte
panel-par-load-error = Fehler an der Last
panel-par-notch-at = Kerbfilter bei

# TCP calibration.
panel-tool-title = TCP vermessen durch Antasten eines Punktes
panel-tool-how = Eine Messspitze einspannen. Mit der Brennerspitze antasten und aufnehmen; Brenner neigen oder drehen und erneut antasten: aus { $n } oder mehr Richtungen, 20° auseinander.
panel-tool-head = Kopf
panel-tool-record = Antastung aufnehmen
panel-tool-jog = Antastungen im Tipp- oder Teachbetrieb aufnehmen.
panel-tool-touch = Antastung { $touch }
panel-tool-remove = Antastung { $touch } entfernen
panel-tool-find = TCP berechnen
panel-tool-was = Aktueller TCP
panel-tool-found = Gefundener TCP
panel-tool-deviation = Standardabweichung
panel-tool-rms = Antastungen neben dem Punkt (RMS)
panel-tool-apart = Winkelspanne
panel-tool-keep = Diesen TCP speichern
panel-tool-verdict-good = Die Antastungen passen zusammen, die Spitze ist in allen Richtungen bestimmt.
panel-tool-verdict-unseen = Die Antastungen passen zusammen, bestimmen die Spitze aber nicht in allen Richtungen.
panel-tool-verdict-far = Die Spitze läge mehr als 20 mm anders: War es immer derselbe Punkt?
panel-tool-verdict-poor = Die Antastungen passen nicht auf 0.5 mm zusammen: neu antasten.
panel-tool-unseen = Nicht bestimmt entlang ({ $direction }): dort bleibt sie, wie sie war.
panel-tool-old = Zurück zum aktuellen TCP

# Sensors.
panel-sensor-none = Die Maschine hat keine Sensoren.
panel-sensor-title = Abbildung der Kamera aus einem Raster finden
panel-sensor-how = Eine Platte mit einem Raster dunkler Punkte gerade vor die Kamera legen, in bekannter Höhe: Sie muss das halbe Bild oder mehr füllen.
panel-sensor-pitch = Abstand der Punkte, mm
panel-sensor-z = Höhe der Platte (z), mm
panel-sensor-file = Bild des Rasters
panel-sensor-simulated = Simuliertes Bild
panel-sensor-find = Abbildung finden
panel-sensor-picture = Bild mit den gefundenen Punkten
panel-sensor-residuals = Netz: die Abbildung. Rote Striche: wie weit jeder Punkt davon abliegt, { $factor }-fach.
panel-sensor-dots = Punkte
panel-sensor-off = Punkte neben der Abbildung (RMS / max.)
panel-sensor-was = Aktuell
panel-sensor-found = Gefunden
panel-sensor-scale = Maßstab x / y, mm je Pixel
panel-sensor-rotation = Drehung
panel-sensor-shear = Scherung
panel-sensor-barrel = Verzeichnung (negativ: Tonne)
panel-sensor-centre = Optische Achse bei (Spalte, Zeile)
panel-sensor-middle = Mitte
panel-sensor-aligned = Die Platte liegt längs der Achsen des Sensors: ihre Drehung ist die der Kamera
panel-sensor-in-place = Anstelle der Ebene bei z = { $z } mm
panel-sensor-new = Als neue Ebene bei z = { $z } mm
panel-sensor-keep = Diese Abbildung übernehmen
panel-sensor-planes = Ebenen der Kamera
panel-sensor-remove = Ebene bei z = { $z } mm entfernen
panel-sensor-verdict-good = Das Bild passt zum Raster.
panel-sensor-move = Ort auf seinem Glied x, y, z
panel-sensor-turn = Gedreht um die Richtung x, y, z
panel-sensor-angle = … um den Winkel
panel-sensor-distance = Kamera vom Ursprung
panel-sensor-laser-angle = Achse der Kamera zur Laserebene
panel-sensor-focal = Brennweite
panel-sensor-homography = Homographie h1 … h8
panel-sensor-origin = Ursprung bei (Spalte, Zeile)
panel-sensor-period = Von Bild zu Bild
panel-sensor-latency = Von der Aufnahme zum Ergebnis
panel-sensor-noise = Rauschen des Orts der Fuge

# Paused dry run.
panel-pause-jog = Von hier tippen
panel-pause-where = Probelauf in Lage { $pass } bei { $s } mm unterbrochen. Tippen und aufnehmen; dann „Rückweg planen“ und „Probelauf“ drücken.
panel-pause-begin = Probelauf vor der ersten Lage unterbrochen. Tippen und aufnehmen; dann „Rückweg planen“ und „Probelauf“ drücken.
panel-pause-back = Rückweg planen
panel-pause-forget = Probelauf abbrechen

# Tour.
panel-tour-title = Ihre erste Schweißung
panel-tour-close = Überspringen
panel-tour-control = „Bedienung nehmen“ drücken (oben rechts): Es bedient immer nur ein Panel.
panel-tour-on = „Einschalten“ drücken: Die Antriebe bekommen Spannung.
panel-tour-home = „Referenz“ drücken: Die Achsen suchen ihre Referenzen.
panel-tour-load = „Aufträge“ öffnen und „Erste Naht“ laden. Er wird geplant und geprüft; nichts bewegt sich.
panel-tour-again = Die Achsen wurden bewegt. „Von hier neu planen“ drücken: Die Anfahrt beginnt, wo sie stehen.
panel-tour-dry = Ein Probelauf: derselbe Weg ohne Bogen. Enden lassen; STOP unten rechts beendet ihn sofort.
panel-tour-jog = Tippen. Wenn die Achsen richtig stehen, „Tippbetrieb beenden“ drücken.
panel-tour-fault = Eine Störung. Die Alarme unten sagen, was zu tun ist: quittieren, dann „Störung zurücksetzen“.
panel-tour-arm = „Freigeben“ drücken: Das erlaubt einen Start binnen einer Minute. „Warum kein Start?“ sagt, was fehlt.
panel-tour-weld = „Schweißung starten“ drücken. STOP ist immer unten rechts.
panel-tour-watch = Dem Brenner zusehen. Halt und Weiter versuchen (vorher wieder freigeben), und die Ansichten in 3D.
panel-tour-hold = Gehalten, der Bogen ist aus. Wieder „Freigeben“ drücken, dann „Weiter“.
panel-tour-left = Die Schweißung wurde verlassen. Links „Lage … fortsetzen“ drücken: von dort weiter, mit Überlappung.
panel-tour-record = Fertig. „Protokolle“ öffnen: Dort bleibt jede Schweißung.
panel-tour-end = Fertig. Weiter: Aufträge > Neu aus Vorlage.

# Kinds of refusals.
panel-trouble-login = Neu anmelden
panel-trouble-password = Abgelehnt
panel-trouble-role = Ihre Rolle erlaubt das nicht
panel-trouble-origin = Die Adresse der Seite ist nicht erlaubt
panel-trouble-token = Die Sitzung gilt nicht mehr: Seite neu laden
panel-trouble-size = Zu groß
panel-trouble-input = Falsche Eingabe
panel-trouble-not-found = Nicht gefunden
panel-trouble-busy = Jetzt nicht
panel-trouble-other = Dort steht ein anderer Text
panel-trouble-exists = Gibt es schon
panel-trouble-slow-down = Zu viele Anfragen: kurz warten
panel-trouble-server = Der Server hat versagt
panel-trouble-lost = Keine Verbindung zur Zelle
panel-trouble-archive = Das ist keine vollständige Sicherung von Seamwright
panel-trouble-archive-newer = Die Sicherung ist von einer neueren Version von Seamwright
panel-trouble-archive-room = Auf der Platte ist kein Platz dafür

# Allowed values.
panel-allowed-not-negative = eine Zahl, 0 oder größer
panel-allowed-positive = eine Zahl größer als 0
panel-allowed-up-to = mehr als 0, bis { $max }

# Actions that roles allow.
panel-action-take-control = Bedienung nehmen
panel-action-watch = zuschauen
panel-action-jobs-read = Aufträge lesen
panel-action-jobs-write = Aufträge ändern
panel-action-plan = planen
panel-action-edit = bearbeiten
panel-action-post = Steuerungsprogramme erzeugen
panel-action-load = laden
panel-action-records-read = Protokolle lesen
panel-action-tune = Regler einstellen
panel-action-set-up = einrichten
panel-action-shelve = Alarme zurückstellen
panel-action-audit = Audit-Protokoll
panel-action-audit-read = Audit-Protokoll lesen
panel-action-backup = Sicherungen herunterladen
panel-action-restore = wiederherstellen
panel-action-users-read = Benutzer ansehen
panel-action-users-write = Benutzer ändern
panel-action-diagnose = Diagnose ansehen
panel-action-jog = tippen
panel-action-teach = teachen

# Diagnostics.
panel-diag-state = Zustand
panel-diag-ready = Die Zelle ist bereit.
panel-diag-version = Programmversion
panel-diag-uptime = Läuft seit (min:s)
panel-diag-latency = Verspätung der Takte
panel-diag-latency-how = Takte seit dem Start des Servers, nach ihrer Verspätung. Höhen sind logarithmisch.
panel-diag-most = Größter Wert
panel-diag-gap = Längste Lücke
panel-diag-cycles = Takte
panel-diag-rights = Echtzeitrechte
panel-diag-granted = erteilt
panel-diag-missing = fehlt
panel-diag-right-priority = Echtzeitpriorität
panel-diag-right-memory = Gesperrter Speicher
panel-diag-right-cpu = Eigene CPU
panel-diag-grant-priority = Priorität: LimitRTPRIO=80 im Dienst setzen, oder rtprio auf 80 in /etc/security/limits.conf, dann neu starten.
panel-diag-grant-memory = Speicher: LimitMEMLOCK=infinity im Dienst setzen, oder memlock auf unlimited in /etc/security/limits.conf, dann neu starten.
panel-diag-grant-cpu = CPU: eine wählen, die es gibt und die erlaubt ist, dann neu starten.
panel-diag-devices = Alter der Meldungen der Geräte
panel-diag-devices-how = Mehr zu jedem Gerät: Ein- und Ausgänge.
panel-diag-device-latency = Latenz
panel-diag-disk = Platte und Speicher
panel-diag-free = Frei / Größe
panel-diag-write = Kleiner Schreibvorgang
panel-diag-look = Geprüft vor
panel-diag-resident = Speicher des Panels
panel-diag-cell-resident = Speicher der Zelle
panel-diag-locked = davon gesperrt
panel-diag-queues = Warteschlangen
panel-diag-waiting = Wartend
panel-diag-room = Plätze
panel-diag-queue-cycles = Takte
panel-diag-queue-notes = Ereignisse
panel-diag-queue-commands = Befehle
panel-diag-queue-audit = Bedienprotokoll
panel-diag-alarms = Alarme nach Priorität
panel-diag-priority = Priorität
panel-diag-active = Aktiv
panel-diag-unacknowledged = Nicht quittiert
panel-priority-critical = kritisch
panel-priority-high = hoch
panel-priority-medium = mittel
panel-priority-low = niedrig
panel-diag-workers = Planungsprozesse
panel-diag-runs = läuft seit
panel-question-draft = Entwurf
panel-question-plan = Planung
panel-question-recorded = Plan eines Protokolls
panel-question-report = Bericht
panel-question-post = Teileprogramm
panel-question-load = Laden
panel-question-place = Werkstücklage
panel-question-reach = Suche des besten Platzes
panel-question-schedule = Serie
panel-worker-answered = Beantwortet
panel-worker-refused = Auftrag fehlerhaft
panel-worker-superseded = Durch neuere Anfrage beendet
panel-worker-late = Abgebrochen: zu lange
panel-worker-memory = Abgebrochen: zu viel Speicher
panel-worker-failed = Fehlgeschlagen
panel-diag-since = Seit dem Start des Servers
panel-diag-welds = Schweißungen
panel-diag-clients = Verbindungen / Seiten / Sitzungen
panel-diag-logins = Anmeldungen / abgelehnt
panel-diag-answers = Antworten nach HTTP-Status
