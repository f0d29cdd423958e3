# Sizes and poses of solids.
clearance-size = { $what } must be greater than 0 and at most { $max }, not { $value }
    .cause = The size is 0, negative, not finite, or above 10 km; of a cone both radii are 0 or one is negative.
    .cure = Correct the size in mm in `[[shapes.LINK]]`, `[[zones.solids]]`, `[[fixtures]]` or `[part]`.
clearance-short-capsule = the capsule's length { $length } is less than its two round ends, { $min }
    .cause = `length_mm` of a capsule is over all: its two half spheres alone are twice `radius_mm` long.
    .cure = Raise `length_mm` to twice `radius_mm` or more, or use a `sphere`.
clearance-too-far = the solid is { $value } from the origin; the maximum is { $max }
    .cause = A coordinate of the solid's position is above 10 km: usually a wrong unit in `at.move_mm`.
    .cure = Enter `at.move_mm` in mm, in the frame of its link.
clearance-not-rigid = the pose is not a rigid motion
    .cause = The pose scales, shears or mirrors, or is not finite. Files describe only rigid poses: a program that uses the library made it.
    .cure = Build the pose from one rotation and one translation.
clearance-box-side = a side of the box
clearance-radius = the radius
clearance-length = the length
clearance-semi-axis = a semi-axis
clearance-capsule-allowed = a length over all, round ends included: at least twice the radius
clearance-cone-allowed = radii and length up to { $max }, one radius above 0
clearance-sizes-allowed = sizes up to { $max }

# STL files and meshes.
clearance-file-unreadable = the file could not be read: { $why }
    .cause = The file does not exist at this path, or this user may not read it.
    .cure = Correct `file` of `shape.stl`, relative to the folder of the machine file or of the job.
clearance-file-allowed = an existing file, its path relative to the file that names it
clearance-not-stl = this is not an STL file: { $why }
    .cause = The bytes are neither an ASCII STL file from its first line on, nor a binary one of matching length.
    .cure = Export the body as STL again, without renaming files of another format.
clearance-stl-no-header = it starts neither with `solid` nor with a binary header
    .cause = A binary file has 80 bytes of text, the number of triangles, then 50 bytes each; an ASCII file starts with `solid`.
    .cure = Open the file in the program that wrote it, and export it as STL.
clearance-stl-corner = line { $line }: a corner must have three numbers
    .cause = The line `vertex` has fewer or more than three numbers, or a decimal comma.
    .cure = Export the file again with decimal points, or as binary.
clearance-stl-facet = line { $line }: { $corners -> 
    [one] a facet with { $corners } corner; three are needed
   *[other] a facet with { $corners } corners; three are needed
 }
    .cause = Between `facet` and `endfacet` another number of `vertex` lines stands: the program wrote polygons, or the file is damaged.
    .cure = Export triangles, or export as binary.
clearance-stl-word = line { $line }: unknown word `{ $word }`
    .cause = The line starts with another word than those of STL: a damaged file or another format.
    .cure = Export the file again.
clearance-stl-cut-short = the STL file is truncated: { $why }
    .cause = The file ends before its last triangle: a copy, a download or an export was cut off.
    .cure = Copy the file again and compare its size, or export it again.
clearance-stl-triangles-missing = { $found } of { $count } triangles are there
    .cause = The header announces more triangles than the file has bytes for.
    .cure = Copy or export the file again.
clearance-stl-no-endsolid = `endsolid` is missing after { $count -> 
    [one] { $count } triangle
   *[other] { $count } triangles
 }
    .cause = The last line of an ASCII file must be `endsolid`.
    .cure = Copy or export the file again.
clearance-corner-not-finite = triangle { $triangle } has a corner that is not a finite number
    .cause = A coordinate is nan or inf, or becomes so with `scale`: a damaged file or a failed export.
    .cure = Repair the body in its own program, and export it again.
clearance-corner-too-far = triangle { $triangle } has a corner { $distance } mm from the origin
    .cause = A coordinate is above 10 km in mm, often by a wrong `scale` or by geographic coordinates.
    .cure = Correct `scale`: 1 for mm, 25.4 for inches, 1000 for m. Move the body near its origin before the export.
clearance-no-triangles = the mesh has no triangles
    .cause = The file has no triangle with an area: an empty export, or a body that is flat or shrunk by `scale`.
    .cure = Select the body in its own program, and export it again.
clearance-open-surface = the surface is not closed: { $edges -> 
    [one] { $edges } edge does not have exactly two triangles, at { $point } mm
   *[other] { $edges } edges do not have exactly two triangles, one of them at { $point } mm
 }
    .cause = Holes, walls without thickness, or bodies that share an edge: there inside and outside are not defined.
    .cure = Repair the mesh at this point (close holes, thicken walls), or use a `box` or `cylinder` around the body.
clearance-stl-whole-allowed = a whole STL file: copy or export it again
clearance-stl-closed-allowed = a closed surface: close the holes, or export the body again as one solid; a plain box or cylinder around it does as well
clearance-stl-corners-allowed = corners within { $max } of the origin; `scale` converts other units to mm
clearance-stl-finite-allowed = finite coordinates: export the file again
clearance-stl-triangles-allowed = a file with at least four triangles around a body
clearance-stl-allowed = an STL file, ASCII or binary

# Watches of a scene.
clearance-no-such-group = watch { $watch } names group { $group }, which does not exist
    .cause = A program that uses the library gave a watch a group that the scene lacks. Files make no such watch.
    .cure = Give the watch indices of groups in the scene.
clearance-unbounded-group = watch { $watch }: group `{ $group }` has a half-space; here it must be bounded
    .cause = Two half-spaces must keep clear of each other, or a group with a half-space must stay in a permitted zone.
    .cure = Replace one `half_space` by a large `box`, take the group out of `watch`, or name the pair in `ignore` of `[clearance]`.
clearance-zone-shape = watch { $watch }: a permitted zone is a box, a cylinder, a sphere or a half-space
    .cause = A permitted zone has a cone, a capsule, an ellipsoid or a mesh. In files `machine-zone-shape` reports it before.
    .cure = Build the zone from boxes, cylinders, spheres and half-spaces.
clearance-no-zone = watch { $watch } has no permitted zone
    .cause = The watch for permitted zones has an empty list. In files `machine-zone-empty` reports it before.
    .cure = Give the zone at least one solid.
clearance-minimum = watch { $watch }: the minimum distance of two groups must be greater than 0, and a minimum margin finite
    .cause = The minimum distance is 0, negative or not finite: bodies that overlap have distance 0, so that 0 finds nothing.
    .cure = Set `least_mm` above 0.
clearance-limit = { $what } must be greater than 0
    .cause = A program that uses the library gave the sampling along a motion a limit of 0, below 0, or nan.
    .cure = Set cut-off distance, precision and smallest cell above 0.
clearance-cutoff = the cut-off distance
clearance-precision = the precision
clearance-smallest-cell = the smallest cell
