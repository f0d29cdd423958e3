# Words by names in files: the part behind the first hyphen is the name.

# Process values, without their units.
value-heat-input = Wärmeeinbringung
value-tip-speed = Geschwindigkeit der Spitze
value-current = Strom
value-voltage = Spannung
value-wire-feed = Drahtvorschub
value-power = Leistung
value-beam-current = Strahlstrom
value-accelerating = Beschleunigungsspannung
value-beam = Strahlstrom
value-frequency = Frequenz
value-focus = Fokus
value-gas = Gas
value-laser = Laserleistung
value-speed = Schweißgeschwindigkeit
value-travel-angle = Schlepp-/Stechwinkel
value-work-angle = Arbeitswinkel
value-stick-out = Freies Drahtende
value-preheat = Vorwärmtemperatur
value-interpass = Zwischenlagentemperatur

# Deviations.
track-lateral = Seitlich
track-height = In der Höhe

# Welding processes, by their numbers in ISO 4063.
process-111 = Lichtbogenhandschweißen
process-114 = Metall-Lichtbogenschweißen mit selbstschützender Fülldrahtelektrode
process-121 = Unterpulverschweißen mit Massivdraht
process-131 = MIG-Schweißen mit Massivdraht
process-135 = MAG-Schweißen mit Massivdraht
process-136 = MAG-Schweißen mit schweißpulvergefüllter Drahtelektrode
process-138 = MAG-Schweißen mit metallpulvergefüllter Drahtelektrode
process-141 = WIG-Schweißen mit massivem Zusatz
process-142 = WIG-Schweißen ohne Zusatz
process-15 = Plasmaschweißen
process-51 = Elektronenstrahlschweißen
process-52 = Laserstrahlschweißen
