# Reasons for a low confidence of a detected joint.
vision-doubt-clutter = viele erkannte Punkte liegen nicht auf den Linien der Fuge: Reflexe oder Spritzer
vision-doubt-short = ein Teil der Fuge ist in weniger als 30 Spalten zu sehen: den Sensor näher oder über die ganze Fuge bringen
vision-doubt-uneven = ein Teil der Fuge ist nicht gerade: seine Punkte liegen mehrere Zeilen neben der Linie
vision-doubt-light = der Lichtstreifen beginnt und endet nicht mit den Teilen der Fuge: dunkle Stellen darauf, Licht jenseits der Enden oder ein verdecktes Ende
vision-doubt-shape = die Form liegt an der Grenze dieser Stoßart
vision-doubt-moved = die Fuge liegt weit von ihrer erwarteten Position
vision-doubt-unknown = ein Punkt oder ein Wert der Fuge ist unbekannt

# Reasons why no joint was detected.
vision-no-stripe = das Bild zeigt keinen Lichtstreifen
vision-saturated = das Bild ist überbelichtet: Belichtungszeit oder Licht verringern
vision-short-stripe = der Lichtstreifen ist in { $found } von { $columns } Spalten zu sehen; ein Viertel ist nötig
vision-too-few-points = das Profil hat { $found } brauchbare Punkte; nötig sind { $needed }
vision-no-corner = im Profil wurde keine Ecke aus zwei Flächen unter 60° bis 120° gefunden
vision-no-groove = zwischen zwei Schultern wurde keine Fuge dieser Art gefunden
vision-no-step = zwischen zwei parallelen Blechen wurde keine Stufe gefunden
vision-no-seam = zwischen zwei fluchtenden Blechen wurde weder Spalt noch Kantenversatz noch dunkle Linie gefunden

# Reasons why a picture of a grid of dots gives no map.
vision-grid-pitch = ein Rasterabstand von { $pitch }: erlaubt ist eine endliche Zahl größer als 0
vision-grid-plain = keine dunklen Punkte: das Bild ist fast gleichmäßig (die dunkelsten Stellen sind { $contrast } dunkler als ihre Umgebung)
vision-grid-few-dots = gefundene Rasterpunkte: { $found }; mindestens { $min } sind nötig, über das ganze Bild verteilt
vision-grid-tangled = die Punkte bilden kein einheitliches Raster: bei ({ $x }, { $y }) treffen sich Zeilen und Spalten nicht
vision-grid-corner = die Punkte bedecken { $part } der Breite oder Höhe des Bildes; mindestens die Hälfte ist nötig
vision-grid-residual = die Punkte weichen um { $rms } RMS von der besten Abbildung ab; erlaubt sind { $max }: das Bild zeigt ein anderes Raster oder ist unscharf
vision-grid-map = die Anpassung an die Punkte ergibt eine ungültige Abbildung: { $why }

# Frames.
vision-frame-size = ein Bild von { $width } x { $height } Pixeln: erlaubt sind Seiten von 1 bis { $max } Pixeln
vision-frame-pixels = { $found } Pixel für ein Bild von { $width } x { $height }; nötig sind { $needed }
