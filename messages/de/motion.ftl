# Limits of axes and of the torch tip.
motion-limit-speed = Geschwindigkeitsgrenze
motion-limit-acceleration = Beschleunigungsgrenze
motion-limit-jerk = Ruckgrenze

# Speed that the axes do not allow.
motion-speed-axis = Achse { $axis } kann { $asked } nicht halten: ihre { $limit } von { $value } erlaubt { $reached }
motion-speed-tip = die Brennerspitze kann { $asked } nicht halten: ihre { $limit } von { $value } erlaubt { $reached }
motion-speed-rounded-off = die Spitze fährt mit { $reached } statt { $asked }: die geforderte Geschwindigkeit ändert sich dort, und das Geschwindigkeitsprofil rundet die Änderung ab
motion-speed-slowed = { $reason }; dort wird langsamer geschweißt, wie gefordert
motion-too-short = die Naht ist zu kurz: zwischen Beschleunigungs- und Bremsphase werden { $reached } von { $asked } erreicht
motion-too-short-between-stops = der Weg zwischen zwei Halten ist zu kurz: zwischen Beschleunigungs- und Bremsphase werden { $reached } von { $asked } erreicht
motion-no-speed-profile = für die Achsen von { $machine } gibt es kein Geschwindigkeitsprofil: { $reason }
motion-profile-limit = die { $limit } von Kanal { $channel } ist { $value }; sie muss eine endliche Zahl größer als 0 sein (eine Ruckgrenze darf unendlich sein)
motion-profile-asked = die geforderte Geschwindigkeit bei { $at } ist { $value }; sie muss größer als 0 sein
motion-profile-range = die Bahn geht von { $from } bis { $to }; ihr Ende muss eine endliche Zahl und größer als ihr Anfang sein
motion-profile-not-smooth = Kanal { $channel } ist bei { $at } nicht glatt: eine Ableitung ist keine endliche Zahl
motion-profile-still = zwischen { $from } und { $to } bewegt sich nichts: keine Grenze beschränkt dort die Geschwindigkeit

# Weave that is too fast.
motion-weave-frequency = das Pendeln ist zu schnell: { $reason }; bei { $width } Breite ist die höchste Frequenz { $frequency }
motion-weave-pitch = das Pendeln ist zu schnell: { $reason }; bei { $width } Breite ist die kleinste Teilung { $pitch }

# Corners: stops and blends.
motion-stop = der Brenner hält bei s = { $s } mit brennendem Lichtbogen: Geschwindigkeit oder Beschleunigung von Achse { $axis } würde dort springen
motion-stop-because = der Brenner hält bei s = { $s } mit brennendem Lichtbogen: Geschwindigkeit oder Beschleunigung von Achse { $axis } würde dort springen; { $reason }
motion-blend = der Brenner überschleift die Ecke bei s = { $s }: auf { $over } weicht die Spitze um bis zu { $deviation } von der Naht ab
motion-blend-turned = der Brenner überschleift die Ecke bei s = { $s }: auf { $over } weicht die Spitze um bis zu { $deviation } von der Naht ab, ihre Richtung um bis zu { $turned }
motion-blend-no-room = für ein Überschleifen ist kein Platz: die nächste Ecke oder das Ende ist { $distance } entfernt
motion-blend-turns-back = die Bahn kehrt dort um, und kein Überschleifen ist möglich
motion-blend-too-far = das kürzeste Überschleifen, über { $over }, führt die Spitze mehr als { $deviation } von der Naht weg oder dreht den Brenner um mehr als { $turned } aus der geforderten Richtung
motion-cure-stop-weave = mit corner = "stop" dort mit brennendem Lichtbogen halten; oder mit pitch_mm statt einer Frequenz pendeln; oder die Naht runden; oder die Naht dort beenden und danach eine neue beginnen
motion-cure-stop-or-blend = mit corner = "stop" dort mit brennendem Lichtbogen halten, oder mit corner = {"{ blend_mm = 0.2 }"} die Ecke höchstens so weit neben der Naht überschleifen; oder die Naht runden; oder die Naht dort beenden und danach eine neue beginnen
motion-cure-stop = mit corner = "stop" an Ecken halten; oder die Naht runden; oder die Naht dort beenden und danach eine neue beginnen

# Minimum speed of the welding procedure with the arc on.
motion-least-speed-stop = die Spitze fährt bei s = { $at } mit { $reached } bei brennendem Lichtbogen, und die Mindestgeschwindigkeit der Schweißanweisung ist { $minimum }: dort hält sie an einer Ecke
motion-least-speed-axis = die Spitze fährt bei s = { $at } mit { $reached } bei brennendem Lichtbogen, und die Mindestgeschwindigkeit der Schweißanweisung ist { $minimum }: die { $limit } von Achse { $axis }, { $value }, erlaubt nicht mehr
motion-least-speed-tip = die Spitze fährt bei s = { $at } mit { $reached } bei brennendem Lichtbogen, und die Mindestgeschwindigkeit der Schweißanweisung ist { $minimum }: die { $limit } der Brennerspitze, { $value }, erlaubt nicht mehr
motion-least-speed-short = die Spitze fährt bei s = { $at } mit { $reached } bei brennendem Lichtbogen, und die Mindestgeschwindigkeit der Schweißanweisung ist { $minimum }: die Naht ist zu kurz, um mehr zu erreichen
motion-least-speed-start = der Brenner fährt mit brennendem Lichtbogen aus dem Stillstand an: auf { $over } ist er langsamer als die Mindestgeschwindigkeit der Schweißanweisung von { $minimum }
motion-least-speed-end = der Brenner kommt mit brennendem Lichtbogen zum Stillstand: auf { $over } ist er langsamer als die Mindestgeschwindigkeit der Schweißanweisung von { $minimum }
motion-cure-least-speed-blend = mit corner = {"{ blend_mm = 0.2 }"} Ecken höchstens so weit neben der Naht überschleifen; oder die Naht davor beenden und danach eine neue beginnen; oder least_speed_mm_s senken, wenn die Schweißanweisung dafür qualifiziert ist
motion-cure-least-speed-axis = das Werkstück so aufstellen oder den Brenner so drehen, dass sich Achse { $axis } dort weniger bewegt; oder die Naht davor beenden und danach eine neue beginnen; oder least_speed_mm_s senken, wenn die Schweißanweisung dafür qualifiziert ist
motion-cure-least-speed-tip = die Grenzen der Spitze in der Maschinendatei anheben, wenn der Brenner es zulässt; oder die Naht davor beenden und danach eine neue beginnen; oder least_speed_mm_s senken, wenn die Schweißanweisung dafür qualifiziert ist
motion-cure-least-speed-longer = die Naht länger machen; oder die Naht davor beenden und danach eine neue beginnen; oder least_speed_mm_s senken, wenn die Schweißanweisung dafür qualifiziert ist

# Operator actions against a speed that the axes do not allow.
motion-cure-longer-change = die Geschwindigkeit über einen längeren Weg ändern, oder mit weld.on_limit = "slow" dort langsamer werden
motion-cure-speed = { $speed } fordern, die jede Achse überall halten kann, oder mit weld.on_limit = "slow" dort langsamer werden
motion-cure-speed-or-blend = { $speed } fordern, die jede Achse überall halten kann, oder mit weld.on_limit = "slow" dort langsamer werden, oder ein längeres Überschleifen erlauben
motion-cure-speed-part = { $part } der Geschwindigkeit fordern, die jede Achse überall halten kann, oder mit weld.on_limit = "slow" dort langsamer werden
motion-cure-speed-part-or-blend = { $part } der Geschwindigkeit fordern, die jede Achse überall halten kann, oder mit weld.on_limit = "slow" dort langsamer werden, oder ein längeres Überschleifen erlauben
motion-cure-slow = mit weld.on_limit = "slow" dort langsamer werden
motion-cure-slow-or-blend = mit weld.on_limit = "slow" dort langsamer werden, oder ein längeres Überschleifen erlauben
motion-cure-speed-at-most = höchstens { $speed } fordern, oder weld.on_limit = "slow" setzen
motion-cure-weave-frequency = frequency_hz = { $frequency } oder eine kleinere Breite fordern, oder mit weld.on_limit = "slow" dort langsamer werden
motion-cure-weave-pitch = pitch_mm = { $pitch }, eine kleinere Breite oder eine kleinere Geschwindigkeit fordern, oder mit weld.on_limit = "slow" dort langsamer werden
motion-cure-limits = den Achsen der Maschine endliche Grenzen größer als 0 geben, und der Lage eine Geschwindigkeit und eine Länge

# Times.
motion-time-too-long = { $key } = { $time }: eine Lage darf höchstens { $limit } dauern
motion-cure-time = { $key } auf höchstens { $limit } setzen
motion-travel-too-long = mit der geforderten Geschwindigkeit dauert die Fahrt { $time }: eine Lage darf höchstens { $limit } dauern
motion-cure-travel = eine höhere speed_mm_s fordern oder die Naht in mehrere Lagen teilen
motion-travel-too-long-axes = mit den Grenzen der Achsen dauert die Fahrt { $time }: eine Lage darf höchstens { $limit } dauern
motion-cure-travel-axes = den Achsen der Maschine höhere Geschwindigkeiten und Beschleunigungen geben oder die Naht in mehrere Lagen teilen

# Reach and ranges of the axes.
motion-unreachable = { $machine }: { $reason }
motion-cure-unreachable = Aufstellung des Werkstücks, Brennerwinkel oder Maschine ändern
motion-no-solution = keine Achsstellungen folgen der Bahn
motion-no-positions = keine Achsstellungen erreichen die Stelle
motion-axis-beyond = Achse { $axis } müsste { $by } über ihren Bereich hinausfahren
motion-unreachable-redundant = { $machine }, bei jeder Stellung der redundanten Achsen: { $reason }
motion-cure-unreachable-redundant = Aufstellung des Werkstücks, Brennerwinkel oder gehaltene Achsen ändern
motion-beyond-range = Achse { $axis } würde auf { $value } fahren, { $by } über ihre Grenze { $limit } hinaus
motion-cure-range = das Werkstück so aufstellen, dass die Achse in ihrem Bereich bleibt
motion-attitude = { $machine } hat zu wenige Achsen für die ganze Brennerstellung: sie weicht bis zu { $error } von der geforderten ab (Toleranz { $tolerance })
motion-arc-off-line = { $machine } kann die geforderte Brennerstellung nicht halten, und der Brenner ist für sein freies Drahtende um { $back } zurückgezogen: der Lichtbogen läge { $off } neben seiner Linie
motion-cure-attitude = Brennerwinkel ändern, eine Maschine mit einer Drehachse mehr nehmen oder mit tolerance.attitude_deg mehr erlauben
motion-cure-arc-off-line = mit dem freien Drahtende der Maschine schweißen, die Brennerwinkel ändern oder eine Maschine mit einer Drehachse mehr nehmen
motion-not-smooth = die Achsen von { $machine } können dem Brenner hier nicht glatt folgen: er geht durch eine singuläre Stellung
motion-not-smooth-redundant = bei jeder Stellung der redundanten Achsen von { $machine } können die anderen dem Brenner nicht glatt folgen: er geht durch eine singuläre Stellung oder verlässt ihre Reichweite
motion-jump = jede Stelle ist erreichbar, aber nicht stetig: zwischen s = { $from } und { $to } müsste Achse { $axis } um { $by } springen
motion-cure-jump = nicht versucht: in Teilen schweißen (start.end_phi_deg), ein anderer Anfang oder eine andere Aufstellung können helfen
motion-near-singular = { $distance } vor einer singulären Stellung braucht Achse { $axis } { $used } ihres Vermögens bei { $asked }; hier wären { $holds } möglich
motion-cure-near-singular = für mehr Reserve Brenner oder Werkstück um einige Grad neigen

# Axes that are held.
motion-hold-unknown = zwischen Werkstück und Brenner gibt es keine Achse { $axis }
motion-hold-decided = Achse { $axis } ist nicht redundant: die Brennerstellung bestimmt hier alle Achsen
motion-hold-too-few = wenn { $held } gehalten werden, erreichen die anderen Achsen nicht jede Brennerstellung
motion-hold-range = Achse { $axis } würde auf { $value } gehalten, außerhalb ihres Bereichs
motion-hold-allowed-none = keine Achse
motion-hold-allowed-count = { $axes ->
    [1] eine Achse, oder eine andere
   *[other] bis zu { $axes } Achsen, oder andere
}

# Changes of the job that were tried as cures.
motion-change-move = das Werkstück um { $x }; { $y }; { $z } entlang x, y, z versetzen (placement.move_mm)
motion-change-work-angle = torch.work_angle_deg um { $by } ändern
motion-change-work-angles = work_angle_deg in jedem [[torch.at]] um { $by } ändern
motion-cure-range-weld = { $change }: geprüft, alle Achsen bleiben dann in ihrem Bereich
motion-cure-range-pass = { $change }: für diese Lage geprüft, alle Achsen bleiben dann in ihrem Bereich
motion-cure-range-none = keine gefunden: Versetzen des Werkstücks und andere Arbeitswinkel wurden versucht
motion-cure-range-none-moved = keine gefunden: Versetzen des Werkstücks wurde versucht
motion-cure-range-none-angle = keine gefunden: andere Arbeitswinkel wurden versucht
motion-cure-range-none-stroke = { $tried }; Achse { $axis } bräuchte { $needed } entlang der Naht, ihr Bereich ist { $stroke }
motion-cure-redundant = mit redundanten Achsen wurde nichts versucht: das Werkstück näher an die Mitte der Achsbereiche stellen
motion-cure-range-no-time = in der erlaubten Zeit wurde nichts versucht
motion-cure-range-stopped = { $changes ->
    [one] in der erlaubten Zeit keine gefunden: { $tried } von { $changes } Änderung wurde versucht
   *[other] in der erlaubten Zeit keine gefunden: { $tried } von { $changes } Änderungen wurden versucht
}
motion-cure-not-tried = nicht versucht: andere Brennerwinkel oder eine andere Aufstellung des Werkstücks können helfen

# Clearance.
motion-too-near = { $first } kommt bis auf { $distance } an { $second } heran (mindestens { $minimum })
motion-collision = { $first } stößt gegen { $second } (mindestens { $minimum })
motion-above-root = { $contact }, { $height } über der Wurzel
motion-below-root = { $contact }, { $height } unter der Wurzel
motion-no-torch-angle = keine Winkel bis { $work } neben dem Arbeitswinkel und { $travel } neben dem Anstellwinkel halten den Brenner frei: { $reason }
motion-no-torch-angle-longer = keine Winkel bis { $work } neben dem Arbeitswinkel und { $travel } neben dem Anstellwinkel halten den Brenner frei, auch mit einem bis zu { $longer } längeren freien Drahtende: { $reason }
motion-angle-none-allowed = die Flächen des Stoßes, die Schweißanweisung oder der Bereich einer Achse erlauben keinen davon
motion-angle-turns-too-fast = die freien ändern sich um mehr als { $turn } auf { $way }
motion-cure-torch-angle = einen schlankeren Brenner oder ein längeres freies Drahtende, eine weitere Fuge, weitere Grenzen in torch.search, oder weniger Abstand mit clearance.least_mm
motion-cure-clearance = die Brennerwinkel oder die Aufstellung ändern, oder mit clearance.least_mm weniger erlauben, wenn die Körper stimmen
motion-cure-clearance-weld = { $change }: geprüft, dann kommt nichts zu nahe; oder mit clearance.least_mm weniger erlauben, wenn die Körper stimmen
motion-cure-clearance-pass = { $change }: für diese Lage geprüft, dann kommt nichts zu nahe; oder mit clearance.least_mm weniger erlauben, wenn die Körper stimmen
motion-cure-clearance-none = keine gefunden: Arbeitswinkel bis { $angle } daneben helfen nicht; das Hindernis entfernen, oder mit clearance.least_mm weniger erlauben, wenn die Körper stimmen
motion-cure-clearance-stopped = { $angles ->
    [one] in der erlaubten Zeit keine gefunden: { $tried } von { $angles } Arbeitswinkel wurde versucht; das Hindernis entfernen, oder mit clearance.least_mm weniger erlauben, wenn die Körper stimmen
   *[other] in der erlaubten Zeit keine gefunden: { $tried } von { $angles } Arbeitswinkeln wurden versucht; das Hindernis entfernen, oder mit clearance.least_mm weniger erlauben, wenn die Körper stimmen
}
motion-cure-clearance-move = das Hindernis entfernen, oder mit clearance.least_mm weniger erlauben, wenn die Körper stimmen
motion-no-shapes = { $machine } hat keine Körper: nichts wird auf Kollisionen geprüft, Leerfahrten gehen gerade
motion-cure-no-shapes = Brenner und Glieder mit [[shapes.<link>]] in der Maschinendatei beschreiben

# Transfer moves.
motion-transfer-from-home = die Leerfahrt von der Grundstellung zur Naht
motion-transfer-home = die Leerfahrt von der Naht zurück in die Grundstellung
motion-transfer-between = die Leerfahrt von Lage { $from } zu Lage { $to }
motion-transfer-too-long = { $move }: sie dauert { $time }, erlaubt sind höchstens { $limit }
motion-cure-transfer-too-long = den Achsen der Maschine höhere Geschwindigkeiten und Beschleunigungen geben oder das Werkstück näher rücken
motion-transfer-blocked = { $move }: { $reason }
motion-cure-transfer-blocked = nicht versucht: Werkstück, Vorrichtung oder Grundstellung versetzen oder ein anderer Anfang der Naht können helfen
motion-transfer-start = ihr Anfang ist nicht frei: { $obstacle }
motion-transfer-end = ihr Ende ist nicht frei: { $obstacle }
motion-transfer-retract = der Rückzug ist nicht frei: { $obstacle }
motion-transfer-approach = das Anfahren ist nicht frei: { $obstacle }
motion-transfer-none = kein freier Weg wurde gefunden; auf dem geraden Weg gilt: { $obstacle }
motion-retract-short = { $move }: der Brenner kann nur { $distance } von { $asked } zurückziehen
motion-retract-none = { $move }: keine Achse kann den Brenner in seiner Längsrichtung zurückziehen, er fährt seitlich weg
motion-cure-retract = sicherstellen, dass dort neben der Naht nichts steht, oder einen kleineren Rückzug fordern
motion-unwind = { $move }: Achse { $axis } dreht um { $by } zurück

# Planning that was stopped.
motion-search-out-of-time = kein Plan in { $limit } Suche: { $progress }
motion-search-cancelled = die Planung wurde abgebrochen: { $progress }
motion-search-progress = { $positions ->
    [one] { $stage } war zu { $part } fertig, { $positions } Stellung versucht
   *[other] { $stage } war zu { $part } fertig, { $positions } Stellungen versucht
}
motion-search-reach = Lösen der Stellungen entlang der Naht
motion-search-sampling = Abtasten der redundanten Achsen
motion-search-joining = Verbinden der abgetasteten Stellungen
motion-search-refining = Verfeinern der redundanten Achsen
motion-search-speed = Planen des Geschwindigkeitsprofils
motion-search-weave = Versuchen von Pendelfrequenzen
motion-search-transfer = Suchen einer Leerfahrt
motion-search-cure = Versuchen von Abhilfen
motion-search-torch-angles = Versuchen von Brennerwinkeln
motion-cure-search = mehr Zeit erlauben, redundante Achsen festhalten (spare_axes.hold), ihre Bereiche in der Maschinendatei verkleinern oder die Naht in Teilen schweißen
motion-cure-plan-again = neu planen

# Comparison with the welding procedure specification.
motion-quantity-speed = die Geschwindigkeit der Spitze
motion-quantity-heat-input = die Wärmeeinbringung
motion-quantity-travel-angle = der Schlepp-/Stechwinkel
motion-quantity-work-angle = der Arbeitswinkel
motion-quantity-stick-out = das freie Drahtende
motion-run-pass = Lage { $passes }
motion-run-passes = Lagen { $passes }
motion-procedure-outside = { $quantity } ist { $found } bei s = { $at }; { $procedure } erlaubt ({ $run }) { $min } bis { $max }
motion-procedure-unbounded = { $quantity } ist bei s = { $at } unbegrenzt, wo der Brenner mit brennendem Lichtbogen hält; { $procedure } erlaubt ({ $run }) { $min } bis { $max }
motion-procedure-no-power = die Lage gibt { $keys } nicht an, daher ist ihre Wärmeeinbringung unbekannt; { $procedure } erlaubt ({ $run }) { $min } bis { $max }
motion-procedure-no-faces = die Flächen des Stoßes sind unbekannt, daher auch der Arbeitswinkel; { $procedure } erlaubt ({ $run }) { $min } bis { $max }
motion-procedure-no-stick-out = das freie Drahtende ist unbekannt; { $procedure } erlaubt ({ $run }) { $min } bis { $max }
motion-procedure-missing = die Lage gibt { $key } nicht an; { $procedure } erlaubt ({ $run }) { $min } bis { $max }
motion-implausible = { $key } = { $found } passt nicht zu { $current }: üblich ist { $expected }, { $percent } mehr oder weniger
motion-cure-implausible = { $key }, Strom und Draht prüfen; bei einem besonderen Lichtbogen percent in [plausibility] der Anweisung erweitern
motion-cooling-outside = die Naht kühlt in { $found } von 800 auf 500 °C ab; erlaubt sind { $min } bis { $max }
motion-cooling-unbounded = der Brenner hält mit Lichtbogen an: die Abkühlzeit ist unbegrenzt; erlaubt sind { $min } bis { $max } (höchstens { $found })
motion-cure-cooling-slow = Wärmeeinbringung oder Zwischenlagentemperatur senken
motion-cure-cooling-fast = Wärmeeinbringung oder Vorwärmung erhöhen
motion-preheat-low = die Anweisung wärmt auf { $found } vor; EN 1011-2 (Verfahren B) verlangt { $needed }
motion-pool-too-large = die Raupe hat { $area } bei s = { $s } in Position { $position }; ohne Pendeln bleiben höchstens { $max } an ihrem Platz
motion-cure-preheat-low = die Untergrenze von preheat_c und interpass_c auf { $needed } anheben
motion-cure-pool = kleinere Raupen (höhere Geschwindigkeit, weniger Draht) oder Pendeln, oder das Werkstück näher zur Wannenlage drehen
motion-preheat-range = die Vorwärmung ist extrapoliert: Verfahren B der EN 1011-2 gilt für CET 0,2 bis 0,5 %, 10 bis 90 mm, 1 bis 20 ml Wasserstoff in 100 g und 0,5 bis 4 kJ/mm
motion-interpass-wait = wartet { $time }, bis die Naht abgekühlt ist
motion-interpass-thickness = das Warten auf die Zwischenlagentemperatur braucht die Dicke der Teile
motion-interpass-power = das Warten auf die Zwischenlagentemperatur braucht die Wärmeeinbringung
motion-interpass-never = die Naht kühlt in zwei Tagen nicht unter die Zwischenlagentemperatur ab
motion-cure-interpass = [materials] und die Anweisung ergänzen, oder in [interpass] wait_s statt below_c angeben
motion-procedure-no-run = kein Eintrag von { $procedure } gilt für Lage { $pass } ({ $name })
motion-procedure-position = die Naht liegt in Position { $position }; { $procedure } erlaubt ({ $run }) { $positions }
motion-procedure-inclination = die Naht liegt in Position { $position } (Neigung { $min_slope } bis { $max_slope }, Drehung { $min_rotation } bis { $max_rotation }); { $procedure } erlaubt ({ $run }) { $positions }
motion-cure-procedure-run = [[runs]] mit Namen oder Nummer der Lage in die Anweisung aufnehmen, oder die Lage umbenennen; oder eine dafür qualifizierte Schweißanweisung nehmen
motion-cure-procedure-power = { $keys } in weld.process angeben, oder in der Anweisung `power` auf die Werte setzen, die die Leistung ergeben; oder eine dafür qualifizierte Schweißanweisung nehmen
motion-cure-procedure-work-angle = work_angle_deg aus dem Eintrag der Anweisung nehmen; oder eine dafür qualifizierte Schweißanweisung nehmen
motion-cure-procedure-stick-out = stick_out_mm in [torch] der Maschinendatei angeben
motion-cure-procedure-own-stick-out = stick_out_mm des Laufs oder von [torch] ändern; oder eine dafür qualifizierte Schweißanweisung nehmen
motion-cure-procedure-missing = { $key } in weld.process angeben oder aus [runs.ranges] nehmen; oder eine dafür qualifizierte Schweißanweisung nehmen
motion-cure-procedure-slower = dort weniger Geschwindigkeit fordern; oder eine dafür qualifizierte Schweißanweisung nehmen
motion-cure-procedure-faster = dort mehr Geschwindigkeit fordern, oder so aufstellen, dass die Achsen sie halten; oder eine dafür qualifizierte Schweißanweisung nehmen
motion-cure-procedure-less-heat = dort schneller oder mit weniger Leistung schweißen; oder eine dafür qualifizierte Schweißanweisung nehmen
motion-cure-procedure-more-heat = dort langsamer oder mit mehr Leistung schweißen; oder eine dafür qualifizierte Schweißanweisung nehmen
motion-cure-procedure-angles = dort die Brennerwinkel ändern, oder eine Maschine mit genug Achsen nehmen; oder eine dafür qualifizierte Schweißanweisung nehmen
motion-cure-procedure-lower = dort { $key } senken (weld.process des Auftrags oder Abschnitte des Programms); oder eine dafür qualifizierte Schweißanweisung nehmen
motion-cure-procedure-raise = dort { $key } erhöhen (weld.process des Auftrags oder Abschnitte des Programms); oder eine dafür qualifizierte Schweißanweisung nehmen
motion-cure-procedure-position = das Werkstück anders drehen oder neigen (placement, Nullpunktverschiebung, spare_axes), oder in Gegenrichtung schweißen, wo aus fallend steigend wird; oder eine dafür qualifizierte Schweißanweisung nehmen

# Simulated weld.
motion-simulated-path = die simulierte Brennerspitze weicht { $deviation } von der Naht ab; erlaubt sind { $tolerance }
motion-cure-simulated-path = die Schleppfehler ansehen: Lageregler einstellen oder langsamer schweißen
motion-cure-simulated-path-tracked = die Ergebnisse der Nahtverfolgung ansehen: Sensor, Geschwindigkeit und Reichweite der Korrekturen
motion-cure-simulated-path-untracked = die Naht verfolgen oder das Werkstück wie geplant aufstellen
motion-simulated-speed = die simulierte Geschwindigkeit der Spitze weicht { $deviation } von der geplanten ab; erlaubt sind { $tolerance }
motion-cure-simulated-speed = feinere Geber, weichere Lageregler, weniger Reibung oder eine höhere Geschwindigkeit wählen
motion-simulated-stop = die Schweißung wurde bei { $at } gestoppt: { $reason }; danach wurde nichts geschweißt
motion-simulated-other-head = ein anderer Kopf hielt an
motion-cure-simulated-stop = das Werkstück näher an die geplante Stelle setzen, den Sensor instand setzen oder langsamer schweißen
motion-simulated-drive = der Antrieb von Achse { $axis } erreicht seine Stromgrenze
motion-cure-simulated-drive = einen stärkeren Antrieb oder weniger max_acceleration in der Maschinendatei nehmen

# Playing a speed profile under an operator's commands.
motion-override = der Override muss von 0 bis { $max } sein, nicht { $value } (bis 1,5 mit einem dafür geplanten Geschwindigkeitsprofil)
motion-override-faster = der Override muss von 0 bis { $max } sein, nicht { $value }
motion-override-zero = der Override ist 0: vor dem Fortsetzen einen größeren als 0 einstellen
motion-period = die Periode muss von 0,00025 bis 0,004 s sein, nicht { $value }
motion-path-length = die Weglänge muss von 0 bis { $length } sein, nicht { $value }
motion-faster-profile = das schnellere Profil muss für mehr als das 1- und bis zum 1,5-Fache der Geschwindigkeit geplant sein, nicht { $value }
motion-step-end = ein Schritt muss hinter { $welded }, dem Ende des Geschweißten, und spätestens bei { $length } enden, nicht bei { $value }
motion-stuck = die Bewegung kann bei { $s } nicht weitergehen: das Geschwindigkeitsprofil überschreitet dort die Grenzen der Achsen

# Manual motion.
motion-jog-range = Achse { $axis } kann nicht auf { $value } fahren: ihr Bereich ist { $min } bis { $max }
motion-jog-position = die Position von Achse { $axis } ist keine endliche Zahl
motion-jog-speed = die Geschwindigkeit von Achse { $axis } ist keine endliche Zahl
motion-jog-tip = die Geschwindigkeit der Spitze ist keine endliche Zahl
motion-jog-period = die Periode ist { $value }; sie muss größer als 0 und höchstens 1 s sein
motion-jog-silence = die Signalüberwachungszeit ist { $value }; sie muss größer als 0 und höchstens 1 s sein
motion-jog-override = der Override ist { $value }; er muss größer als 0 und höchstens 1 sein
motion-jog-axis = { $axes ->
    [one] die Maschine hat { $axes } Achse, und keine Achse { $axis }
   *[other] die Maschine hat { $axes } Achsen, und keine Achse { $axis }
}
motion-jog-not-clear = am Anfang sind { $first } und { $second } { $distance } voneinander entfernt; mindestens { $minimum } sind gefordert
motion-jog-halted = der Tippbetrieb hat angehalten: zuerst Ruhe befehlen
motion-jog-no-motion = vom jetzigen Zustand zum Ziel wurde keine Bewegung innerhalb der Grenzen gefunden

# Pulses.
motion-pulses-too-fast = eine Periode braucht { $asked } Impulse, höchstens { $max } sind möglich
motion-pulses-crowded = { $pulses ->
    [one] { $pulses } Impuls passt nicht zwischen den Richtungswechsel und das Ende der Periode
   *[other] { $pulses } Impulse passen nicht zwischen den Richtungswechsel und das Ende der Periode
}
motion-pulses-position = die Position von { $steps } Schritten liegt zu weit von null, um gezählt zu werden; erlaubt: bis 1e11
motion-pulses-period = eine Periode von { $ticks } Takten des Zeitgebers; erlaubt: 1 bis 2,7e11

# Textbook interpolators.
motion-value-not-positive = { $what }: eine endliche Zahl größer als 0 ist nötig, nicht { $value }
motion-value-not-finite = { $what }: eine endliche Zahl ist nötig, nicht { $value }
motion-value-semi-axis-a = Halbachse a
motion-value-semi-axis-b = Halbachse b
motion-value-x = x eines Punkts
motion-value-y = y eines Punkts
motion-value-nozzle-radius = Radius des Stutzens
motion-value-shell-radius = Radius des Mantels
motion-value-start-angle = Anfangswinkel
motion-value-sweep = Überstrichener Winkel
motion-value-speed = Geschwindigkeit
motion-value-period = Periode
motion-value-step = Geschwindigkeit mal Periode
motion-value-pulse = Impulswert
motion-start-off-ellipse = der Anfangspunkt ({ $x }; { $y }) liegt { $distance } neben der Ellipse; höchstens { $tolerance } sind erlaubt, ihr nächster Punkt ist ({ $near_x }; { $near_y })
motion-end-off-ellipse = der Endpunkt ({ $x }; { $y }) liegt { $distance } neben der Ellipse; höchstens { $tolerance } sind erlaubt, ihr nächster Punkt ist ({ $near_x }; { $near_y })
motion-nozzle-too-large = der Radius des Stutzens { $nozzle } muss kleiner sein als der Radius des Mantels { $shell }
motion-sweep = der überstrichene Winkel darf nicht 0 und in jeder Richtung höchstens { $limit } sein, nicht { $sweep }
motion-step-too-long = ein Schritt von { $step } (Geschwindigkeit mal Periode) ist zu lang für diese Bahn: höchstens { $max } (die Länge der Bahn, oder ein Achtel eines ganzen Umlaufs)
motion-pulse-too-large = ein Impuls von { $pulse } ist zu groß für diese Form: höchstens { $max }
motion-too-many-steps = das braucht etwa { $steps } Schritte oder Impulse; die Grenze ist { $max }
motion-not-verified = Lage { $pass }: die geplante Bewegung ist nicht abspielbar ({ $why })

# Reach of placements.
motion-reach-jump = keine stetige Bewegung der Achsen führt über die Bahn
motion-reach-speed = Achse { $axis } bräuchte { $used } ihrer Geschwindigkeit bei { $asked }
motion-reach-position = die Schweißposition liegt { $by } außerhalb der von der Anweisung erlaubten
