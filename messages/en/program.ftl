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
program-pass-without-seam = the pass runs along a seam, but the program has no seam
program-seam-or-points = [seam] in the program, or [passes.points]
program-pass-without-spans = the pass has no spans
program-span-gap = the span does not start where the one before it ends
program-span-empty = the span has no length
program-span-other-values = the span sets other process values than the first one
program-min-speed-not-below = the minimum speed is not below the programmed one
program-below-span-speed = less than speed_mm_s = { $max } of every span
program-too-many-passes = up to this pass the program has too many passes
program-too-many-rows = up to this pass the program has too many rows of points, beads and spans
program-corner-choice = "refuse", "stop" or { "{" } blend_mm = 0.2 { "}" }
program-corner-outside-tolerance = the torch would leave the tolerance of the weld
program-role-tack = tack
program-role-root = root
program-role-fill = fill
program-role-cap = cap
program-role-cosmetic = cosmetic

# Copies of the seam and work offsets.
program-copies-and-placement = the copies have placements of their own
program-no-placement = no [placement] beside [[copies]]
program-name-taken = { $other } has this name already
program-placement-taken = { $other } has this placement already
program-own-placement = a placement of its own
program-no-such-copy = there is no such copy
program-no-copies = 0: the program has no [[copies]]
program-copy-index = 0 to { $max }, the index in [[copies]]
program-offset-name-invalid = `{ $name }` is not a valid name of a work offset
program-offset-names = letters, digits, - and _
program-offset-table = the name of a table in this file, here [offsets.{ $name }]

# Beads.
program-bead-empty = the bead has no rows
program-bead-column-length = the column has { $rows ->
        [one] { $rows } row
       *[other] { $rows } rows
    }, s_mm has { $wanted }
program-path-lengths-increase = the path lengths must increase
program-torch-behind-face = the torch would lie behind a face
program-weave-part-above-one = a part above 1 makes the weave wider than that of the pass

# Joints.
program-root-face-too-high = the root face leaves no thickness to bevel
program-groove-angle-too-large = the angle is too large for a groove
program-radius-too-large = the radius is too large for the depth over the root face
program-nothing-filled = the unfilled depth leaves nothing to fill
program-fillet-size-unclear = the size of the fillet is not clear
program-fillet-sizes = one of leg_mm, throat_mm, or both first_leg_mm and second_leg_mm
program-bevel-angle-unclear = the angle of the bevel is not clear
program-bevel-angles = either angle_deg (of the groove) or cut_deg (of the edge)
program-positions-increase = the positions must increase
program-flare-root-gap = round parts that touch have no root gap

# Process values.
program-process-name-invalid = this is not a valid name of a process value
program-process-names = lower-case letters, digits and _, ending in the unit, like current_a
program-column-name-taken = another column has this name
program-process-value-negative = the process value is negative
program-process-value-too-large = `{ $name }` = { $value } is more than any welding machine has
program-same-quantity = `{ $other }` is the same quantity in another unit: they could contradict one another
program-no-such-process-value = the weld has no such process value
program-upslope-too-long = the upslope takes longer than the time given for it
program-downslope-too-long = the downslope takes longer than the time given for it

# Weaving and oscillation.
program-weave-at-blend = corners cannot be blended where the torch weaves
program-corner-or-no-weave = "refuse" or "stop", or no weave
program-weave-pitch-unclear = the pitch of the weave is not clear
program-only-trapezoid-dwells = only a trapezoid dwells
program-no-dwell-or-trapezoid = 0, or figure = "trapezoid"
program-dwell-needs-frequency = a dwell in seconds needs a frequency
program-frequency-instead-of-pitch = frequency_hz instead of pitch_mm
program-dwells-too-long = the dwells leave no time to go across
program-dwells-together = up to { $max } both together
program-weave-along-torch = the weave would go along the torch
program-figure-without-length = this figure has no length
program-figures-with-length = no such key, or figure = "circle" or "eight"
program-sides-not-steady = the sides take steady values, not ramps
program-weave-period-short = a period of the weave would take only { $pitch } of the seam
program-frequency-at-speed = up to { $max } at { $speed }
program-weave-periods = the weave would have { $periods } periods in one pass
program-up-to-periods = up to { $max } periods
program-weave-speed-jumps = the speed jumps at the start of the span, and with it a weave given by its frequency
program-span-speed-or-pitch = a span that starts with { $speed }, or a weave with pitch_mm
program-oscillation-gaps = the beam advances by { $advance } in a period of its oscillation, more than its spot of { $spot }: it leaves gaps
program-cure-oscillation-gaps = set frequency_hz to { $frequency } or more, or weld slower

# Passes through points.
program-pass-without-points = the pass has no points
program-span-without-points = the span has no points
program-value-out-of-bounds = { $column } = { $value } is out of bounds
program-value-not-allowed = { $column } = { $value } is not allowed here
program-column-twice = the column `{ $column }` is there twice
program-each-column-once = each column once
program-last-column = the last column, and no other one, gives the time or speed of a point
program-time-or-speed-last = time_s or speed_mm_s last
program-columns-without-position = the columns give no position, or two
program-position-columns = x_mm, y_mm, z_mm, with ax, ay, az or without; or names of the machine's axes
program-arc-in-span = an arc needs `via_mm`, and has one point
program-one-arc-per-span = one arc per span, with `via_mm` halfway
program-arc-of-axes = axis positions can follow an arc only if they include two of x, y and z
program-only-arcs = only arcs have this key
program-arc-or-leave-out = `along = "arc"`, or leave it out
program-speed-rows = { $rows ->
        [one] { $rows } row of speeds
       *[other] { $rows } rows of speeds
    }
program-cubic-speeds = for a cubic one more than points, the first at its start; otherwise none
program-cubic-needs-times = a cubic needs times
program-time-last = the last column `time_s`
program-speeds-for-columns = { $speeds ->
        [one] { $speeds } speed
       *[other] { $speeds } speeds
    } for { $columns } columns of the position
program-numbers-for-columns = { $numbers ->
        [one] { $numbers } number
       *[other] { $numbers } numbers
    } for { $columns } columns
program-pace-zero = 0: it is the start, or as fast as the axes can
program-block-number = a whole number, 0 (none) or greater
program-direction-columns = a direction: ax, ay, az not all 0
program-key-of-seam-passes = the pass goes through points: only passes along a seam have this key
program-leave-out-key-or-points = leave it out, or leave out `points`
program-event-after-end = the pass has fewer points
program-event-several = an event does exactly one thing
program-event-keys = one of gas, wire, output (with on), message, call

# Procedures.
program-procedure-without-runs = the procedure has no runs
program-run-without-passes = the run names no passes
program-run-passes-twice = the run names its passes twice
program-run-names = either name = "tack", "root", "fill" or "cap", or passes = "1", "2-5" and so on
program-run-without-position = the run allows no welding position
program-run-positions = one or more; without the key all are allowed
program-not-a-process-value = this is not a process value
program-beside-ranges = { $key } beside `ranges`
program-ranges-in-table = put ranges of process values into [runs.ranges]
program-part-above-one = this part of the whole is above 1
program-one-run-per-name = one run per name
program-pass-in-two-runs = pass { $pass } is named by { $other } already
program-named-pass-in-two-runs = pass { $pass } ({ $name }) is in { $other } already
program-pass-in-one-run = each pass in one run
program-no-pass-numbers = `{ $text }` names no passes
program-pass-named-twice = pass { $pass } is named twice
program-pass-numbers = numbers from 1 like "1", "2-5" or "1, 3-4", each once
program-limits-increase = the limits must increase
program-hysteresis-too-large = no slope exceeds vertical_slope_deg by that much
program-no-power = the product of these values is not a power
program-power-values = ["current_a", "voltage_v"], ["laser_w"]: one in W or kW, or a current in A, mA or kA and a voltage in V or kV
program-window-order = the minimum, { $min }, is above the maximum, { $max }
program-window = [minimum, maximum]
program-processes = { $processes }
program-process = { $number } ({ $name })

# Jumps of the torch.
program-torch-direction-jumps = the torch's direction would jump by { $jump } at the corner at s = { $s }
program-torch-tip-jumps = the torch's tip would jump by { $jump } at the corner at s = { $s }
program-cure-direction-jumps = end one pass there and start another after it (in a job order.parts = "at_corners", tacks elsewhere); or round the corner in the seam; in a butt joint weld without work and travel angle
program-cure-tip-jumps = end one pass there and start another after it (in a job order.parts = "at_corners", tacks elsewhere), or round the corner in the seam

# Variables and expressions.
program-expression = "= expression"
program-expression-lines = an expression stays on its line
program-expression-grammar = numbers, names of variables, + - * / and parentheses
program-expression-rest = `{ $text }` is not understood
program-expression-ends = the expression ends where a number or a name should come
program-unexpected-character = `{ $text }` stands where a number or a name should come
program-number-invalid = `{ $text }` is not a number
program-nesting-too-deep = too many parentheses or signs within each other
program-parenthesis-missing = a closing parenthesis is missing
program-result-not-finite = the result is not finite
program-finite-result = no division by 0, no number beyond 1e308
program-not-a-number = this is not a number
program-variables-no-table = the variables are not a table
program-variables-table = [variables] with name = number
program-variable-name-invalid = `{ $name }` is not a valid name of a variable
program-variable-names = a letter or _, then letters, digits and _
program-no-variables = no variables are given: [variables] with name = number

# Refused edits.
program-edit-refused = the edit is refused: the document stays as it was; the line is that of the result
program-help-and-help =
    { $first }
    { "   " }{ $second }
program-edit-layout = the edit cannot be written into the layout of this document
program-usual-layout = the layout that the operation `format` makes
program-history-of-other-text = the document was changed since the edit and no longer contains its result
program-text-of-last-edit = the document as the last edit left it
program-history-line = line { $line }: { $fault }
program-history-empty = the history is empty
program-history-head = the head of the history does not fit its edits
program-history-format = a history as `seamwright edit` writes it, one JSON object a line
program-number-not-finite = a number is not finite or too large
program-no-pass = there is no pass { $pass }
program-pass-along-seam = pass { $pass } runs along the seam
program-pass-has-points = pass { $pass } goes through points
program-pass-through-points = a pass through points
program-no-points = there are no points { $from } to { $to } for this edit
program-nothing-to-set = nothing is given to set
program-no-order-position = there is no position { $at } in the order
program-only-pass = it is the only pass
program-no-event = there is no event { $event }
program-pass-with-events = a pass with events
program-mirror-unclear = the plane or axis to mirror about is missing, or both are given
program-mirror-keys = `normal` with `at_mm` for poses, `axis` with `about` for axis positions
program-points-are-axes = the points of pass { $pass } are axis positions
program-points-are-poses = the points of pass { $pass } are poses
program-no-points-pass = no pass goes through points
program-with-points = a program with [passes.points]
program-offset-of-axes = the points are axis positions: only the machine knows the torch's frame
program-points-with-poses = points that are poses
program-no-torch-frame = at point { $point } the torch lies along the path, or the path has no direction
program-torch-across-path = a torch across the path
program-no-point = there is no point { $point }
program-no-number-given = no number is given
program-column-without-speed = `{ $column }` is not a column of the position and has no speed
program-no-cubic-at-point = no cubic ends or starts at point { $point }
program-point-of-cubic = a point of a span that is `cubic`
program-no-next-point = there is no next point for a position halfway
program-no-point-left = no point would be left
program-keep-a-point = keep at least one point, or delete the pass
program-points-without-xyz = the points have no x, y and z for lines and arcs
program-poses-or-xyz = poses, or positions of axes x, y and z
program-no-span = there is no span { $span } for this edit
program-pass-of-more-spans = a pass with more spans
program-rapid-with-arc = the arc is on in this pass: a rapid move does not weld
program-ways-or-no-arc = line, arc, spline; or a pass with `arc = false`
program-pass-with-times = a pass whose last column is `time_s`
program-arc-of-points = an arc needs `via_mm` and one point; the span has { $points }
program-split-first = split the span first; give `via_mm`
program-via-of-arcs = `via_mm` and `normal` belong to arcs, not to `{ $along }`
program-rapid-without-pace = points reached by rapid have no time or speed
program-pace = `pace`: time or speed to each point
program-pace-given = the points have a time or speed already
program-no-pace = no `pace`
program-no-split-at-point = no span can be split at point { $point }
program-point-within-span = a point within a span, not its last one
program-no-split-at-length = no span can be split at { $s }
program-length-within-span = a path length within a span, not its end
program-split-unclear = the position of the split is missing, or does not fit the pass
program-split-keys = `point` through points, `s_mm` along the seam
program-spans-not-joined = spans { $first } and { $second } do not continue each other
program-spans-that-join = the same way (no arcs) and stops, cubics with the same speeds; along the seam the same values, or ramps that continue
program-points-without-seam = the pass goes through points: it has no seam
program-no-seam-length = no `seam_length_mm`
program-pass-over-start = the pass runs over the seam's start
program-seam-length = `seam_length_mm`: the seam is welded all round
program-start-point = `point`, at which closed points are to start
program-start-without-seam = the program has no seam on which to start
program-start-unclear = the new start is missing, or given twice
program-start-keys = `pass` with `point`, or `pass` with `begin_mm`, or `phi_deg` alone
program-points-not-closed = the points do not end where they start
program-closed-points = closed points: the last point is the start
program-no-range = the pass has no range from { $from } to { $to }
program-range-of-points = `points`, and no `s_mm`
program-range-of-seam = `s_mm`, and no `points`
program-range-without-pass = a range needs its pass
program-pass-with-range = `pass` with `points` or `s_mm`
program-speed-not-positive = a speed would not be a finite number above 0
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
