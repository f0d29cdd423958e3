# Errors of curves, surfaces and their intersections.
geometry-size = { $what }: muss eine endliche Zahl größer als 0 sein, nicht { $value }
geometry-range = { $what }: muss mehr als { $min } und weniger als { $max } sein, nicht { $value }
geometry-too-small = { $what }: muss endlich und mehr als { $min } sein, nicht { $value }
geometry-direction = { $what }: muss ein endlicher Vektor mit einer Länge größer als 0 sein
geometry-parallel = { $first } und { $second } sind parallel
geometry-tube-larger-than-body = das Rohr ist größer als der Körper: seine Wand verfehlt ihn bei jedem Winkel
geometry-tube-beside-body = das Rohr geht am Körper vorbei und trifft ihn nicht
geometry-not-closed = die Rohrwand verfehlt den Körper zwischen phi = { $from } und { $to }: die Kurve schließt sich nicht
geometry-beyond-head = die Rohrwand liegt zwischen phi = { $from } und { $to } jenseits des Bordendes des Bodens
geometry-tangent = die Rohrwand berührt den Körper bei phi = { $angle } tangential: die Kurve hat dort keine Tangente
geometry-beside-trimming-tube = ab phi = { $angle } geht die Rohrwand an dem Rohr vorbei, das sie beschneidet
geometry-never-leaves = die Richtung des Rohrs zeigt in den Körper: entlang +direction verlässt das Rohr ihn nicht
geometry-arc-length = die Länge der Kurve ließ sich nahe Parameter { $parameter } nicht auf { $accuracy } genau bestimmen
geometry-sharp-turn = { $what }: dreht sich von einem Punkt zum nächsten um 90° oder mehr
geometry-gap = Stück { $piece } der Kette beginnt nicht am Ende des Stücks davor
geometry-knots = die Positionen der Werte eines Splines müssen streng ansteigen (Wert { $index })
geometry-column = eine Spalte hat { $values } Werte für { $points } Punkte
geometry-point = Punkt { $index } hat einen Wert, der zu groß oder nicht endlich ist

# Errors of fits to touched points.
geometry-too-few-points = zu wenige Punkte ({ $what }): { $given } angegeben, mindestens { $min } nötig
geometry-points-in-one-position = die Punkte ({ $what }) fallen fast zusammen: sie bestimmen das Gesuchte nicht
geometry-points-on-one-line = die Punkte ({ $what }) liegen fast auf einer Geraden: sie bestimmen das Gesuchte nicht
geometry-short-arc = der Kreis wurde nur über { $touched } angetastet; mindestens { $min } sind nötig
geometry-attitudes-alike = die Stellungen unterscheiden sich um höchstens { $angle }: sie bestimmen den Werkzeugmittelpunkt (TCP) nicht
geometry-no-fit = es wurde keine Lage gefunden, in der das Werkstück zu den Punkten passt

# Motions that touched points leave free.
geometry-motion-along = Verschieben entlang { $direction }
geometry-motion-about = Drehen um die Achse entlang { $direction } durch { $point } mm
geometry-motion-screw = Drehen um die Achse entlang { $direction } durch { $point } mm, je Umdrehung { $pitch } entlang der Achse

# Maps between pixels and a plane.
geometry-map-scale = ein Pixel von { $scale }: erlaubt sind { $min } bis { $max }
geometry-map-shear = eine Scherung von { $shear }: erlaubt ist { $min } bis { $max }
geometry-map-rotation = eine Drehung von { $rotation }: erlaubt ist eine endliche Zahl innerhalb einer halben Umdrehung
geometry-map-centre = die Mitte ({ $x }, { $y }) liegt um mehr als die Bildgröße außerhalb des Bildes
geometry-map-barrel = eine Verzeichnung von { $barrel }: erlaubt ist höchstens { $max }, und keine Faltung innerhalb des Bildes
geometry-heights-empty = die Höhentabelle hat keine Zeilen
geometry-heights-order = Zeile { $row }: die Höhe { $height } liegt nicht über der Höhe der Zeile davor
geometry-heights-frame-size = Zeile { $row }: die Bildgröße ist anders als in der ersten Zeile
geometry-heights-between = zwischen den Zeilen { $row } und { $next }: { $why }
geometry-height-outside = eine Höhe von { $height }: die Tabelle der Kamera reicht von { $min } bis { $max }
geometry-pixel-folded = das Pixel ({ $x }, { $y }) liegt außerhalb des Bereichs der Verzeichnung

# Names of sets of points.
geometry-points-chain = Kette
geometry-points-spline = Spline
geometry-points-frame = Koordinatensystem
geometry-points-nominal-frame = Nennkoordinatensystem
geometry-points-measured-frame = gemessenes Koordinatensystem
geometry-points-plane = Ebene
geometry-points-line = Gerade
geometry-points-point = Punkt
geometry-points-origin = Ursprung
geometry-points-direction = Richtung
geometry-points-circle = Kreis
geometry-points-tube = Rohr
geometry-points-surfaces = Flächen
geometry-points-tip = Werkzeugmittelpunkt (TCP)
geometry-points-taught-line = geteachte Linie

# Names of sizes and directions.
geometry-tube-radius = Rohrradius
geometry-tube-direction = Richtung des Rohrs
geometry-tube-zero-direction = Nullrichtung des Rohrs
geometry-zero-direction = seine Nullrichtung
geometry-tube-origin = Ursprung des Rohrs
geometry-sphere-radius = Kugelradius
geometry-cylinder-radius = Zylinderradius
geometry-cylinder-axis = Zylinderachse
geometry-elliptic-cylinder-semi-axis = Halbachse des elliptischen Zylinders
geometry-elliptic-cylinder-axis = Achse des elliptischen Zylinders
geometry-elliptic-cylinder-x-direction = x-Richtung des elliptischen Zylinders
geometry-ellipsoid-semi-axis = Halbachse des Ellipsoids
geometry-ellipsoid-axis = Achse des Ellipsoids
geometry-ellipsoid-x-direction = x-Richtung des Ellipsoids
geometry-x-direction = die x-Richtung
geometry-cone-axis = Kegelachse
geometry-cone-half-angle = halber Kegelwinkel
geometry-torus-ring-radius = Ringradius des Torus
geometry-torus-tube-radius = Rohrradius des Torus
geometry-torus-axis = Achse des Torus
geometry-torus-centre = Mitte des Torus
geometry-body-position = Position des Körpers
geometry-plane-normal = Ebenennormale
geometry-head-radius = Radius des Bodens
geometry-head-depth = Höhe des Bodens
geometry-head-flange = zylindrischer Bord des Bodens
geometry-head-axis = Achse des Bodens
geometry-crown-radius = Kalottenradius
geometry-knuckle-radius = Krempenradius
geometry-wall-of-ellipsoid = Wanddicke
geometry-line-length = Länge der Geraden
geometry-arc-axis = Achse des Bogens
geometry-arc-radius = Bogenradius
geometry-arc-angle = Bogenwinkel
geometry-chord-to-via-point = die Gerade zum Zwischenpunkt
geometry-chord-to-end = die Gerade zum Endpunkt
geometry-helix-pitch = Steigung der Schraubenlinie
geometry-turns = Anzahl der Umdrehungen
geometry-width = Breite
geometry-height = Höhe
geometry-corner-radius = Eckradius
geometry-rectangle-normal = Normale des Rechtecks
geometry-width-direction = Richtung der Breite
geometry-semi-axis-a = Halbachse a der Ellipse
geometry-semi-axis-b = Halbachse b der Ellipse
geometry-ellipse-normal = Normale der Ellipse
geometry-semi-axis-a-direction = Richtung der Halbachse a
geometry-curve = die Kurve
geometry-curve-through-points = die Kurve durch die Punkte
geometry-normal = die Normale
geometry-face-normal = eine Flächennormale
geometry-tolerance = Toleranz
geometry-column-tolerance = Toleranz weiterer Spalten
