# Positions on the weld, and torch angles.
weld-position-beside-weld = diese Position liegt nicht auf der Schweißung
weld-positions-must-increase = die Positionen müssen wachsen
weld-without-length = die Schweißung hat keine Länge
weld-angles-twice = Winkel sind fest und an mehreren Positionen angegeben
weld-travel-angle-too-large = der Brenner läge entlang der Naht
weld-work-angle-too-large = der Brenner läge hinter einer Fläche
weld-torch-search-too-wide = die Suche der Brennerwinkel geht über das hinaus, was ein Brenner kann
weld-stick-out-range = mit diesem freien Drahtende schweißt kein Brenner
weld-stick-out-of-machine = das freie Drahtende am Brenner der Maschine ist unbekannt, daher kann er für ein anderes nicht zurückgezogen werden
weld-stick-out-above-search = die Suche kann das freie Drahtende nicht auf diesen Wert verlängern: ohne sie sind es schon { $own }
weld-allowed-stick-out = `stick_out_mm` in [torch] der Maschinendatei: der Draht zwischen Kontaktrohr und Brennerspitze
weld-min-speed-too-high = die Mindestgeschwindigkeit liegt nicht unter der Schweißgeschwindigkeit
weld-speed-below-min = die Schweißgeschwindigkeit liegt nicht über der Mindestgeschwindigkeit
weld-value-ramps-already = dieser Wert hat schon eine Rampe über die ganze Naht

# Allowed values of these.
weld-allowed-from-less-than = { $min } oder mehr, weniger als { $max }
weld-allowed-positions-increasing = wachsende Positionen
weld-allowed-path-lengths-increasing = wachsende Weglängen
weld-allowed-seam-with-length = eine Naht mit einer Länge
weld-allowed-angles-once = entweder die festen Winkel oder [[torch.at]]
weld-allowed-travel-angle = { $min } (stechend) bis { $max } (schleppend)
weld-allowed-number-or-no-value = eine Zahl in [weld.process] oder hier kein Wert
weld-allowed-less-than-key = weniger als { $key } = { $value }
weld-allowed-more-than-key = mehr als { $key } = { $value }
weld-allowed-positive-less-than-key = mehr als 0 und weniger als { $key } = { $value }
weld-allowed-positive-less-than-half-key = mehr als 0 und weniger als die Hälfte von { $key } = { $value }
weld-allowed-not-along = nicht längs `{ $key }`
weld-allowed-other-point = ein anderer Punkt als `{ $key }`
weld-allowed-schema = zueinander passende Maße (siehe das Schema der Auftragsdateien)

# Bodies that nozzles stand on.
weld-body-cylinder = Zylinder, Radius { $radius }
weld-body-cone = Kegel, halber Winkel { $angle }
weld-body-sphere = Kugel, Radius { $radius }
weld-body-ellipsoid = Ellipsoid, Halbachsen { $a }, { $b }, { $c }
weld-body-plane = Ebene, mit der Normalen aus der Platte
weld-body-torus = Rohrbogen, Rohrradius { $radius }
weld-body-torispherical-head = Klöpper- oder Korbbogenboden, Außendurchmesser { $diameter }
weld-body-ellipsoidal-head = elliptischer Boden, Außendurchmesser { $diameter }
weld-body-hemispherical-head = Halbkugelboden, Außendurchmesser { $diameter }
weld-body-flat-head = ebener Boden, Außendurchmesser { $diameter }
weld-body-conical-head = Kegelboden, Außendurchmesser { $diameter }
weld-body-inside = Innenseite der Wand; außen: { $body }
weld-allowed-nozzle-fits = ein Stutzen, der auf den Körper passt: { $body }
weld-allowed-nozzle-axis = eine Achse, die den Körper trifft: { $body }
weld-allowed-nozzle-on-body = Radius und Achse, bei denen die ganze Wand (Radius { $radius }) auf dem Körper liegt: { $body }
weld-allowed-nozzle-on-head = ein Stutzen, dessen ganze Wand (Radius { $radius }) auf dem Boden und seinem Bord liegt: { $body }
weld-allowed-nozzle-smaller = ein Stutzen, der kleiner als der Körper ist: { $body }
weld-allowed-nozzle-direction = eine Richtung aus dem Körper heraus: { $body }
weld-cone-angle-too-large = der halbe Kegelwinkel ist zu groß
weld-torus-meets-itself = das Rohr träfe sich in der Mitte des Bogens selbst
weld-set-in-wall-missing = der Stutzen ist eingesetzt: die Wanddicke des Körpers fehlt
weld-set-on-root-wall-missing = die Wurzel eines aufgesetzten Stutzens liegt an seiner Bohrung: seine Wanddicke fehlt
weld-wall-leaves-no-room = die Wand lässt innen keinen Platz
weld-wall-leaves-no-bore = die Wand lässt keine Bohrung
weld-knuckle-too-large = die Krempe mit dem Innenradius { $radius } passt nicht in den Bord
weld-allowed-knuckle = ein Innenradius der Krempe kleiner als der des Bords, { $max }
weld-head-radii-missing = die Radien von Kalotte und Krempe fehlen
weld-allowed-head-radii = `standard` ("din_28011", "din_28013" oder "asme_fd"), oder `crown_radius_mm` und `knuckle_radius_mm` zusammen
weld-crown-too-curved = die Kalotte ist nicht flacher als eine Halbkugel
weld-allowed-crown = mehr als der Innenradius des Bords, { $min }

# Branches of tubes, and girths.
weld-branch-along-chord = der Abzweig liegt längs des Gurtrohrs
weld-branch-wider-than-chord = der Abzweig ist nicht enger als das Gurtrohr
weld-branch-past-chord = die Wand des Abzweigs geht am Gurtrohr vorbei
weld-branches-do-not-part = die zwei Abzweige sind parallel oder laufen ineinander
weld-branch-position-missing = die Position des anderen Abzweigs fehlt
weld-branch-position-twice = die Position des anderen Abzweigs ist zweimal angegeben
weld-allowed-tube = ein Rohr
weld-allowed-tubes-meet = Rohre, deren Wände sich ringsum treffen: ein kleinerer Abzweig oder weniger Überlappung
weld-allowed-other-branch-angle = weniger als { $max } beim ersten Abzweig unter { $first }, damit die Achsen auseinandergehen
weld-allowed-gap-or-offset = genau eines von `gap_mm` (zwischen den Fußpunkten; negativ bei Überlappung) und `offset_mm` (zwischen den Achsen)
weld-allowed-branch-within-chord = ein Abzweig innerhalb des Gurtrohrs
weld-allowed-eccentricity = mehr als { $min } und weniger als { $max }: chord_radius_mm - radius_mm
weld-cut-along-tube = der Schnitt läuft längs des Rohrs: seine Normale weicht { $angle } von der Achse ab
weld-allowed-cut-angle = bis { $max } Abweichung von `direction`
weld-allowed-other-plane = eine andere Ebene

# Shapes of seams.
weld-seam-too-long = die Naht wäre { $length } lang
weld-allowed-smooth-seam = eine glatte Naht
weld-zero-direction-along-normal = die Nullrichtung liegt längs der Normalen
weld-arc-normal-off = die Ebene der drei Punkte weicht { $angle } von dieser Normalen ab
weld-allowed-arc-normal = senkrecht zu dieser Ebene: { $normal } oder entgegengesetzt
weld-allowed-point-off-line-or-line-seam = ein Punkt neben der Geraden vom Anfang zum Ende; eine gerade Naht ist [seam.line]
weld-allowed-point-off-line = ein Punkt neben der Geraden vom Anfang zum Ende, oder kein solcher Schlüssel
weld-corner-radius-too-large = der Eckradius ist größer als die halbe kürzere Seite
weld-point-count = die Naht hat { $count ->
        [one] { $count } Punkt
       *[other] { $count } Punkte
    }
weld-allowed-point-count = { $min } bis { $max } Punkte, hier oder in einer Datei (`file`)
weld-point-above-plate = dieser Punkt liegt { $height } über der Platte
weld-point-below-plate = dieser Punkt liegt { $height } unter der Platte
weld-allowed-point-in-plane = ein Punkt in der Ebene durch den ersten mit dieser `normal`
weld-point-repeated = dieser Punkt fällt mit dem vorigen zusammen
weld-last-point-repeated = der letzte Punkt fällt mit dem ersten zusammen; die Naht schließt sich auch ohne ihn
weld-spline-point-repeated = Punkt { $point } fällt mit dem vorigen zusammen
weld-spline-last-point-repeated = der letzte Punkt, { $point }, fällt mit dem ersten zusammen; die Naht schließt sich auch ohne ihn
weld-allowed-points-apart = Punkte an verschiedenen Positionen
weld-allowed-points-apart-by = Punkte mindestens { $min } auseinander
weld-allowed-leave-point-out = diesen Punkt weglassen
weld-allowed-other-points = andere Punkte
weld-normal-not-square = die Normale der Fläche steht nicht senkrecht zur Naht
weld-allowed-square-to-line = senkrecht zu end_mm - start_mm
weld-faces-opposed = die Flächen zeigen aufeinander und lassen keine erreichbare Fuge
weld-spline-faces-opposed = Punkt { $point }: die Flächen zeigen aufeinander und lassen keine erreichbare Fuge
weld-allowed-not-opposite = nicht entgegengesetzt zu `{ $key }`
weld-helix-without-pitch = eine Schraubenlinie ohne Steigung ist ein Kreis
weld-allowed-pitch = nicht 0; für eine Naht um ein Rohr [seam.girth]
weld-helix-too-long = die Schraubenlinie hat zu viele Umläufe
weld-allowed-less-turn = kleinere Richtungsänderungen von Punkt zu Punkt
weld-allowed-normals-less-turn = Normalen, die sich von Punkt zu Punkt um weniger als 90° drehen
weld-normal-along-seam = die Normale einer Fläche liegt irgendwo längs der Naht
weld-allowed-normals-across = Normalen quer zur Naht
weld-closed-seam-has-no-ends = eine geschlossene Naht hat keine Enden
weld-allowed-no-key-closed = kein solcher Schlüssel bei `closed = true`
weld-tangent-backwards = die Tangente zeigt zurück, vom nächsten Punkt der Naht weg
weld-allowed-welding-direction = eine Richtung im Sinne des Schweißens
weld-normal-count = { $normals ->
        [one] { $normals } Normale
       *[other] { $normals } Normalen
    } für { $points ->
        [one] { $points } Punkt
       *[other] { $points } Punkte
    }
weld-allowed-one-per-point = eine je Punkt
weld-second-normals-alone = `second_normals` brauchen `first_normals`
weld-allowed-first-normals-too = auch `first_normals`
weld-normal-twice = jeder Punkt hat schon seine eigene Normale
weld-allowed-one-or-all-normals = entweder eine Normale oder eine je Punkt
weld-allowed-other-normals = andere Normalen
weld-skin-normal-along-web = die Normale der Haut liegt längs des Stegs
weld-allowed-out-of-skin = eine Richtung aus der Haut heraus
weld-allowed-thin-web = ein Steg, der viel dünner als der Bogenradius ist
weld-seam-without-surfaces = { $seam } hat keine Flächen, an die sich Punkte anpassen lassen
weld-seam-curved-t-joint = ein gekrümmter T-Stoß
weld-seam-arc = ein Bogen
weld-seam-rectangle = ein Rechteck
weld-seam-helix = eine Schraubenlinie
weld-seam-inside-girth = eine Rundnaht innen im Rohr
weld-seam-spline = ein Spline
weld-seam-polyline = ein Polygonzug
weld-allowed-fit-methods = die Verfahren three-point und plane-line-point

# Start and end of the weld.
weld-phi-too-large = der Winkel ist größer als zehn Umdrehungen
weld-overlap-with-end = eine Naht, die bei `end_phi_deg` endet, schließt sich nicht und hat keine Überlappung
weld-allowed-overlap-or-end = entweder `overlap_mm` oder `end_phi_deg`
weld-end-beside-turn = die Naht hätte keine Länge oder mehr als eine Umdrehung
weld-allowed-end-phi-more = mehr als phi_deg = { $start }, um bis zu { $max }
weld-allowed-end-phi-less = weniger als phi_deg = { $start }, um bis zu { $max }
weld-overlap-too-long = die Überlappung ist länger als die Naht
weld-start-at-first-point = diese Naht beginnt am ersten Punkt und läuft zum zweiten
weld-allowed-points-in-other-order = kein solcher Schlüssel; die Punkte in anderer Reihenfolge angeben
weld-start-of-open-seam = diese Naht läuft von einem Ende zum anderen und schließt sich nicht
weld-allowed-no-key-on-open-seam = kein solcher Schlüssel an einer offenen Naht

# Data outside the file.
weld-no-machine-here = hier steht keine Maschine zur Verfügung
weld-allowed-tip-coordinates = Koordinaten der Spitze x_mm, y_mm, z_mm
weld-no-files-here = hier stehen keine Dateien zur Verfügung
weld-points-twice = die Punkte sind zweimal angegeben
weld-allowed-points-or-axes = entweder `points_mm` oder `axes`
weld-position-not-finite = die Position ist nicht endlich
weld-allowed-finite-numbers = endliche Zahlen
weld-file-and-points = eine Datei und `{ $key }` sind angegeben
weld-allowed-points-in-file-or-job = Punkte und ihre Normalen in der Datei oder im Auftrag
weld-table-point-not-finite = { $file }: Punkt { $point } ist nicht endlich
weld-table-normal-without-length = { $file }: Punkt { $point } hat eine Normale ohne Länge
weld-allowed-coordinates-and-normals = endliche Koordinaten und Normalen mit einer Länge
weld-procedure-unreadable = die Datei der Schweißanweisung ist nicht lesbar: { $error }
weld-allowed-procedure = { $names } oder der Pfad einer Schweißanweisung vom Ordner des Auftrags aus
weld-procedure-not-text = das ist keine Textdatei
weld-allowed-toml = eine TOML-Datei in UTF-8
weld-wrong-wire = { $procedure } wird mit einem Draht von { $wire } geschweißt
weld-two-wires = `{ $other }` ist { $wire }: ein Draht hat einen Durchmesser
weld-allowed-wire = { $wire }, oder eine andere Schweißanweisung

# Taught spans.
weld-taught-spans-overlap = dieser Abschnitt beginnt, bevor der vorige endet
weld-allowed-taught-from = { $min } oder mehr; Abschnitte in der Reihenfolge des Schweißens
weld-taught-span-without-length = der Abschnitt hat keine Länge
weld-taught-span-beyond-seam = der Abschnitt endet hinter der Sollnaht
weld-taught-span-without-points = zwischen den Anschlüssen liegen keine Punkte
weld-allowed-taught-points = mindestens einer, in `points_mm` oder `axes`
weld-allowed-smooth-points = Punkte weiter auseinander oder näher an einer glatten Kurve
weld-taught-point-far = Punkt { $point } liegt { $distance } von der Sollnaht zwischen den Anschlüssen
weld-allowed-taught-within = { $key } = { $value }; oder ein größeres `{ $key }`, wenn das Teil so weit abweicht
weld-taught-point-out-of-order = Punkt { $point } liegt an der Naht bei s = { $s }
weld-allowed-taught-after-join = nach dem ersten Anschluss bei { $min } und vor dem zweiten Anschluss bei { $max }
weld-allowed-taught-after-point = nach dem vorigen Punkt bei { $min } und vor dem zweiten Anschluss bei { $max }
weld-taught-point-repeated = Punkt { $point } fällt mit einem Punkt oder Anschluss daneben zusammen
weld-allowed-taught-apart = Punkte und Anschlüsse mindestens { $min } auseinander
weld-taught-curve-turns = bei Punkt { $point } weicht die Kurve durch die Punkte { $angle } von der Naht ab
weld-allowed-taught-turn = bis { $max }: Punkte weiter auseinander oder näher an einer glatten Kurve

# Passes.
weld-pass-begins-beyond-end = die Lage beginnt hinter dem Ende der Naht
weld-pass-round-more-than-twice = die Lage geht mit einer Raupe mehr als zweimal um die Naht
weld-pass-beyond-end = die Lage geht über das Ende der Naht hinaus
weld-pass-beyond-start = die Lage läuft hinter den Anfang der Naht zurück
weld-pass-without-seam = die Lage hat keine Naht, an der sie entlangläuft
weld-travel-too-long = { $pass } wäre { $time } lang unterwegs
weld-allowed-travel-time = bis { $max }: eine höhere Geschwindigkeit
weld-bead-rows-too-short = die Zeilen reichen nicht über die ganze Lage
weld-pass-without-motion = in dieser Lage bewegt sich nichts
weld-allowed-point-elsewhere = ein Punkt anderswo
weld-arc-points-in-line = Anfang, `via_mm` und Ende des Bogens liegen auf einer Geraden, oder zwei davon fallen zusammen
weld-allowed-arc-points = drei Punkte, die nicht auf einer Geraden liegen; ein Vollkreis sind zwei Bögen

# Findings of passes.
weld-torch-inside-first-face = der Brenner läge um { $angle } hinter der Fläche des ersten Teils (Flächenwinkel { $dihedral })
weld-torch-inside-second-face = der Brenner läge um { $angle } hinter der Fläche des zweiten Teils (Flächenwinkel { $dihedral })
weld-cure-smaller-work-angle = den Arbeitswinkel kleiner machen als den halben Flächenwinkel
weld-bead-goes-back = die Raupe stünde (fast) still oder liefe zurück: sie liegt jenseits der Mitte der Nahtkrümmung, oder ihre Zeilen ändern sich zu schnell
weld-cure-bead-nearer = die Raupe dort näher an die Naht legen
weld-bead-area-out-of-range = um die Fuge zu füllen, hätte die Raupe { $area }: { $ratio } der { $run } ihrer Vorgabe; erlaubt sind { $min } bis { $max }
weld-cure-thinner-layers = dünnere Lagen, größere Raupen (Querschnitt, Drahtvorschub, geringere Geschwindigkeit), adapt = "passes" oder ein größeres most_percent
weld-cure-smaller-beads = kleinere Raupen (höhere Geschwindigkeit, weniger Draht), adapt = "passes" oder ein größeres most_percent
weld-bead-width-out-of-window = die Raupe wäre { $width } breit und { $height } hoch; erlaubte Breite: { $min } bis { $max }
weld-bead-height-out-of-window = die Raupe wäre { $height } hoch und { $width } breit; erlaubte Höhe: { $min } bis { $max }
weld-bead-ratio-out-of-window = die Raupe wäre { $width } breit und { $height } hoch: ein Verhältnis von { $ratio }; erlaubt: { $min } bis { $max }
weld-bead-too-wide-without-weave = die Raupe wäre ohne Pendeln { $width } breit und { $height } hoch; erlaubt: bis { $max }
weld-bead-toe-steep = der Nahtübergangswinkel der Decklage wäre { $angle }; erlaubt: { $min } oder mehr
weld-layer-height-not-kept = die Lage wäre { $height } hoch statt { $wanted }: Raupen von { $area } füllen sie anders
weld-cure-bead-window = layer_mm oder Querschnitt des Laufs (Geschwindigkeit, Drahtvorschub) ändern, adapt = "passes", oder ein anderes Fenster in der Schweißanweisung
weld-cure-weave-or-smaller-beads = dem Lauf ein Pendeln geben, oder kleinere Raupen (höhere Geschwindigkeit, weniger Draht)
weld-cure-bead-toe = cap_mm senken, spacing_to_width näher an 2/3, oder flachere Decklagenraupen (Pendeln, kleinerer Querschnitt)
weld-cure-layer-height = layer_mm näher an diese Höhe setzen, oder den Querschnitt des Laufs ändern (Geschwindigkeit, Drahtvorschub)

# Joints.
weld-groove-at = bei s = { $s }: { $why }
weld-remaining-area-impossible = die Fuge hat keine solche offene Fläche
weld-scan-after-last-layer = bis dahin { $layers ->
        [one] ist { $layers } Lage
       *[other] sind { $layers } Lagen
    } geplant: für diese Messung bleibt keine
weld-scan-too-few-points = nur { $found } Punkte; nötig sind { $needed }
weld-scan-no-groove = die Fuge ist nicht da: { $share } % der Punkte liegen auf ihr, mit einer Streuung von { $scatter } mm
weld-scan-other-angle = die Flächen oder Kanten stehen in { $angle }; gezeichnet sind { $drawn }
weld-scan-uncertain = die offene Fläche ist um { $uncertainty } unsicher: eine Kante ist nicht zu sehen
weld-groove-no-butt = Flächen unter { $dihedral } zueinander bilden keinen Stumpfstoß
weld-groove-no-corner = Flächen unter { $dihedral } zueinander bilden weder Kehlnaht noch T-Stoß
weld-groove-no-outside-corner = Flächen unter { $dihedral } zueinander bilden keine Außenecke
weld-groove-edge-within-part = die vorbereitete Kante, { $angle } zur Fläche des anderen Teils, bleibt innerhalb ihres Teils: der Flächenwinkel ist { $dihedral }
weld-groove-edge-in-other-part = der Schnitt lässt { $angle } zur Fläche des anderen Teils: die Kante läge in diesem Teil
weld-groove-edges-cross = die Kanten kreuzen sich
weld-groove-empty = die Fuge hat keine Fläche
weld-standard-of-other-joints = { $standard } gilt für andere Stöße als diesen
weld-joint-beside-standard = { $size } beträgt { $value } bei s = { $s }: { $standard } gibt für diese Fugenform { $min } bis { $max } an
weld-joint-below-standard = { $size } beträgt { $value } bei s = { $s }: { $standard } gibt für diesen Stoß mindestens { $min } an
weld-joint-beside-standard-at-dihedral = { $size } beträgt { $value } bei s = { $s }: { $standard } gibt bei einem Flächenwinkel von { $dihedral } { $min } bis { $max } an
weld-size-thickness = die Wanddicke
weld-size-groove-angle = der Öffnungswinkel
weld-size-root-gap = der Stegabstand
weld-size-root-face = die Steghöhe
weld-size-cover-throat = die Dicke der Deckkehlnaht
weld-cure-joint-standard = die Fugenform ändern oder die Schweißung damit qualifizieren
weld-allowed-butt-dihedral = ein Flächenwinkel von { $min } oder mehr, oder eine Kehlnaht
weld-allowed-corner-dihedral = ein Flächenwinkel bis { $max }, oder ein Stumpfstoß
weld-allowed-outside-corner = ein Flächenwinkel zwischen { $min } und { $max } (joint = "corner" der Naht)
weld-allowed-edge-cut = überall mehr als 90° minus Flächenwinkel
weld-allowed-larger-gap = ein größerer Stegabstand oder weniger Kantenversatz
weld-allowed-room-to-weld = ein Stegabstand oder Winkel, der Platz zum Schweißen lässt

# Beads.
weld-beads-without-joint = es gibt keine Fuge zu füllen
weld-allowed-joint = ein [joint] mit seiner Fugenvorbereitung
weld-stations-with-beads = mit [beads] gehören Werte zu [beads.root], [beads.fill] und [beads.cap]
weld-sector-position-unclear = die Position des Sektors ist nicht klar
weld-sectors-unequal = die Sektoren geben Faktoren für verschiedene Werte an
weld-sectors-at-one-place = zwei Sektoren liegen bei s = { $s }
weld-feed-follows-area = der Drahtvorschub folgt dem Querschnitt der Fuge
weld-allowed-s-or-phi = entweder s_mm oder phi_deg
weld-allowed-same-factors = die Namen der ersten Zeile
weld-allowed-sectors-apart = verschiedene Positionen
weld-allowed-no-feed-factor = kein Faktor dafür, oder ein anderes adapt
weld-allowed-no-table-or-beads = keine solche Tabelle, oder kein [beads]
weld-ramp-with-beads = ein Wert mit einer Rampe über die Naht passt nicht zu [beads]
weld-travel-angle-twice = der Anstellwinkel ist hier und an mehreren Positionen der Naht angegeben
weld-allowed-travel-angle-once = kein solcher Schlüssel, oder kein [[torch.at]]
weld-area-with-wire-feed = eine angegebene Fläche folgt nicht dem Drahtvorschub
weld-allowed-no-area-with-wire-feed = kein solcher Schlüssel bei adapt = "wire_feed"
weld-bead-area-missing = die Querschnittsfläche einer Raupe fehlt
weld-insert-without-root = ein Einlegeteil braucht einen Wurzellauf, der es aufschmilzt
weld-allowed-insert-root = `root` in [beads], oder kein Einlegeteil
weld-allowed-bead-area = area_mm2, oder beads.wire_mm und wire_feed_m_min
weld-bead-area-needs-steady-feed = die Querschnittsfläche einer Raupe braucht einen festen Drahtvorschub
weld-allowed-steady-feed = wire_feed_m_min größer als 0 in [weld.process] oder hier, oder area_mm2
weld-deposition-too-large = die Raupe hätte mehr Metall als der Draht
weld-bead-range-too-large = Raupen behalten über einen solchen Bereich nicht ihre Form
weld-wall-tilt-too-large = der Draht läge an der Wand
weld-step-over-needs-closed-seam = ein Übergang zur nächsten Raupe braucht eine rundum geschweißte Naht
weld-wire-implausible = so dick ist kein Draht ({ $wire })
weld-step-over-too-short = der Übergang ist so kurz, dass der Brenner quer zur Naht führe
weld-step-over-too-long = der Übergang ist länger als die halbe Naht
weld-step-over-with-alternate = durch Übergänge verbundene Raupen laufen in einer Richtung
weld-step-over-with-passes = Lagen über einen Teil der Naht lassen sich nicht durch Übergänge verbinden
weld-step-over-with-parts = eine Lage mit Übergängen lässt sich nicht in Teilen schweißen
weld-allowed-no-step-over = kein Übergang, oder eine rundum geschweißte Naht
weld-station-distance-invalid = unzulässiger Abstand der Stationen
weld-no-bead-weaves = keine Raupe wird gependelt
weld-allowed-weave = ein [weld.weave], ein `weave` von [beads.root], [beads.fill] oder [beads.cap], oder ein anderer Wert
weld-bead-spacing-invalid = so weit oder so dicht können Raupen nicht liegen
weld-layer-height-impossible = Raupen von { $area } ergeben keine Lagen dieser Höhe
weld-too-many-beads = die Fuge von { $groove } braucht { $beads } Raupen von { $bead }
weld-too-many-stations = die Raupen würden an { $count ->
        [one] { $count } Station
       *[other] { $count } Stationen
    } angeordnet
weld-too-many-bead-positions = { $passes ->
        [one] { $passes } Lage
       *[other] { $passes } Lagen
    } mit je { $rows ->
        [one] { $rows } Zeile
       *[other] { $rows } Zeilen
    } sind zu viele
weld-allowed-larger-beads = größere Raupen: geringere Geschwindigkeit oder mehr Draht; bis { $max } Raupen füllen eine Fuge
weld-allowed-smaller-groove = bis { $max } Raupen: eine kleinere Fuge oder größere Raupen
weld-allowed-stations = bis { $max } Stationen: ein größerer Abstand
weld-allowed-bead-positions = bis { $max } Positionen: ein größerer Abstand oder größere Raupen

# Order of welding: copies, parts, tacks.
weld-order-without-rows = es gibt keine Reihen, zwischen denen gewechselt wird
weld-allowed-two-rows = zwei Reihen: [rows] oder `row` in jeder von [[copies]]
weld-skip-invalid = so wird keine Kopie übersprungen, oder alle
weld-allowed-no-skip = kein Überspringen: zu wenige Kopien in einer Reihe
weld-allowed-skip = 2 bis { $max }: die längste Reihe hat { $copies ->
        [one] { $copies } Kopie
       *[other] { $copies } Kopien
    }
weld-copies-twice = die Kopien sind zweimal angegeben
weld-allowed-rows-or-copies = entweder [rows] oder [[copies]]
weld-too-many-passes = insgesamt { $passes } Lagen sind zu viele
weld-allowed-passes = bis { $max }: weniger Kopien oder Heftstellen, oder weniger oder längere Teile
weld-too-many-rows = { $passes ->
        [one] { $passes } Lage
       *[other] { $passes } Lagen
    } mit insgesamt { $rows } Zeilen von Raupen und Abschnitten sind zu viele
weld-allowed-row-count = bis { $max } Zeilen: weniger Kopien oder Heftstellen, weniger oder längere Teile, oder ein größeres beads.station_mm
weld-copy-count-invalid = unzulässige Zahl der Kopien
weld-too-many-copies = zu viele Kopien
weld-allowed-columns = 1 bis { $max }: insgesamt { $copies } Kopien
weld-copies-coincide = Kopien stünden an derselben Position
weld-allowed-row-step = ein Schritt neben die Linie der Reihe oder über ihr Ende
weld-copy-too-far = eine Kopie stünde zu weit entfernt
weld-allowed-copies-within = Kopien innerhalb von { $limit } um 0
weld-seam-without-corners = die Naht hat keine Ecken
weld-overlap-at-corners = Teile von Ecke zu Ecke haben keine Überlappung
weld-allowed-no-overlap-at-corners = 0 bei order.parts = "at_corners"
weld-seam-without-quarters = eine Naht, die nicht ringsum geschweißt wird, hat keine gegenüberliegenden Viertel
weld-pieces-longer-than-weld = die Stücke wären länger als die Naht
weld-too-many-pieces = zu viele Stücke
weld-allowed-piece-length = mindestens { $min }: bis { $count } Stücke
weld-tie-in-too-long = die Überlappung der Teile ist nicht kürzer als ein Teil
weld-allowed-tie-in = weniger als ein Teil: { $max }
weld-all-round-has-one-end = eine ringsum geschweißte Naht endet, wo sie beginnt
weld-cosmetic-ramp = eine Glättlage hat feste Werte
weld-cosmetic-beyond-end = die Glättlage beginnt hinter dem Ende der Naht
weld-tack-count-or-pitch = die Zahl der Heftstellen folgt aus genau einem von zwei Schlüsseln
weld-allowed-count-or-pitch = entweder `count` oder `pitch_mm`
weld-tack-count-invalid = unzulässige Zahl der Heftstellen
weld-tack-ramp = eine Heftstelle hat feste Werte
weld-too-many-tacks = zu viele Heftstellen
weld-allowed-tack-pitch = mindestens { $min }: bis { $count } Heftstellen
weld-tacks-meet = die Heftstellen würden sich treffen
weld-allowed-tack-length = weniger als der Abstand von Heftstelle zu Heftstelle: { $count } auf { $length } Naht
weld-tacks-near-start = Heftstellen begännen { $distance } vom Anfang der Naht
weld-allowed-tack-clearance = bis { $max }, oder weniger Heftstellen

# The part as solids.
weld-part-replaced-by-nothing = das aus der Naht gemachte Werkstück ist ersetzt, aber es sind keine Körper angegeben
weld-allowed-part-solids = [[part.solids]] dazu, oder kein solcher Schlüssel
weld-allowed-rigid-placement = eine starre Aufstellung
weld-body-too-short = der Körper endete innerhalb der Naht
weld-part-from-seam = das aus der Naht gemachte Werkstück: { $why }
weld-allowed-part-sizes = Maße bis { $max }, auch die von [part]; oder [[part.solids]] mit part.replace = true
weld-allowed-sphere = eine Kugel
