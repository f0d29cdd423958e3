
# Parts of every error in a file.
document-error = { $at }: { $message }
document-allowed = erlaubt: { $allowed }
document-help = Hinweis: { $help }

# Keys and names.
document-unknown-key = hier gibt es keinen Schlüssel `{ $key }`
document-unknown-name = `{ $name }` ist nicht bekannt
document-missing-key = der Schlüssel `{ $key }` fehlt
document-key-in-unit = `{ $key } = ...`, in { $unit }
document-missing-schema = die Datei beginnen mit: schema = 1
document-schema-version = 1, die Version, die dieses Programm liest
document-none-given = nichts davon ist angegeben
document-several-given = mehrere sind angegeben
document-exactly-one = genau eines davon
document-suggestion = war `{ $name }` gemeint?
document-suggestion-unit = war `{ $name }` gemeint? Dieser Wert wird in { $unit } angegeben
document-own-name = ein eigener Name
document-own-names = eigene Namen
document-nested = Tabellen und Listen sind zu tief verschachtelt
document-nesting = bis zu { $max } Ebenen
document-no-such-entry = diesen Eintrag gibt es im Text nicht
document-unfit-change = der Eintrag lässt sich so nicht ändern

# Values.
document-invalid-value = unzulässiger Wert: { $value }
document-invalid-type = Wert der falschen Art: { $value }
document-number = eine Zahl
document-positive-number = eine endliche Zahl größer als 0
document-non-negative-number = eine endliche Zahl, 0 oder größer
document-finite-number = eine endliche Zahl
document-whole-number = eine ganze Zahl von { $min } bis { $max }
document-table = eine Tabelle { $name }
document-number-without-unit = eine Zahl steht allein: ihre Einheit ist im Schlüssel
document-direction = drei Zahlen, die nicht alle 0 sind
document-direction-without-length = die Richtung hat keine Länge
document-coordinates = drei Zahlen innerhalb von { $limit } um 0
document-coordinate-too-large = die Koordinate ist zu groß
document-too-large = dieser Wert ist zu groß
document-too-small = dieser Wert ist zu klein

# Allowed values; numbers come with their units.
document-at-least = mindestens { $min }
document-at-most = bis { $max }
document-more-than = mehr als { $min }
document-less-than = weniger als { $max }
document-between = { $min } bis { $max }
document-more-than-up-to = mehr als { $min }, bis { $max }
document-strictly-between = mehr als { $min } und weniger als { $max }
document-within = mindestens { $min }, bis { $max } ({ $reason })
document-up-to = bis { $max } ({ $reason })

# Reasons of bounds.
document-bound-scanner-jerk = Ruck des schnellsten Scanners
document-bound-scanner-acceleration = Beschleunigung des schnellsten Scanners
document-bound-turns = eine Umdrehung in 40 Tagen bis 280 in der Sekunde
document-bound-gravity = das 10.000-Fache der Erdbeschleunigung
document-bound-speed = 0,36 mm in der Stunde bis 100 m in der Sekunde
document-bound-wire-feeder = das Zehnfache des schnellsten Drahtvorschubs
document-bound-square-metre = ein Quadratmeter
document-bound-many-turns = 2.700 Umdrehungen
document-bound-kilometre = ein Kilometer
document-bound-10-km = 10 Kilometer
document-bound-hour = eine Stunde
document-bound-pulses = der schnellste Impulsgeber
document-bound-hundredfold = das Hundertfache
document-bound-process-source = die größte Stromquelle
document-bound-beam-generator = der größte Strahlerzeuger

# The code under which docs/reference/messages.md explains a message.
document-code = Code: { $code }
