# Numbered parts of a page, results and findings.
report-table = Table { $number }.
report-figure = Figure { $number }.
report-in-order = In order
report-not-in-order = Not in order
report-severity-note = Note
report-severity-warning = Warning
report-severity-error = Error
report-finding-place = At: { $place }
report-finding-cure = Cure: { $cure }
report-no-findings = No findings.
report-heading-notes = Notes
report-heading-findings = Findings
report-more-places = { $n ->
        [one] 1 more place
       *[other] { $n } more places
    }

# Places, ranges and pairs of values.
report-range = { $from } to { $to }
report-at = s = { $s }
report-at-range = s = { $from } to { $to }
report-pass-at = pass { $pass }, { $place }
report-passes-at = passes { $first } to { $last }, { $place }
report-pair = { $first } and { $second }
report-pass-named = pass { $pass }: { $name }
report-curve-of-head = { $curve }, head { $head }
report-part-of = { $value } of { $whole }
report-more-than = more than { $value }

# Charts.
report-no-data = no data
report-limit-above = { $limit }, above
report-limit-below = { $limit }, below
report-limit-outside = { $limit }, outside
report-limit = limit
report-limit-at-least = at least
report-limit-at-most = at most
report-limit-min = minimum
report-limit-max = maximum
report-label-path-length = path length s
report-label-distance = distance
report-label-angle = angle
report-label-heat-input = heat input
report-label-speed = speed
report-label-acceleration = acceleration
report-label-jerk = jerk
report-label-position = position
report-label-curvature = curvature
report-label-deviation = deviation
report-label-path-error = path error
report-label-following-error = following error
report-label-attitude-error = attitude error
report-label-along-seam = along the seam
report-label-across = across
report-label-torch-tip = torch tip

# Names of views.
report-view-front = Front
report-view-side = Side, from the left
report-view-top = Top
report-view-pictorial = Pictorial, not to scale
report-seen-from-above = seen from above
report-seen-from-below = seen from below
report-seen-from-plus-x = seen from +x
report-seen-from-minus-x = seen from -x
report-seen-from-plus-y = seen from +y
report-seen-from-minus-y = seen from -y

# Columns of tables.
report-column-value = Value
report-column-min = Minimum
report-column-mean = Mean
report-column-max = Maximum
report-column-allowed = Allowed
report-column-outside-s = Outside, s
report-column-outside-mm = Outside, mm
report-column-pass = Pass
report-column-name = Name
report-column-date = Date
report-column-signature = Signature
report-column-alarm = Alarm
report-column-priority = Priority
report-column-cause = Cause
report-column-position-mm = s, mm
report-column-time-s = t, s
report-column-first-out = First-out
report-column-acknowledged = Acknowledged
report-column-time = Time
report-column-event = Event
report-column-text = Text
report-column-version = Version
report-column-file = File
report-column-rows = Rows
report-column-bytes = Bytes
report-column-transfer-before-s = Transfer move before, s
report-column-start-s = Start at, s
report-column-travel-s = Travel, s
report-column-arc-on-s = Arc on, s
report-column-total-s = Total, s
report-column-speed-mm-s = Speed, mm/s
report-column-stick-out = Stick-out, mm
report-column-arc-energy = Arc energy, kJ/mm
report-column-heat-input = Heat input, kJ/mm
report-column-length-mm = Length, mm
report-column-wire-m = Wire, m
report-column-bead = Bead in section
report-column-toe-deg = Toe angle, °
report-column-weld-metal-kg = Weld metal, kg
report-column-wait-before-s = Wait before, s
report-column-group = Group (ISO/TR 15608)
report-column-thickness = Thickness, mm
report-column-ce = CE (IIW), %
report-column-cet = CET, %
report-column-pcm = Pcm, %
report-column-preheat = Preheat by EN 1011-2, °C
report-column-work = Work before the pass, °C
report-column-t85 = t8/5, s
report-column-heat-flow = Heat flow
report-column-at-requested-speed = At requested speed, %
report-column-attitude-error = Attitude error, °
report-column-clearance = Minimum clearance, mm
report-column-between = between
report-column-path-error-mm = Path error, mm
report-column-rms-mm = RMS, mm
report-column-rms = RMS
report-column-speed-ripple = Speed ripple, %
report-column-position = Position
report-column-from = From
report-column-to = To
report-column-slope = Slope
report-column-rotation = Rotation
report-column-section = Section
report-column-min-speed = Minimum speed
report-column-max-speed = Maximum speed
report-column-binding = Binding limit
report-column-head = Head
report-column-untracked = untracked, 99 % (mm)
report-column-tracked = tracked, 99 % (mm)
report-column-correction-used = of the allowed correction
report-column-stopped-at = stopped at (mm)
report-column-corrected-by = corrected by
report-column-deflected = deflected by up to (mm)
report-column-gun-carried = gun carried by up to (mm)
report-column-away = away from the weld (% of the time)
report-column-longest = longest (ms)
report-column-stored-within = nine of ten points from the stored deviations (mm)
report-column-peak-load = Peak load, %
report-column-axis = Axis
report-column-unit = Unit
report-column-range = Range
report-column-of = of
report-column-speed-used = Speed, %
report-column-acceleration-used = Acceleration, %
report-column-jerk-used = Jerk, %
report-column-tip-mm = Tip, mm
report-column-linear-axis = Linear axis
report-column-rotary-axis = Rotary axis
report-column-tip-speed = Tip speed
report-column-process-value = Process value

# Title blocks of pages.
report-subtitle-plan = Weld report: plan
report-subtitle-simulation = Weld report: plan and simulation
report-subtitle-record = Weld record { $id }
report-subtitle-record-simulated = Weld record { $id }, simulated: no metal was welded
report-meta-part = Part
report-meta-welder = Welder
report-meta-machine = Machine
report-meta-procedure = Procedure
report-meta-started = Started
report-meta-ended = Ended
report-not-yet = not yet
report-none = none
report-meta-page-made = Page created
report-meta-made-by = Created by

# Headings.
report-heading-values = Procedure and actual values
report-heading-deviations = Deviations
report-heading-alarms = Alarms
report-heading-events = Events
report-heading-record = Record
report-heading-procedure = Procedure
report-heading-program = Program
report-heading-signatures = Signatures
report-heading-errors = Errors
report-heading-map = Weld map and schedule
report-heading-process = Process along the seam
report-heading-materials = Materials, preheat and cooling
report-heading-cut = Cut of the tube
report-heading-source = Text of the job
report-heading-passes = Passes
report-heading-checks = Checks
report-heading-curves = Appendix: curves
report-heading-seam = Seam and torch
report-heading-joint = Joint
report-heading-taught = Taught spans
report-heading-tracking = Tracking
report-heading-simulated = Simulated weld
report-heading-axes = Axes
report-heading-programs = Part programs
report-heading-job = Start and end of the passes
report-heading-released = Released
report-heading-pass-curves = Pass { $pass } ({ $name }): curves

# Record of a weld: result.
report-result-good = Welded to its end, within its tolerance.
report-result-deviating = Welded to its end, with deviations from the request.
report-result-stopped = Stopped before its end.
report-result-interrupted = Interrupted: the program or the power failed.
report-result-running = Not ended: the weld is running, or the program crashed.
report-windows-without-procedure = There is no procedure for comparison.
report-windows-within = All values within the procedure's windows.
report-windows-outside = Outside the procedure's windows: { $values }.
report-value-outside-at = { $value } in pass { $pass }, s = { $from } to { $to }
report-value-outside = { $value } in pass { $pass }
report-record-note = Note: { $note }.
report-tile-arc-on = Arc-on time
report-tile-deviation = Deviation
report-tile-mean = mean; { $from } to { $to }
report-tile-max-at = maximum, at s = { $s }

# Record of a weld: tables.
report-caption-by-hand = To be filled in by hand
report-inspector = Inspector
report-welding-engineer = Welding engineer
report-caption-actual-values = Actual values while the torch travelled, without holds, starts and ends, compared with the procedure's windows
report-no-values = No values are recorded.
report-not-limited = not limited
report-outside = outside
report-within = within
report-allowed = allowed
report-no-alarms = No alarms.
report-caption-alarms = Alarms in the order of their occurrence
report-first-out = first
report-no = no
report-caption-events = Events in the order of their occurrence
report-caption-sources = Source texts of this weld, stored in the library; SHA-256 of the program { $sha256 }
report-caption-files = Files of the record

# Record of a weld: charts.
report-heat-input-unknown = Unknown: the power is not defined without a procedure.
report-chart-heat-input = Heat input along the seam
report-caption-heat-input-bins = Energy divided by the travel of the torch tip, for every { $bin }.
report-chart-tip-off-path = Deviation of the torch tip from the planned path
report-caption-tip-off-path = Distance of the actual torch tip from the seam, normal to it; the maximum of every { $bin }.
report-chart-weld-off-joint = Deviation of the weld from the joint
report-caption-weld-off-joint = Lateral and height deviation of the weld from the joint; the maximum of every { $bin }.
report-curves-shown = Showing { $shown } of { $all } curves; all are in the trace.

# Plan: checks and verdict.
report-no-findings-plan = None: this machine can make the weld as requested.
report-checked = Checked: reach, ranges, speeds, accelerations and jerks of the axes; that the torch axis stays clear of both faces; and the clearances between { $objects }, along the passes and in the transfer moves, as far as the files give their shapes. Not checked: objects that are missing in this list, parts beyond the lengths given in the job, cables and hoses.
report-checked-without-shapes = Checked: reach, ranges, speeds, accelerations and jerks of the axes, and that the torch axis stays clear of both faces. Collisions are not checked: the machine file has no shapes.
report-verdict-planned = Planned: all axes within their limits, the requested speed from the acceleration to the deceleration phase.
report-verdict-planned-slowed = Planned: all axes within their limits, slowed to { $speed } where an axis needs it.
report-verdict-within = Within { $procedure }.
report-verdict-outside = Outside { $procedure }: { $n ->
        [one] 1 finding
       *[other] { $n } findings
    }.
report-verdict-findings = Findings: { $errors } to be corrected, { $warnings } to be reviewed.
report-verdict-simulated = Simulated: path error up to { $error } ({ $allowed } allowed), speed within { $ripple } ({ $ripple_allowed } allowed).
report-verdict-simulated-short = Simulated: path error up to { $error } ({ $allowed } allowed), too short to evaluate its speed.

# Plan: key figures.
report-tile-weld-length = Weld length
report-seam-length = seam { $length }
report-length-of-passes = { $of }; { $n } passes, { $length } in total
report-through-points = through points
report-tile-weld-time = Weld time
report-travel = travel, rest to rest
report-travel-of-passes = travel of all { $n } passes, rest to rest
report-tile-path-error = Path error, simulated
report-path-error-rms = maximum; RMS { $rms }
report-tile-speed-ripple = Speed ripple, simulated
report-speed-range = { $from } to { $to }, RMS { $rms }
report-too-short = weld too short to evaluate
report-tile-attitude-error = Attitude error
report-attitude-error-of-plan = maximum of the plan
report-tile-arc-energy = Arc energy
report-arc-energy-range = maximum; minimum { $min }; U I / v
report-tile-wire = Wire
report-wire-length = { $length } while the arc is on
report-tile-weld-metal = Weld metal
report-tile-gas = Gas
report-gas-time = from preflow to postflow
report-tile-flux = Flux
report-tile-energy = Energy of the arc
report-mains = { $energy } from the mains
report-tile-heat-input = Heat input
report-heat-input-range = maximum; minimum { $min }
report-tile-total = Total time
report-total-parts = from home to home; transfer moves { $transfer }
report-total-parts-waiting = from home to home; transfer moves { $transfer }, waits { $wait }
report-duty = { $part } of the total; duty cycle { $duty } in 10 minutes
report-tile-cost = Cost
report-cost-labour = labour
report-cost-machine = machine
report-cost-wire = wire
report-cost-gas = gas
report-cost-flux = flux
report-cost-energy = energy
report-cost-incomplete = incomplete: a quantity is unknown
report-wire-with-arc = while the arc is on

# Plan: order of welding.
report-caption-order = Passes numbered in the order of welding. Dashed: transfer moves, drawn as straight lines from end to start.
report-chart-order = Order of welding: { $n } passes, { $view }
report-order-key = Dot: start. Arrow: direction of welding. Dashed: transfer moves, drawn as straight lines.
report-order-key-tacks = Orange, numbers outside: tacks.
report-order-lines = { $title }: { $n } lines
report-caption-map = Weld map: the seam unrolled, a row for each bead in the order of welding.
report-chart-map = Weld map on the unrolled seam
report-map-key = Dot: start. Stroke: stop. Arrow: direction of welding. Numbers: passes.
report-map-copies = The first of { $n } seams.
report-map-label = { $title }: { $n } rows, { $length }
report-caption-order-table = Schedule: passes in the order of welding
report-all-from-home = all, from home to home

# Plan: passes.
report-caption-passes = Values of each pass, as planned
report-all-passes = all passes
report-caption-checks = Checks of each pass
report-caption-materials = Base materials and weld metal with carbon equivalents: CE of the IIW, CET of EN 1011-2, Pcm of Ito and Bessyo.
report-materials-decisive = For the preheat counts CET { $cet } with { $hydrogen } ml of hydrogen in 100 g.
report-caption-heat = Preheat by method B and cooling time from 800 to 500 °C by EN 1011-2, for { $thickness }: from the lowest heat input on the coldest work to the highest on the hottest.
report-no-preheat = none
report-weld-metal = weld metal
report-material-group = group { $group }
report-caption-simulated-passes = Results of each simulated pass
report-about-curves = Curves of one pass of each kind: a pass with an error, or else the longest. `plan --plots` writes those of every pass.

# Plan: seam, torch and process.
report-caption-seam = Seam with the requested torch axis, in the frame of the job, first-angle projection.
report-curve-bead = bead
report-curve-seam = seam
report-curve-path = path
report-curve-torch-axis = torch axis
report-mark-start = start
report-mark-end = end
report-mark-end-of-overlap = end of overlap
report-chart-torch-angles = Torch angles and groove
report-curve-work-angle = work angle (offset from bisector)
report-curve-travel-angle = travel angle (+ drag, − push)
report-curve-half-dihedral = half the dihedral angle
report-caption-torch-angles = Work angle from the bisector of the faces (positive towards the first part), travel angle, and half the angle between the faces.
report-chart-process-values = Process values as requested
report-caption-process-values = Process values along the pass where they change, without the slopes at its ends.
report-chart-weave = Woven path of the torch tip over the first { $length }
report-curve-tip = tip
report-curve-beam = beam
report-first-part = first part
report-second-part = second part
report-caption-weave = Requested woven path, seen along the torch; the seam is straightened, both axes have the same scale, and the torch travels to the right.
report-chart-oscillation = Path of the beam on the work over { $n } periods: { $advance } per period at { $speed }
report-caption-oscillation = Path of the deflected beam on the work, both axes at the same scale; oscillation.csv has one period of the deflection.
report-caption-cut = Cut end of the tube, unrolled; cut.svg shows it at true size from outside, to wrap around the tube, and cut.csv lists its points.
report-chart-cut = Template of the cut
report-cut-outside = outside: radius { $radius }, circumference { $around }, cut { $from } to { $to } along the axis, edge at { $edge }
report-cut-inside = inside: radius { $radius }, circumference { $around }, cut { $from } to { $to } along the axis, edge at { $edge }
report-sections = { $title }: { $n ->
        [one] 1 cross-section
       *[other] { $n } cross-sections
    }
report-section-note = dihedral { $dihedral }, area { $area }
report-section-toes = , toe angles { $second } and { $first }
report-area-with-cap = { $groove } + { $cap }
report-section-torch = torch: work angle { $work }, travel angle { $travel }
report-caption-sections = Cross-sections along the seam at one scale, with the second part's face level or a butt joint's face up: beads in the order of welding, and the wire's direction in each. The area is that of the groove and of the cap above it.

# Plan: welding procedure.
report-caption-heat-input = Heat input at the planned speed between acceleration and deceleration phase, with its window; shaded where it is outside.
report-caption-positions = Welding position (ISO 6947) by slope of the weld axis and rotation of the weld face, as the axes of the machine turn the part.
report-too-high = too high
report-too-low = too low
report-chart-positions = Welding position
report-curve-slope = slope (+ uphill)
report-curve-rotation = rotation of the face (0 up, 180 down)
report-run = run { $run }
report-no-run = no run for this pass
report-procedure = { $number } ({ $title }), { $run }. Process { $process }: { $process_name }. Heat input is { $efficiency } times the power over the planned speed. Positions are those of a { $joint ->
        [fillet] fillet
       *[butt] butt
    } weld.
report-caption-plan-values-of = Planned values and the procedure, pass { $passes }
report-unbounded = unbounded
report-to-be-measured = to be measured
report-unknown-see-findings = unknown: see the findings
report-outside-at = outside: s = { $from } to { $to }
report-outside-pass = outside: pass { $passes }
report-outside-at-more = outside: s = { $from } to { $to } and { $n ->
        [one] 1 more stretch
       *[other] { $n } more stretches
    }
report-caption-positions-any = Welding positions (mm, degrees); the procedure allows any
report-caption-positions-allowed = Welding positions (mm, degrees); the procedure allows { $positions }
report-not-allowed = not allowed

# Plan: taught spans.
report-chart-taught = Taught span { $number }
report-caption-taught = Seam as welded and nominal seam; at both joins position, direction and curvature agree.
report-taught = taught
report-chart-off-nominal = Distance from the nominal seam
report-curve-as-welded = the seam as welded
report-curve-nominal = nominal seam
report-curve-taught-points = taught points
report-chart-direction-off-nominal = Direction relative to the nominal seam
report-chart-curvature = Curvature
report-chart-tip-speed = Speed of the torch tip
report-curve-planned = planned
report-shorter = shorter
report-longer = longer
report-taught-span = Span { $number }: s = { $from } to { $to } ({ $length } { $change } than the nominal seam there), { $n } taught points; up to { $distance } from the nominal seam and { $angle } from its direction.

# Plan: clearance.
report-caption-clearance = Minimum clearance between torch, links, part, fixtures and zones, and its lower bound along the whole pass.
report-chart-clearance = Minimum clearance (shown up to { $limit })
report-curve-clearance = minimum clearance
report-curve-clearance-bound = proven lower bound between samples

# Plan: speed.
report-speed-reached = Requested: { $requested }. Reached between acceleration and deceleration phase: { $reached }. At the requested speed over { $part } of the length.
report-caption-speed = Speed of the torch tip along the seam, relative to the work; shaded where it is below the requested speed, with the binding limit.
report-chart-speed = Speed of the torch tip along the seam
report-curve-tip-simulated = actual torch tip, simulated
report-acceleration-phase = acceleration phase
report-deceleration-phase = deceleration phase
report-section-weld = weld
report-axis = axis { $axis }
report-torch-tip = the torch tip
report-requested-speed = requested speed
report-binding = the { $what } of { $owner }, { $limit }
report-no-binding = none: at the requested speed
report-caption-binding = Binding limits of the speed (mm, mm/s)
report-caption-binding-first = Binding limits of the speed (mm, mm/s): the first { $n } stretches, { $more } more in report.json
report-caption-deviation = Deviation of the simulated speed between acceleration and deceleration phase; at the start the drives settle.
report-chart-deviation = Speed of the actual torch tip compared with the planned speed

# Plan: tracking.
report-part-displaced = The part is displaced from its planned position.
report-tracking-without-alarms = Tracking reported no alarms.
report-welded-as-planned = It was welded as planned.
report-to-be-checked = To be checked: { $alarms }.
report-alarm-at = { $head } at { $s }: { $alarm }
report-caption-tracking = Actual position of the joint relative to the planned path, deviation of the weld from the joint, and uncertainty of the tracked joint.
report-chart-tracking = Joint and weld
report-chart-joint = joint relative to the planned path (deviation of a weld without tracking)
report-chart-weld = weld relative to the joint
report-chart-correction = lateral correction: deflection of the beam; dashed, gun carried by the axes
report-chart-sigma = uncertainty of the joint (standard deviation)
report-curve-lateral = lateral
report-curve-height = height
report-curve-deflection = deflection
report-curve-gun = gun carried by the axes
report-curve-sigma = sigma
report-not-welded = not welded
report-not-tracked = not tracked
report-caption-tracked-lateral = Deviation of the weld from the joint, lateral: a beam has no height
report-caption-tracked = Deviation of the weld from the joint, lateral and height together
report-stored-points = { $value } ({ $n ->
        [one] 1 point
       *[other] { $n } points
    })
report-stored-deviations = stored deviations
report-seen-by-beam = measurement by the beam
report-caption-beam = Corrections of the beam

# Plan: simulation.
report-simulation = Every axis on its position loop at the servo period, with inertia, friction, cogging, encoder steps and current limit (seed { $seed }). The part is nominal: without displacement, distortion, fit-up errors or wire cast. Speed ripple is the maximum deviation of the torch-tip speed from the planned one, from half a second after the acceleration phase to the deceleration phase.
report-highest-load = The drive with the highest load is { $axis }: { $load } of its peak.
report-assumed-drives = The machine file describes no drive for { $axes }: the simulation assumes one for each.
report-caption-path-error = Distance of the actual torch tip from the seam, normal to it.
report-chart-path-error = Distance of the actual torch tip from the seam
report-curve-normal-to-seam = normal to the seam
report-caption-following = Set-point minus actual position of each axis.
report-chart-following = Following error of each axis
report-caption-following-table = Following error while the arc is on
report-caption-attitude = Angle between the actual and the requested torch direction.
report-chart-attitude = Deviation of the actual torch direction from the requested one

# Plan: axes.
report-continuous = continuous
report-caption-axes = Planned position, speed and acceleration of each axis with its limits.
report-caption-jerks = Planned jerk of each axis with its limit.
report-chart-axes = Axes and their limits
report-chart-jerks = Jerk of the axes and its limits
report-caption-ranges = Positions of the axes and their ranges
report-caption-uses = Maximum use of the limits of each axis

# Plan: part programs.
report-program = { $file } for { $dialect }: { $n } moves, read back, run by the rules of the control for interpolation and feeds, taken through the forward kinematics of the machine and compared with the plan; { $tolerance } are allowed.
report-as-in-program = as in the program
report-caption-program = Maximum deviations of { $file }

# Plan: job data.
report-caption-job = Times and values before and after the travel
report-row-seam = Seam
report-row-seam-length = Seam length
report-row-acceleration-phase = Acceleration phase
report-row-deceleration-phase = Deceleration phase
report-row-start-angle = Start angle
report-row-direction = Direction of welding
report-row-dihedral = Dihedral angle
report-row-preparation = Joint preparation
report-counter-clockwise = counter-clockwise
report-clockwise = clockwise
report-row-overlap = Overlap
report-row-preflow = Gas preflow
report-row-travel-delay = Arc on before travel
report-row-upslope = Upslope from { $value }
report-row-upslope-time = Upslope: time
report-row-downslope = Downslope to { $value }
report-row-downslope-time = Downslope: time
report-row-crater = Crater fill
report-row-postflow = Gas postflow

# Check of a machine: page.
report-check-subtitle = Check of the machine file
report-check-made-by = Seamwright { $version }, seed { $seed }
report-check-heading-failed = Failed tests
report-check-remarks = Remarks
report-check-heading-kinematics = Kinematics
report-check-singular = Singular configurations
report-check-heading-reach = Reach
report-check-heading-file = Machine file
report-check-remark-count = { $n ->
        [0] no remarks
        [one] 1 remark
       *[other] { $n } remarks
    }
report-check-passed = Every pose is found again from its own positions, and the Jacobian agrees with differences; { $remarks }.
report-check-failed = { $failures }; { $remarks }.
report-check-axis-count = { $rotary } rotary, { $linear } linear
report-check-tip-error = Round trip, tip
report-check-tip-error-note = maximum of { $n } random poses per head
report-check-jacobian = Jacobian
report-check-jacobian-note = maximum relative difference
report-check-singular-note = inside the ranges
report-check-remarks-note = unusual values
report-check-caption-machine = Machine at home in its base frame, first-angle projection. Arrows show the positive sense of what each axis moves: the torch on the tool side, the work on the work side; rotations follow the right-hand rule. Symbols that would overlap are drawn side by side.
report-check-no-remarks = None: limits, ranges and drives have usual sizes and match each other.
report-check-remark = { $key }: { $why }
report-check-remark-value = { $key } = { $value }: { $why }
report-check-line = { $file }, line { $line }
report-check-typical = A typical weld runs at { $speed } around a bend of { $radius }, where the torch turns at { $rate }.
report-check-too-fast = In { $part } of the ranges a typical weld needs more speed than a rotary axis has.
report-check-fast-enough = Every typical weld is within the speed of the rotary axes in their whole ranges.
report-check-no-singular = Head { $head }: no singular configurations inside the ranges. The worst conditioned position is { $position } (conditioning { $worst }; { $best } at the best position).
report-check-reach = Head { $head }: { $kind ->
        [volume] volume
        [area] area
       *[length] length
    } reached by the tip in the work frame: { $size }, { $part } of its bounding box. The torch tilts up to { $tilt } from its direction at home, seen from the work.
report-check-no-volume = none: the tip stays on a surface or a line
report-check-point = a point
report-check-size = { $value } ± { $deviation }
report-check-position = { $axis } { $position }

# Check of a machine: tables.
report-check-column-letter = Letter
report-check-column-kind = Kind
report-check-column-moves = Moves
report-check-column-home = Home
report-check-column-speed = Speed, /s
report-check-column-acceleration = Acceleration, /s²
report-check-column-jerk = Jerk, /s³
report-check-column-time = To speed, s
report-check-caption-axes = Axes; linear ones in mm, rotary ones in degrees. The last column is the time from rest to the maximum speed.
report-check-linear = linear
report-check-rotary = rotary
report-check-torch = torch
report-check-work = work
report-check-no-end-stops = no end stops
report-check-column-result = Result
report-check-column-poses = Poses
report-check-column-direction = Direction, °
report-check-column-axes = Axes, mm or °
report-check-column-near-singular = Near singular
report-check-column-unsolved = Unsolved
report-check-column-branch-missing = Own branch missing
report-check-both-heads = both heads
report-check-off-centre = { $unsolved } (and { $n } with slides off centre)
report-check-caption-results = Round trip: random positions, their pose, all positions for this pose, and the pose of each. Maximum differences; those of the axes away from singular configurations.
report-check-result-passed = passed
report-check-result-failed = failed
report-check-column-inverse = Inverse
report-check-column-difference = Difference
report-check-column-worst-axis = Worst axis
report-check-caption-structure = Method that finds positions for a pose, and the Jacobian compared with central differences: maximum difference relative to its column.
report-check-margin = { $distance } ({ $axis } is too slow at a smaller distance)
report-check-caption-singular = Singular configurations of head { $head } inside the ranges, and the distance that a typical weld needs from them.
report-check-column-configuration = Configuration
report-check-column-distance = Distance needed
report-check-column-box = Box of
report-check-tip-in-work = tip in the work frame
report-check-tip-in-base = tip in the base frame
report-check-caption-reach = Bounding box of all positions that a tip can reach, mm.

# Check of a machine: text.
report-check-text-result = result
report-check-text-failure = failed
report-check-text-head = head
report-check-text-inverse = inverse
report-check-text-round-trip = round trip
report-check-text-errors = { $n } poses: tip { $tip }, direction { $direction }, axes { $axes } (mm or °); { $near } near singular
report-check-text-jacobian = { $difference } of a column from differences
report-check-text-singular = singular
report-check-text-margin = { $place }; below a distance of { $distance } { $axis } is too slow for { $speed } on { $radius }
report-check-text-no-singular = none inside the ranges
report-check-text-reach = reach
report-check-text-box = x { $x }, y { $y }, z { $z } mm in the work frame
report-check-text-tilt = { $size }; up to { $tilt } from home
report-check-text-pair = { $n } poses: tips { $tip }, directions { $direction }; { $off } with slides off centre have no solution
report-check-text-remark = remark
report-check-text-line = line { $line }: { $remark }
report-check-text-cure = cure: { $cure }

# Drawings without a title, for screen readers.
report-three-views = three views
report-charts = charts
report-machine = machine

# Drawing of a machine.
report-machine-title = { $machine }: axes at home, in the base frame
report-machine-moves-torch = positive moves the torch
report-machine-moves-work = positive moves the work
report-machine-beam = beam or wire, ending at the tip
report-machine-links = links and shapes
report-machine-towards = positive towards you
report-machine-away = positive away from you
report-machine-stroke = stroke, its arrow at the maximum position
report-machine-cut = continues
report-machine-home = home
report-machine-base = base
report-machine-work = work
report-machine-up = up

# Bode plots.
report-bode-frequency = frequency
report-bode-magnitude = magnitude of the open loop
report-bode-phase = phase of the open loop
report-bode-crossover = crossover
report-bode-open-loop = open loop
report-bode-gain-margin = gain margin { $margin } at { $frequency }
report-bode-gain-unbounded = gain margin: unbounded
report-bode-phase-margin = phase margin { $margin } at { $frequency }
report-bode-phase-unbounded = phase margin: unbounded

# Search for placements.
report-reach-subtitle = Placements of the work
report-reach-subtitle-base = Placements of the machine's base
report-reach-title = Reach of { $machine }
report-reach-key = Number: smallest distance of an axis from an end of its range, % of the range
report-reach-label = { $title }: map of placements
report-reach-shade = { $from } to { $to } %
report-reach-shade-above = above { $from } %
report-reach-fails = not weldable
report-reach-present = present placement
report-reach-best = best placement
report-reach-judged = placements judged
report-reach-weldable = weldable
report-reach-clearance = clearance at the best
report-reach-kind-reach = out of reach
report-reach-kind-range = range of an axis
report-reach-kind-jump = no continuous motion
report-reach-kind-speed = speed of an axis
report-reach-kind-position = welding position
report-reach-found = best placement: x { $x }, y { $y }, z { $z }, turned { $turn }; planned
report-reach-none = no placement is weldable and planned
    .cause = No judged placement passes all checks.
    .cure = Widen the ranges, or give the search more time.
report-reach-heading-map = Map
report-reach-heading-best = Best placements
report-reach-heading-reasons = Reasons of failures
report-reach-heading-method = Method
report-reach-method = Displacements are in the work frame, from the present placement; the rotation is about the vertical through the middle of the seam. Each cell shows the best placement of the grid with these x and y. In cells that fail, the axis or the kind of the reason. The best placement was planned in full, with clearance and transfer moves; the others were judged by ranges, speeds, welding positions and a continuous motion.
report-reach-method-base = Displacements are those of the machine's base in the base frame, from its present placement; the rotation is about the vertical through the origin of that frame. All that stands on the base goes with it. Each cell shows the best placement of the grid with these x and y. In cells that fail, the axis or the kind of the reason. The best placement was planned in full, with clearance and transfer moves; the others were judged by ranges, speeds, welding positions and a continuous motion.
report-reach-caption-map = Placements along x and y
report-reach-caption-best = The best placements judged
report-reach-caption-reasons = Reasons, each with the placement that is nearest to being weldable
report-reach-column-turn = turned, °
report-reach-column-margin = margin, % of the range
report-reach-column-axis = axis
report-reach-column-singular = from a singular attitude, %
report-reach-column-speed = speed of an axis used, %
report-reach-column-kind = reason
report-reach-column-count = placements
report-reach-column-pass = pass
report-reach-column-s = s, mm
report-reach-column-reason = nearest case
