# Allowed values.
program-less-than-key = less than { $key } = { $max }
program-up-to-key = up to { $key } = { $max }
program-positive-up-to-key = more than 0, up to { $key } = { $max }
program-up-to-in-all = up to { $max } in all
program-either = either { $first } or { $second }
program-at-least-one = at least one
program-at-least-one-table = at least one { $table }
program-at-least-one-pass = a program has at least one pass
program-at-least-one-point = at least one span with at least one point
program-at-least-one-path-length = at least one path length
program-at-least-one-column = at least one column = number
program-numbers = { $numbers ->
        [one] { $numbers } number
       *[other] { $numbers } numbers
    }
program-one-for-each = one for each
program-one-for-each-of = one for each of { $columns }
program-range-in-order = { $min } to { $max }, the smaller one first
program-start-to-point = 0 (the start) to { $max }
program-after-start-to-point = after: 0 (the start) to { $max }
program-start-to-last-point = 0 (the start) to { $max } (the last point)
program-positions-within = finite numbers, positions within { $max } of the origin
program-number-or-ramp = a finite number, or { "{" } from = .., to = .. { "}" }
program-leave-out = leave them out

# Programs and passes.
program-no-passes = the program has no passes
    .cause = The program file has no `[[passes]]`, or the list is empty.
    .cure = Run `seamwright plan JOB` to make a program, or add a `[[passes]]` table.
program-pass-without-seam = the pass runs along a seam, but the program has no seam
    .cause = The pass has spans and no `[passes.points]`, and the program has no `[seam]`.
    .cure = Add the `[seam]` of the job, or give the pass points.
program-seam-or-points = [seam] in the program, or [passes.points]
program-pass-without-spans = the pass has no spans
    .cause = The pass has neither `[[passes.spans]]` nor `[passes.points]`, or the list is empty.
    .cure = Add a span from 0 to the length of the pass, with `speed_mm_s`.
program-span-gap = the span does not start where the one before it ends
    .cause = `from_mm` differs from `to_mm` of the span before, or from 0 in the first span. The tolerance is 0.000001 mm.
    .cure = Set `from_mm` to the value in the message, with all of its decimals.
program-span-empty = the span has no length
    .cause = `to_mm` of the span is not greater than `from_mm`.
    .cure = Correct `to_mm`, or delete the span and extend the one before.
program-span-other-values = the span sets other process values than the first one
    .cause = All spans of a pass name the same process values. This one lacks a value, or has another.
    .cure = Add or delete keys in `process` of the span until its names are those of the first span.
program-min-speed-not-below = the minimum speed is not below the programmed one
    .cause = `least_speed_mm_s` of the pass is not less than the speed of one of its spans, the lower end of a ramp included.
    .cure = Lower `least_speed_mm_s`, or raise `speed_mm_s` of that span.
program-below-span-speed = less than speed_mm_s = { $max } of every span
program-too-many-passes = up to this pass the program has too many passes
    .cause = Passes with their repetitions are more than 10,000.
    .cure = Lower `repeat`, or split the program into several.
program-too-many-rows = up to this pass the program has too many rows of points, beads and spans
    .cause = Points, rows of beads and spans, multiplied by repetitions, are more than 4,000,000.
    .cure = Lower `repeat`, split the program, or reduce the points before with `seamwright tools reduce`.
program-corner-choice = "refuse", "stop" or { "{" } blend_mm = 0.2 { "}" }
program-corner-outside-tolerance = the torch would leave the tolerance of the weld
    .cause = `corner.blend_mm` is greater than `tolerance.path_mm`, whose default is 0.5 mm.
    .cure = Lower `blend_mm`, or raise `tolerance.path_mm` if the weld permits it.
program-role-tack = tack
program-role-root = root
program-role-fill = fill
program-role-cap = cap
program-role-cosmetic = cosmetic

# Copies of the seam and work offsets.
program-copies-and-placement = the copies have placements of their own
    .cause = The file has `[[copies]]`, and `[placement]` moves the seam too.
    .cure = Delete `[placement]`, and give its values in `placement` of each copy.
program-no-placement = no [placement] beside [[copies]]
program-name-taken = { $other } has this name already
    .cause = Two `[[copies]]`, or two runs of the procedure, have the same `name`.
    .cure = Rename one of them, or join the two runs.
program-placement-taken = { $other } has this placement already
    .cause = Two `[[copies]]` have the same `placement`, so one would be welded over the other.
    .cure = Correct the placement of this copy, or delete it. To weld twice, use `repeat` of the pass.
program-own-placement = a placement of its own
program-no-such-copy = there is no such copy
    .cause = `copy` of the pass is not the index of a table `[[copies]]`. The first one is 0.
    .cure = Correct `copy`, or add the missing table.
program-no-copies = 0: the program has no [[copies]]
program-copy-index = 0 to { $max }, the index in [[copies]]
program-offset-name-invalid = `{ $name }` is not a valid name of a work offset
    .cause = The name has characters other than letters without accents, digits, `-` and `_`, or is empty.
    .cure = Rename the table `[offsets.NAME]`, and correct `offset`.
program-offset-names = letters, digits, - and _
program-offset-table = the name of a table in this file, here [offsets.{ $name }]

# Beads.
program-bead-empty = the bead has no rows
    .cause = `s_mm` of `[passes.bead]` is empty.
    .cure = Add one row, or delete the table to weld on the seam.
program-bead-column-length = the column has { $rows ->
        [one] { $rows } row
       *[other] { $rows } rows
    }, s_mm has { $wanted }
    .cause = A column of `[passes.bead]` has more or fewer numbers than `s_mm`.
    .cure = Give one number for each path length in `s_mm`.
program-path-lengths-increase = the path lengths must increase
    .cause = A path length in `s_mm` of `[passes.bead]` is not greater than the one before.
    .cure = Sort the rows of all columns by `s_mm`, and delete repeated ones.
program-torch-behind-face = the torch would lie behind a face
    .cause = `work_angle_deg` of `[passes.bead]` is 90° or more, either way.
    .cure = Correct the angle; it is added to the work angle in `torch`.
program-weave-part-above-one = a part above 1 makes the weave wider than that of the pass
    .cause = `weave_part` is the width of the weave as a part of `width_mm`, and this one is above 1.
    .cure = Lower it to 1 or less, or raise `width_mm` of the weave.
program-step-over-without-bead = a step-over needs a bead from which it leads
    .cause = The pass has `[[passes.step_overs]]` but no `[passes.bead]`.
    .cure = Add the first bead as `[passes.bead]`, or delete the step-overs.
program-step-over-misplaced = the step-over from { $from } to { $to } is not between the one before and the end of the pass
    .cause = Step-overs follow one another without overlap, and all of them lie within the pass.
    .cure = Move `at_mm`, or shorten `length_mm`.

# Joints.
program-root-face-too-high = the root face leaves no thickness to bevel
    .cause = `root_face_mm` is not less than `thickness_mm`.
    .cure = Correct the two keys in `[joint.preparation]`. Use `square` for an edge without a bevel.
program-groove-angle-too-large = the angle is too large for a groove
    .cause = The limit is 170° for `single_v` and `double_v`, 85° for `bevel` and `double_bevel`, and 60° for `u`, `double_u`, `j` and `t_j`.
    .cure = Correct `angle_deg`. It is the whole groove of `single_v` and `double_v`, and one face of the others.
program-radius-too-large = the radius is too large for the depth over the root face
    .cause = The arc at the root ends above the surface: it is higher than `thickness_mm` minus `root_face_mm`.
    .cure = Lower `radius_mm` below the value in the message, or raise `angle_deg`.
program-root-gap-too-wide = the root gap is wider than the wall and than the groove itself
    .cause = `root_gap_mm` exceeds the thickness of the wall (the leg of a fillet) and the width that the bevels open. A wrong unit, or a gap entered for a thickness, is the usual reason.
    .cure = Correct `root_gap_mm`, or fit the parts closer.
program-mismatch-too-large = the edges do not face each other: the mismatch is as large as the wall
    .cause = `mismatch_mm` of a measured fit-up is as large as `thickness_mm` of the preparation.
    .cure = Correct `mismatch_mm` or `thickness_mm`, or align the parts.
program-nothing-filled = the unfilled depth leaves nothing to fill
    .cause = `unfilled_mm` is not less than `radius_mm` of the round part.
    .cure = Lower `unfilled_mm`.
program-fillet-size-unclear = the size of the fillet is not clear
    .cause = A `fillet` has no size, more than one, or only one of its two legs.
    .cure = Keep one of `leg_mm` and `throat_mm`, or the pair `first_leg_mm` and `second_leg_mm`.
program-fillet-sizes = one of leg_mm, throat_mm, or both first_leg_mm and second_leg_mm
program-bevel-angle-unclear = the angle of the bevel is not clear
    .cause = `t_bevel` has both `angle_deg` and `cut_deg`, or neither.
    .cure = Keep `angle_deg` for a constant groove, or `cut_deg` for an edge that is cut at a constant angle.
program-bevel-angles = either angle_deg (of the groove) or cut_deg (of the edge)
program-positions-increase = the positions must increase
    .cause = `s_mm` of a `[[joint.fit_up]]` table is not greater than that of the table before.
    .cure = Sort the tables by `s_mm`, and delete repeated ones.
program-depth-leaves-no-back = the depth on the face leaves nothing to prepare on the back
    .cause = `depth_mm` is not less than `thickness_mm` minus `root_face_mm`.
    .cure = Lower `depth_mm`, or use a preparation of one side such as `single_v`.
program-fillet-implausible = no fillet is that large
    .cause = A leg or the throat of a fillet is more than 150 mm.
    .cure = Correct the size; it is in mm.
program-cap-implausible = no cap is that high
    .cause = `joint.cap_mm` is the height of the cap over the line from toe to toe, usually 0 to 5 mm.
    .cure = Correct `cap_mm`.
program-lap-leg-too-long = the leg is longer than the edge that it lies on
    .cause = `leg_mm` of `lap` is more than `thickness_mm` of the plate that lies on the other.
    .cure = Lower `leg_mm`.
program-gouge-on-face = only the back of a joint is gouged
    .cause = `[joint.gouge]` is given, and `side` is `face`.
    .cure = Weld the face by a job without `[joint.gouge]`, and the back by a second one with `side = "back"`.
program-side-back = side = "back"
program-back-without-groove = there is no groove on the back
    .cause = `side = "back"` needs a preparation of both sides (`double_v`, `double_bevel`, `double_u`, `t_double_bevel`), or a butt joint that is gouged.
    .cure = Give `[joint.gouge]` with its depth, or another preparation. The back of a fillet is a seam of its own.
program-groove-on-back = a preparation of both sides, or [joint.gouge] of a butt joint
program-gouge-through-wall = the gouge goes through the wall
    .cause = `depth_mm` of `[joint.gouge]` and the preparation on the back are together as deep as the wall.
    .cure = Lower `depth_mm` of `[joint.gouge]`.
program-gouge-angle-too-large = the sides of the gouge are too flat
    .cause = `angle_deg` of `[joint.gouge]` is 85° or more from the depth direction.
    .cure = Lower it: 10° to 30° are usual.
program-at-dihedral-without-edge = the groove angle does not follow the dihedral angle here
    .cause = `[[joint.at_dihedral]]` belongs to an edge on a face with a groove angle: `t_bevel` with `angle_deg`, `t_double_bevel` or `t_j`.
    .cure = Use one of them, or delete the tables. With `cut_deg` the angle follows the dihedral angle by itself.
program-edge-on-face = t_bevel with angle_deg, t_double_bevel or t_j
program-at-dihedral-unequal = the rows by dihedral angle give different quantities
    .cause = One row of `[[joint.at_dihedral]]` has `angle_deg` or `root_gap_mm`, and another has not; or a row has neither.
    .cure = Give the same keys in all rows.
program-same-keys-in-rows = angle_deg, root_gap_mm or both, the same ones in all rows
program-dihedrals-increase = the dihedral angles must increase
    .cause = `dihedral_deg` of a `[[joint.at_dihedral]]` table is not greater than that of the table before.
    .cure = Sort the tables by `dihedral_deg`, and delete repeated ones.
program-flare-root-gap = round parts that touch have no root gap
    .cause = `[[joint.fit_up]]` gives a gap, and the preparation is `flare_bevel` or `flare_v`, whose parts touch.
    .cure = Set `root_gap_mm` to 0 there. Use `unfilled_mm` for the depth that stays empty.
program-layers-increase = measurements after fewer layers must come first
    .cause = `after_layer` of a `[[joint.fit_up]]` table is less than that of the table before.
    .cure = Sort the tables by `after_layer`, then by `s_mm`.
program-fit-up-without-angle = edges of this kind have no groove angle
    .cause = `[[joint.fit_up]]` gives `angle_deg`, and the preparation has no straight bevelled edge.
    .cure = Delete `angle_deg` there.
program-allowed-bevelled-kinds = no angle_deg, or single_v, bevel, u, j, t_bevel, t_j
program-fit-up-angle-invalid = the edges have no groove of this angle
program-remaining-before-weld = before the weld the whole groove is open
    .cause = `[[joint.fit_up]]` gives `remaining_mm2` without `after_layer`.
    .cure = Give the number of complete layers in `after_layer`, or delete `remaining_mm2`.
program-allowed-after-layer = after_layer of 1 or more
program-remaining-missing = the area that was still open is missing
    .cause = A `[[joint.fit_up]]` table with `after_layer` has no `remaining_mm2`.
    .cure = Measure it (`seamwright vision scan`), or delete the table.
program-allowed-remaining = with remaining_mm2

# Process values.
program-process-name-invalid = this is not a valid name of a process value
    .cause = The name has capitals or other characters, or no `_` with a unit after it.
    .cure = Rename the value, for example `current_a`, also in `io.analog` and `set` of the machine file.
program-process-names = lower-case letters, digits and _, ending in the unit, like current_a
program-column-name-taken = another column has this name
    .cause = Traces and tables already have a column of this name, for example `s_mm`, `t_s` or `error`.
    .cure = Rename the process value, also in the machine file.
program-process-value-negative = the process value is negative
    .cause = A process value, or the end of a ramp, is below 0.
    .cure = Correct the value. Polarity belongs to the source, not to the sign.
program-process-value-too-large = `{ $name }` = { $value } is more than any welding machine has
    .cause = The value exceeds every known source of this unit: for example 3,000 A and 100 V with an arc, or 300 kV.
    .cure = Check the decimal point and the unit at the end of the name.
program-same-quantity = `{ $other }` is the same quantity in another unit: they could contradict one another
    .cause = Two names differ only in their unit, such as `wire_feed_m_min` and `wire_feed_mm_s`.
    .cure = Delete one of the two.
program-no-such-process-value = the weld has no such process value
    .cause = `upslope` or `downslope` changes a value that the weld or the first span does not set.
    .cure = Correct the name, or add the value to `process` of the weld.
program-upslope-too-long = the upslope takes longer than the time given for it
    .cause = `upslope.time_s` is greater than `travel_delay_s`, during which the torch rests with the arc on.
    .cure = Raise `travel_delay_s` in `[sequence]`, or lower `upslope.time_s`.
program-downslope-too-long = the downslope takes longer than the time given for it
    .cause = `downslope.time_s` is greater than `crater_s`, during which the torch rests at the end.
    .cure = Raise `crater_s` in `[sequence]`, or lower `downslope.time_s`.

# Weaving and oscillation.
program-weave-at-blend = corners cannot be blended where the torch weaves
    .cause = The pass has a weave, and `corner` is a blend.
    .cure = Set `corner` to `"stop"` or `"refuse"`, or weld from corner to corner with `order.parts = "at_corners"`.
program-corner-or-no-weave = "refuse" or "stop", or no weave
program-weave-pitch-unclear = the pitch of the weave is not clear
    .cause = The weave has both `pitch_mm` and `frequency_hz`, or neither.
    .cure = Keep one of the two keys.
program-only-trapezoid-dwells = only a trapezoid dwells
    .cause = `dwell_first_s` or `dwell_second_s` is above 0, and the `figure` has no dwells.
    .cure = Set `figure = "trapezoid"`, or delete the dwells.
program-no-dwell-or-trapezoid = 0, or figure = "trapezoid"
program-dwell-needs-frequency = a dwell in seconds needs a frequency
    .cause = The weave has dwells in s and a `pitch_mm`, so that the time of a period is unknown.
    .cure = Replace `pitch_mm` by `frequency_hz`: the speed divided by the pitch.
program-frequency-instead-of-pitch = frequency_hz instead of pitch_mm
program-dwells-too-long = the dwells leave no time to go across
    .cause = Both dwells together take more than 0.9 of a period.
    .cure = Shorten `dwell_first_s` and `dwell_second_s`, or lower `frequency_hz`.
program-dwells-together = up to { $max } both together
program-weave-along-torch = the weave would go along the torch
    .cause = `plane_deg` is beyond 80° either way.
    .cure = Correct `plane_deg`; 0 is square to the torch.
program-figure-without-length = this figure has no length
    .cause = `length_mm` of a weave, or `along_mm` of an oscillation, stands beside a figure that only goes across.
    .cure = Delete the length, or set `figure` to `"circle"` or `"eight"`.
program-figures-with-length = no such key, or figure = "circle" or "eight"
program-sides-not-steady = the sides take steady values, not ramps
    .cause = A value in `at_sides` has `from` and `to`.
    .cure = Give it as a number.
program-weave-period-short = a period of the weave would take only { $pitch } of the seam
    .cause = A period is shorter than 0.1 mm along the seam: `pitch_mm`, or the slowest speed divided by `frequency_hz`.
    .cure = Lower `frequency_hz`, or raise `pitch_mm`.
program-frequency-at-speed = up to { $max } at { $speed }
program-weave-periods = the weave would have { $periods } periods in one pass
    .cause = The pass is so long that the weave has more than 200,000 periods.
    .cure = Lower `frequency_hz`, raise `pitch_mm`, or divide the pass.
program-up-to-periods = up to { $max } periods
program-weave-speed-jumps = the speed jumps at the start of the span, and with it a weave given by its frequency
    .cause = With `frequency_hz` the pitch follows the speed, and here the speed of one span does not continue that of the next.
    .cure = Join the speeds by a ramp with `from` and `to`, or give the weave by `pitch_mm`.
program-span-speed-or-pitch = a span that starts with { $speed }, or a weave with pitch_mm
program-oscillation-gaps = the beam advances by { $advance } in a period of its oscillation, more than its spot of { $spot }: it leaves gaps
    .cause = The fastest speed of the pass, divided by `frequency_hz`, is greater than `spot_mm`.
    .cure = Raise `frequency_hz` of the oscillation up to the limit of the coils, or lower the speed. Check `spot_mm` on the work.
program-cure-oscillation-gaps = set frequency_hz to { $frequency } or more, or weld slower

# Passes through points.
program-pass-without-points = the pass has no points
    .cause = `[passes.points]` has no point in its spans; `start` alone is no way.
    .cure = Add a span with at least one point.
program-span-without-points = the span has no points
    .cause = `points` of a span is empty.
    .cure = Add a point, or delete the span.
program-value-out-of-bounds = { $column } = { $value } is out of bounds
    .cause = The value exceeds the bound of the unit at the end of the column's name: for example 1,000,000 mm or 3,600 s.
    .cure = Correct the number. Bounds of all units are in the reference of the job file.
program-value-not-allowed = { $column } = { $value } is not allowed here
    .cause = Times and speeds are 0 in `start` and rapids and positive elsewhere. Process values are not negative, and directions are not 0.
    .cure = Correct the number in this row, or the order of its columns.
program-column-twice = the column `{ $column }` is there twice
    .cause = A name occurs twice in `columns`.
    .cure = Rename or delete one of them, with its numbers in all points.
program-each-column-once = each column once
program-last-column = the last column, and no other one, gives the time or speed of a point
    .cause = `time_s` and `speed_mm_s` are both in `columns`, or both are missing, or another column follows.
    .cure = Move the column to the end, with its numbers in all points, and keep one of the two.
program-time-or-speed-last = time_s or speed_mm_s last
program-columns-without-position = the columns give no position, or two
    .cause = The columns are neither three or six of a pose nor names of axes, or both are there.
    .cure = Give `x_mm`, `y_mm`, `z_mm`, perhaps with `ax`, `ay`, `az`, or axes of the machine.
program-position-columns = x_mm, y_mm, z_mm, with ax, ay, az or without; or names of the machine's axes
program-arc-in-span = an arc needs `via_mm`, and has one point
    .cause = `along = "arc"` stands at a span without `via_mm`, or with several points.
    .cure = Add `via_mm`, a point on the arc. Give each arc a span of its own.
program-one-arc-per-span = one arc per span, with `via_mm` halfway
program-arc-of-axes = axis positions can follow an arc only if they include two of x, y and z
    .cause = The columns are axes, and fewer than two of them are x, y and z.
    .cure = Set `along` to `"line"` or another way.
program-only-arcs = only arcs have this key
    .cause = `via_mm` or `normal` stands at a span that is not an arc.
    .cure = Delete the key, or set `along = "arc"`.
program-arc-or-leave-out = `along = "arc"`, or leave it out
program-speed-rows = { $rows ->
        [one] { $rows } row of speeds
       *[other] { $rows } rows of speeds
    }
    .cause = A span with `along = "cubic"` needs a row of `speeds` for its start and for each point. Other spans have none.
    .cure = Add or delete rows. From a valid `line`, `seamwright edit FILE interpolate --along cubic` calculates them.
program-cubic-speeds = for a cubic one more than points, the first at its start; otherwise none
program-cubic-needs-times = a cubic needs times
    .cause = The way is `cubic`, and the last column is `speed_mm_s`.
    .cure = Give the points times in a last column `time_s`, or choose another way.
program-time-last = the last column `time_s`
program-speeds-for-columns = { $speeds ->
        [one] { $speeds } speed
       *[other] { $speeds } speeds
    } for { $columns } columns of the position
    .cause = A row of `speeds` has not one number for each column of the position.
    .cure = Add or delete numbers. Process values, `n` and the last column have no speeds.
program-numbers-for-columns = { $numbers ->
        [one] { $numbers } number
       *[other] { $numbers } numbers
    } for { $columns } columns
    .cause = A point has more or fewer numbers than `columns` has names.
    .cure = Add or delete numbers in this row.
program-pace-zero = 0: it is the start, or as fast as the axes can
program-block-number = a whole number, 0 (none) or greater
program-direction-columns = a direction: ax, ay, az not all 0
program-key-of-seam-passes = the pass goes through points: only passes along a seam have this key
    .cause = A pass with `[passes.points]` also has `spans`, `begin_mm`, `reverse`, `least_speed_mm_s`, `torch`, `bead`, `weave` or `oscillation`.
    .cure = Delete this key, or delete `[passes.points]`.
program-leave-out-key-or-points = leave it out, or leave out `points`
program-event-after-end = the pass has fewer points
    .cause = `after` of an event is greater than the number of points in the pass.
    .cure = Lower `after`; the number of the last point means the end of the pass.
program-event-several = an event does exactly one thing
    .cause = An event has none or several of `gas`, `wire`, `output`, `message` and `call`, or `output` and `on` are not both there.
    .cure = Write one event for each action, and `on` with each `output`.
program-event-keys = one of gas, wire, output (with on), message, call

# Procedures.
program-procedure-without-runs = the procedure has no runs
    .cause = The procedure file has no `[[runs]]`, or the list is empty.
    .cure = Add a run with its `name` or `passes` and its ranges.
program-run-without-passes = the run names no passes
    .cause = The run has neither `name` nor `passes`.
    .cure = Add `name`, such as `"root"`, or `passes`, such as `"2-5"`.
program-run-passes-twice = the run names its passes twice
    .cause = The run has both `name` and `passes`.
    .cure = Delete one of the two keys.
program-run-names = either name = "tack", "root", "fill" or "cap", or passes = "1", "2-5" and so on
program-run-without-position = the run allows no welding position
    .cause = `positions` is an empty list.
    .cure = List the qualified positions, such as `["PA", "PC"]`, or delete the key.
program-run-positions = one or more; without the key all are allowed
program-toe-angle-too-large = a weld cannot be flatter than flush with its part
    .cause = `min_toe_angle_deg` is more than 180. The angle lies between the surface of the part and the face of the weld, through the air.
    .cure = Give 90 to 150, or delete the key to take the limit of `quality_level`.
program-insert-without-root-faces = this joint takes no consumable insert
    .cause = An insert lies between the root faces of a butt joint that is welded from its face. Corner joints, flare joints, edges on a face, the back and joints with a backing have no such root.
    .cure = Delete `[joint.insert]`, or describe a butt joint without `[joint.backing]`.
program-allowed-insert = an insert in a butt joint with side = "face" and no backing
program-insert-area-missing = the area of the insert is missing
    .cause = The section of a T, J or Y is not the product of `width_mm` and `height_mm`.
    .cure = Give `area_mm2` from the maker's data sheet, or weigh a piece: mass divided by length and density.
program-allowed-insert-area = area_mm2, or kind = "ring" or "rectangular"
program-insert-too-high = the insert would be as high as the wall
    .cause = `height_mm` of `[joint.insert]` is not less than `thickness_mm` of the preparation.
    .cure = Correct `height_mm`: usual inserts are 1.6 to 5 mm high.
program-insert-gap = an insert { $width } wide does not fit in a root gap of { $gap }
    .cause = The root faces are nearer than the insert is wide, or the insert lies so loose that it does not fuse to both of them.
    .cure = Give the gap with the insert in place, or choose an insert of another width. Joints that were fitted up too wide are tacked again.
program-not-a-process-value = this is not a process value
    .cause = `[runs.ranges]` contains a key that has its place in the run itself, such as `speed_mm_s` or `heat_input_kj_mm`.
    .cure = Move the key out of `[runs.ranges]` into `[[runs]]`.
program-beside-ranges = { $key } beside `ranges`
program-ranges-in-table = put ranges of process values into [runs.ranges]
program-part-above-one = this part of the whole is above 1
    .cause = `thermal_efficiency` or `deposition_efficiency` is greater than 1.
    .cure = Give it as a part, not in percent: 0.8 for 80 %.
program-carbon-invalid = { $found } of carbon is not a steel
    .cause = The composition has no carbon or more than 2.1 %, as with a mistaken decimal point.
    .cure = Give the carbon of the material certificate in % of mass, like `C = 0.18`.
program-composition-sum = the elements add up to { $sum }
    .cause = The elements of a composition exceed 100 %.
    .cure = Give every element in % of mass; iron is the rest.
program-material-group-invalid = { $group } is not a group of materials
    .cause = `group` is not a main group of ISO/TR 15608 with or without a subgroup.
    .cure = Take the group from the WPS or the material certificate.
program-material-groups = a group of ISO/TR 15608: 1 to 11, 21 to 26, 31 to 38, 41 to 48, 51 to 54, 61, 62, 71 to 76, perhaps with a subgroup, like "1.2"
program-material-unknown = the material has neither composition nor group
    .cause = A material needs `composition` or `group`.
    .cure = Copy the composition of the material certificate, or the group of the WPS.
program-composition-or-group = `composition` or `group`
program-interpass-one-of = a wait needs a time or a temperature, not both
    .cause = `[interpass]` has neither or both of `wait_s` and `below_c`.
    .cure = Give `wait_s` for a fixed time, or `below_c` to wait until the weld has cooled.
program-interpass-wait-or-below = `wait_s` or `below_c`
program-interpass-below-work = the work never cools to { $found }
    .cause = `below_c` is not above `work_c`, the temperature of the work far from the weld.
    .cure = Give the maximum interpass temperature of the WPS.
program-heat-flow-2d = two-dimensional
program-heat-flow-3d = three-dimensional
program-one-run-per-name = one run per name
program-pass-in-two-runs = pass { $pass } is named by { $other } already
    .cause = `passes` of two runs contain the same number.
    .cure = Correct the numbers in one of the two.
program-named-pass-in-two-runs = pass { $pass } ({ $name }) is in { $other } already
    .cause = One run selects the pass by its role or the start of its name, another by its number.
    .cure = Delete the number in `passes`, or rename the pass or its role.
program-pass-in-one-run = each pass in one run
program-no-pass-numbers = `{ $text }` names no passes
    .cause = A part of `passes` is not a whole number from 1, or a range with the smaller number first.
    .cure = Write numbers and ranges separated by commas, such as `"1, 3-4"`.
program-pass-named-twice = pass { $pass } is named twice
    .cause = Two parts of `passes` overlap.
    .cure = Delete the number in one of them.
program-pass-numbers = numbers from 1 like "1", "2-5" or "1, 3-4", each once
program-limits-increase = the limits must increase
    .cause = A limit in `position_limits` is not greater than the one before it, or reaches 180° (rotation) or 90° (slope).
    .cure = Sort the limits; the defaults are in the reference of the procedure file.
program-hysteresis-too-large = no slope exceeds vertical_slope_deg by that much
    .cause = `hysteresis_deg` is not less than 90° minus `vertical_slope_deg`.
    .cure = Lower `hysteresis_deg`; the default is 4.
program-no-power = the product of these values is not a power
    .cause = `power` is neither one value in W or kW nor one current and one voltage.
    .cure = Correct the names in `power`, or delete the key to get those of the process.
program-power-values = ["current_a", "voltage_v"], ["laser_w"]: one in W or kW, or a current in A, mA or kA and a voltage in V or kV
program-window-order = the minimum, { $min }, is above the maximum, { $max }
    .cause = The first number of a range is greater than the second.
    .cure = Exchange the two numbers.
program-window-negative = this range begins below 0
    .cause = Speeds, sizes of beads, stick-outs and heat inputs are never negative.
    .cure = Correct the first number of the range.
program-window = [minimum, maximum]
program-processes = { $processes }
program-process = { $number } ({ $name })

# Jumps of the torch.
program-torch-direction-jumps = the torch's direction would jump by { $jump } at the corner at s = { $s }
    .cause = The bisector of the faces turns suddenly at a sharp corner, and a torch with the arc on takes time to follow. `corner` does not help here.
    .cure = Set `order.parts = "at_corners"` in the job, or round the corner, for example by `corner_mm` of a rectangle.
program-torch-tip-jumps = the torch's tip would jump by { $jump } at the corner at s = { $s }
    .cause = The bead lies beside the seam, so its line is interrupted at a sharp corner of the seam. `corner` does not help here.
    .cure = Set `order.parts = "at_corners"` in the job, or round the corner in `[seam]`.
program-cure-direction-jumps = end one pass there and start another after it (in a job order.parts = "at_corners", tacks elsewhere); or round the corner in the seam; in a butt joint weld without work and travel angle
program-cure-tip-jumps = end one pass there and start another after it (in a job order.parts = "at_corners", tacks elsewhere), or round the corner in the seam

# Variables and expressions.
program-expression = "= expression"
program-expression-lines = an expression stays on its line
    .cause = A text that starts with `=` goes over several lines.
    .cure = Write the expression in one line, or calculate a part of it as a variable by hand.
program-expression-grammar = numbers, names of variables, + - * / and parentheses
program-expression-rest = `{ $text }` is not understood
    .cause = Something follows after a complete expression: an operator is missing, or a function or power is used.
    .cure = Use only `+`, `-`, `*`, `/` and parentheses.
program-expression-ends = the expression ends where a number or a name should come
    .cause = The expression is empty, or an operator or an opening parenthesis is its last character.
    .cure = Complete or delete the operator.
program-unexpected-character = `{ $text }` stands where a number or a name should come
    .cause = A character stands where a number, a name or a parenthesis should start, for example `^`, `%` or a second operator.
    .cure = Correct the character. Write powers as products.
program-number-invalid = `{ $text }` is not a number
    .cause = A number has no digits, or two decimal points.
    .cure = Correct the number; decimals follow a point.
program-nesting-too-deep = too many parentheses or signs within each other
    .cause = The expression has more than 64 parentheses and signs within each other.
    .cure = Simplify the expression.
program-parenthesis-missing = a closing parenthesis is missing
    .cause = The expression has more opening than closing parentheses.
    .cure = Add `)`, or delete a parenthesis.
program-result-not-finite = the result is not finite
    .cause = The expression divides by 0, or its result is too large.
    .cure = Correct the variables in `[variables]`, or the expression.
program-finite-result = no division by 0, no number beyond 1e308
program-not-a-number = this is not a number
    .cause = A variable is a text, a list, infinite, or an expression itself.
    .cure = Give it a number. Expressions belong to the keys that use the variable.
program-variables-no-table = the variables are not a table
    .cause = `variables` has a value instead of being a table.
    .cure = Write `[variables]` and below it one line `name = number` for each variable.
program-variables-table = [variables] with name = number
program-variable-name-invalid = `{ $name }` is not a valid name of a variable
    .cause = The name starts with a digit, or has characters other than letters without accents, digits and `_`.
    .cure = Rename the variable, also where expressions use it.
program-variable-names = a letter or _, then letters, digits and _
program-no-variables = no variables are given: [variables] with name = number
    .cause = An expression uses a name, and the program has no `[variables]`.
    .cure = Add `[variables]` with this name, or write the number.

# Refused edits.
program-edit-refused = the edit is refused: the document stays as it was; the line is that of the result
    .cause = After the edit the text would not be a valid program; the error above gives the reason. Nothing is written.
    .cure = Change the operation, or make several changes at once with `--script`.
program-help-and-help =
    { $first }
    { "   " }{ $second }
program-edit-layout = the edit cannot be written into the layout of this document
    .cause = The text that would be written gives another program than the edit. An unusual layout of the file is the reason.
    .cure = Run `seamwright edit FILE format`, then repeat the edit.
program-usual-layout = the layout that the operation `format` makes
program-history-of-other-text = the document was changed since the edit and no longer contains its result
    .cause = The text that the edit wrote is no longer in the file, or not exactly once. The file was changed by hand or by another program.
    .cure = Restore the file from a copy, or correct it by hand. The next edit starts a new history.
program-text-of-last-edit = the document as the last edit left it
program-history-line = line { $line }: { $fault }
    .cause = A line of `FILE.edits` is damaged or of another version.
    .cure = Move `FILE.edits` away: the program stays as it is, and the next edit starts a new history.
program-history-empty = the history is empty
    .cause = `FILE.edits` exists and has no line.
    .cure = Move `FILE.edits` away; the next edit starts a new history.
program-history-head = the head of the history does not fit its edits
    .cause = The first line of `FILE.edits` names another version, or more edits than the file contains. The file may be cut off.
    .cure = Move `FILE.edits` away; the next edit starts a new history.
program-history-format = a history as `seamwright edit` writes it, one JSON object a line
program-number-not-finite = a number is not finite or too large
    .cause = The edit gives a number that is infinite, not a number, or beyond 10,000,000 mm.
    .cure = Lower the distance, factor or value of the operation.
program-no-pass = there is no pass { $pass }
    .cause = `--pass` is 0, or greater than the number of passes.
    .cure = Count passes from 1, in the order of the program file.
program-pass-along-seam = pass { $pass } runs along the seam
    .cause = The operation is for points, and this pass has spans along the seam.
    .cure = Choose a pass with `[passes.points]`, or the options for the seam, such as `--s-mm` instead of `--points`.
program-pass-has-points = pass { $pass } goes through points
    .cause = The operation or option is for passes along the seam, and this pass has `[passes.points]`.
    .cure = Use the options for points: `--points`, `--point`, `--dx-mm`, `--dy-mm` or `--dz-mm`.
program-pass-through-points = a pass through points
program-no-points = there are no points { $from } to { $to } for this edit
    .cause = The range of points is not in order, or ends beyond the last point.
    .cure = Correct the numbers; point 0 is the start, point 1 the first one reached.
program-nothing-to-set = nothing is given to set
    .cause = `set-pass` has none of its options.
    .cure = Add `--name`, `--role`, `--arc` or `--repeat`.
program-no-order-position = there is no position { $at } in the order
    .cause = The new position of the pass is 0 or beyond the end of the order.
    .cure = Correct `--at` or `--to`; positions count from 1.
program-only-pass = it is the only pass
    .cause = `delete-pass` would leave a program without passes.
    .cure = Add the new pass first, then delete this one.
program-no-event = there is no event { $event }
    .cause = `--event` is 0, or greater than the number of events of the pass.
    .cure = Count events from 1, in the order of `events`.
program-pass-with-events = a pass with events
program-mirror-unclear = the plane or axis to mirror about is missing, or both are given
    .cause = `mirror` has neither `--normal` nor `--axis`, or options of both kinds.
    .cure = Give `--normal` with `--at-mm` for poses, or `--axis` with `--about` for axis positions.
program-mirror-keys = `normal` with `at_mm` for poses, `axis` with `about` for axis positions
program-points-are-axes = the points of pass { $pass } are axis positions
    .cause = The pass has columns of axes, and `--normal` mirrors poses.
    .cure = Use `--axis` and `--about`.
program-points-are-poses = the points of pass { $pass } are poses
    .cause = The pass has columns of poses, and `--axis` mirrors axis positions.
    .cure = Use `--normal` and `--at-mm`.
program-no-points-pass = no pass goes through points
    .cause = All passes of the program run along the seam.
    .cure = Use an operation for the seam. Import or teach a pass with `[passes.points]` first if points are meant.
program-with-points = a program with [passes.points]
program-offset-of-axes = the points are axis positions: only the machine knows the torch's frame
    .cause = `offset` moves points in the torch frame, and the columns of this pass are axes.
    .cure = Change the axis columns with `seamwright edit FILE set-point`.
program-points-with-poses = points that are poses
program-no-torch-frame = at point { $point } the torch lies along the path, or the path has no direction
    .cause = At this point the path does not move, or moves along the torch, so the direction across both is undefined.
    .cure = Leave this point out with `--points FROM,TO`, or change it with `set-point`.
program-torch-across-path = a torch across the path
program-no-point = there is no point { $point }
    .cause = The number of the point is greater than that of the last point.
    .cure = Correct the number; point 0 is the start.
program-no-number-given = no number is given
    .cause = `set-point` has neither `--set` nor `--speeds`.
    .cure = Add `--set NAME=V` with a name of `columns`.
program-column-without-speed = `{ $column }` is not a column of the position and has no speed
    .cause = `--speeds` names a process value, `n`, `time_s`, or a column that does not exist.
    .cure = Name a column of the position: of the pose, or of an axis.
program-no-cubic-at-point = no cubic ends or starts at point { $point }
    .cause = `--speeds` is given at a point that is not on a span with `along = "cubic"`.
    .cure = Choose another point, or make the span cubic with `seamwright edit FILE interpolate --along cubic`.
program-point-of-cubic = a point of a span that is `cubic`
program-no-next-point = there is no next point for a position halfway
    .cause = `insert-point` without `--numbers` is used after the last point.
    .cure = Give `--numbers`, or a smaller `--after`.
program-no-point-left = no point would be left
    .cause = `delete-points` would delete all points of the pass.
    .cure = Keep one point, or use `delete-pass`.
program-keep-a-point = keep at least one point, or delete the pass
program-points-without-xyz = the points have no x, y and z for lines and arcs
    .cause = `reduce` needs positions in space, and the columns lack one of x, y and z.
    .cure = Reduce the points before they are converted to axes, with `seamwright tools reduce`.
program-poses-or-xyz = poses, or positions of axes x, y and z
program-no-span = there is no span { $span } for this edit
    .cause = `--span` is 0 or beyond the last span. `join-spans` needs a span after it.
    .cure = Correct `--span`; spans count from 1.
program-pass-of-more-spans = a pass with more spans
program-rapid-with-arc = the arc is on in this pass: a rapid move does not weld
    .cause = The pass has the arc on, and rapid moves do not keep a welding speed.
    .cure = Choose another way, or set `--arc false` with `set-pass` if the pass does not weld.
program-ways-or-no-arc = line, arc, spline; or a pass with `arc = false`
program-pass-with-times = a pass whose last column is `time_s`
program-arc-of-points = an arc needs `via_mm` and one point; the span has { $points }
    .cause = `--along arc` is used without `--via-mm`, or on a span with several points.
    .cure = Divide the span with `split-span`, then give `--via-mm`.
program-split-first = split the span first; give `via_mm`
program-via-of-arcs = `via_mm` and `normal` belong to arcs, not to `{ $along }`
    .cause = `--via-mm` or `--normal` is given with another way than an arc.
    .cure = Leave the option out, or use `--along arc`.
program-rapid-without-pace = points reached by rapid have no time or speed
    .cause = Points that were reached by rapid have time or speed 0, and the new way needs one.
    .cure = Add `--pace`, in the unit of the last column.
program-pace = `pace`: time or speed to each point
program-pace-given = the points have a time or speed already
    .cause = `--pace` is given, and the points keep their times or speeds, or become rapid.
    .cure = Leave `--pace` out. Use `set-point` or `scale-speed` to change times.
program-no-pace = no `pace`
program-no-split-at-point = no span can be split at point { $point }
    .cause = The point is the start, the last point of its span, or does not exist.
    .cure = Choose a point within a span.
program-point-within-span = a point within a span, not its last one
program-no-split-at-length = no span can be split at { $s }
    .cause = The path length is at an end of a span, or outside the pass.
    .cure = Choose a path length within a span, counted from the start of the pass.
program-length-within-span = a path length within a span, not its end
program-split-unclear = the position of the split is missing, or does not fit the pass
    .cause = `split-span` has no position, or `--point` at a pass along the seam, or `--s-mm` at a pass through points.
    .cure = Use `--point` for passes through points and `--s-mm` for passes along the seam.
program-split-keys = `point` through points, `s_mm` along the seam
program-spans-not-joined = spans { $first } and { $second } do not continue each other
    .cause = The spans differ in their way or `stops`, are arcs, or their speeds or values do not continue each other.
    .cure = Make them equal first, with `interpolate`, `set-process` or `scale-speed`.
program-spans-that-join = the same way (no arcs) and stops, cubics with the same speeds; along the seam the same values, or ramps that continue
program-points-without-seam = the pass goes through points: it has no seam
    .cause = `reverse-pass` has `--seam-length-mm` for a pass through points.
    .cure = Leave the option out.
program-no-seam-length = no `seam_length_mm`
program-pass-over-start = the pass runs over the seam's start
    .cause = A reversed pass on a closed seam is longer than its `begin_mm`, so it runs over the start of the seam.
    .cure = Add `--seam-length-mm`. `seamwright tools seam FILE` prints the path lengths.
program-seam-length = `seam_length_mm`: the seam is welded all round
program-start-point = `point`, at which closed points are to start
program-start-without-seam = the program has no seam on which to start
    .cause = `shift-start --phi-deg` is used in a program without `[seam]`.
    .cure = Use `--pass` and `--point`.
program-start-unclear = the new start is missing, or given twice
    .cause = `shift-start` needs exactly one of `--point`, `--begin-mm` and `--phi-deg`, the first two with `--pass`.
    .cure = Correct the options.
program-start-keys = `pass` with `point`, or `pass` with `begin_mm`, or `phi_deg` alone
program-points-not-closed = the points do not end where they start
    .cause = `shift-start --point` needs a closed run, and a column of the position differs between start and last point.
    .cure = Add a last point equal to the start, or reverse or split the pass instead.
program-closed-points = closed points: the last point is the start
program-no-range = the pass has no range from { $from } to { $to }
    .cause = The range is empty, not in order, or ends beyond the pass.
    .cure = Correct `--s-mm FROM,TO`, counted in mm from the start of the pass.
program-range-of-points = `points`, and no `s_mm`
program-range-of-seam = `s_mm`, and no `points`
program-range-without-pass = a range needs its pass
    .cause = `scale-speed` has `--points` or `--s-mm`, and no `--pass`.
    .cure = Add `--pass`, or leave the range out to change all passes.
program-pass-with-range = `pass` with `points` or `s_mm`
program-speed-not-positive = a speed would not be a finite number above 0
    .cause = A speed multiplied by `--factor` is 0 or infinite.
    .cure = Choose a factor nearer to 1.
program-other-factor = another factor

# Edits that were made.
program-edit-formatted = formatted
program-edit-offset = work offset in force: `{ $name }`
program-edit-no-offset = no work offset in force
program-edit-variable = variable { $name } = { $value }
program-edit-variable-removed = variable { $name } removed
program-edit-pass = pass { $pass }: { $changes }
program-edit-pass-name = name `{ $name }`
program-edit-pass-role = role { $role }
program-edit-arc-on = arc on
program-edit-arc-off = arc off
program-edit-repeat = welded { $times ->
        [one] once
       *[other] { $times } times
    }
program-edit-pass-added = pass `{ $name }` added
program-edit-pass-deleted = pass { $pass } `{ $name }` deleted
program-edit-pass-moved = pass { $pass } moved to { $to }
program-edit-pass-copied = pass { $pass } copied
program-edit-event-added = pass { $pass }: event added after point { $point }
program-edit-event-deleted = pass { $pass }: event { $event } deleted
program-edit-mirrored = mirrored
program-edit-moved = pass { $pass } moved
program-edit-point = pass { $pass }, point { $point }: set { $columns }
program-edit-speed-of = speed of { $column }
program-edit-point-inserted = pass { $pass }: point inserted after { $after }
program-edit-points-deleted = pass { $pass }: points { $from } to { $to } deleted
program-edit-reduced = pass { $pass }: { $before ->
        [one] { $before } point
       *[other] { $before } points
    } reduced to { $after }
program-edit-along = pass { $pass }, span { $span }: { $along }
program-edit-span-split = pass { $pass }: span { $span } split
program-edit-spans-joined = pass { $pass }: spans { $first } and { $second } joined
program-edit-reversed = pass { $pass } reversed
program-edit-pass-start = pass { $pass } starts at { $s }
program-edit-pass-start-point = pass { $pass } starts at point { $point }
program-edit-weld-start = the weld starts at { $phi }
program-edit-speed = speed times { $factor }
program-edit-process = pass { $pass }: { $name } set
program-edit-numbered = points numbered
