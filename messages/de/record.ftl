# Errors of files and of the library.
record-full =
    { $path }: { $why }
       erlaubt: Speicherplatz schaffen oder ein anderer Datenordner; bisherige Daten bleiben erhalten
record-disk-full = der Datenträger ist voll
record-no-room = { $free } sind frei, das Protokoll der Schweißung braucht { $needed }
record-read-only =
    { $path }: nicht beschreibbar: { $why }
       erlaubt: ein Ordner mit Schreibrecht
record-not-read =
    { $path }: Lesen fehlgeschlagen: { $why }
       erlaubt: eine vorhandene Datei oder ein Ordner auf einem intakten Datenträger
record-not-written =
    { $path }: Schreiben fehlgeschlagen: { $why }
       erlaubt: eine vorhandene Datei oder ein Ordner auf einem intakten Datenträger
record-not-created =
    { $path }: Anlegen fehlgeschlagen: { $why }
       erlaubt: eine vorhandene Datei oder ein Ordner auf einem intakten Datenträger
record-not-removed =
    { $path }: Löschen fehlgeschlagen: { $why }
       erlaubt: eine vorhandene Datei oder ein Ordner auf einem intakten Datenträger
record-not-moved =
    { $path }: Verschieben fehlgeschlagen: { $why }
       erlaubt: eine vorhandene Datei oder ein Ordner auf einem intakten Datenträger
record-not-archived =
    { $path }: Aufnahme ins Archiv fehlgeschlagen: { $why }
       erlaubt: eine vorhandene Datei oder ein Ordner auf einem intakten Datenträger
record-not-unpacked =
    { $path }: Entpacken des Archivs fehlgeschlagen: { $why }
       erlaubt: eine vorhandene Datei oder ein Ordner auf einem intakten Datenträger
record-damaged =
    { $path }: { $why }
       erlaubt: { $allowed }
record-newer =
    { $path }: von einer neueren Version geschrieben (Schema { $found }, diese Version liest bis { $known })
       erlaubt: jene Version von Seamwright; nichts wurde geändert
record-busy =
    { $path }: ein anderes Programm benutzt die Datei
       erlaubt: erneut versuchen, wenn es beendet ist
record-search-ended =
    { $path }: Suche dauerte zu lange
       erlaubt: erneut mit kürzerem Zeitraum oder ohne Text
record-invalid =
    { $what }
       erlaubt: { $allowed }
record-database = { $path }: { $why }
record-invalid-moment = ungültiges Datum: { $text }; erlaubt: 2026-11-21 oder "2026-11-21 14:05", UTC

# The library.
record-library-damaged = die Bibliothek ist beschädigt ({ $why })
record-library-from-copy = durch die letzte Kopie ersetzen oder wegräumen: eine neue Bibliothek wird angelegt, Aufzeichnungen bleiben erhalten
record-library-missing = { $path }: die Bibliothek fehlt
record-begin-library = ein Datenordner mit aufgezeichneten Schweißungen: simulate JOB -o DIR --data DIR legt einen an
record-schema-version = ihr Schema hat Version { $found }, dieses Programm liest { $known }
record-migrate = jeder Befehl, der in sie schreibt, bringt sie auf den Stand: records recover
record-no-library = keine Bibliothek von Seamwright
record-other-folder = ein anderer Datenordner
record-own-archive = ein Archiv von `records backup`
record-own-schema = ein Archiv einer Bibliothek, die nur Seamwright geändert hat; Fremdes zuerst mit sqlite3 entfernen
record-schema-foreign = die Bibliothek enthält Fremdes: { $kind } `{ $name }`
record-schema-changed = { $kind } `{ $name }` der Bibliothek wurde geändert
record-schema-missing = { $kind } `{ $name }` fehlt in der Bibliothek
record-loose-row = eine Zeile der Tabelle { $table } verweist auf eine fehlende Zeile
record-no-document = es gibt kein Dokument { $id }
record-no-alarm = es gibt keinen Alarm { $id }
record-known-number = eine Nummer aus der Bibliothek
record-no-weld = { $path }: es gibt keine Schweißung { $id }
record-no-welds-yet = noch nichts: keine Schweißung ist aufgezeichnet
record-weld-damaged = Schweißung { $id }: { $why }
record-whole-library = eine unbeschädigte Bibliothek
record-foreign-file = sie nennt `{ $name }` für Schweißung { $id }; das ist keine Datei dieser Schweißung
record-own-files = Dateinamen im Ordner der Schweißung
record-finite-numbers = endliche Zahlen

# Traces.
record-no-trace = keine Aufzeichnung: { $why }
record-own-parquet = eine von Seamwright geschriebene Parquet-Datei
record-own-trace = eine von Seamwright geschriebene Aufzeichnung
record-column-kind = Spalte { $column } enthält { $kind }
record-trace-groups = Zeilengruppen mit mehr als { $max } Zeilen oder Spalten verschiedener oder negativer Länge
record-no-column = { $path }: es gibt keine Spalte { $column }
record-row-length =
    { $path }: eine Zeile mit { $n ->
        [one] { $n } Wert
       *[other] { $n } Werten
    }
record-value-per-column = { $n }, einer pro Spalte
record-trace-left = diese Aufzeichnung blieb nach einem Absturz zurück oder wird gerade geschrieben
record-recover-first = zuerst wiederherstellen: seamwright records recover
record-trace-replaced = während des Schreibens entfernt oder ersetzt: die Zeilen sind verloren
record-folder-untouched = den Ordner bis zum Ende der Schweißung nicht verändern
record-no-raw-trace = keine Rohaufzeichnung, oder im Kopf abgeschnitten
record-own-raw-trace = eine von einer Aufzeichnung begonnene Datei

# Backup and restore.
record-folder-not-empty = { $path }: der Ordner ist nicht leer
record-empty-folder = ein leerer oder neuer Ordner
record-archive-as-written = ein unverändertes Archiv
record-manifest-missing = { $name }: fehlt, obwohl die Version des Archivs sie schreibt
record-manifest-size = { $name }: { $size }, zu groß
record-archive-changed = { $name }: seit der Sicherung geändert, verschwunden oder hinzugekommen
record-archive-without-hashes = das Archiv hat keine Liste der Prüfsummen und ist nicht in Ordnung: { $problem }
record-archive-problems =
    der Inhalt ist nicht in Ordnung: { $problem } ({ $more ->
        [0] keine weiteren Mängel
        [one] und { $more } weiterer Mangel
       *[other] und { $more } weitere Mängel
    })
record-restore-elsewhere = `seamwright records restore` stellt es in einem eigenen Ordner wieder her
record-nothing-restored = nichts wurde wiederhergestellt
record-checked-archive = ein geprüftes Archiv
record-archive-foreign = es enthält { $name }; das gehört nicht in eine Sicherung
record-archive-outside = { $name } führt aus dem Archiv hinaus
record-archive-entries = mehr als { $max } Dateien und Ordner
record-archive-fewer = ein Datenordner mit weniger Dateien
record-archive-name = ein Name oder ein Zusatz dazu ist länger als { $max } KiB
record-archive-cut-off = das Ende des Archivs fehlt
record-archive-no-library = das Archiv hat keine Bibliothek

# Problems found by `records verify`.
record-problem-audit = Prüfprotokoll, Eintrag { $id }: { $why }
record-audit-missing = der Eintrag fehlt
record-audit-hash = die Prüfsumme passt nicht zum Eintrag oder zum vorigen
record-audit-cut-off = dieser Eintrag und alle danach fehlen
record-problem-lost = Schweißung { $id }: die Bibliothek hat ihren Eintrag verloren; die Dateien sind in { $folder }
record-problem-unfinished = Schweißung { $id }: ihre Aufzeichnung wird gerade geschrieben
record-problem-left = Schweißung { $id }: ein Absturz ließ ihre Aufzeichnung unfertig zurück; `records recover` ausführen
record-problem-program = Schweißung { $id }: der Text ihres Programms wurde geändert
record-problem-changed = { $path }: seit der Aufzeichnung geändert

# Notes of a weld.
record-notes = { $first }; { $then }
record-interrupted = unterbrochen: { $cause }
record-log-damaged = eine Zeile des Protokolls dieser Schweißung ist beschädigt
record-rows-late = die Platte war zu langsam
record-rows-lost =
    { $n ->
        [one] { $n } Zeile
       *[other] { $n } Zeilen
    } der Aufzeichnung verloren: { $why }
record-incomplete = das Protokoll ist unvollständig: { $why }
record-no-figures = keine Kennwerte: { $why }
record-heat-input-outside = Wärmeeinbringung auf { $length } außerhalb der Schweißanweisung
record-recovered = wiederhergestellt { $time }
record-recovered-without = wiederhergestellt { $time } ohne die letzten { $size } der Aufzeichnung, die keine ganzen Zeilen sind
