# Allowed values.
program-less-than-key = weniger als { $key } = { $max }
program-up-to-key = bis { $key } = { $max }
program-positive-up-to-key = mehr als 0, bis { $key } = { $max }
program-up-to-in-all = insgesamt bis { $max }
program-either = entweder { $first } oder { $second }
program-at-least-one = mindestens einer
program-at-least-one-table = mindestens eine { $table }
program-at-least-one-pass = ein Programm hat mindestens eine Lage
program-at-least-one-point = mindestens ein Abschnitt mit mindestens einem Punkt
program-at-least-one-path-length = mindestens eine Weglänge
program-at-least-one-column = mindestens eine Spalte = Zahl
program-numbers = { $numbers ->
        [one] { $numbers } Zahl
       *[other] { $numbers } Zahlen
    }
program-one-for-each = eine für jede
program-one-for-each-of = eine für jede von { $columns }
program-range-in-order = { $min } bis { $max }, der kleinere Wert zuerst
program-start-to-point = 0 (der Anfang) bis { $max }
program-after-start-to-point = after: 0 (der Anfang) bis { $max }
program-start-to-last-point = 0 (der Anfang) bis { $max } (der letzte Punkt)
program-positions-within = endliche Zahlen, Positionen höchstens { $max } vom Ursprung
program-number-or-ramp = eine endliche Zahl oder { "{" } from = .., to = .. { "}" }
program-leave-out = weglassen

# Programs and passes.
program-no-passes = das Programm hat keine Lagen
program-pass-without-seam = die Lage läuft an einer Naht entlang, aber das Programm hat keine Naht
program-seam-or-points = [seam] im Programm oder [passes.points]
program-pass-without-spans = die Lage hat keine Abschnitte
program-span-gap = der Abschnitt beginnt nicht dort, wo der vorige endet
program-span-empty = der Abschnitt hat keine Länge
program-span-other-values = der Abschnitt setzt andere Prozesswerte als der erste
program-min-speed-not-below = die Mindestgeschwindigkeit liegt nicht unter der programmierten
program-below-span-speed = weniger als speed_mm_s = { $max } jedes Abschnitts
program-too-many-passes = bis zu dieser Lage hat das Programm zu viele Lagen
program-too-many-rows = bis zu dieser Lage hat das Programm zu viele Zeilen aus Punkten, Raupen und Abschnitten
program-corner-choice = "refuse", "stop" oder { "{" } blend_mm = 0.2 { "}" }
program-corner-outside-tolerance = der Brenner verließe die Toleranz der Schweißung
program-role-tack = Heftlage
program-role-root = Wurzellage
program-role-fill = Fülllage
program-role-cap = Decklage
program-role-cosmetic = Glättlage

# Copies of the seam and work offsets.
program-copies-and-placement = die Kopien haben eigene Aufstellungen
program-no-placement = kein [placement] neben [[copies]]
program-name-taken = { $other } heißt schon so
program-placement-taken = { $other } hat schon diese Aufstellung
program-own-placement = eine eigene Aufstellung
program-no-such-copy = diese Kopie gibt es nicht
program-no-copies = 0: das Programm hat keine [[copies]]
program-copy-index = 0 bis { $max }, der Index in [[copies]]
program-offset-name-invalid = `{ $name }` ist kein zulässiger Name einer Nullpunktverschiebung
program-offset-names = Buchstaben, Ziffern, - und _
program-offset-table = der Name einer Tabelle in dieser Datei, hier [offsets.{ $name }]

# Beads.
program-bead-empty = die Raupe hat keine Zeilen
program-bead-column-length = die Spalte hat { $rows ->
        [one] { $rows } Zeile
       *[other] { $rows } Zeilen
    }, s_mm hat { $wanted }
program-path-lengths-increase = die Weglängen müssen zunehmen
program-torch-behind-face = der Brenner läge hinter einer Flanke
program-weave-part-above-one = ein Anteil über 1 macht das Pendeln breiter als das der Lage
program-step-over-without-bead = ein Übergang braucht eine Raupe, von der er ausgeht
program-step-over-misplaced = der Übergang von { $from } bis { $to } liegt nicht zwischen dem vorigen und dem Ende der Lage

# Joints.
program-root-face-too-high = der Steg lässt keine Dicke für die Fase
program-groove-angle-too-large = der Winkel ist zu groß für eine Fuge
program-radius-too-large = der Radius ist zu groß für die Tiefe über dem Steg
program-root-gap-too-wide = der Stegabstand ist größer als die Wand und als die Fuge selbst
program-mismatch-too-large = die Kanten liegen einander nicht gegenüber: der Kantenversatz ist so groß wie die Wand
program-nothing-filled = die ungefüllte Tiefe lässt nichts zu füllen
program-fillet-size-unclear = die Größe der Kehlnaht ist nicht eindeutig
program-fillet-sizes = leg_mm oder throat_mm, oder first_leg_mm und second_leg_mm zusammen
program-bevel-angle-unclear = der Flankenwinkel ist nicht eindeutig
program-bevel-angles = entweder angle_deg (der Fuge) oder cut_deg (der Kante)
program-positions-increase = die Positionen müssen zunehmen
program-depth-leaves-no-back = die Tiefe auf der Vorderseite lässt für die Rückseite nichts übrig
program-fillet-implausible = so groß ist keine Kehlnaht
program-cap-implausible = so hoch ist keine Decklage
program-lap-leg-too-long = der Schenkel ist länger als die Kante, an der er liegt
program-gouge-on-face = ausgefugt wird nur die Rückseite
program-side-back = side = "back"
program-back-without-groove = auf der Rückseite gibt es keine Fuge
program-groove-on-back = eine beidseitige Fugenform, oder [joint.gouge] eines Stumpfstoßes
program-gouge-through-wall = die Ausfugung geht durch die Wand
program-gouge-angle-too-large = die Flanken der Ausfugung sind zu flach
program-at-dihedral-without-edge = der Öffnungswinkel folgt hier nicht dem Flächenwinkel
program-edge-on-face = t_bevel mit angle_deg, t_double_bevel oder t_j
program-at-dihedral-unequal = die Zeilen nach Flächenwinkel geben verschiedene Größen an
program-same-keys-in-rows = angle_deg, root_gap_mm oder beide, in allen Zeilen dieselben
program-dihedrals-increase = die Flächenwinkel müssen zunehmen
program-flare-root-gap = runde Teile, die sich berühren, haben keinen Stegabstand
program-layers-increase = Messungen nach weniger Lagen müssen zuerst kommen
program-fit-up-without-angle = Kanten dieser Art haben keinen Öffnungswinkel
program-allowed-bevelled-kinds = kein angle_deg, oder single_v, bevel, u, j, t_bevel, t_j
program-fit-up-angle-invalid = die Kanten bilden keine Fuge mit diesem Winkel
program-remaining-before-weld = vor dem Schweißen ist die ganze Fuge offen
program-allowed-after-layer = after_layer von 1 oder mehr
program-remaining-missing = die noch offene Fläche fehlt
program-allowed-remaining = mit remaining_mm2

# Process values.
program-process-name-invalid = das ist kein zulässiger Name eines Prozesswerts
program-process-names = Kleinbuchstaben, Ziffern und _, am Ende die Einheit, wie current_a
program-column-name-taken = eine andere Spalte heißt so
program-process-value-negative = der Prozesswert ist negativ
program-process-value-too-large = `{ $name }` = { $value } ist mehr, als eine Schweißmaschine hat
program-same-quantity = `{ $other }` ist dieselbe Größe in einer anderen Einheit: sie könnten einander widersprechen
program-no-such-process-value = die Schweißung hat keinen solchen Prozesswert
program-upslope-too-long = der Anstieg dauert länger als die Zeit, die dafür vorgesehen ist
program-downslope-too-long = die Absenkung dauert länger als die Zeit, die dafür vorgesehen ist

# Weaving and oscillation.
program-weave-at-blend = Ecken lassen sich nicht überschleifen, wo der Brenner pendelt
program-corner-or-no-weave = "refuse" oder "stop", oder kein Pendeln
program-weave-pitch-unclear = die Pendelteilung ist nicht eindeutig
program-only-trapezoid-dwells = nur ein Trapez hat Verweilzeiten
program-no-dwell-or-trapezoid = 0, oder figure = "trapezoid"
program-dwell-needs-frequency = eine Verweilzeit in Sekunden braucht eine Frequenz
program-frequency-instead-of-pitch = frequency_hz statt pitch_mm
program-dwells-too-long = die Verweilzeiten lassen keine Zeit für den Weg quer
program-dwells-together = beide zusammen bis { $max }
program-weave-along-torch = das Pendeln liefe entlang des Brenners
program-figure-without-length = diese Figur hat keine Länge
program-figures-with-length = ohne diesen Schlüssel, oder figure = "circle" oder "eight"
program-sides-not-steady = die Seiten haben feste Werte, keine Rampen
program-weave-period-short = eine Periode des Pendelns nähme nur { $pitch } der Naht ein
program-frequency-at-speed = bis { $max } bei { $speed }
program-weave-periods = das Pendeln hätte { $periods } Perioden in einer Lage
program-up-to-periods = bis { $max } Perioden
program-weave-speed-jumps = die Geschwindigkeit springt am Anfang des Abschnitts und mit ihr ein Pendeln nach Frequenz
program-span-speed-or-pitch = ein Abschnitt, der mit { $speed } beginnt, oder ein Pendeln mit pitch_mm
program-oscillation-gaps = der Strahl rückt in einer Periode seiner Oszillation um { $advance } vor, mehr als sein Fleck von { $spot }: es bleiben Lücken
program-cure-oscillation-gaps = frequency_hz auf { $frequency } oder mehr setzen, oder langsamer schweißen

# Passes through points.
program-pass-without-points = die Lage hat keine Punkte
program-span-without-points = der Abschnitt hat keine Punkte
program-value-out-of-bounds = { $column } = { $value } liegt außerhalb der Grenzen
program-value-not-allowed = { $column } = { $value } ist hier nicht erlaubt
program-column-twice = die Spalte `{ $column }` kommt zweimal vor
program-each-column-once = jede Spalte einmal
program-last-column = die letzte Spalte, und nur sie, gibt Zeit oder Geschwindigkeit eines Punkts an
program-time-or-speed-last = zuletzt time_s oder speed_mm_s
program-columns-without-position = die Spalten geben keine Position an oder zwei
program-position-columns = x_mm, y_mm, z_mm, mit oder ohne ax, ay, az; oder Namen der Achsen der Maschine
program-arc-in-span = ein Bogen braucht `via_mm` und hat einen Punkt
program-one-arc-per-span = ein Bogen je Abschnitt, mit `via_mm` auf halbem Weg
program-arc-of-axes = Achspositionen können einem Bogen nur folgen, wenn zwei von x, y und z dabei sind
program-only-arcs = nur Bögen haben diesen Schlüssel
program-arc-or-leave-out = `along = "arc"`, oder weglassen
program-speed-rows = { $rows ->
        [one] { $rows } Zeile mit Geschwindigkeiten
       *[other] { $rows } Zeilen mit Geschwindigkeiten
    }
program-cubic-speeds = für eine kubische Kurve eine mehr als Punkte, die erste am Anfang; sonst keine
program-cubic-needs-times = eine kubische Kurve braucht Zeiten
program-time-last = die letzte Spalte `time_s`
program-speeds-for-columns = { $speeds ->
        [one] { $speeds } Geschwindigkeit
       *[other] { $speeds } Geschwindigkeiten
    } für { $columns } Spalten der Position
program-numbers-for-columns = { $numbers ->
        [one] { $numbers } Zahl
       *[other] { $numbers } Zahlen
    } für { $columns } Spalten
program-pace-zero = 0: es ist der Anfang, oder so schnell, wie die Achsen können
program-block-number = eine ganze Zahl, 0 (keine) oder größer
program-direction-columns = eine Richtung: ax, ay, az nicht alle 0
program-key-of-seam-passes = die Lage geht durch Punkte: nur Lagen an einer Naht haben diesen Schlüssel
program-leave-out-key-or-points = weglassen, oder `points` weglassen
program-event-after-end = die Lage hat weniger Punkte
program-event-several = ein Ereignis tut genau eine Sache
program-event-keys = eines von gas, wire, output (mit on), message, call

# Procedures.
program-procedure-without-runs = die Schweißanweisung hat keine Einträge
program-run-without-passes = der Eintrag nennt keine Lagen
program-run-passes-twice = der Eintrag nennt seine Lagen zweimal
program-run-names = entweder name = "tack", "root", "fill" oder "cap", oder passes = "1", "2-5" und so weiter
program-run-without-position = der Eintrag erlaubt keine Schweißposition
program-run-positions = eine oder mehrere; ohne den Schlüssel sind alle erlaubt
program-toe-angle-too-large = flacher als bündig mit dem Bauteil kann keine Naht sein
program-insert-without-root-faces = diese Fuge nimmt kein Einlegeteil auf
program-allowed-insert = ein Einlegeteil in einem Stumpfstoß mit side = "face" und ohne Badsicherung
program-insert-area-missing = der Querschnitt des Einlegeteils fehlt
program-allowed-insert-area = area_mm2, oder kind = "ring" oder "rectangular"
program-insert-too-high = das Einlegeteil wäre so hoch wie die Wand
program-insert-gap = ein { $width } breites Einlegeteil passt nicht in einen Stegabstand von { $gap }
program-not-a-process-value = das ist kein Prozesswert
program-beside-ranges = { $key } neben `ranges`
program-ranges-in-table = Bereiche von Prozesswerten in [runs.ranges] schreiben
program-part-above-one = dieser Anteil am Ganzen liegt über 1
program-carbon-invalid = { $found } Kohlenstoff hat kein Stahl
program-composition-sum = die Elemente ergeben zusammen { $sum }
program-material-group-invalid = { $group } ist keine Werkstoffgruppe
program-material-groups = eine Gruppe der ISO/TR 15608: 1 bis 11, 21 bis 26, 31 bis 38, 41 bis 48, 51 bis 54, 61, 62, 71 bis 76, auch mit Untergruppe, wie "1.2"
program-material-unknown = der Werkstoff hat weder Zusammensetzung noch Gruppe
program-composition-or-group = `composition` oder `group`
program-interpass-one-of = zum Warten gehört eine Zeit oder eine Temperatur, nicht beides
program-interpass-wait-or-below = `wait_s` oder `below_c`
program-interpass-below-work = auf { $found } kühlt das Werkstück nie ab
program-heat-flow-2d = zweidimensional
program-heat-flow-3d = dreidimensional
program-one-run-per-name = ein Eintrag je Name
program-pass-in-two-runs = Lage { $pass } ist schon in { $other } genannt
program-named-pass-in-two-runs = Lage { $pass } ({ $name }) steht schon in { $other }
program-pass-in-one-run = jede Lage in nur einem Eintrag
program-no-pass-numbers = `{ $text }` nennt keine Lagen
program-pass-named-twice = Lage { $pass } ist zweimal genannt
program-pass-numbers = Zahlen ab 1 wie "1", "2-5" oder "1, 3-4", jede einmal
program-limits-increase = die Grenzen müssen zunehmen
program-hysteresis-too-large = keine Neigung überschreitet vertical_slope_deg so weit
program-no-power = das Produkt dieser Werte ist keine Leistung
program-power-values = ["current_a", "voltage_v"], ["laser_w"]: einer in W oder kW, oder ein Strom in A, mA oder kA und eine Spannung in V oder kV
program-window-order = der kleinste Wert, { $min }, liegt über dem größten, { $max }
program-window-negative = dieser Bereich beginnt unter 0
program-window = [kleinster, größter]
program-processes = { $processes }
program-process = { $number } ({ $name })

# Jumps of the torch.
program-torch-direction-jumps = die Richtung des Brenners spränge um { $jump } an der Ecke bei s = { $s }
program-torch-tip-jumps = die Brennerspitze spränge um { $jump } an der Ecke bei s = { $s }
program-cure-direction-jumps = eine Lage dort enden und eine andere danach beginnen lassen (im Auftrag order.parts = "at_corners", Heftstellen anderswo); oder die Ecke in der Naht runden; im Stumpfstoß ohne Arbeits- und Schlepp-/Stechwinkel schweißen
program-cure-tip-jumps = eine Lage dort enden und eine andere danach beginnen lassen (im Auftrag order.parts = "at_corners", Heftstellen anderswo), oder die Ecke in der Naht runden

# Variables and expressions.
program-expression = "= Ausdruck"
program-expression-lines = ein Ausdruck bleibt in seiner Zeile
program-expression-grammar = Zahlen, Namen von Variablen, + - * / und Klammern
program-expression-rest = `{ $text }` ist nicht verständlich
program-expression-ends = der Ausdruck endet, wo eine Zahl oder ein Name kommen sollte
program-unexpected-character = `{ $text }` steht, wo eine Zahl oder ein Name kommen sollte
program-number-invalid = `{ $text }` ist keine Zahl
program-nesting-too-deep = zu viele Klammern oder Vorzeichen ineinander
program-parenthesis-missing = eine schließende Klammer fehlt
program-result-not-finite = das Ergebnis ist nicht endlich
program-finite-result = keine Division durch 0, keine Zahl über 1e308
program-not-a-number = das ist keine Zahl
program-variables-no-table = die Variablen sind keine Tabelle
program-variables-table = [variables] mit Name = Zahl
program-variable-name-invalid = `{ $name }` ist kein zulässiger Name einer Variablen
program-variable-names = ein Buchstabe oder _, dann Buchstaben, Ziffern und _
program-no-variables = keine Variablen angegeben: [variables] mit Name = Zahl

# Refused edits.
program-edit-refused = die Änderung ist abgelehnt: das Dokument bleibt, wie es war; die Zeile ist die des Ergebnisses
program-help-and-help =
    { $first }
    { "   " }{ $second }
program-edit-layout = die Änderung passt nicht in die Form dieses Dokuments
program-usual-layout = die Form, die der Schritt `format` macht
program-history-of-other-text = das Dokument wurde seit der Änderung bearbeitet und enthält ihr Ergebnis nicht mehr
program-text-of-last-edit = das Dokument, wie es die letzte Änderung hinterließ
program-history-line = Zeile { $line }: { $fault }
program-history-empty = die Historie ist leer
program-history-head = der Kopf der Historie passt nicht zu ihren Änderungen
program-history-format = eine Historie, wie `seamwright edit` sie schreibt, ein JSON-Objekt je Zeile
program-number-not-finite = eine Zahl ist nicht endlich oder zu groß
program-no-pass = es gibt keine Lage { $pass }
program-pass-along-seam = Lage { $pass } läuft entlang der Naht
program-pass-has-points = Lage { $pass } geht durch Punkte
program-pass-through-points = eine Lage durch Punkte
program-no-points = für diese Änderung gibt es keine Punkte { $from } bis { $to }
program-nothing-to-set = es ist nichts zum Setzen angegeben
program-no-order-position = in der Reihenfolge gibt es keine Position { $at }
program-only-pass = es ist die einzige Lage
program-no-event = es gibt kein Ereignis { $event }
program-pass-with-events = eine Lage mit Ereignissen
program-mirror-unclear = die Ebene oder Achse zum Spiegeln fehlt, oder beide sind angegeben
program-mirror-keys = `normal` mit `at_mm` für Posen, `axis` mit `about` für Achspositionen
program-points-are-axes = die Punkte von Lage { $pass } sind Achspositionen
program-points-are-poses = die Punkte von Lage { $pass } sind Posen
program-no-points-pass = keine Lage geht durch Punkte
program-with-points = ein Programm mit [passes.points]
program-offset-of-axes = die Punkte sind Achspositionen: nur die Maschine kennt das Koordinatensystem des Brenners
program-points-with-poses = Punkte, die Posen sind
program-no-torch-frame = an Punkt { $point } liegt der Brenner entlang der Bahn, oder die Bahn hat keine Richtung
program-torch-across-path = ein Brenner quer zur Bahn
program-no-point = es gibt keinen Punkt { $point }
program-no-number-given = es ist keine Zahl angegeben
program-column-without-speed = `{ $column }` ist keine Spalte der Position und hat keine Geschwindigkeit
program-no-cubic-at-point = keine kubische Kurve endet oder beginnt an Punkt { $point }
program-point-of-cubic = ein Punkt eines Abschnitts `cubic`
program-no-next-point = es gibt keinen nächsten Punkt für eine Position auf halbem Weg
program-no-point-left = es bliebe kein Punkt übrig
program-keep-a-point = mindestens einen Punkt behalten, oder die Lage löschen
program-points-without-xyz = die Punkte haben kein x, y und z für Geraden und Bögen
program-poses-or-xyz = Posen oder Positionen der Achsen x, y und z
program-no-span = für diese Änderung gibt es keinen Abschnitt { $span }
program-pass-of-more-spans = eine Lage mit mehr Abschnitten
program-rapid-with-arc = in dieser Lage brennt der Lichtbogen: im Eilgang wird nicht geschweißt
program-ways-or-no-arc = line, arc, spline; oder eine Lage mit `arc = false`
program-pass-with-times = eine Lage, deren letzte Spalte `time_s` ist
program-arc-of-points = ein Bogen braucht `via_mm` und einen Punkt; der Abschnitt hat { $points }
program-split-first = zuerst den Abschnitt teilen; `via_mm` angeben
program-via-of-arcs = `via_mm` und `normal` gehören zu Bögen, nicht zu `{ $along }`
program-rapid-without-pace = Punkte im Eilgang haben weder Zeit noch Geschwindigkeit
program-pace = `pace`: Zeit oder Geschwindigkeit zu jedem Punkt
program-pace-given = die Punkte haben schon Zeit oder Geschwindigkeit
program-no-pace = kein `pace`
program-no-split-at-point = an Punkt { $point } lässt sich kein Abschnitt teilen
program-point-within-span = ein Punkt innerhalb eines Abschnitts, nicht sein letzter
program-no-split-at-length = bei { $s } lässt sich kein Abschnitt teilen
program-length-within-span = eine Weglänge innerhalb eines Abschnitts, nicht sein Ende
program-split-unclear = die Position der Teilung fehlt oder passt nicht zur Lage
program-split-keys = `point` durch Punkte, `s_mm` entlang der Naht
program-spans-not-joined = die Abschnitte { $first } und { $second } setzen einander nicht fort
program-spans-that-join = gleicher Weg (keine Bögen) und Halte, kubische Kurven mit gleichen Geschwindigkeiten; an der Naht gleiche Werte oder fortlaufende Rampen
program-points-without-seam = die Lage geht durch Punkte: sie hat keine Naht
program-no-seam-length = kein `seam_length_mm`
program-pass-over-start = die Lage läuft über den Anfang der Naht
program-seam-length = `seam_length_mm`: die Naht wird ringsum geschweißt
program-start-point = `point`, an dem geschlossene Punkte beginnen sollen
program-start-without-seam = das Programm hat keine Naht für den Anfang
program-start-unclear = der neue Anfang fehlt oder ist zweimal angegeben
program-start-keys = `pass` mit `point`, oder `pass` mit `begin_mm`, oder `phi_deg` allein
program-points-not-closed = die Punkte enden nicht, wo sie beginnen
program-closed-points = geschlossene Punkte: der letzte Punkt ist der Anfang
program-no-range = die Lage hat keinen Bereich von { $from } bis { $to }
program-range-of-points = `points`, und kein `s_mm`
program-range-of-seam = `s_mm`, und keine `points`
program-range-without-pass = ein Bereich braucht seine Lage
program-pass-with-range = `pass` mit `points` oder `s_mm`
program-speed-not-positive = eine Geschwindigkeit wäre keine endliche Zahl über 0
program-other-factor = ein anderer Faktor

# Edits that were made.
program-edit-formatted = formatiert
program-edit-offset = geltende Nullpunktverschiebung: `{ $name }`
program-edit-no-offset = keine Nullpunktverschiebung in Kraft
program-edit-variable = Variable { $name } = { $value }
program-edit-variable-removed = Variable { $name } entfernt
program-edit-pass = Lage { $pass }: { $changes }
program-edit-pass-name = Name `{ $name }`
program-edit-pass-role = Rolle { $role }
program-edit-arc-on = Lichtbogen ein
program-edit-arc-off = Lichtbogen aus
program-edit-repeat = { $times ->
        [one] einmal
       *[other] { $times }-mal
    } geschweißt
program-edit-pass-added = Lage `{ $name }` hinzugefügt
program-edit-pass-deleted = Lage { $pass } `{ $name }` gelöscht
program-edit-pass-moved = Lage { $pass } an Position { $to } verschoben
program-edit-pass-copied = Lage { $pass } kopiert
program-edit-event-added = Lage { $pass }: Ereignis nach Punkt { $point } hinzugefügt
program-edit-event-deleted = Lage { $pass }: Ereignis { $event } gelöscht
program-edit-mirrored = gespiegelt
program-edit-moved = Lage { $pass } verschoben
program-edit-point = Lage { $pass }, Punkt { $point }: { $columns } gesetzt
program-edit-speed-of = Geschwindigkeit von { $column }
program-edit-point-inserted = Lage { $pass }: Punkt nach { $after } eingefügt
program-edit-points-deleted = Lage { $pass }: Punkte { $from } bis { $to } gelöscht
program-edit-reduced = Lage { $pass }: { $before ->
        [one] { $before } Punkt
       *[other] { $before } Punkte
    } auf { $after } verringert
program-edit-along = Lage { $pass }, Abschnitt { $span }: { $along }
program-edit-span-split = Lage { $pass }: Abschnitt { $span } geteilt
program-edit-spans-joined = Lage { $pass }: Abschnitte { $first } und { $second } verbunden
program-edit-reversed = Lage { $pass } umgekehrt
program-edit-pass-start = Lage { $pass } beginnt bei { $s }
program-edit-pass-start-point = Lage { $pass } beginnt an Punkt { $point }
program-edit-weld-start = die Schweißung beginnt bei { $phi }
program-edit-speed = Geschwindigkeit mal { $factor }
program-edit-process = Lage { $pass }: { $name } gesetzt
program-edit-numbered = Punkte nummeriert
