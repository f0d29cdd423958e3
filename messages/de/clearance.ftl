# Sizes and poses of solids.
clearance-size = { $what }: muss größer als 0 und höchstens { $max } sein, nicht { $value }
clearance-short-capsule = die Länge der Kapsel { $length } ist kleiner als ihre zwei runden Enden, { $min }
clearance-too-far = der Körper ist { $value } vom Ursprung entfernt; erlaubt sind höchstens { $max }
clearance-not-rigid = die Lage ist keine starre Bewegung
clearance-box-side = Kantenlänge des Quaders
clearance-radius = Radius
clearance-length = Länge
clearance-semi-axis = Halbachse
clearance-capsule-allowed = Gesamtlänge mit den runden Enden: mindestens der doppelte Radius
clearance-cone-allowed = Radien und Länge bis { $max }, ein Radius größer als 0
clearance-sizes-allowed = Größen bis { $max }

# STL files and meshes.
clearance-file-unreadable = die Datei konnte nicht gelesen werden: { $why }
clearance-file-allowed = eine vorhandene Datei, ihr Pfad relativ zur Datei, die sie nennt
clearance-not-stl = das ist keine STL-Datei: { $why }
clearance-stl-no-header = sie beginnt weder mit `solid` noch mit einem binären Kopf
clearance-stl-corner = Zeile { $line }: ein Eckpunkt muss drei Zahlen haben
clearance-stl-facet = Zeile { $line }: { $corners -> 
    [one] eine Facette mit { $corners } Eckpunkt; drei sind nötig
   *[other] eine Facette mit { $corners } Eckpunkten; drei sind nötig
 }
clearance-stl-word = Zeile { $line }: unbekanntes Wort `{ $word }`
clearance-stl-cut-short = die STL-Datei ist abgeschnitten: { $why }
clearance-stl-triangles-missing = { $found } von { $count } Dreiecken sind vorhanden
clearance-stl-no-endsolid = `endsolid` fehlt nach { $count -> 
    [one] { $count } Dreieck
   *[other] { $count } Dreiecken
 }
clearance-corner-not-finite = Dreieck { $triangle } hat einen Eckpunkt, der keine endliche Zahl ist
clearance-corner-too-far = Dreieck { $triangle } hat einen Eckpunkt { $distance } mm vom Ursprung entfernt
clearance-no-triangles = das Netz hat keine Dreiecke
clearance-open-surface = die Oberfläche ist nicht geschlossen: { $edges -> 
    [one] { $edges } Kante hat nicht genau zwei Dreiecke, bei { $point } mm
   *[other] { $edges } Kanten haben nicht genau zwei Dreiecke, eine davon bei { $point } mm
 }
clearance-stl-whole-allowed = eine ganze STL-Datei: neu kopieren oder exportieren
clearance-stl-closed-allowed = eine geschlossene Oberfläche: Löcher schließen oder den Körper neu als einen Volumenkörper exportieren; ein einfacher Quader oder Zylinder darum genügt auch
clearance-stl-corners-allowed = Eckpunkte höchstens { $max } vom Ursprung; `scale` rechnet andere Einheiten in mm um
clearance-stl-finite-allowed = endliche Koordinaten: die Datei neu exportieren
clearance-stl-triangles-allowed = eine Datei mit mindestens vier Dreiecken um einen Körper
clearance-stl-allowed = eine STL-Datei, ASCII oder binär

# Watches of a scene.
clearance-no-such-group = Überwachung { $watch } nennt Gruppe { $group }, die es nicht gibt
clearance-unbounded-group = Überwachung { $watch }: Gruppe `{ $group }` hat einen Halbraum; hier muss sie begrenzt sein
clearance-zone-shape = Überwachung { $watch }: eine erlaubte Zone ist ein Quader, ein Zylinder, eine Kugel oder ein Halbraum
clearance-no-zone = Überwachung { $watch } hat keine erlaubte Zone
clearance-minimum = Überwachung { $watch }: der Mindestabstand zweier Gruppen muss größer als 0 sein, ein Mindestspielraum endlich
clearance-limit = { $what }: muss größer als 0 sein
clearance-cutoff = Grenzabstand
clearance-precision = Genauigkeit
clearance-smallest-cell = kleinste Zelle
