# Sizes and poses of solids.
clearance-size = { $what } must be greater than 0 and at most { $max }, not { $value }
clearance-short-capsule = the capsule's length { $length } is less than its two round ends, { $min }
clearance-too-far = the solid is { $value } from the origin; the maximum is { $max }
clearance-not-rigid = the pose is not a rigid motion
clearance-box-side = a side of the box
clearance-radius = the radius
clearance-length = the length
clearance-semi-axis = a semi-axis
clearance-capsule-allowed = a length over all, round ends included: at least twice the radius
clearance-cone-allowed = radii and length up to { $max }, one radius above 0
clearance-sizes-allowed = sizes up to { $max }

# STL files and meshes.
clearance-file-unreadable = the file could not be read: { $why }
clearance-file-allowed = an existing file, its path relative to the file that names it
clearance-not-stl = this is not an STL file: { $why }
clearance-stl-no-header = it starts neither with `solid` nor with a binary header
clearance-stl-corner = line { $line }: a corner must have three numbers
clearance-stl-facet = line { $line }: { $corners -> 
    [one] a facet with { $corners } corner; three are needed
   *[other] a facet with { $corners } corners; three are needed
 }
clearance-stl-word = line { $line }: unknown word `{ $word }`
clearance-stl-cut-short = the STL file is truncated: { $why }
clearance-stl-triangles-missing = { $found } of { $count } triangles are there
clearance-stl-no-endsolid = `endsolid` is missing after { $count -> 
    [one] { $count } triangle
   *[other] { $count } triangles
 }
clearance-corner-not-finite = triangle { $triangle } has a corner that is not a finite number
clearance-corner-too-far = triangle { $triangle } has a corner { $distance } mm from the origin
clearance-no-triangles = the mesh has no triangles
clearance-open-surface = the surface is not closed: { $edges -> 
    [one] { $edges } edge does not have exactly two triangles, at { $point } mm
   *[other] { $edges } edges do not have exactly two triangles, one of them at { $point } mm
 }
clearance-stl-whole-allowed = a whole STL file: copy or export it again
clearance-stl-closed-allowed = a closed surface: close the holes, or export the body again as one solid; a plain box or cylinder around it does as well
clearance-stl-corners-allowed = corners within { $max } of the origin; `scale` converts other units to mm
clearance-stl-finite-allowed = finite coordinates: export the file again
clearance-stl-triangles-allowed = a file with at least four triangles around a body
clearance-stl-allowed = an STL file, ASCII or binary

# Watches of a scene.
clearance-no-such-group = watch { $watch } names group { $group }, which does not exist
clearance-unbounded-group = watch { $watch }: group `{ $group }` has a half-space; here it must be bounded
clearance-zone-shape = watch { $watch }: a permitted zone is a box, a cylinder, a sphere or a half-space
clearance-no-zone = watch { $watch } has no permitted zone
clearance-minimum = watch { $watch }: the minimum distance of two groups must be greater than 0, and a minimum margin finite
clearance-limit = { $what } must be greater than 0
clearance-cutoff = the cut-off distance
clearance-precision = the precision
clearance-smallest-cell = the smallest cell
