# Positions on the weld, and torch angles.
weld-position-beside-weld = this position is not on the weld
    .cause = A station `s_mm` lies before 0 or after the end of the weld. On a seam welded all round, the end itself counts as the start.
    .cure = Correct `s_mm` of `[[torch.at]]`, `[[weld.at]]`, `[[joint.fit_up]]` or the bead. `seamwright tools seam JOB` lists the path lengths.
weld-positions-must-increase = the positions must increase
    .cause = The `s_mm` of this station is equal to the one before it, or smaller. Positions within 0.000001 mm count as equal.
    .cure = Sort `[[torch.at]]` or `[[weld.at]]` by `s_mm`, and delete stations that are given twice.
weld-without-length = the weld has no length
    .cause = The range from `start.phi_deg` to `start.end_phi_deg`, or the seam itself, has a length of 0.
    .cure = Correct the dimensions of the seam and the angles in `[start]`.
weld-angles-twice = angles are given both constant and at several positions
    .cause = With `[[torch.at]]` stations, `torch.work_angle_deg` or `torch.travel_angle_deg` is also different from 0.
    .cure = Delete the two keys in `[torch]`, or delete all `[[torch.at]]` tables.
weld-travel-angle-too-large = the torch would lie along the seam
    .cause = Travel angles beyond 75° either way are refused. The sign is positive for drag and negative for push.
    .cure = Correct `travel_angle_deg` of `[torch]`, `[[torch.at]]` or the run of `[beads]`.
weld-work-angle-too-large = the torch would lie behind a face
    .cause = The work angle is 90° or more off the bisector of the two faces.
    .cure = Correct `work_angle_deg`: 0 is the bisector, positive leans the torch towards the first part.
weld-torch-search-too-wide = the search of torch angles goes beyond what a torch can do
    .cause = Work angles more than 60° and travel angles more than 45° from the given ones are not searched.
    .cure = Give a better `work_angle_deg` to start with.
weld-stick-out-range = no torch welds with this stick-out
    .cause = The wire between contact tip and arc is shorter or longer than any process uses.
    .cure = Correct `stick_out_mm`: 10 to 25 mm with gas and thin wire, 25 to 40 mm with submerged arc.
weld-stick-out-of-machine = the stick-out of the machine's torch is unknown, so the torch cannot be drawn back for another one
    .cause = A job's stick-out moves the torch back by the difference to the one for which its tip was measured, and the machine's file does not say that one. Machines with several heads have none: they weld with the stick-out of their calibration.
    .cure = Measure the wire between contact tip and torch tip as it was when the tip was calibrated, and write it as `stick_out_mm` to `[torch]` of the machine's file.
weld-stick-out-above-search = the search may not lengthen the stick-out to this: { $own } is what the torch has without it
    .cause = `max_stick_out_mm` of `[torch.search]` is below the `stick_out_mm` of the run, of `[torch]` or of the machine.
    .cure = Raise `max_stick_out_mm`, or leave it out: then the stick-out stays.
weld-allowed-stick-out = `stick_out_mm` in [torch] of the machine's file: the wire between contact tip and torch tip
weld-min-speed-too-high = the minimum speed is not below the welding speed
    .cause = `weld.least_speed_mm_s` is equal to `weld.speed_mm_s` or greater.
    .cure = Lower `least_speed_mm_s` to the minimum speed of the procedure, or raise `speed_mm_s`.
weld-speed-below-min = the welding speed is not above the minimum speed
    .cause = `speed_mm_s` of a `[[weld.at]]` station is not above `weld.least_speed_mm_s`.
    .cure = Raise the speed at this station, or lower `weld.least_speed_mm_s`.
weld-value-ramps-already = this value already ramps over the whole weld
    .cause = `weld.process` gives this value as a ramp with `from` and `to`, and a `[[weld.at]]` station gives it too.
    .cure = Give the value in `weld.process` as a number and keep the stations, or delete it in `[[weld.at]]`.

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
    .cause = The half angle of a cone, measured from its axis to its surface, is 90° or more.
    .cure = Check whether `half_angle_deg` is the full angle of the drawing, and halve it. For a flat body use `plane` or `flat_head`.
weld-torus-meets-itself = the pipe would meet itself in the middle of the bend
    .cause = The radius of the bend is not greater than the outer radius of the pipe.
    .cure = Measure `bend_radius_mm` to the centre line of the pipe, and give `radius_mm` as a radius, not a diameter.
weld-set-in-wall-missing = the nozzle is set in: the thickness of the body's wall is missing
    .cause = A nozzle with `mount = "set_in"` needs the inner surface of the body.
    .cure = Give `thickness_mm` in the table of the body under `[seam.nozzle.body]`.
weld-set-on-root-wall-missing = the root of a set-on nozzle is at its bore: the thickness of its wall is missing
    .cause = The seam is `curve = "inner_root"` with `mount = "set_on"`, and `wall_mm` is missing.
    .cure = Give `wall_mm` in `[seam.nozzle]`, the thickness of the nozzle's wall.
weld-wall-leaves-no-room = the wall leaves no room inside
    .cause = The wall is as thick as the body's outer radius, or thicker.
    .cure = Correct `thickness_mm`. Check that radius and diameter are not confused in the outer size.
weld-wall-leaves-no-bore = the wall leaves no bore
    .cause = `wall_mm` is equal to the outer radius of the nozzle or branch, or greater.
    .cure = Correct `wall_mm`, and check that `radius_mm` is the outer radius.
weld-knuckle-too-large = the knuckle, with an inside radius of { $radius }, does not fit into the flange
    .cause = The inside radius of the knuckle is not less than the inside radius of the flange: half of `outer_diameter_mm` minus `thickness_mm`.
    .cure = Lower `knuckle_radius_mm`. If it follows from `standard`, check `outer_diameter_mm` and `thickness_mm`.
weld-allowed-knuckle = an inside radius of the knuckle less than the flange's, { $max }
weld-head-radii-missing = the radii of crown and knuckle are missing
    .cause = A `torispherical_head` has no `standard`, and only one or none of its two radii is given.
    .cure = Give `standard`, or the two inside radii from the drawing of the head.
weld-allowed-head-radii = `standard` ("din_28011", "din_28013" or "asme_fd"), or both `crown_radius_mm` and `knuckle_radius_mm`
weld-crown-too-curved = the crown is not flatter than a hemisphere
    .cause = The inside radius of the crown is not greater than the inside radius of the flange.
    .cure = Raise `crown_radius_mm`, or use `hemispherical_head`.
weld-allowed-crown = more than the flange's inside radius, { $min }

# Branches of tubes, and girths.
weld-branch-along-chord = the branch lies along the chord
    .cause = The angle between branch and chord is outside 10° to 170°.
    .cure = Correct `angle_deg` of `[seam.branch]` or `[seam.branch.other]`: it is measured between the axes, 90 is square.
weld-branch-wider-than-chord = the branch is not narrower than the chord
    .cause = The outer radius of the branch is not less than `chord_radius_mm`.
    .cure = Correct `radius_mm` or `chord_radius_mm`. Equal tubes need a branch that is slightly smaller.
weld-branch-past-chord = the branch's wall goes past the chord
    .cause = The eccentricity is not less than the chord's radius minus the radius of the branch, so part of the branch misses the chord.
    .cure = Lower `eccentricity_mm`, or correct the radii.
weld-branches-do-not-part = the two branches are parallel or run into each other
    .cause = The two angles add up to 180° or more, so the axes of the branches do not diverge from the chord.
    .cure = Lower `angle_deg` of `[seam.branch.other]` or of `[seam.branch]`.
weld-branch-position-missing = the position of the other branch is missing
    .cause = The table `[seam.branch.other]` has neither `gap_mm` nor `offset_mm`.
    .cure = Measure the gap between the toes along the chord and give it as `gap_mm`.
weld-branch-position-twice = the position of the other branch is given twice
    .cause = The table `[seam.branch.other]` has `gap_mm` and `offset_mm`.
    .cure = Delete one of the two keys.
weld-allowed-tube = a tube
weld-allowed-tubes-meet = tubes whose walls meet all round: a smaller branch, or less overlap
weld-allowed-other-branch-angle = less than { $max } with the first branch at { $first }, so that the axes part
weld-allowed-gap-or-offset = exactly one of `gap_mm` (between the toes; negative where they overlap) and `offset_mm` (between the axes)
weld-allowed-branch-within-chord = a branch within the chord
weld-allowed-eccentricity = more than { $min } and less than { $max }: chord_radius_mm - radius_mm
weld-cut-along-tube = the cut runs along the tube: its normal is { $angle } off the axis
    .cause = The normal of the cutting plane is more than 85° off the axis of the tube.
    .cure = Correct `seam.girth.cut_normal`, or delete it for a square cut.
weld-allowed-cut-angle = up to { $max } off `direction`
weld-allowed-other-plane = another plane

# Shapes of seams.
weld-seam-too-long = the seam would be { $length } long
    .cause = The seam is longer than 1,000,000 mm.
    .cure = Check the units of the dimensions in `[seam]`, and `turns` and `pitch_mm` of a helix.
weld-allowed-smooth-seam = a smooth seam
weld-zero-direction-along-normal = the zero direction lies along the normal
    .cause = The `zero_direction` and the normal of the circle are parallel, so angles have no start.
    .cure = Give a `zero_direction` across the normal, or delete the key.
weld-arc-normal-off = the plane of the three points is { $angle } off this normal
    .cause = The plate's `normal` is not perpendicular to the plane of start, intermediate point and end. The allowed error is 0.000001 of a unit vector.
    .cure = Copy the normal from the message into `seam.arc.normal`, with the sign that points out of the plate.
weld-allowed-arc-normal = perpendicular to that plane: { $normal } or its opposite
weld-allowed-point-off-line-or-line-seam = a point off the straight line from start to end; a straight seam is [seam.line]
weld-allowed-point-off-line = a point off the straight line from start to end, or no such key
weld-corner-radius-too-large = the corner's radius is more than half the smaller side
    .cause = `corner_mm` is more than half of the smaller of `width_mm` and `height_mm`.
    .cure = Lower `corner_mm` of `[seam.rounded_rectangle]`, or correct the sides.
weld-point-count = the seam has { $count ->
        [one] { $count } point
       *[other] { $count } points
    }
    .cause = An open seam needs 2 points, a closed one 3. A spline takes up to 20,000.
    .cure = Add points, or thin them out. `seamwright tools reduce` replaces dense points by few.
weld-allowed-point-count = { $min } to { $max } points, here or in a `file`
weld-point-above-plate = this point is { $height } above the plate
    .cause = The points of a polyline must lie in one plane, within 0.000001 of its size. This one lies off it, on the side of the normal.
    .cure = Correct the point, or `normal` of `[seam.polyline]`. For a seam out of a plane use `[seam.spline]`.
weld-point-below-plate = this point is { $height } below the plate
    .cause = The points of a polyline must lie in one plane, within 0.000001 of its size. This one lies off it, against the normal.
    .cure = Correct the point, or `normal` of `[seam.polyline]`. For a seam out of a plane use `[seam.spline]`.
weld-allowed-point-in-plane = a point in the plane through the first with this `normal`
weld-point-repeated = this point coincides with the one before
    .cause = The distance to the point before is at most 0.000001 of the size of the polyline.
    .cure = Delete one of the two points in `seam.polyline.points_mm`.
weld-last-point-repeated = the last point coincides with the first; the seam closes without it
    .cause = With `closed = true` the seam returns to its first point by itself.
    .cure = Delete the last point in `seam.polyline.points_mm`.
weld-spline-point-repeated = point { $point } coincides with the one before
    .cause = The distance to the point before is less than 0.001 mm. Recorded points may repeat where the hand rested.
    .cure = Delete this point in `seam.spline.points_mm`, or its line in the CSV file.
weld-spline-last-point-repeated = the last point, { $point }, coincides with the first; the seam closes without it
    .cause = With `closed = true` the spline returns to its first point by itself.
    .cure = Delete the last point in `seam.spline.points_mm`, or the last line of the CSV file.
weld-allowed-points-apart = points at different positions
weld-allowed-points-apart-by = points at least { $min } apart
weld-allowed-leave-point-out = leave this point out
weld-allowed-other-points = other points
weld-normal-not-square = the face's normal is not perpendicular to the seam
    .cause = The normal has a component along the line of more than 0.000001 of its length.
    .cure = Correct `first_normal` or `second_normal` of `[seam.line]`, with more decimals if they are rounded.
weld-allowed-square-to-line = perpendicular to end_mm - start_mm
weld-faces-opposed = the faces point at each other and leave no joint to reach
    .cause = The two normals are opposite to each other: the angle between the faces is 0.
    .cure = Correct the sign of `first_normal` or `second_normal`: both point out of their parts.
weld-spline-faces-opposed = point { $point }: the faces point at each other and leave no joint to reach
    .cause = The first and the second normal at this point are opposite to each other.
    .cure = Correct the sign in `first_normals` or `second_normals` of this point: both point out of their parts.
weld-allowed-not-opposite = not opposite to `{ $key }`
weld-helix-without-pitch = a helix without a pitch is a circle
    .cause = `pitch_mm` of `[seam.helix]` is 0.
    .cure = Give the climb per turn. Use `[seam.circle]` or `[seam.girth]` for a seam without climb.
weld-allowed-pitch = not 0; for a seam around a tube use [seam.girth]
weld-helix-too-long = the helix has too many turns
    .cause = `turns` of `[seam.helix]` is more than 1000.
    .cure = Check whether `turns` was given in degrees or mm.
weld-allowed-less-turn = smaller turns from point to point
weld-allowed-normals-less-turn = normals that turn by less than 90° from point to point
weld-normal-along-seam = a face's normal lies along the seam somewhere
    .cause = A normal of the plate or face is parallel to the direction of the spline at some point.
    .cure = Correct `normal` or `first_normals` of `[seam.spline]`. Give a normal for each point if the seam climbs steeply.
weld-allowed-normals-across = normals across the seam
weld-closed-seam-has-no-ends = a closed seam has no ends
    .cause = A spline with `closed = true` has a `start_tangent` or `end_tangent`.
    .cure = Delete the tangents, or set `closed = false`.
weld-allowed-no-key-closed = no such key with `closed = true`
weld-tangent-backwards = the tangent points back, away from the next point of the seam
    .cause = The tangent is 90° or more off the line between the two points at this end of the spline.
    .cure = Reverse the signs of `start_tangent` or `end_tangent`: both point in the direction of welding.
weld-allowed-welding-direction = a direction in the sense of welding
weld-normal-count = { $normals ->
        [one] { $normals } normal
       *[other] { $normals } normals
    } for { $points ->
        [one] { $points } point
       *[other] { $points } points
    }
    .cause = `first_normals` or `second_normals` does not have as many entries as `points_mm`.
    .cure = Give one normal for each point in the same order.
weld-allowed-one-per-point = one for each point
weld-second-normals-alone = `second_normals` need `first_normals`
    .cause = The spline has `second_normals`, but no `first_normals`.
    .cure = Add `first_normals`. To give the plate alone, rename the key to `first_normals`.
weld-allowed-first-normals-too = `first_normals` too
weld-normal-twice = every point already has a normal of its own
    .cause = `[seam.spline]` has `first_normals` and also `normal`.
    .cure = Delete `normal`.
weld-allowed-one-or-all-normals = either one normal or one for each point
weld-allowed-other-normals = other normals
weld-skin-normal-along-web = the skin's normal lies along the web
    .cause = `skin_normal` is within about 6° of the direction of the web at its start.
    .cure = Correct `skin_normal` of `[seam.t_joint]`: it points out of the skin, on the side of the web.
weld-allowed-out-of-skin = a direction out of the skin
weld-allowed-thin-web = a web much thinner than the arc's radius
weld-seam-without-surfaces = { $seam } has no surfaces to which points can be fitted
    .cause = `seamwright machine place` fits points to the surfaces of both parts. Arcs, rectangles, helices, splines, polylines and curved T-joints have no such surfaces.
    .cure = Determine the position by other means, and give it in `[offsets.NAME]` with `move_mm`, `turn` and `angle_deg`.
weld-seam-curved-t-joint = a curved T-joint
weld-seam-arc = an arc
weld-seam-rectangle = a rectangle
weld-seam-helix = a helix
weld-seam-inside-girth = a girth inside its tube
weld-seam-spline = a spline
weld-seam-polyline = a polyline
weld-allowed-fit-methods = the methods three-point and plane-line-point

# Start and end of the weld.
weld-phi-too-large = the angle is more than ten turns
    .cause = An angle in `[start]` is beyond 3600° either way.
    .cure = Correct `phi_deg` or `end_phi_deg`.
weld-overlap-with-end = a weld that ends at `end_phi_deg` does not close and has no overlap
    .cause = `[start]` has `end_phi_deg`, and `overlap_mm` is greater than 0.
    .cure = Delete `overlap_mm`, or delete `end_phi_deg` to weld all round.
weld-allowed-overlap-or-end = either `overlap_mm` or `end_phi_deg`
weld-end-beside-turn = the weld would have no length, or more than one turn
    .cause = Seen in the direction of welding, `end_phi_deg` lies at or before `phi_deg`, or more than a turn after it.
    .cure = Add or subtract 360 to `end_phi_deg`, or set `direction` in `[start]`. From 300 through 360 to 40 is 300 to 400.
weld-allowed-end-phi-more = more than phi_deg = { $start }, by up to { $max }
weld-allowed-end-phi-less = less than phi_deg = { $start }, by up to { $max }
weld-overlap-too-long = the overlap is longer than the seam
    .cause = `start.overlap_mm` is greater than the length of the seam.
    .cure = Lower `overlap_mm`. For several rounds use several passes.
weld-start-at-first-point = this seam starts at its first point and runs to the second
    .cause = The keys `phi_deg`, `end_phi_deg` and `direction` have no meaning on a closed polyline or spline.
    .cure = Delete the key in `[start]`. To start elsewhere or weld in the other direction, reorder the points.
weld-allowed-points-in-other-order = no such key; give the points in another order
weld-start-of-open-seam = this seam runs from one end to the other and does not close
    .cause = Angles, `direction` and `overlap_mm` in `[start]` are for closed seams only.
    .cure = Delete the key in `[start]`. To weld in the other direction, exchange start and end of the seam.
weld-allowed-no-key-on-open-seam = no such key on an open seam

# Data outside the file.
weld-no-machine-here = no machine is available here
    .cause = The file has axis positions, and it was read without access to machine files. This happens in programs that use the library alone.
    .cure = Give points instead of axis positions, or read the file with the command line or the panel.
weld-allowed-tip-coordinates = tip coordinates x_mm, y_mm, z_mm
weld-no-files-here = no files are available here
    .cause = The spline names a CSV file, and the job was read without access to other files.
    .cure = Put the points into `seam.spline.points_mm`, or use `program.toml` of `seamwright plan`, which contains them.
weld-points-twice = the points are given twice
    .cause = A `[[taught]]` table has `axes` and also `points_mm`.
    .cure = Delete one of the two keys.
weld-allowed-points-or-axes = either `points_mm` or `axes`
weld-position-not-finite = the position is not finite
    .cause = The axis positions of a taught point give a tip position beyond all bounds.
    .cure = Check this row of `taught.axes`, and the units and dimensions in the machine file.
weld-allowed-finite-numbers = finite numbers
weld-file-and-points = both a file and `{ $key }` are given
    .cause = `[seam.spline]` has `file`, and also points or normals of its own.
    .cure = Delete `file`, or delete the points and normals in the job.
weld-allowed-points-in-file-or-job = points and their normals in the file, or in the job
weld-table-point-not-finite = { $file }: point { $point } is not finite
    .cause = A coordinate in the CSV file is infinite, not a number, or beyond 10,000,000 mm.
    .cure = Correct this line of the CSV file.
weld-table-normal-without-length = { $file }: point { $point } has a normal without length
    .cause = A normal in the CSV file is 0 in all three columns, or not finite.
    .cure = Correct the columns `n1x` to `n2z` in this line, or delete the columns.
weld-allowed-coordinates-and-normals = finite coordinates, and normals with a length
weld-procedure-unreadable = the procedure file is not readable: { $error }
    .cause = The `procedure` of the job is not a supplied procedure, and the operating system does not open a file of this name.
    .cure = Correct the path, relative to the job's folder. `seamwright examples --procedures` lists the supplied ones.
weld-allowed-procedure = { $names }, or the path of a procedure file from the job's folder
weld-procedure-not-text = this is not a text file
    .cause = The procedure file is not UTF-8: a word processor document, or another encoding.
    .cure = Save it as plain text in UTF-8.
weld-allowed-toml = a TOML file in UTF-8
weld-wrong-wire = { $procedure } is welded with a wire of { $wire }
    .cause = `beads.wire_mm` of the job differs from `wire_diameter_mm` of the procedure.
    .cure = Set `beads.wire_mm` to the wire on the machine. Name another procedure if that wire is not qualified.
weld-two-wires = `{ $other }` is { $wire }: one wire has one diameter
    .cause = `beads.wire_mm` and `consumables.wire_mm` differ.
    .cure = Give the diameter once, or the same at both.
weld-allowed-wire = { $wire }, or another procedure

# Taught spans.
weld-taught-spans-overlap = this span starts before the one before it ends
    .cause = `from_mm` of this `[[taught]]` table is less than `to_mm` of the table before it.
    .cure = Sort the `[[taught]]` tables by `from_mm`. Join two overlapping spans into one with the points of both.
weld-allowed-taught-from = { $min } or more; spans in the order of welding
weld-taught-span-without-length = the span has no length
    .cause = `to_mm` of this `[[taught]]` table is not greater than `from_mm`.
    .cure = Exchange or correct the two path lengths; both count in the direction of welding.
weld-taught-span-beyond-seam = the span ends beyond the nominal seam
    .cause = `to_mm` is greater than the length of the nominal seam without overlap.
    .cure = Lower `to_mm`. `seamwright tools seam JOB`, without `[[taught]]` in the job, prints the path lengths.
weld-taught-span-without-points = there are no points between the joins
    .cause = The `[[taught]]` table has neither `points_mm` nor `axes`, or the list is empty.
    .cure = Teach at least one point between `from_mm` and `to_mm`, or delete the table.
weld-allowed-taught-points = at least one, in `points_mm` or `axes`
weld-allowed-smooth-points = points farther apart, or nearer to one smooth curve
weld-taught-point-far = point { $point } is { $distance } from the nominal seam between the joins
    .cause = The distance of the point from the nominal seam is greater than `within_mm` of this `[[taught]]` table. The part may have moved as a whole.
    .cure = Check the point and the work offset first. Raise `within_mm` if the part is bent that far.
weld-allowed-taught-within = { $key } = { $value }; or a larger `{ $key }`, if the part is that far off
weld-taught-point-out-of-order = point { $point } lies at s = { $s } along the seam
    .cause = The point nearest to it on the nominal seam is not after that of the point before, or not between the joins. The minimum step is 0.001 mm.
    .cure = Sort the points in the direction of welding. Move `from_mm` or `to_mm` outwards if the point lies beyond a join.
weld-allowed-taught-after-join = after the first join at { $min } and before the second join at { $max }
weld-allowed-taught-after-point = after the point before at { $min } and before the second join at { $max }
weld-taught-point-repeated = point { $point } coincides with a point or join beside it
    .cause = Two neighbouring points, or a point and a join, are less than 0.001 mm apart.
    .cure = Delete the repeated point in this `[[taught]]` table.
weld-allowed-taught-apart = points and joins at least { $min } apart
weld-taught-curve-turns = near point { $point } the curve through the points turns { $angle } off the seam
    .cause = The spline through the points leaves the direction of the nominal seam by more than 60°. Points with errors of measurement lie too near to each other.
    .cure = Delete or teach again the points near this one. Place points far apart where the part is smooth.
weld-allowed-taught-turn = up to { $max }: points farther apart, or nearer to one smooth curve

# Passes.
weld-pass-begins-beyond-end = the pass starts beyond the end of the weld
    .cause = `begin_mm` of the pass is greater than the length of the weld.
    .cure = Lower `begin_mm` of `[[passes]]`. After a change of the seam, run `seamwright plan` on the job again.
weld-pass-round-more-than-twice = the pass goes round the seam more than twice on one bead
    .cause = On a seam welded all round a pass is at most two turns long, and one turn longer for each of its step-overs.
    .cure = Shorten the last span with `to_mm`. Repeat the pass with `repeat` for more turns.
weld-pass-beyond-end = the pass runs beyond the end of the weld
    .cause = On this seam `begin_mm` plus the length of the spans is greater than the length of the weld.
    .cure = Lower `to_mm` of the last span, or `begin_mm`. After a change of the seam, run `seamwright plan` again.
weld-pass-beyond-start = the pass runs back beyond the start of the weld
    .cause = With `reverse = true` the pass is longer than `begin_mm`, so it runs past the start of the weld.
    .cure = Raise `begin_mm` to the length of the pass, or lower `to_mm` of the last span.
weld-pass-without-seam = the pass has no seam to run along
    .cause = The pass has spans, but the program has no `[seam]`.
    .cure = Add `[seam]`, or give the pass `[passes.points]`.
weld-travel-too-long = { $pass } would travel for { $time }
    .cause = The length of the pass, divided by its asked speed, is more than 86,400 s.
    .cure = Check the unit of `speed_mm_s`: a value in m/min or m/s is too small.
weld-allowed-travel-time = up to { $max }: a higher speed
weld-bead-rows-too-short = the rows do not reach over the whole pass
    .cause = The rows of `[passes.bead]` start after the pass starts, or end before it ends. Only one row, or a seam welded all round, needs no such range.
    .cure = Extend `s_mm` of `[passes.bead]` with a row at the start or end of the pass.
weld-pass-without-motion = nothing moves in this pass
    .cause = All points of the pass are at the start point and take no time.
    .cure = Correct the points in `[[passes.points.spans]]`, or delete the pass with `seamwright edit FILE delete-pass`.
weld-allowed-point-elsewhere = a point elsewhere
weld-arc-points-in-line = the arc's start, `via_mm` and end lie on a line, or two of them coincide
    .cause = No circle goes through the three points, or with `normal` no helix about that direction.
    .cure = Correct `via_mm` to a point about halfway on the arc. Use `along = "line"` for a straight way.
weld-allowed-arc-points = three points that are not on a line; a full circle is two arcs

# Findings of passes.
weld-torch-inside-first-face = the torch would lie { $angle } inside the face of the first part (dihedral angle { $dihedral })
    .cause = Work angle, wall tilt and travel angle together lean the torch past the face of the first part at these stations. Acute dihedral angles leave little room.
    .cure = Lower `torch.work_angle_deg` or `beads.wall_tilt_deg`, or give smaller angles there by `[[torch.at]]`.
weld-torch-inside-second-face = the torch would lie { $angle } inside the face of the second part (dihedral angle { $dihedral })
    .cause = Work angle, wall tilt and travel angle together lean the torch past the face of the second part at these stations. Acute dihedral angles leave little room.
    .cure = Bring a negative `torch.work_angle_deg` nearer to 0, lower `beads.wall_tilt_deg`, or give other angles there by `[[torch.at]]`.
weld-cure-smaller-work-angle = make the work angle smaller than half the dihedral angle
weld-bead-goes-back = the bead would (nearly) stand still or go back: it lies beyond the centre of the seam's bend, or its rows change too quickly
    .cause = On the bead the tip advances by less than 0.1 mm for each mm along the seam. A bead inside a tight bend has no room.
    .cure = Lower `across_mm` and `out_mm` of `[passes.bead]`, or space its rows farther apart. In a job use thinner layers in `[beads]`.
weld-cure-bead-nearer = lay the bead nearer to the seam there
weld-bead-area-out-of-range = to fill the groove, the bead would need { $area }, { $ratio } of the { $run } of its run; allowed: { $min } to { $max }
    .cause = The groove's area varies along the seam, and the beads follow it by more than `beads.most_percent`. Fit-up gaps or a varying dihedral angle are usual reasons.
    .cure = Set `layer_mm`, speed or wire feed of the run in `[beads]` to fit the mean groove. `seamwright tools section JOB` lists the areas.
weld-cure-thinner-layers = use thinner layers, larger runs (area, wire feed, lower speed), adapt = "passes", or a larger most_percent
weld-cure-smaller-beads = use smaller beads (higher speed, less wire), adapt = "passes", or a larger most_percent
weld-bead-width-out-of-window = the bead would be { $width } wide and { $height } high; allowed width: { $min } to { $max }
    .cause = The layers that fill the groove have no room for beads of the run's area in the window of the procedure, or in the usual one of the process.
    .cure = Change the run's area (speed, wire feed) or `layer_mm` in `[beads]`, or `bead_width_mm` of the procedure's run.
weld-bead-height-out-of-window = the bead would be { $height } high and { $width } wide; allowed height: { $min } to { $max }
    .cause = The groove's depth does not divide into layers in the window of the procedure, or in the usual one of the process.
    .cure = Change `layer_mm` or the run's area (speed, wire feed) in `[beads]`, or `bead_height_mm` of the procedure's run.
weld-bead-ratio-out-of-window = the bead would be { $width } wide and { $height } high: a ratio of { $ratio }; allowed: { $min } to { $max }
    .cause = A bead deeper than wide tends to crack along its middle; a much wider one does not fuse well. The groove and the run's area leave no other shape.
    .cure = Change `layer_mm` or the run's area (speed, wire feed) in `[beads]`, or `bead_width_to_height` of the procedure's run.
weld-bead-too-wide-without-weave = the bead would be { $width } wide and { $height } high without a weave; allowed: up to { $max }
    .cause = The arc does not melt a groove so wide without a weave. The limit is that of the procedure, or the usual one of process and wire.
    .cure = Give the run a `weave`, or a smaller area, so that more beads lie side by side. Or set `max_unwoven_mm` of the procedure's run.
weld-bead-toe-steep = the toe angle of the cap would be { $angle }; allowed: { $min } or more
    .cause = The cap is too high for its width, so its face meets the part at a notch. The limit is `min_toe_angle_deg` of the procedure's run, or that of its `quality_level` by ISO 5817, no. 505. 180° is flush.
    .cure = Lower `cap_mm` of `[joint]`, or set `spacing_to_width` of `[beads]` nearer to 2/3. Wider and flatter cap beads need a weave or a smaller area.
weld-layer-height-not-kept = the layer would be { $height } high instead of { $wanted }: beads of { $area } fill it otherwise
    .cause = The run's area, the windows of its beads and the groove leave no layers of this height.
    .cure = Set `layer_mm` nearer to this height, or change the run's area (speed, wire feed) in `[beads]`.
weld-cure-bead-window = use another layer_mm or area of the run (speed, wire feed), adapt = "passes", or another window in the procedure
weld-cure-weave-or-smaller-beads = give the run a weave, or smaller beads (higher speed, less wire)
weld-cure-bead-toe = lower cap_mm, set spacing_to_width nearer to 2/3, or use flatter cap beads (weave, smaller area)
weld-cure-layer-height = set layer_mm nearer to this height, or change the run's area (speed, wire feed)

# Joints.
weld-groove-at = at s = { $s }: { $why }
    .cause = The joint is drawn at 721 stations along the seam, and at those of `[beads]`. This is the first one without a valid groove.
    .cure = Correct `[joint.preparation]`, or shorten the weld by `[start]`. The reason follows the position.
weld-remaining-area-impossible = the groove does not have this open area
    .cause = `remaining_mm2` is more than the area of the groove with the gap, mismatch and angle of its table, or so far below 0 that cap and groove are full.
    .cure = Measure again, or correct `[joint.preparation]`.
weld-scan-after-last-layer = { $layers ->
        [one] { $layers } layer is planned
       *[other] { $layers } layers are planned
    } until then: none is left for this measurement
    .cause = `after_layer` of a `[[joint.fit_up]]` table is not less than the number of layers planned from the tables before.
    .cure = Correct `after_layer`, or delete the table.
weld-scan-too-few-points = only { $found } points; { $needed } are needed
weld-scan-no-groove = the joint is not there: { $share } % of the points lie on it, with a scatter of { $scatter } mm
    .cause = Less than half of the profile's points lie on the drawn groove in any pose, or they scatter by more than 0.5 mm about it.
    .cure = Look at the profile. The sensor must see both faces beside the groove, and look into the groove along its middle within 15°: `--turn-deg`.
weld-scan-other-angle = the faces or edges are at { $angle }; drawn are { $drawn }
    .cause = The dihedral or groove angle differs from the drawing by more than 8°: usually the profile of another station.
    .cure = Check `s_mm` of the row, and the joint of the job.
weld-scan-uncertain = the open area is uncertain by { $uncertainty }: an edge is not seen
    .cause = The standard uncertainty of the area is more than 5 % of the groove. Usually the points of one edge are missing, or do not fit it.
    .cure = Look at the profile. Both edges must be seen down to the root or the metal: turn the sensor, and give `--turn-deg`.
weld-groove-no-butt = faces at { $dihedral } to each other do not form a butt joint
    .cause = Butt preparations (`square`, `single_v`, `bevel`, `u`, `j`, the double ones, `flare_v`) need faces at 120° or more to each other.
    .cure = Use `fillet`, `t_bevel`, `t_j` or `flare_bevel` in `[joint.preparation]`, or correct the normals of the seam.
weld-groove-no-corner = faces at { $dihedral } to each other do not form a fillet or T-joint
    .cause = Preparations of an edge on a face (`fillet`, `lap`, `t_bevel`, `t_double_bevel`, `t_j`, `flare_bevel`) need faces at 170° or less to each other.
    .cure = Use a butt preparation such as `single_v`, or correct the normals of the seam.
weld-groove-no-outside-corner = faces at { $dihedral } to each other do not form an outside corner
    .cause = The preparation `corner` needs walls whose outsides meet at more than 200°, as on the rim of a box.
    .cure = Set `joint = "corner"` of the circle, ellipse or rectangle. Use `fillet` for an inside corner.
weld-groove-edge-within-part = the prepared edge, { $angle } from the other part's face, stays within its part: the dihedral angle is { $dihedral }
    .cause = The bevel is so flat that its edge never reaches the surface of its own part.
    .cure = Lower `angle_deg` (or `cut_deg`) of `t_bevel` or `t_j`. The dihedral angle is smallest at the heel of an oblique nozzle or branch.
weld-groove-edge-in-other-part = the cut leaves { $angle } to the other part's face: the edge would lie inside that part
    .cause = `cut_deg` is less than 90° minus the dihedral angle at this station.
    .cure = Raise `cut_deg` of `[joint.preparation.t_bevel]`, or give `angle_deg`, so that the groove stays constant.
weld-groove-edges-cross = the edges cross each other
    .cause = The prepared edges of the two parts intersect: the gap is too small, or the mismatch lifts one edge over the other.
    .cure = Raise `root_gap_mm`, or lower `mismatch_mm` of `[[joint.fit_up]]` at this station.
weld-groove-empty = the groove has no area
    .cause = The area between the prepared edges and the line from toe to toe is 0 or negative.
    .cure = Raise `root_gap_mm` or the groove angle. With parts that touch squarely, weld without `[joint]`.
weld-standard-of-other-joints = { $standard } gives ranges for other joints than this one
    .cause = `standard = "aws_d1_1"` compares edges that stand on a tube: details A to D of T-, Y- and K-connections.
    .cure = Use `t_bevel`, `t_double_bevel` or `t_j` in `[joint.preparation]`, or another `standard`.
weld-joint-beside-standard = { $size } is { $value } at s = { $s }: { $standard } gives { $min } to { $max } for this preparation
    .cause = The size is outside the range of `standard` in `[joint]`. The weld can be made; it needs a qualification of its own.
    .cure = Change the preparation, choose another one, or delete `standard`.
weld-joint-below-standard = { $size } is { $value } at s = { $s }: { $standard } gives { $min } or more for this joint
    .cause = The size is below the minimum of `standard` in `[joint]`.
    .cure = Change the preparation or its legs, choose another one, or delete `standard`.
weld-joint-beside-standard-at-dihedral = { $size } is { $value } at s = { $s }: { $standard } gives { $min } to { $max } where the dihedral angle is { $dihedral }
    .cause = At this dihedral angle the groove fits none of the details A to D; the ranges are those of the nearest one.
    .cure = Give `[[joint.at_dihedral]]` groove angles and root gaps that follow the dihedral angle, or change the preparation.
weld-size-thickness = the thickness
weld-size-groove-angle = the groove angle
weld-size-root-gap = the root gap
weld-size-root-face = the root face
weld-size-cover-throat = the throat of the cover fillet
weld-cure-joint-standard = change the preparation, or qualify the weld with it
weld-allowed-butt-dihedral = a dihedral angle of { $min } or more, or a fillet
weld-allowed-corner-dihedral = a dihedral angle up to { $max }, or a butt joint
weld-allowed-outside-corner = a dihedral angle between { $min } and { $max } (joint = "corner" of the seam)
weld-allowed-edge-cut = more than 90° - dihedral angle everywhere
weld-allowed-larger-gap = a larger gap, or less mismatch
weld-allowed-room-to-weld = a gap or an angle that leaves room to weld

# Beads.
weld-beads-without-joint = there is no joint to fill
    .cause = The job has `[beads]`, but no `[joint]`, so the area to fill is unknown.
    .cure = Add `[joint.preparation.KIND]`, or delete `[beads]`.
weld-allowed-joint = a [joint] with its preparation
weld-stations-with-beads = with [beads], values belong to [beads.root], [beads.fill] and [beads.cap]
    .cause = The job has `[beads]` and also `[[weld.at]]` stations.
    .cure = Move speed and process values into `[beads.root]`, `[beads.fill]` and `[beads.cap]`, and delete `[[weld.at]]`.
weld-sector-position-unclear = the position of the sector is not clear
    .cause = A row of `[[beads.sectors]]` has both `s_mm` and `phi_deg`, or neither.
    .cure = Give one of them in each row.
weld-sectors-unequal = the sectors give factors for different values
    .cause = All rows of `[[beads.sectors]]` change the same process values: those in between are linear.
    .cure = Give the same names in `factors` of every row; a factor of 1 changes nothing.
weld-sectors-at-one-place = two sectors are at s = { $s }
    .cause = Two rows of `[[beads.sectors]]` have the same position on the seam.
    .cure = Delete one of them, or move it.
weld-feed-follows-area = the wire feed follows the area of the groove
    .cause = With `adapt = "wire_feed"` the wire feed is computed at every station, so a sector cannot change it.
    .cure = Delete the factor, or use `adapt = "speed"`.
weld-allowed-s-or-phi = either s_mm or phi_deg
weld-allowed-same-factors = the names of the first row
weld-allowed-sectors-apart = positions that differ
weld-allowed-no-feed-factor = no factor for it, or another adapt
weld-allowed-no-table-or-beads = no such table, or no [beads]
weld-ramp-with-beads = a value that ramps over the weld does not go with [beads]
    .cause = A value in `weld.process` has `from` and `to`, and the job has `[beads]`.
    .cure = Give this value as a number. Edit the spans of `program.toml` after planning if it must ramp.
weld-travel-angle-twice = the travel angle is given here and at several positions of the seam
    .cause = `travel_angle_deg` of a run stands beside `[[torch.at]]` stations.
    .cure = Delete `travel_angle_deg` in `[beads]`, or delete the stations.
weld-allowed-travel-angle-once = no such key, or no [[torch.at]]
weld-area-with-wire-feed = a given area does not follow the wire feed
    .cause = With `adapt = "wire_feed"` the wire feed gives the area of the bead, but `area_mm2` fixes it.
    .cure = Delete `area_mm2` of the run and give `beads.wire_mm`, or choose another `adapt`.
weld-allowed-no-area-with-wire-feed = no such key with adapt = "wire_feed"
weld-bead-area-missing = the area of a bead is missing
    .cause = The run has no `area_mm2`, and `[beads]` has no `wire_mm` to calculate it from.
    .cure = Give `beads.wire_mm` and `wire_feed_m_min` in `weld.process`, or `area_mm2` of the run.
weld-insert-without-root = a consumable insert needs a root pass that fuses it
    .cause = The job has `[joint.insert]` and `[beads]`, but no `root` in `[beads]`.
    .cure = Add `root` with current, voltage and speed. Without `wire_feed_m_min` the insert is the only filler.
weld-allowed-insert-root = `root` in [beads], or no insert
weld-allowed-bead-area = area_mm2, or beads.wire_mm and a wire_feed_m_min
weld-bead-area-needs-steady-feed = the area of a bead needs a steady wire feed
    .cause = `wire_feed_m_min` is missing, 0, or a ramp.
    .cure = Give `wire_feed_m_min` as a number in `weld.process` or in the run's `process`, or give `area_mm2`.
weld-allowed-steady-feed = wire_feed_m_min greater than 0 in [weld.process] or here, or area_mm2
weld-deposition-too-large = the bead would have more metal than the wire
    .cause = `beads.deposition` is greater than 1.
    .cure = Give it as a part, not in percent: 0.95 for 95 %.
weld-bead-range-too-large = beads do not keep their shape over such a range
    .cause = `beads.most_percent` is greater than 80.
    .cure = Lower `most_percent`. With `adapt = "passes"` layers cover only a part of the seam.
weld-wall-tilt-too-large = the wire would lie against the wall
    .cause = `beads.wall_tilt_deg` is greater than 45.
    .cure = Lower `wall_tilt_deg`; the default is 12.
weld-step-over-needs-closed-seam = a step-over needs a seam welded all round
    .cause = With a step-over the torch goes round the seam again on the next bead. This seam has ends.
    .cure = Delete the key, or weld the whole seam: a closed seam without `end_phi_deg`.
weld-wire-implausible = no wire is { $wire } thick
    .cause = `beads.wire_mm` is the diameter of the wire: 0.6 to 1.6 mm for gas-shielded arcs, up to 6.4 mm for submerged arcs.
    .cure = Correct `wire_mm`.
weld-step-over-too-short = the step-over is so short that the torch would go across the seam
    .cause = Within `beads.step_over_mm` of seam the torch goes over to the line of the next bead, several millimetres beside.
    .cure = Lengthen `step_over_mm`; usual are 50 to 150 mm.
weld-step-over-too-long = the step-over is longer than half of the seam
    .cause = Step-overs follow one another at every turn. Longer ones would leave no bead between them.
    .cure = Shorten `beads.step_over_mm`; usual are 50 to 150 mm.
weld-step-over-with-alternate = beads joined by step-overs run in one direction
    .cause = `beads.alternate` turns every other pass around, and `beads.step_over_mm` welds the beads without a stop.
    .cure = Delete one of both keys.
weld-step-over-with-passes = layers over a part of the seam cannot be joined by step-overs
    .cause = With `beads.adapt = "passes"` some layers start and end on the seam. A step-over needs beads all round.
    .cure = Let the speed follow the area with `adapt = "speed"`, or delete `step_over_mm`.
weld-step-over-with-parts = a pass with step-overs cannot be welded in parts
    .cause = `order.parts` cuts each pass into parts, and `beads.step_over_mm` welds several beads without a stop.
    .cure = Set `parts = "whole"`, or delete `beads.step_over_mm`.
weld-allowed-no-step-over = no step-over, or a seam welded all round
weld-station-distance-invalid = invalid distance between stations
    .cause = `beads.station_mm` is outside 0.1 to 100 mm.
    .cure = Correct `station_mm`; the default is 5.
weld-no-bead-weaves = no bead weaves
    .cause = With `adapt = "weave_width"` the width of the weave follows the groove, but no run has a weave.
    .cure = Add `[weld.weave]`, or `weave` in a run, or choose another `adapt`.
weld-allowed-weave = a [weld.weave] or a `weave` of [beads.root], [beads.fill] or [beads.cap], or another value
weld-bead-spacing-invalid = beads cannot lie so far apart, or so near
    .cause = `spacing_to_width` is the distance of neighbouring beads as a part of their width: below 0.5 they pile up, above 1 they do not touch.
    .cure = Use 0.67 to 0.74; 0.7 is the default.
weld-layer-height-impossible = beads of { $area } cannot make layers of this height
    .cause = The bead would be more than a hundred times as wide as high, or the reverse, or higher or lower than the procedure allows.
    .cure = Correct `layer_mm`, or the area of the run: wire feed, speed, `wire_mm`.
weld-too-many-beads = the groove of { $groove } takes { $beads } beads of { $bead }
    .cause = The area of the groove, divided by the area of the smallest bead, is more than 5,000. A wrong unit of speed, wire feed or thickness is the usual reason.
    .cure = Check `speed_mm_s`, `wire_feed_m_min` or `area_mm2` in `[beads]`, and `thickness_mm` of the preparation.
weld-too-many-stations = the beads would be laid out at { $count ->
        [one] { $count } station
       *[other] { $count } stations
    }
    .cause = The length of the seam, divided by `beads.station_mm`, is more than 20,000.
    .cure = Raise `station_mm`.
weld-too-many-bead-positions = { $passes ->
        [one] { $passes } pass
       *[other] { $passes } passes
    } with { $rows ->
        [one] { $rows } row
       *[other] { $rows } rows
    } each are too many
    .cause = The number of beads, multiplied by the number of stations, is more than 1,000,000.
    .cure = Raise `beads.station_mm`, or use larger beads with a higher wire feed or a lower speed.
weld-allowed-larger-beads = larger beads: lower speed, or more wire; up to { $max } beads fill a groove
weld-allowed-smaller-groove = up to { $max } beads: a smaller groove, or larger beads
weld-allowed-stations = up to { $max } stations: a larger distance
weld-allowed-bead-positions = up to { $max } positions: a larger distance, or larger beads

# Order of welding: copies, parts, tacks.
weld-order-without-rows = there are no rows to go back and forth between
    .cause = The rule is `back_and_forth`, and all copies are in the same row.
    .cure = Give `row` in each `[[copies]]` table, use `[rows]` with 2 rows or more, or choose another `order.rule`.
weld-allowed-two-rows = two rows: [rows], or `row` in each of [[copies]]
weld-skip-invalid = this skips none of the copies, or all of them
    .cause = The number in `skip` is below 2, or not less than the number of copies in the longest row.
    .cure = Correct `skip` of `order.rule`, or choose `"in_turn"`.
weld-allowed-no-skip = no skip: there are too few copies in a row
weld-allowed-skip = 2 to { $max }: the longest row has { $copies ->
        [one] { $copies } copy
       *[other] { $copies } copies
    }
weld-copies-twice = the copies are given twice
    .cause = The job has `[rows]` and also `[[copies]]`.
    .cure = Delete one of the two.
weld-allowed-rows-or-copies = either [rows] or [[copies]]
weld-too-many-passes = { $passes } passes in all are too many
    .cause = Copies, tacks, beads, parts and repetitions multiply to more than 10,000 passes.
    .cure = Lower the counts in `[rows]`, `[tacks]` or `[order]`, or use larger beads.
weld-allowed-passes = up to { $max }: fewer copies or tacks, or fewer or longer parts
weld-too-many-rows = { $passes ->
        [one] { $passes } pass
       *[other] { $passes } passes
    } with { $rows } rows of beads and spans in all are too many
    .cause = The rows of beads and spans in all passes are more than 4,000,000.
    .cure = Raise `beads.station_mm`, or use fewer copies, tacks and parts.
weld-allowed-row-count = up to { $max } rows: fewer copies or tacks, fewer or longer parts, or a larger beads.station_mm
weld-copy-count-invalid = invalid number of copies
    .cause = `rows` or `columns` of `[rows]` is 0 or more than 1000.
    .cure = Correct the count.
weld-too-many-copies = too many copies
    .cause = `rows` multiplied by `columns` is more than 1000.
    .cure = Lower `columns` or `rows`, or split the job into several.
weld-allowed-columns = 1 to { $max }: { $copies } copies in all
weld-copies-coincide = copies would stand at the same position
    .cause = With several columns `step_mm` is 0, with several rows `row_step_mm` is 0, or copies of two rows meet at one position.
    .cure = Give `step_mm` and `row_step_mm` of `[rows]` different directions.
weld-allowed-row-step = a step off the line of the row, or beyond its end
weld-copy-too-far = a copy would stand too far away
    .cause = A coordinate of a copy is beyond 10,000,000 mm.
    .cure = Check `step_mm` and `row_step_mm` of `[rows]`.
weld-allowed-copies-within = copies within { $limit } of 0
weld-seam-without-corners = the seam has no corners
    .cause = The seam is smooth: its direction changes nowhere by more than about 0.1°.
    .cure = Choose another value of `order.parts`.
weld-overlap-at-corners = parts from corner to corner have no overlap
    .cause = With `parts = "at_corners"` the weld goes on past its start.
    .cure = Delete `start.overlap_mm`, or correct `start.end_phi_deg`.
weld-allowed-no-overlap-at-corners = 0 with order.parts = "at_corners"
weld-seam-without-quarters = a seam that is not welded all round has no opposite quarters
    .cause = `parts = "quadrants"` needs a closed seam without a shortened end.
    .cure = Delete `start.end_phi_deg`, or use `back_step_mm` in `order.parts`.
weld-pieces-longer-than-weld = the pieces would be longer than the weld
    .cause = `back_step_mm` is not less than the length of the weld.
    .cure = Lower `back_step_mm`, or set `parts = "whole"`.
weld-too-many-pieces = too many pieces
    .cause = The length of the weld, divided by `back_step_mm`, is more than 1000.
    .cure = Raise `back_step_mm`.
weld-allowed-piece-length = at least { $min }: up to { $count } pieces
weld-tie-in-too-long = the tie-in is not shorter than a part
    .cause = `order.tie_in_mm` is not less than a part, such as a quarter or a back step. Its default is 5 mm.
    .cure = Lower `tie_in_mm`, or use longer parts.
weld-allowed-tie-in = less than a part: { $max }
weld-all-round-has-one-end = a seam that is welded all round ends where it starts
    .cause = `either_end = true` needs a seam with two ends.
    .cure = Delete `either_end` in `[order]`.
weld-cosmetic-ramp = a cosmetic pass has steady values
    .cause = A value in `cosmetic.process` has `from` and `to`.
    .cure = Give it as a number.
weld-cosmetic-beyond-end = the cosmetic pass starts beyond the end of the weld
    .cause = `cosmetic.from_mm` leaves less than 1 mm of the weld.
    .cure = Lower `from_mm`.
weld-tack-count-or-pitch = the number of tacks follows from exactly one of two keys
    .cause = `[tacks]` has both `count` and `pitch_mm`, or neither.
    .cure = Delete or add one of the two keys.
weld-allowed-count-or-pitch = either `count` or `pitch_mm`
weld-tack-count-invalid = invalid number of tacks
    .cause = `tacks.count` is below 2 or above 1000.
    .cure = Correct `count`, or give `pitch_mm`.
weld-tack-ramp = a tack has steady values
    .cause = A value in `tacks.process` has `from` and `to`.
    .cure = Give it as a number.
weld-too-many-tacks = too many tacks
    .cause = The length of the seam, divided by `tacks.pitch_mm`, is more than 1000.
    .cure = Raise `pitch_mm`.
weld-allowed-tack-pitch = at least { $min }: up to { $count } tacks
weld-tacks-meet = the tacks would meet
    .cause = `tacks.length_mm` is not less than the distance from one tack to the next.
    .cure = Lower `length_mm` or `count`, or raise `pitch_mm`.
weld-allowed-tack-length = less than the distance from one tack to the next: { $count } on { $length } of seam
weld-tacks-near-start = tacks would start { $distance } from the weld's start
    .cause = Half of the gap between two tacks is less than `tacks.clear_mm`, so the weld would start too near to a tack.
    .cure = Lower `clear_mm` (default 5 mm), `count` or `length_mm`.
weld-allowed-tack-clearance = up to { $max }, or fewer tacks

# The part as solids.
weld-part-replaced-by-nothing = the part made from the seam is replaced, but no solids are given
    .cause = `part.replace` is true, and `[[part.solids]]` is empty.
    .cure = Add `[[part.solids]]`. To leave out the check of the part, set `part.watched = false`.
weld-allowed-part-solids = [[part.solids]] with it, or no such key
weld-allowed-rigid-placement = a rigid placement
weld-body-too-short = the body would end within the seam
    .cause = `part.body_length_mm` is not greater than the extent of the seam on the body, so the solid would end under the weld.
    .cure = Raise `body_length_mm`, or delete it to get the default.
weld-part-from-seam = the part made from the seam: { $why }
    .cause = The collision check needs solids of the part, and a size or position is invalid for one. Solids are limited to 10,000,000 mm.
    .cure = Correct `nozzle_length_mm` and `body_length_mm` of `[part]`, or replace the part by `[[part.solids]]`.
weld-allowed-part-sizes = sizes up to { $max }, also those of [part]; or [[part.solids]] with part.replace = true
weld-allowed-sphere = a sphere
