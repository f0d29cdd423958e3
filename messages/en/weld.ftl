# Positions on the weld, and torch angles.
weld-position-beside-weld = this position is not on the weld
weld-positions-must-increase = the positions must increase
weld-without-length = the weld has no length
weld-angles-twice = angles are given both constant and at several positions
weld-travel-angle-too-large = the torch would lie along the seam
weld-work-angle-too-large = the torch would lie behind a face
weld-min-speed-too-high = the minimum speed is not below the welding speed
weld-speed-below-min = the welding speed is not above the minimum speed
weld-value-ramps-already = this value already ramps over the whole weld

# Allowed values of these.
weld-allowed-from-less-than = { $min } or more, less than { $max }
weld-allowed-positions-increasing = positions that increase
weld-allowed-path-lengths-increasing = path lengths that increase
weld-allowed-seam-with-length = a seam with a length
weld-allowed-angles-once = either the constant angles or [[torch.at]]
weld-allowed-travel-angle = { $min } (push) to { $max } (drag)
weld-allowed-number-or-no-value = a number in [weld.process], or no value here
weld-allowed-less-than-key = less than { $key } = { $value }
weld-allowed-more-than-key = more than { $key } = { $value }
weld-allowed-positive-less-than-key = more than 0 and less than { $key } = { $value }
weld-allowed-positive-less-than-half-key = more than 0 and less than half of { $key } = { $value }
weld-allowed-not-along = not along `{ $key }`
weld-allowed-other-point = a point other than `{ $key }`
weld-allowed-schema = sizes that fit each other (see the schema of job files)

# Bodies that nozzles stand on.
weld-body-cylinder = cylinder, radius { $radius }
weld-body-cone = cone, half angle { $angle }
weld-body-sphere = sphere, radius { $radius }
weld-body-ellipsoid = ellipsoid, semi-axes { $a }, { $b }, { $c }
weld-body-plane = plane, with its normal out of the plate
weld-body-torus = pipe bend, pipe radius { $radius }
weld-body-torispherical-head = torispherical head, outer diameter { $diameter }
weld-body-ellipsoidal-head = ellipsoidal head, outer diameter { $diameter }
weld-body-hemispherical-head = hemispherical head, outer diameter { $diameter }
weld-body-flat-head = flat head, outer diameter { $diameter }
weld-body-conical-head = conical head, outer diameter { $diameter }
weld-body-inside = inside of the wall; outside: { $body }
weld-allowed-nozzle-fits = a nozzle that fits on the body: { $body }
weld-allowed-nozzle-axis = an axis that meets the body: { $body }
weld-allowed-nozzle-on-body = a radius and an axis with the whole wall (radius { $radius }) on the body: { $body }
weld-allowed-nozzle-on-head = a nozzle with its whole wall (radius { $radius }) on the head and its flange: { $body }
weld-allowed-nozzle-smaller = a nozzle smaller than the body: { $body }
weld-allowed-nozzle-direction = a direction out of the body: { $body }
weld-cone-angle-too-large = the half angle of the cone is too large
weld-torus-meets-itself = the pipe would meet itself in the middle of the bend
weld-ellipsoid-inside-unknown = the inside of an ellipsoid's wall has no closed form
weld-allowed-bodies-with-inside = `mount = "set_on"`, or one of cylinder, cone, sphere, plane, torus, torispherical_head, hemispherical_head, flat_head, conical_head
weld-set-in-wall-missing = the nozzle is set in: the thickness of the body's wall is missing
weld-set-on-root-wall-missing = the root of a set-on nozzle is at its bore: the thickness of its wall is missing
weld-wall-leaves-no-room = the wall leaves no room inside
weld-wall-leaves-no-bore = the wall leaves no bore
weld-knuckle-too-large = the knuckle, with an inside radius of { $radius }, does not fit into the flange
weld-allowed-knuckle = an inside radius of the knuckle less than the flange's, { $max }
weld-head-radii-missing = the radii of crown and knuckle are missing
weld-allowed-head-radii = `standard` ("din_28011", "din_28013" or "asme_fd"), or both `crown_radius_mm` and `knuckle_radius_mm`
weld-crown-too-curved = the crown is not flatter than a hemisphere
weld-allowed-crown = more than the flange's inside radius, { $min }

# Branches of tubes, and girths.
weld-branch-along-chord = the branch lies along the chord
weld-branch-wider-than-chord = the branch is not narrower than the chord
weld-branch-past-chord = the branch's wall goes past the chord
weld-branches-do-not-part = the two branches are parallel or run into each other
weld-branch-position-missing = the position of the other branch is missing
weld-branch-position-twice = the position of the other branch is given twice
weld-allowed-tube = a tube
weld-allowed-tubes-meet = tubes whose walls meet all round: a smaller branch, or less overlap
weld-allowed-other-branch-angle = less than { $max } with the first branch at { $first }, so that the axes part
weld-allowed-gap-or-offset = exactly one of `gap_mm` (between the toes; negative where they overlap) and `offset_mm` (between the axes)
weld-allowed-branch-within-chord = a branch within the chord
weld-allowed-eccentricity = more than { $min } and less than { $max }: chord_radius_mm - radius_mm
weld-cut-along-tube = the cut runs along the tube: its normal is { $angle } off the axis
weld-allowed-cut-angle = up to { $max } off `direction`
weld-allowed-other-plane = another plane

# Shapes of seams.
weld-seam-too-long = the seam would be { $length } long
weld-allowed-smooth-seam = a smooth seam
weld-zero-direction-along-normal = the zero direction lies along the normal
weld-arc-normal-off = the plane of the three points is { $angle } off this normal
weld-allowed-arc-normal = perpendicular to that plane: { $normal } or its opposite
weld-allowed-point-off-line-or-line-seam = a point off the straight line from start to end; a straight seam is [seam.line]
weld-allowed-point-off-line = a point off the straight line from start to end, or no such key
weld-corner-radius-too-large = the corner's radius is more than half the smaller side
weld-point-count = the seam has { $count ->
        [one] { $count } point
       *[other] { $count } points
    }
weld-allowed-point-count = { $min } to { $max } points, here or in a `file`
weld-point-above-plate = this point is { $height } above the plate
weld-point-below-plate = this point is { $height } below the plate
weld-allowed-point-in-plane = a point in the plane through the first with this `normal`
weld-point-repeated = this point coincides with the one before
weld-last-point-repeated = the last point coincides with the first; the seam closes without it
weld-spline-point-repeated = point { $point } coincides with the one before
weld-spline-last-point-repeated = the last point, { $point }, coincides with the first; the seam closes without it
weld-allowed-points-apart = points at different positions
weld-allowed-points-apart-by = points at least { $min } apart
weld-allowed-leave-point-out = leave this point out
weld-allowed-other-points = other points
weld-normal-not-square = the face's normal is not perpendicular to the seam
weld-allowed-square-to-line = perpendicular to end_mm - start_mm
weld-faces-opposed = the faces point at each other and leave no joint to reach
weld-spline-faces-opposed = point { $point }: the faces point at each other and leave no joint to reach
weld-allowed-not-opposite = not opposite to `{ $key }`
weld-helix-without-pitch = a helix without a pitch is a circle
weld-allowed-pitch = not 0; for a seam around a tube use [seam.girth]
weld-helix-too-long = the helix has too many turns
weld-allowed-less-turn = smaller turns from point to point
weld-allowed-normals-less-turn = normals that turn by less than 90° from point to point
weld-normal-along-seam = a face's normal lies along the seam somewhere
weld-allowed-normals-across = normals across the seam
weld-closed-seam-has-no-ends = a closed seam has no ends
weld-allowed-no-key-closed = no such key with `closed = true`
weld-tangent-backwards = the tangent points back, away from the next point of the seam
weld-allowed-welding-direction = a direction in the sense of welding
weld-normal-count = { $normals ->
        [one] { $normals } normal
       *[other] { $normals } normals
    } for { $points ->
        [one] { $points } point
       *[other] { $points } points
    }
weld-allowed-one-per-point = one for each point
weld-second-normals-alone = `second_normals` need `first_normals`
weld-allowed-first-normals-too = `first_normals` too
weld-normal-twice = every point already has a normal of its own
weld-allowed-one-or-all-normals = either one normal or one for each point
weld-allowed-other-normals = other normals
weld-skin-normal-along-web = the skin's normal lies along the web
weld-allowed-out-of-skin = a direction out of the skin
weld-allowed-thin-web = a web much thinner than the arc's radius
weld-seam-without-surfaces = { $seam } has no surfaces to which points can be fitted
weld-seam-curved-t-joint = a curved T-joint
weld-seam-arc = an arc
weld-seam-rectangle = a rectangle
weld-seam-helix = a helix
weld-seam-spline = a spline
weld-seam-polyline = a polyline
weld-allowed-fit-methods = the methods three-point and plane-line-point

# Start and end of the weld.
weld-phi-too-large = the angle is more than ten turns
weld-overlap-with-end = a weld that ends at `end_phi_deg` does not close and has no overlap
weld-allowed-overlap-or-end = either `overlap_mm` or `end_phi_deg`
weld-end-beside-turn = the weld would have no length, or more than one turn
weld-allowed-end-phi-more = more than phi_deg = { $start }, by up to { $max }
weld-allowed-end-phi-less = less than phi_deg = { $start }, by up to { $max }
weld-overlap-too-long = the overlap is longer than the seam
weld-start-at-first-point = this seam starts at its first point and runs to the second
weld-allowed-points-in-other-order = no such key; give the points in another order
weld-start-of-open-seam = this seam runs from one end to the other and does not close
weld-allowed-no-key-on-open-seam = no such key on an open seam

# Data outside the file.
weld-no-machine-here = no machine is available here
weld-allowed-tip-coordinates = tip coordinates x_mm, y_mm, z_mm
weld-no-files-here = no files are available here
weld-points-twice = the points are given twice
weld-allowed-points-or-axes = either `points_mm` or `axes`
weld-position-not-finite = the position is not finite
weld-allowed-finite-numbers = finite numbers
weld-file-and-points = both a file and `{ $key }` are given
weld-allowed-points-in-file-or-job = points and their normals in the file, or in the job
weld-table-point-not-finite = { $file }: point { $point } is not finite
weld-table-normal-without-length = { $file }: point { $point } has a normal without length
weld-allowed-coordinates-and-normals = finite coordinates, and normals with a length
weld-procedure-unreadable = the procedure file is not readable: { $error }
weld-allowed-procedure = { $names }, or the path of a procedure file from the job's folder
weld-procedure-not-text = this is not a text file
weld-allowed-toml = a TOML file in UTF-8
weld-wrong-wire = { $procedure } is welded with a wire of { $wire }
weld-allowed-wire = { $wire }, or another procedure

# Taught spans.
weld-taught-spans-overlap = this span starts before the one before it ends
weld-allowed-taught-from = { $min } or more; spans in the order of welding
weld-taught-span-without-length = the span has no length
weld-taught-span-beyond-seam = the span ends beyond the nominal seam
weld-taught-span-without-points = there are no points between the joins
weld-allowed-taught-points = at least one, in `points_mm` or `axes`
weld-allowed-smooth-points = points farther apart, or nearer to one smooth curve
weld-taught-point-far = point { $point } is { $distance } from the nominal seam between the joins
weld-allowed-taught-within = { $key } = { $value }; or a larger `{ $key }`, if the part is that far off
weld-taught-point-out-of-order = point { $point } lies at s = { $s } along the seam
weld-allowed-taught-after-join = after the first join at { $min } and before the second join at { $max }
weld-allowed-taught-after-point = after the point before at { $min } and before the second join at { $max }
weld-taught-point-repeated = point { $point } coincides with a point or join beside it
weld-allowed-taught-apart = points and joins at least { $min } apart
weld-taught-curve-turns = near point { $point } the curve through the points turns { $angle } off the seam
weld-allowed-taught-turn = up to { $max }: points farther apart, or nearer to one smooth curve

# Passes.
weld-pass-begins-beyond-end = the pass starts beyond the end of the weld
weld-pass-round-more-than-twice = the pass goes round the seam more than twice
weld-pass-beyond-end = the pass runs beyond the end of the weld
weld-pass-beyond-start = the pass runs back beyond the start of the weld
weld-pass-without-seam = the pass has no seam to run along
weld-travel-too-long = { $pass } would travel for { $time }
weld-allowed-travel-time = up to { $max }: a higher speed
weld-bead-rows-too-short = the rows do not reach over the whole pass
weld-pass-without-motion = nothing moves in this pass
weld-allowed-point-elsewhere = a point elsewhere
weld-arc-points-in-line = the arc's start, `via_mm` and end lie on a line, or two of them coincide
weld-allowed-arc-points = three points that are not on a line; a full circle is two arcs

# Findings of passes.
weld-torch-inside-first-face = the torch would lie { $angle } inside the face of the first part (dihedral angle { $dihedral })
weld-torch-inside-second-face = the torch would lie { $angle } inside the face of the second part (dihedral angle { $dihedral })
weld-cure-smaller-work-angle = make the work angle smaller than half the dihedral angle
weld-bead-goes-back = the bead would (nearly) stand still or go back: it lies beyond the centre of the seam's bend, or its rows change too quickly
weld-cure-bead-nearer = lay the bead nearer to the seam there
weld-bead-area-out-of-range = to fill the groove, the bead would need { $area } at s = { $s }, { $ratio } of the { $run } of its run; allowed: { $min } to { $max }
weld-cure-thinner-layers = use thinner layers, larger runs (area, wire feed, lower speed), adapt = "passes", or a larger most_percent
weld-cure-smaller-beads = use smaller beads (higher speed, less wire), adapt = "passes", or a larger most_percent

# Joints.
weld-groove-at = at s = { $s }: { $why }
weld-groove-no-butt = faces at { $dihedral } to each other do not form a butt joint
weld-groove-no-corner = faces at { $dihedral } to each other do not form a fillet or T-joint
weld-groove-edge-within-part = the prepared edge, { $angle } from the other part's face, stays within its part: the dihedral angle is { $dihedral }
weld-groove-edge-in-other-part = the cut leaves { $angle } to the other part's face: the edge would lie inside that part
weld-groove-edges-cross = the edges cross each other
weld-groove-empty = the groove has no area
weld-allowed-butt-dihedral = a dihedral angle of { $min } or more, or a fillet
weld-allowed-corner-dihedral = a dihedral angle up to { $max }, or a butt joint
weld-allowed-edge-cut = more than 90° - dihedral angle everywhere
weld-allowed-larger-gap = a larger gap, or less mismatch
weld-allowed-room-to-weld = a gap or an angle that leaves room to weld

# Beads.
weld-beads-without-joint = there is no joint to fill
weld-allowed-joint = a [joint] with its preparation
weld-stations-with-beads = with [beads], values belong to [beads.root], [beads.fill] and [beads.cap]
weld-allowed-no-table-or-beads = no such table, or no [beads]
weld-ramp-with-beads = a value that ramps over the weld does not go with [beads]
weld-travel-angle-twice = the travel angle is given here and at several positions of the seam
weld-allowed-travel-angle-once = no such key, or no [[torch.at]]
weld-area-with-wire-feed = a given area does not follow the wire feed
weld-allowed-no-area-with-wire-feed = no such key with adapt = "wire_feed"
weld-bead-area-missing = the area of a bead is missing
weld-allowed-bead-area = area_mm2, or beads.wire_mm and a wire_feed_m_min
weld-bead-area-needs-steady-feed = the area of a bead needs a steady wire feed
weld-allowed-steady-feed = wire_feed_m_min greater than 0 in [weld.process] or here, or area_mm2
weld-deposition-too-large = the bead would have more metal than the wire
weld-bead-range-too-large = beads do not keep their shape over such a range
weld-wall-tilt-too-large = the wire would lie against the wall
weld-station-distance-invalid = invalid distance between stations
weld-no-bead-weaves = no bead weaves
weld-allowed-weave = a [weld.weave] or a `weave` of [beads.root], [beads.fill] or [beads.cap], or another value
weld-too-many-beads = the groove of { $groove } takes { $beads } beads of { $bead }
weld-too-many-stations = the beads would be laid out at { $count ->
        [one] { $count } station
       *[other] { $count } stations
    }
weld-too-many-bead-positions = { $passes ->
        [one] { $passes } pass
       *[other] { $passes } passes
    } with { $rows ->
        [one] { $rows } row
       *[other] { $rows } rows
    } each are too many
weld-allowed-larger-beads = larger beads: lower speed, or more wire; up to { $max } beads fill a groove
weld-allowed-smaller-groove = up to { $max } beads: a smaller groove, or larger beads
weld-allowed-stations = up to { $max } stations: a larger distance
weld-allowed-bead-positions = up to { $max } positions: a larger distance, or larger beads

# Order of welding: copies, parts, tacks.
weld-order-without-rows = there are no rows to go back and forth between
weld-allowed-two-rows = two rows: [rows], or `row` in each of [[copies]]
weld-skip-invalid = this skips none of the copies, or all of them
weld-allowed-no-skip = no skip: there are too few copies in a row
weld-allowed-skip = 2 to { $max }: the longest row has { $copies ->
        [one] { $copies } copy
       *[other] { $copies } copies
    }
weld-copies-twice = the copies are given twice
weld-allowed-rows-or-copies = either [rows] or [[copies]]
weld-too-many-passes = { $passes } passes in all are too many
weld-allowed-passes = up to { $max }: fewer copies or tacks, or fewer or longer parts
weld-too-many-rows = { $passes ->
        [one] { $passes } pass
       *[other] { $passes } passes
    } with { $rows } rows of beads and spans in all are too many
weld-allowed-row-count = up to { $max } rows: fewer copies or tacks, fewer or longer parts, or a larger beads.station_mm
weld-copy-count-invalid = invalid number of copies
weld-too-many-copies = too many copies
weld-allowed-columns = 1 to { $max }: { $copies } copies in all
weld-copies-coincide = copies would stand at the same position
weld-allowed-row-step = a step off the line of the row, or beyond its end
weld-copy-too-far = a copy would stand too far away
weld-allowed-copies-within = copies within { $limit } of 0
weld-seam-without-corners = the seam has no corners
weld-overlap-at-corners = parts from corner to corner have no overlap
weld-allowed-no-overlap-at-corners = 0 with order.parts = "at_corners"
weld-seam-without-quarters = a seam that is not welded all round has no opposite quarters
weld-pieces-longer-than-weld = the pieces would be longer than the weld
weld-too-many-pieces = too many pieces
weld-allowed-piece-length = at least { $min }: up to { $count } pieces
weld-tie-in-too-long = the tie-in is not shorter than a part
weld-allowed-tie-in = less than a part: { $max }
weld-all-round-has-one-end = a seam that is welded all round ends where it starts
weld-cosmetic-ramp = a cosmetic pass has steady values
weld-cosmetic-beyond-end = the cosmetic pass starts beyond the end of the weld
weld-tack-count-or-pitch = the number of tacks follows from exactly one of two keys
weld-allowed-count-or-pitch = either `count` or `pitch_mm`
weld-tack-count-invalid = invalid number of tacks
weld-tack-ramp = a tack has steady values
weld-too-many-tacks = too many tacks
weld-allowed-tack-pitch = at least { $min }: up to { $count } tacks
weld-tacks-meet = the tacks would meet
weld-allowed-tack-length = less than the distance from one tack to the next: { $count } on { $length } of seam
weld-tacks-near-start = tacks would start { $distance } from the weld's start
weld-allowed-tack-clearance = up to { $max }, or fewer tacks

# The part as solids.
weld-part-replaced-by-nothing = the part made from the seam is replaced, but no solids are given
weld-allowed-part-solids = [[part.solids]] with it, or no such key
weld-allowed-rigid-placement = a rigid placement
weld-body-too-short = the body would end within the seam
weld-part-from-seam = the part made from the seam: { $why }
weld-allowed-part-sizes = sizes up to { $max }, also those of [part]; or [[part.solids]] with part.replace = true
weld-allowed-sphere = a sphere
