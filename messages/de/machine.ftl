# Steps and axes of the machine file.
machine-step-neither = der Schritt ist weder eine Achse noch fest
machine-step-kinds = entweder `axis` mit seinen Schlüsseln oder `fixed` allein
machine-step-fixed-axis = der Schritt hat sowohl `axis` als auch `fixed`
machine-step-fixed-apart = `fixed` in einem eigenen Schritt
machine-axis-name-invalid = der Achsname enthält unzulässige Zeichen
machine-plain-letters = Kleinbuchstaben, Ziffern und _
machine-axis-name-reserved = der Name ist für eine andere Spalte der Tabellen reserviert
machine-axis-turn-or-move = eine Achse dreht entweder oder verfährt linear
machine-turn-or-move = genau einer von `turn` und `move`
machine-axis-key-of-rotary = eine Linearachse hat keinen solchen Schlüssel
machine-only-with-turn = nur mit `turn`
machine-axis-lacks-key = der Achse `{ $axis }` fehlt `{ $key }`
machine-key-positive = { $key } = eine Zahl größer als 0
machine-home-outside-range = die Referenzstellung liegt außerhalb des Bereichs
machine-letter-invalid = kein Achsbuchstabe
machine-linear-axis-in-mm = eine Linearachse wird in mm angegeben
machine-rotary-axis-in-degrees = eine Drehachse wird in Grad angegeben
machine-range-of-continuous = eine Endlosachse hat keinen Bereich
machine-continuous-or-range = `continuous` oder ein Bereich
machine-range-missing = die Achse hat keinen Bereich
machine-range-form = { $key } = [Minimum, Maximum]
machine-range-form-or-continuous = { $key } = [Minimum, Maximum] oder continuous = true
machine-range-empty = der Bereich ist leer
machine-axis-name-taken = eine andere Achse heißt schon so
machine-axis-letter-taken = eine andere Achse hat schon diesen Buchstaben
machine-own-letter = ein eigener Buchstabe
machine-axes-count = die Maschine hat { $n ->
        [one] { $n } Achse
       *[other] { $n } Achsen
    }
machine-axes-allowed = 1 bis { $max } Achsen in [[tool]] und [[work]]
machine-home-order-twice = die Achse steht schon in der Liste
machine-each-axis-once = jede Achse einmal

# Torch and heads.
machine-torch-and-heads = die Maschine hat sowohl `[torch]` als auch `[[heads]]`
machine-torch-or-heads = `[torch]` für einen Kopf, `[[heads]]` für zwei
machine-torch-missing = die Maschine hat keinen Brenner
machine-torch-form = `[torch]` mit `direction` oder zwei `[[heads]]`
machine-heads-many = die Maschine hat { $n ->
        [one] { $n } Kopf
       *[other] { $n } Köpfe
    }
machine-head-without-steps = der Kopf `{ $head }` hat keine eigenen Schritte: nichts trägt ihn
machine-head-steps = `[[heads.steps]]` für jeden Kopf
machine-head-name-taken = eine Achse, ein anderer Kopf oder ein Koordinatensystem heißt schon so
machine-frame-name = Benutzerkoordinatensystem mit dem Namen „{ $name }“
machine-frame-name-allowed = bis { $max } Zeichen, keiner von { $names }

# Outputs and controls.
machine-output-taken = `{ $name }` hat diesen Ausgang schon
machine-own-output = ein eigener Ausgang
machine-address-invalid = unzulässige Adresse
machine-address-form = ein Großbuchstabe außer G und N, dann Großbuchstaben, Ziffern und _, wie X oder CW
machine-address-taken = eine andere Achse oder Prozessgröße hat schon diese Adresse
machine-own-address = eine eigene Adresse
machine-code-invalid = unzulässiger G- oder M-Code
machine-code-form = G oder M und eine Zahl, wie M54
machine-event-invalid = unzulässiger Name eines Ereignisses
machine-event-names = { $names } oder ein eigener Name aus Kleinbuchstaben, Ziffern und _
machine-kinematics-output = nur LinuxCNC schaltet die Kinematik über einen Ausgang um

# Drives.
machine-drive-of-linear = der Antrieb einer Linearachse hat Masse und Kraft, und Längen in mm
machine-drive-of-rotary = der Antrieb einer Drehachse hat Trägheitsmoment und Drehmoment, und Winkel in Grad
machine-drive-key-missing = dem Antrieb fehlt ein Schlüssel
machine-drive-limit-range = die Grenze liegt nicht zwischen Reibung und Spitzenwert
machine-drive-without-resonance = ohne Resonanz sind Motor und Last eine Masse
machine-drive-resonance-alone = eine Resonanz braucht das Verhältnis von Last- zu Motorträgheit
machine-together-with = zusammen mit `{ $key }`
machine-fraction-too-large = der Anteil ist größer als 1
machine-notches-many = der Lageregler hat zu viele Kerbfilter
machine-notch-too-high = { $frequency } liegt nicht unter der halben Abtastrate
machine-notch-depth = die Verstärkung in der Mitte ist größer als 1
machine-friction-smoothing-alone = es gibt keine Reibungskompensation
machine-backlash-time-alone = es gibt keine Losekompensation

# Steppers and their pulses.
machine-full-steps = ein Zweiphasenmotor hat 4 Vollschritte je Zahn des Rotors
machine-multiple-of-4 = ein Vielfaches von 4, meist 200
machine-microsteps-invalid = unzulässige Mikroschritte des Treibers
machine-microsteps-allowed = ganze Zahlen von 1 bis { $max }, steigend, mindestens eine
machine-pulse-time = Pulse mit je { $time } High und Low sind zu lang für diese Frequenz
machine-stepper-lacks-key = dem Schrittmotor fehlt `{ $key }`
machine-motor-key-missing = dem Motor fehlt ein Schlüssel
machine-motor-keys = rotor_inertia_kg_m2, torque_rpm und torque_n_m zusammen, oder ohne alle drei
machine-torque-lengths = Drehzahlen: { $speeds }, Drehmomente: { $torques }
machine-torque-equal-lengths = so viele Drehmomente wie Drehzahlen, mindestens 2
machine-torque-speeds = die Drehmomentkurve beginnt nicht im Stillstand mit steigender Drehzahl
machine-zero-then-increasing = zuerst 0, dann steigend
machine-torque-holding = der Motor hat kein Haltemoment
machine-torque-first = zuerst ein Haltemoment größer als 0
machine-stepper-missing = die Achse `{ $axis }` hat keinen Schrittmotor für Pulse
machine-stepper-or-other-drives = [drives.{ $axis }.stepper] oder andere Antriebe als `steps`
machine-resolution-too-fine = die feinste Einstellung des Treibers ist gröber
machine-pulse-rate = die Achse `{ $axis }` braucht bei Höchstgeschwindigkeit ({ $speed }, Mikroschritte: { $microsteps }) Pulse mit { $needed }; der Treiber nimmt bis { $possible } an
machine-pulse-rate-allowed = eine Höchstgeschwindigkeit bis { $speed }, eine gröbere `{ $resolution }` oder ein schnellerer Treiber (max_pulse_hz, min_pulse_us)
machine-pulses-after-reversal = nach einer Umkehr { $n ->
        [one] passt { $n } Puls
       *[other] passen { $n } Pulse
    } nicht in die Periode
machine-direction-times-allowed = direction_setup_us und direction_hold_us zusammen bis { $time }
machine-tick = der Zeitgeber hat einen Takt von { $tick }
machine-tick-allowed = 10 bis 100000 ns, eine ganze Zahl von Malen in der Periode von { $period }
machine-stream-file = `{ $file }` ist keine VCD-Datei
machine-stream-file-allowed = der Pfad einer Datei, der auf .vcd endet, oder kein `stream`

# Pitch errors.
machine-pitch-in-mm = die Tabelle des Steigungsfehlers der Achse `{ $axis }` wird in mm angegeben
machine-pitch-in-degrees = die Tabelle des Steigungsfehlers der Achse `{ $axis }` wird in Grad angegeben
machine-pitch-keys = { $positions } und { $errors }, gleich lange Listen
machine-pitch-lengths = Positionen: { $positions }, Fehler: { $errors }
machine-pitch-equal-lengths = so viele Fehler wie Positionen, mindestens 2
machine-pitch-positions = unzulässige Positionen der Tabelle des Steigungsfehlers
machine-increasing-positions = steigende Positionen
machine-increasing-within-a-turn = steigende Positionen innerhalb einer Umdrehung
machine-pitch-steep = der Fehler ändert sich um das { $slope }-Fache des Wegs: zu steil für einen Steigungsfehler

# Sensors.
machine-image-width = unzulässige Breite des Bildes
machine-image-height = unzulässige Höhe des Bildes
machine-image-size = 1 bis { $max } Spalten und Zeilen
machine-frames-of-stripe = ein Laserschnittsensor hat keinen Bildstrom
machine-frames-invalid = unzulässige Bildquelle
machine-frames-form = für eine Kamera: "tcp://HOST:PORT"
machine-stripe-map-missing = ein Laserschnittsensor braucht `map`, von Pixeln in mm
machine-stripe-maps = `map.camera`, `map.homography` oder `map.scale`
machine-camera-angle = die Kamera würde die Fuge nicht sehen
machine-map-of-camera = diese Abbildung ist für eine Kamera
machine-map-singular = verschiedene Pixel hätten dieselbe Position
machine-map-invertible = Zahlen einer umkehrbaren Abbildung
machine-map-horizon = das Pixel ({ $column }, { $row }) liegt jenseits des Horizonts: es sieht keinen Punkt der Laserebene
machine-map-every-pixel = eine Abbildung, die jedem Pixel des Bildes eine Position gibt
machine-camera-map-missing = eine Kamera braucht `map.heights`
machine-heights-order = z steigt nicht von Zeile zu Zeile
machine-more-than-before = mehr als in der Zeile davor
machine-heights-rows = Zeilen einer Kamera, mindestens eine

# Shapes and zones.
machine-zone-watches-nothing = `{ $link }` hat keine Körper: die Zone würde nichts überwachen
machine-shapes-first = ein Glied mit [[shapes.{ $link }]]
machine-zone-empty = die Zone hat kein Volumen
machine-zone-solids = mindestens ein [[zones.solids]]
machine-zone-shape = eine erlaubte Zone kann diese Form nicht haben
machine-part = Werkstück
machine-fixtures = Vorrichtungen
machine-solid-of-part = { $name } (Werkstück)
machine-solid-of-fixtures = { $name } (Vorrichtungen)
machine-forbidden-zone = Verbotszone { $zone }
machine-permitted-zone = erlaubte Zone { $zone }

# Interlocks.
machine-interlocks-many = die Maschine hat { $n ->
        [one] { $n } Verriegelung
       *[other] { $n } Verriegelungen
    }
machine-interlock-name-empty = der Name ist leer
machine-interlock-input-empty = der Eingang hat keinen Namen
machine-a-name = ein Name
machine-interlock-name-taken = eine andere Verriegelung heißt schon so
machine-interlocks-contradict = `{ $first }` verlangt am Eingang { $input } { $first_value }, `{ $second }` dagegen { $second_value }: nichts könnte je laufen
machine-value-or-other-input = { $value } oder ein anderer Eingang
machine-input-taken = `{ $interlock }` überwacht den Eingang { $input } schon
machine-one-interlock-an-input = eine Verriegelung je Eingang: for = "{ $level }" ist die stärkere

# Devices.
machine-out-of-range = der Wert liegt außerhalb des Bereichs
machine-unit-reserved = diese Geräteadresse ist reserviert
machine-unit-allowed = 0 bis 247 oder 255
machine-device-without-registers = das Gerät hat keine Register
machine-device-without-role = das Gerät ist weder Stromquelle noch hat es Eingänge
machine-device-roles = Register für Eingänge oder für outputs.on und reports.burning
machine-host-missing = der Host fehlt
machine-port-missing = ein Port von 1 bis 65535 fehlt
machine-host-and-port = Host:Port, wie 192.168.1.20:502 oder [fe80::1]:502
machine-fault-code-type = ein Fehlercode ist ein einfaches u16
machine-exactly-one-of = genau eines von { $names }
machine-register-tables = es ist nicht genau eine Tabelle genannt
machine-register-read-only = `{ $table }` kann nur gelesen werden, hier wird geschrieben
machine-register-single-bit = `{ $table }` ist ein einzelnes Bit
machine-bit-with-register = `bit` mit holding oder input
machine-register-bits = ein Register hat 16 Bit
machine-bit-allowed = 0 (niederwertigstes) bis 15
machine-bit-form = bit = 0 (niederwertigstes) bis 15
machine-safe-of-input = nur Ausgänge haben einen sicheren Zustand
machine-safe-with-outputs = `safe` mit gas, on und set
machine-safe-state-on = der sichere Zustand von Lichtbogen oder Strahl ist aus
machine-words-of-16-bits = 16 Bit sind ein Register
machine-words-with-32-bits = `words` mit u32, i32 und f32
machine-register-last = 32 Bit brauchen zwei Register, und dies ist das letzte
machine-scale-zero = jede Zahl wäre derselbe Wert
machine-not-zero = jede Zahl außer 0
machine-safe-out-of-range = das Register kann diesen Wert nicht aufnehmen
machine-register-taken = `{ $register }` liegt schon auf { $address }
machine-source-taken = das Gerät `{ $device }` ist schon die Stromquelle
machine-one-source = eine Stromquelle
machine-source-without-register = die Stromquelle hat kein Register für `{ $key }`
machine-inputs-taken = das Gerät `{ $device }` hat schon Eingänge
machine-inputs-on-one-device = alle Eingänge an einem Gerät
machine-input-without-register = der Eingang `{ $input }` der Verriegelung `{ $interlock }` hat kein Register
machine-register-for-every-input = ein Register für den Eingang jeder Verriegelung
machine-drives-taken = ein anderes Gerät hat die Antriebe schon
machine-one-device-of-drives = ein Gerät mit `linuxcnc`, `steps`, `rtde`, `egm` oder `rsi`
machine-robot-axis-twice = Achse `{ $axis }` ist zweimal genannt
machine-robot-axis-missing = Achse `{ $axis }` hat kein Gelenk der Robotersteuerung
machine-robot-axis-once = jede Achse der Maschine einmal, in der Reihenfolge der Gelenke der Steuerung
machine-robot-axis-count = { $n } { $n ->
        [one] Achse passt
       *[other] Achsen passen
    } nicht zu den Gelenken der Robotersteuerung
machine-robot-axis-count-allowed = { $arm } Gelenke des Arms und bis zu { $external } externe Gelenke
machine-robot-axis-linear = Achse `{ $axis }` ist linear, aber ein Gelenk des Arms
machine-robot-axis-rotary = Drehachsen als die ersten { $arm }
machine-robot-listen = keine IP-Adresse mit Port
machine-robot-listen-allowed = eine IP-Adresse dieses Rechners mit Port, wie 0.0.0.0:6510
machine-robot-from = keine IP-Adresse
machine-robot-from-allowed = die IP-Adresse der Steuerung, wie 192.168.125.1
machine-hal-file = `{ $file }` ist keine HAL-Datei
machine-hal-file-allowed = der Pfad einer Datei, der auf .hal endet, oder kein `hal`
machine-base-period = unzulässige Periode des schnelleren Threads: { $base }
machine-base-period-allowed = 10 bis 1000, eine ganze Zahl von Malen in der Periode von { $period }, mindestens zweimal
machine-axis-name-long = der Name der Achse `{ $axis }` ist zu lang für die HAL von LinuxCNC
machine-name-length = bis { $max } Zeichen

# Reasons why a pose is out of reach.
machine-unreachable-direction = die Drehachsen können den Brenner nicht so stellen; die nächste Richtung liegt { $angle } daneben
machine-unreachable-point = die Achsen erreichen den Punkt nicht; es fehlen { $distance }
machine-unreachable-flat = bei diesen Stellungen der Drehachsen sind die Linearachsen parallel zu einer Ebene
machine-out-of-reach = außer Reichweite um { $distance }: Achse { $axis } stünde bei { $position }, { $excess } über ihrer Grenze { $limit }
machine-axis-out-of-range = Achse { $axis } stünde bei { $position }, { $excess } über ihrer Grenze { $limit }
machine-pair-axes = zwei Köpfe zugleich brauchen drei Linear- und drei Drehachsen, die beide tragen; benachbarte sind nicht parallel
machine-pair-same-point = beide Brenner sind an einem Punkt: sie haben kein gemeinsames Koordinatensystem
machine-pair-opposed = beide Brenner zeigen aufeinander: sie haben kein gemeinsames Koordinatensystem

# Check of a machine: inverse kinematics and failures.
machine-method-closed = geschlossene Form
machine-method-plane-on-rotary = geschlossene Form, eine Ebene auf einer Drehachse
machine-method-in-plane = geschlossene Form, in einer Ebene
machine-method-numeric = numerisch (Newton-Verfahren)
machine-method-spherical-wrist = geschlossene Form eines Arms mit Zentralhand
machine-method-three-parallel = geschlossene Form eines Arms mit drei parallelen Achsen
machine-method-spherical-shoulder = geschlossene Form eines Arms mit sphärischer Schulter und Zentralhand
machine-free-roll = Drehung um den Brenner
machine-linear-axes = { $n } linear ({ $axes })
machine-rotary-axes = { $n } rotatorisch ({ $axes })
machine-linear-and-rotary = { $linear } + { $rotary }
machine-structure = { $method }: { $axes }
machine-structure-with-free = { $method }: { $axes }; redundant: { $free }
machine-check-head = Kopf { $head }: { $why }
machine-check-pair = beide Köpfe zugleich: { $why }
machine-check-round-trip = Rückrechnung weicht um { $distance } mm, { $angle }°, { $difference } in einer Achse ab; Stellungen ohne Lösung: { $unsolved }, ohne eigenen Zweig: { $missed }
machine-check-jacobian = die Jacobi-Matrix weicht um { $difference } der Spalte der Achse { $axis } ab

# Check of a machine: singular configurations.
machine-singular-linear = die Linearachsen { $axes } liegen in einer Ebene: die Spitze kann sie nicht verlassen
machine-singular-along-axis = der Brenner liegt längs der Achse { $axis }: { $axis } ist dort frei
machine-singular-undone = { $axes } kann die Bewegung der Achse { $axis } aufheben: { $axis } ist dort frei
machine-singular-parallel = die Achsen { $first } und { $second } sind parallel: eine hebt die andere auf
machine-singular-tilt = der Brenner liegt in der Ebene der Achsen { $first } und { $second }: beide neigen ihn gleich
machine-singular-undo = die Achsen { $axes } heben einander auf
machine-singular-following = { $what }, wobei { $axes } mitfährt
machine-singular-wrist = Handgelenksingularität: die Achsen { $first } und { $second } sind parallel
machine-singular-elbow = Ellbogensingularität: der Arm ist gestreckt oder gefaltet
machine-singular-shoulder = Schultersingularität: das Handgelenk liegt über der Achse { $axis }
machine-singular-stretched = der Arm ist gestreckt oder gefaltet: die Achsen { $first } und { $second } bewegen die Spitze gleich
machine-singular-tip-on-axis = die Spitze liegt auf der Achse { $axis }, die sie nicht bewegen kann
machine-singular-direction = die Spitze kann sich nicht längs ({ $x }, { $y }, { $z }) des Werkstücks bewegen
machine-singular-position = { $axis } = { $values }
machine-singular-at = { $what }, bei { $positions }
machine-singular-for-example = { $what }, zum Beispiel bei { $positions }

# Check of a machine: unusual values and what to do.
machine-remark-period = die Lageregler liefen alle { $period }
machine-cure-period = die Periode in ms angeben; üblich ist 1
machine-remark-displacement = die Verschiebung ist länger als { $limit }
machine-cure-displacement = Längen in mm angeben
machine-remark-no-shapes = die Maschine hat keine Körper: Kollisionen werden nicht geprüft
machine-cure-no-shapes = [[shapes.torch]] ergänzen, ebenso für alles andere, was kollidieren kann
machine-remark-home-collision = in der Referenzstellung sind { $first } und { $second } { $distance } voneinander entfernt, weniger als das Minimum { $min }
machine-cure-home-collision = home_mm oder home_deg einer Achse ändern, oder die Körper
machine-remark-range-long = die Achse { $axis } würde über { $travel } verfahren
machine-cure-range-long = den Bereich in mm angeben
machine-remark-range-short = die Achse { $axis } würde insgesamt nur { $travel } verfahren
machine-cure-range-short = den Bereich in mm angeben; vielleicht waren m gemeint
machine-remark-turns = die Achse { $axis } würde { $turns } Umdrehungen machen
machine-cure-turns = den Bereich in Grad angeben oder continuous = true setzen
machine-remark-range-narrow = die Achse { $axis } würde insgesamt nur { $travel } drehen
machine-cure-range-narrow = den Bereich in Grad angeben
machine-remark-range-quarter-turns = die Achse { $axis } würde insgesamt nur { $travel } drehen; die Enden sind Viertelumdrehungen in rad: { $low } bis { $high }
machine-remark-range-radians = die Achse { $axis } würde insgesamt nur { $travel } drehen; in rad wären es { $low } bis { $high }
machine-cure-range-radians = den Bereich in Grad angeben; belassen, wenn so wenig gemeint ist
machine-remark-speed-high = { $speed } ist schneller, als solche Achsen fahren
machine-remark-speed-low = { $speed } ist langsamer, als solche Achsen fahren
machine-cure-linear-speed-high = die Geschwindigkeit in mm/s angeben; vielleicht waren mm/min gemeint
machine-cure-rotary-speed-high = die Geschwindigkeit in °/s angeben; vielleicht waren °/min gemeint
machine-cure-linear-speed-low = die Geschwindigkeit in mm/s angeben; vielleicht waren m/s gemeint
machine-cure-rotary-speed-low = die Geschwindigkeit in °/s angeben; vielleicht waren rad/s oder U/min gemeint
machine-remark-speed-unreached = die Achse { $axis } erreicht sie nie: Beschleunigen und Bremsen brauchen { $needed }, und ihr Bereich ist { $travel }
machine-cure-linear-speed-unreached = die Geschwindigkeit in mm/s und die Beschleunigung in mm/s² angeben
machine-cure-rotary-speed-unreached = die Geschwindigkeit in °/s und die Beschleunigung in °/s² angeben
machine-remark-acceleration-low = die Achse { $axis } braucht { $time } bis zur Höchstgeschwindigkeit
machine-remark-acceleration-high = die Achse { $axis } erreicht ihre Höchstgeschwindigkeit in { $time }
machine-remark-gravity = das { $factor }-Fache der Erdbeschleunigung ist mehr, als solche Achsen aushalten
machine-cure-linear-acceleration = die Beschleunigung in mm/s² angeben
machine-cure-rotary-acceleration = die Beschleunigung in °/s² angeben
machine-cure-linear-acceleration-low = die Beschleunigung in mm/s² angeben; vielleicht waren m/s² gemeint
machine-cure-rotary-acceleration-low = die Beschleunigung in °/s² angeben; vielleicht waren rad/s² gemeint
machine-remark-jerk-missing = die Achse { $axis } hat keine Ruckbegrenzung
machine-cure-jerk-missing = { $key } ergänzen; üblich ist das Zehnfache der Beschleunigung
machine-remark-jerk-low = die Beschleunigung baut sich in { $time } auf
machine-cure-linear-jerk = den Ruck in mm/s³ angeben
machine-cure-rotary-jerk = den Ruck in °/s³ angeben
machine-remark-drive-missing = die Achse { $axis } hat keinen Antrieb: sie wird mit einem angenommenen simuliert
machine-cure-drive-missing = [drives.{ $axis }] ergänzen
machine-remark-drive-weak = die Achse { $axis } braucht { $needed } für ihre Beschleunigung bei Höchstgeschwindigkeit, mit Reibung
machine-cure-drive-weak = einen stärkeren Antrieb nehmen oder max_acceleration senken
machine-remark-drive-strong = der Antrieb ist { $factor }-mal so stark, wie seine Last braucht
machine-cure-linear-drive-strong = die Masse in kg und die Kraft in N angeben
machine-cure-rotary-drive-strong = das Trägheitsmoment in kg m² und das Drehmoment in Nm angeben
machine-remark-encoder = ein Inkrement sind { $count }
machine-cure-linear-encoder = die Inkremente je mm an der Achse angeben
machine-cure-rotary-encoder = die Inkremente je Grad an der Achse angeben
machine-remark-velocity-loop = { $bandwidth } ist zu schnell für einen Lageregler alle { $period }
machine-cure-velocity-loop = die Bandbreite in Hz angeben oder servo_period_ms verkürzen
machine-remark-pitch = die Achse { $axis } läge um bis zu { $error } daneben
machine-cure-linear-pitch = die Fehler in mm angeben
machine-cure-rotary-pitch = die Fehler in Grad angeben

# Import of arms.
machine-urdf-not-xml = die Datei ist kein XML: { $why }
machine-urdf-cure-xml = Korrigieren Sie das XML hier, oder exportieren Sie die Datei neu.
machine-urdf-attribute-missing = dem Element fehlt das Attribut `{ $name }`
machine-urdf-cure-attribute = Ergänzen Sie `{ $name }="…"` im Element.
machine-urdf-element-missing = dem Element fehlt `<{ $name }>`
machine-urdf-cure-element = Ergänzen Sie `<{ $name } link="…"/>` im Gelenk.
machine-urdf-not-numbers = ungültige Zahlen
machine-urdf-cure-numbers = Hier nötige Zahlen: { $n }, durch Leerzeichen getrennt, etwa `0.1 0 0.25`.
machine-urdf-root = das Wurzelelement ist `{ $name }`, nicht `robot`
machine-urdf-empty = die Datei hat keine Glieder
machine-urdf-cure-root = Geben Sie eine URDF-Datei an: ihre Wurzel ist `<robot>`, darin `<link>` und `<joint>`.
machine-urdf-xacro = die Datei enthält xacro-Makros
machine-urdf-cure-xacro = Lösen Sie zuerst die Makros auf: `xacro robot.urdf.xacro > robot.urdf`.
machine-urdf-two-parents = Glied `{ $link }` hängt schon an Gelenk `{ $joint }`
machine-urdf-loop = Glied `{ $link }` gehört zu einer geschlossenen Schleife
machine-urdf-cure-tree = Entfernen Sie eines der Gelenke: jedes Glied wird von einem Gelenk getragen.
machine-urdf-name-taken = der Name `{ $name }` kommt zweimal vor
machine-urdf-cure-name = Benennen Sie eines der beiden um.
machine-urdf-link-unknown = es gibt kein Glied `{ $link }`
machine-urdf-cure-link = Geben Sie eines der Glieder der Datei an.
machine-urdf-axis-zero = die Achse hat keine Richtung
machine-urdf-cure-axis = Geben Sie eine Richtung an, etwa `xyz="0 0 1"`.
machine-urdf-size = die Größe ist nicht größer als 0
machine-urdf-cure-size = Geben Sie Größen in Metern an, größer als 0.
machine-urdf-roots = die Datei hat mehrere Basisglieder: { $links }
machine-urdf-cure-roots = Wählen Sie die Basis: `--base LINK`.
machine-urdf-tips = der Baum hat { $n } von Achsen bewegte Enden: { $links }
machine-urdf-cure-tips = Wählen Sie das Glied, das den Brenner trägt: `--tip LINK`.
machine-urdf-no-axes = keine Achse bewegt ein von `{ $link }` getragenes Glied
machine-urdf-cure-no-axes = Wählen Sie mit `--base LINK` eine andere Basis, oder machen Sie Gelenke zu `revolute` oder `prismatic`.
machine-urdf-not-carried = die Basis `{ $base }` trägt das Glied `{ $tip }` nicht
machine-urdf-cure-not-carried = Wählen Sie `--base` oder `--tip` anders.
machine-urdf-axes = Zahl der Achsen bis Glied `{ $link }`: { $n }
machine-urdf-cure-axes = Wählen Sie `--base` und `--tip` mit 1 bis { $max } Achsen dazwischen.
machine-urdf-too-long = die Kette von Basis bis Ende ist { $length } lang: kein Arm in Metern
machine-urdf-too-short = die Kette von der Basis bis zum Ende ist nur { $length } lang: kein Arm in Metern
machine-urdf-cure-scale = URDF ist in Metern. Importieren Sie mit `--scale { $factor }`, oder exportieren Sie in Metern.
machine-urdf-degrees = die Winkel von Gelenk `{ $joint }` sind keine Winkel in rad
machine-urdf-cure-degrees = Schreiben Sie Grenzen in rad und rad/s: Grad geteilt durch 57.29578.
machine-urdf-joint-type = der Typ von Gelenk `{ $joint }` ist keine Achse
machine-urdf-cure-joint-type = Zwischen Basis und Ende erlaubt: `revolute`, `continuous`, `prismatic`, `fixed`.
machine-urdf-mimic = Gelenk `{ $joint }` folgt Gelenk `{ $other }`
machine-urdf-cure-mimic = Wählen Sie `--tip` vor diesem Gelenk, oder machen Sie es `fixed`, oder entfernen Sie `<mimic>`, wenn es einen eigenen Antrieb hat.
machine-urdf-limit-missing = Gelenk `{ $joint }` hat keine Grenzen
machine-urdf-limit-empty = der Bereich von Gelenk `{ $joint }` ist leer
machine-urdf-cure-limit = Schreiben Sie `<limit lower="…" upper="…" velocity="…" effort="…"/>` in rad, rad/s und N m oder in m, m/s und N, wie im Datenblatt.
machine-urdf-velocity = Gelenk `{ $joint }` hat keine Höchstgeschwindigkeit
machine-urdf-cure-velocity = Geben Sie `velocity` des Datenblatts an, in rad/s oder m/s.
machine-urdf-mesh-missing = es gibt kein Netz `{ $mesh }`
machine-urdf-mesh-tried = eine Datei an einer dieser Stellen: { $files }
machine-urdf-cure-mesh = Geben Sie den Ordner seines Pakets an, `--package NAME=DIR`, oder importieren Sie ohne Körper, `--no-shapes`.
machine-import-rounded-angles = { $n } Winkel der Quelle sind gerundete Vielfache von 15 Grad, wie 1.5708; sie wurden als genaue gelesen
machine-import-flange = von mehreren Enden ({ $links }) wurde der Flansch `tool0` gewählt; `--tip` wählt ein anderes
machine-import-held = Gelenke neben der Kette bleiben auf null: { $joints }
machine-import-no-shapes = es gibt keine Körper: Abstände werden nicht geprüft
machine-import-shape-kind = ein Körper von Glied { $link } wurde weggelassen: `{ $kind }` ist weder Quader, Zylinder, Kugel noch Netz
machine-import-mesh-format = das Netz { $file } von Glied { $link } wurde weggelassen: wandeln Sie es in STL um
machine-import-mesh-unusable = das Netz { $file } von Glied { $link } wurde weggelassen: { $why }
machine-import-mesh-stretched = sein Maßstab ist entlang x, y und z verschieden
