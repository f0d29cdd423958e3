# Notes and errors of every command.
cli-more-time = { $cure }; more time: --time-limit S
cli-verb-renamed = note: `seamwright { $former }` is now `seamwright { $present }`
    .cause = The verb has moved; the former name still works and does the same.
    .cure = Write the new name into scripts.
cli-unknown-language = note: there is no language `{ $language }`, so this is English; available: { $known }
    .cause = The option `--language`, or `LC_ALL`, `LC_MESSAGES` or `LANG`, names a language without a catalogue.
    .cure = Give `--language` with one of the available codes.
cli-error = error: { $error }
cli-option = { $option }: { $fault }
    .cause = The value of this option is invalid, for the reason that follows.
    .cure = Give an allowed value; `--help` of the verb explains the option.
cli-not-allowed = not allowed
    .cause = The value of the option is outside the allowed values that follow.
    .cure = Give one of them; `--help` of the verb explains the option.
cli-with-cure =
    { $failure }
    { "   " }{ $cure }
cli-range = { $from } to { $to }
cli-plus = +{ $value }
cli-wrote = wrote { $files }
cli-no-such-axis = there is no such axis
    .cause = The name differs from the axes of the machine file, also by capitals.
    .cure = Give one of the listed names; `seamwright machine show NAME` prints them.
cli-cycle-ended-early = the thread of the cycle ended early
    .cause = The thread of the cycle ended by a fault of the program.
    .cure = Check at the machine that arc, gas and drives are off; report the fault with the lines printed before.
cli-jobs-unreadable = not every job could be read
    .cause = At least one of the jobs is invalid or missing; its error stands beside its name above.
    .cure = Correct that file and check it again alone.
cli-no-notices = the licences of third-party packages are not in this program: { $why }
    .cause = The build could not read the folders of the packages, for the stated reason.
    .cure = Run `cargo fetch --locked` with a network, and build again.
cli-at-least-two = at least two
cli-standard-input = standard input

# Progress.
cli-progress-planning = planning
cli-progress-rows = rows
cli-schedule-done = { $weldable } of { $rows } rows can be welded as asked; { $kept } were not planned again
cli-progress-draws = draws
cli-study-done = { $draws } draws of { $job } on { $machine }; { $kept } plans were kept from an earlier run
cli-study-weldable = weldable: { $percent } % (95 % interval { $low } to { $high } %)
cli-study-first-error = first fault: { $error }
cli-progress-pass = pass { $pass } of { $passes }: { $stage }
cli-progress-simulating = welding in simulation
cli-progress-machine = checking the machine
cli-progress-tuning = tuning the axes
cli-progress-cycles = cycles
cli-progress-pulses = pulses
cli-progress-set-points = set-points
cli-progress-teaching = teaching
cli-progress-faults = faults
cli-progress-frames = simulated frames
cli-progress-welds = simulated welds

# Labels of the summary of a weld.
cli-label-machine = machine
cli-label-seam = seam
cli-label-speed = speed
cli-label-time = time
cli-label-energy = energy
cli-label-clearance = clearance
cli-label-passes = passes
cli-label-pass = pass { $pass }
cli-label-takes = takes
cli-label-waits = waits
cli-label-duty = arc on
cli-label-cost = cost
cli-label-transfers = transfers
cli-label-wrote = wrote
cli-label-welded = welded
cli-label-path-error = path error
cli-label-tip-speed = tip speed
cli-label-axis = axis { $axis }

# Summary of a weld.
cli-summary-seam = { $length }, weld { $weld }
cli-summary-takes-energy = { $energy } arc energy
cli-summary-takes-wire = { $wire } of wire
cli-summary-takes-metal = { $mass } of weld metal
cli-summary-takes-gas = { $gas } of gas
cli-summary-takes-flux = { $mass } of flux
cli-summary-waits = { $time } between passes, until the weld has cooled
cli-summary-duty = { $part } of the time, { $duty } of the worst 10 minutes
cli-summary-cost = { $total } { $currency }
cli-summary-cost-incomplete = { $total } { $currency }, without: { $without }
cli-summary-transfers = { $time }, home to home { $total }
cli-summary-speed = { $from } to { $to } planned, { $asked-from } to { $asked-to } asked
cli-summary-time = { $travel } travel, { $arc } arc on, { $total } in all
cli-summary-passes = { $passes }, { $length } in all
cli-summary-clearance = clearance { $clearance }
cli-summary-arc-energy = arc energy { $energy }
cli-summary-heat-input = heat input { $heat }
cli-clearance-between = { $distance }: { $first } and { $second }
cli-clearance-none = { $distance }: nothing watched comes nearer
    .cause = No body that is checked comes within the distance up to which clearances are measured.
cli-summary-not-welded = nothing of it (simulated)
    .cause = The simulated weld was stopped before this pass, by an alarm or by tracking.
    .cure = Look at the alarms in the summary and in `events.jsonl`.
cli-summary-path-error = { $max } maximum, { $rms } RMS (simulated)
cli-summary-tip-speed = { $from } to { $to }, RMS deviation { $rms } (simulated)
cli-summary-too-short = the weld is too short to judge
    .cause = Nothing lies between the acceleration and deceleration phases, so no speed is judged.
cli-summary-following-error = following error { $error }, RMS { $rms }
cli-summary-tracked = { $p99 } from the joint for 99 % of the weld, { $max } at most; untracked { $plain-p99 } and { $plain-max }
cli-summary-untracked = { $p99 } from the joint for 99 % of the weld, { $max } at most; not tracked
    .cause = The part differs from the planned one by `--distortion`, and the passes were not corrected, as with `--no-tracking`.
cli-summary-stopped = stopped at { $at }
    .cause = Tracking gave up there: the joint was lost or the correction exceeded its range.
    .cure = Look at the alarm below; see `docs/explanation/tracking.md`.
cli-summary-alarm = at { $at }: { $alarm }
    .cause = Tracking raised this alarm in the simulation at this length.
    .cure = Search its own code for cause and action.
cli-summary-beam = deflected by up to { $deflection } of { $range }, gun carried by { $carried }; beam away { $away } of the time, { $longest } at most
cli-summary-beam-replayed = replayed: { $beam }
cli-summary-beam-fit = { $beam }; 90 % of { $points ->
        [one] { $points } point
       *[other] { $points } points
    } within { $distance } of the stored deviations

# Positions along the seam.
cli-no-such-angle = this seam has no such angle
    .cause = The angle in `--phi-deg` does not exist on the seam: it is straight, or the curve does not reach around that far.
    .cure = Use `--points` or `--every-mm` instead.
cli-angle-not-welded = this angle is not on the welded part
    .cause = The weld ends before this angle, by `end_phi_deg` in `[start]`.
    .cure = Choose an angle between start and end of the weld, in the direction of welding.
cli-too-many-points = too many points
    .cause = Positions along a seam are limited to 10,000,000, touched points to 10,000, points of a stripe profile to 1,000,000.
    .cure = Enlarge `--every-mm`, or remove rows from the file.
cli-at-least-step = at least { $step }: { $points } points
cli-section-no-joint = the job has no joint, so there is no section
    .cause = Cross-sections are those of the groove and its beads, which the job describes in `[joint]`.
    .cure = Add a `[joint]`, or use `seamwright tools seam` for the geometry of the seam.
cli-section-joint = a [joint] with its preparation

# Lists.
cli-list-machine = machine
cli-list-axes = axes
cli-list-example = example
cli-list-procedure = procedure
cli-list-process = process
cli-list-title = title
cli-no-machine = { $name }: there is no such machine
    .cause = No supplied machine has this name; files are not printed by this verb.
    .cure = Run `seamwright machine list` for the names.
cli-no-example = { $name }: there is no such example
    .cause = No supplied job has this name.
    .cure = Run `seamwright examples` for the names.
cli-no-procedure = { $name }: there is no such procedure
    .cause = No supplied procedure has this name.
    .cure = Run `seamwright examples --procedures` for the names.

# Lateness of the cycle.
cli-latency-cycles = { $cycles ->
        [one] { $cycles } cycle
       *[other] { $cycles } cycles
    } of { $period }, { $missed } missed
cli-latency-late = { $part } begin at most { $late } late

# Moves from point to point.
cli-motions-up-to-two-hours = motions of up to two hours
cli-move-set-points = { $count } set-points
    .cause = The motion divided by `--period-ms` gives more than 1,000,000,000 set-points.
    .cure = Give a longer `--period-ms`, or a larger `--override-percent`.
cli-longer-period = up to { $max }, with a longer period
cli-move-done = { $time }, { $count ->
        [one] { $count } set-point
       *[other] { $count } set-points
    }; { $clearance }
cli-axis-value-of = AXIS=VALUE with axis { $axes }
cli-any-number-of = any number of { $unit }
cli-axis-twice = axis { $axis } is given twice
    .cause = One option `--from` or `--to` names the axis two times.
    .cure = Remove one of them.
cli-each-axis-once = each axis once
cli-axis-position-not-a-number = the position of axis { $axis } is not a number
    .cause = The text behind the equals sign is missing, is not a number, or has a unit or a decimal comma.
    .cure = Write positions as in `--to x=10,b=-5`, in mm or degrees.
cli-axis-outside = outside the range of axis { $axis }
    .cause = The position is beyond `range_mm` or `range_deg` of the axis in the machine file.
    .cure = Give a position within the range that follows.
cli-move-no-shapes = no collision check: the machine file has no shapes that could meet
    .cause = The machine file has no two shapes in `[[shapes.LINK]]` that move against each other, or `ignore` names all pairs.
    .cure = Describe table, torch and frame with `[[shapes.LINK]]` before you rely on the check.
cli-move-min-distance = minimum distance { $distance } at { $time }: { $first } and { $second }
cli-move-clear = nothing comes nearer than { $distance }
cli-move-impossible = the move cannot be made as asked: { $findings ->
        [one] { $findings } finding
       *[other] { $findings } findings
    }
    .cause = Two bodies come nearer than `least_mm` in `[clearance]` of the machine file on the straight move of the axes.
    .cure = Divide the move: first away from the obstacle, then past it.
cli-move-times = t = { $from } to { $to }
cli-move-in-parts = go round the obstacle, in several moves

# Part programs.
cli-as-far-as-axes-reach = a distance that the axes reach
cli-post-differs = the part program differs from the plan, and is not written:
    .cause = The program was read back, and positions, times or outputs differ from the plan by more than its tolerance.
    .cure = Report the listed differences with the job; for a trial use another `--interpolation` or `--feed`.
cli-too-coarse = too coarse
    .cause = The tolerance of a part program is up to 10 mm.
    .cure = Give `--tolerance-mm` in mm, such as 0.01.
cli-finer-than-decimals = finer than the words' six decimals
    .cause = Words of part programs have six decimals, so a tolerance below 0.00002 mm is lost in rounding.
    .cure = Give a larger `--tolerance-mm`.
cli-no-such-blocks = this control has no such blocks
    .cause = The control of `--dialect` has no blocks of this interpolation.
    .cure = Leave out `--interpolation`, or choose one of those listed for the control.
cli-interpolations = pvt, spline1, linear for PMAC; linear, poly for Sinumerik; linear for LinuxCNC and grblHAL
cli-too-far = too far
    .cause = Rounded corners may leave the path by at most 0.5 mm, the largest tolerance of a pass.
    .cure = Give a smaller `--blend-mm`.
cli-up-to-pass-tolerance = up to { $max }, the tolerance of a pass
cli-import = { $file }: { $dialect } program, { $moves ->
        [one] { $moves } move
       *[other] { $moves } moves
    }, { $time } by its feeds; passes: { $passes }
cli-import-left-out = left out: { $place }: { $words }: { $why }
    .cause = The words are unknown in this dialect, and `--lenient` permits leaving them out.
    .cure = Check that nothing needed is lost; without `--lenient` the import stops there.

# Points to lines and arcs, and interpolators.
cli-cure-line-or-column = correct the line, or remove a column that is not an axis from the file
cli-cure-line-in-mm = correct the line; coordinates are in mm
cli-cure-line-per-point = one line of numbers per point, below the header line
cli-too-far-away = too far away
    .cause = A coordinate is beyond 1,000,000,000 mm; usually a wrong column or unit.
    .cure = Correct the column or the unit of that line; coordinates are in mm.
cli-points-found = { $points ->
        [one] { $points } point
       *[other] { $points } points
    }
    .cause = The table has fewer than two rows below its header.
    .cure = Give a file with two or more rows below its header.
cli-reduced = { $points ->
        [one] { $points } point
       *[other] { $points } points
    }; lines: { $lines }, arcs: { $arcs }; maximum error { $error }; minimum number of spans: { $min }
cli-not-a-point = not a point
    .cause = The option needs two numbers separated by a comma.
    .cure = Write x and y in mm without spaces.
cli-point-form = x,y in mm, like { $example }
cli-too-many-to-draw = { $method } has more than { $max } points to draw
    .cause = The method gives more than 4,000,000 points along the curve.
    .cure = Enlarge the pulse or the period, or leave out `--svg`.
cli-coarser-or-no-drawing = a coarser pulse or period, or no drawing

# Edits of a program file.
cli-edit-no-operation = no operation is given, or several
    .cause = The command has neither an operation nor `--script`, or both.
    .cure = Give one of them; several operations go into one script.
cli-edit-operations = one operation, undo, redo, history, or --script OPS.json; see `seamwright edit --help`
cli-edit-new-history = note: { $file } was changed by hand since its last edit: a new history begins
    .cause = The text of the program differs from that after the last edit, so earlier edits no longer fit.
    .cure = Nothing is needed; undo reaches back to this state of the file only.
cli-edit-of-operation = operation { $number }: { $why }
    .cause = One operation of the script failed, so none was applied and nothing was written.
    .cure = Correct this entry of `--script`, counted from 1.
cli-edit-job = { $file }: this is a job; edits are of programs
    .cause = Edits change points and passes, which a program has; a job has parameters instead.
    .cure = Change keys of the job in a text editor, or plan it and edit `program.toml`.
cli-edit-plan-first = plan it first: seamwright plan { $file }; then edit { $program }
cli-edit-by-hand = { $file }: the file was changed by hand since its last edit
    .cause = The text differs from that after the last edit, so undoing may not fit.
    .cure = Undo the change by hand first, or add `--force`.
cli-edit-force = --force, which goes as far as it can
cli-edit-nothing-to-undo = { $file }: there is nothing to be undone
    .cause = The history in `FILE.edits` has no edit before the present text, or the file of the history is missing.
    .cure = See the edits with `seamwright edit FILE history`; restore `FILE.edits` if it was moved or deleted.
cli-edit-nothing-to-redo = { $file }: there is nothing to be redone
    .cause = No edit was undone since the last new edit.
    .cure = See the edits with `seamwright edit FILE history`, and make the edit again.
cli-edit-see-history = see `history`
cli-edit-undone = undone: { $edit }
cli-edit-redone = redone: { $edit }
cli-edit-unchanged = { $edit } (nothing changed)
    .cause = The text already had these values.
cli-edit-undone-entry = { $edit } (undone)
cli-edit-by-hand-since = the file was changed by hand since
    .cause = The program has another text than after its last edit.
    .cure = Undo with `--force` only, as far as it fits; the next edit begins a new history.
cli-edit-none = no edits
cli-edit-value = one number, or two for a ramp
    .cause = The option `--value` has no number, or more than two.
    .cure = Write one number, or the values at the start and the end of the ramp, separated by a comma.
cli-edit-see-schema = see `seamwright schema operation`

# Records of welds.
cli-no-data-folder = there is no data folder
    .cause = The command has no `--data`, and `SEAMWRIGHT_DATA`, `XDG_DATA_HOME`, `HOME` and `USERPROFILE` are unset, as in services.
    .cure = Give `--data DIR`.
cli-data-folder = --data DIR, or SEAMWRIGHT_DATA
cli-record-backup = { $file }: { $size } MB
cli-record-restored = { $folder }: restored; check it with `seamwright records verify`
cli-recovered = weld { $weld } ({ $part }): { $rows ->
        [one] { $rows } row
       *[other] { $rows } rows
    } recovered, { $result }
cli-recovered-unread = weld { $weld } ({ $part }): { $rows ->
        [one] { $rows } row
       *[other] { $rows } rows
    } recovered, { $unread } at its end unread, { $result }
    .cause = The program or the power failed within a write; bytes that form no complete block are not readable.
    .cure = Large unread rests are kept as `trace.raw.damaged` in the weld's folder.
cli-nothing-to-recover = nothing to recover
cli-recorded = recorded: weld { $weld }
cli-record-weld-note = note: weld { $weld }: { $note }
cli-record-heading = weld { $weld }: { $title }
cli-label-part = part
cli-label-result = result
cli-label-begun = begun
cli-label-ended = ended
cli-label-welder = welder
cli-label-procedure = procedure
cli-label-job = job
cli-label-program = program
cli-label-heat-input = heat input
cli-label-deviation = deviation
cli-label-note = note
cli-label-alarm = alarm
cli-label-event = event
cli-label-file = file
cli-record-simulated = { $result }, simulated
cli-record-version = { $name }, version { $version }
cli-record-heat-input = { $min } to { $max }, mean { $mean }
cli-record-deviation = { $max } at most, at s = { $at }
cli-record-value = { $name } { $from } to { $to }
cli-record-value-allowed = { $value } ({ $min } to { $max } allowed)
cli-record-value-outside = { $value } ({ $min } to { $max } allowed, outside for { $time })
    .cause = The value left the range of the procedure between the acceleration and deceleration phases, for this time.
    .cure = Look at the positions in the report of `seamwright records export ID -o DIR`.
cli-record-with-cause = { $alarm }: { $cause }
cli-record-at = { $alarm } at s = { $at }
cli-record-file = { $file }, { $size }, SHA-256 { $hash }
cli-record-table = { $file }, { $size }, { $rows ->
        [one] { $rows } row
       *[other] { $rows } rows
    }, SHA-256 { $hash }
cli-verified = { $welds ->
        [one] { $welds } weld
       *[other] { $welds } welds
    }, { $files ->
        [one] { $files } file
       *[other] { $files } files
    } as recorded, { $entries ->
        [one] { $entries } audit entry
       *[other] { $entries } audit entries
    }: in order
cli-verified-problems = { $welds ->
        [one] { $welds } weld
       *[other] { $welds } welds
    }, { $files ->
        [one] { $files } file
       *[other] { $files } files
    } as recorded, { $entries ->
        [one] { $entries } audit entry
       *[other] { $entries } audit entries
    }: not in order
    .cause = The library, a file or the audit log differs from its hashes, or a crash left a trace unfinished.
    .cure = Run `seamwright records recover` if a problem says so; restore changed files from a backup.
cli-problem = problem: { $problem }

# Position of the work in the machine.
cli-place-more-points = more points, spread over the touched features, or another --method
cli-place-side-unknown = the side on which the probe touched a single point is not known
    .cause = Three single points do not show on which side of the surface the ball of the probe was.
    .cure = Touch the three points with a pointed tip, or choose `--method best-fit` or `plane-line-point`.
cli-place-radius-with-three-points = 0 with three-point, or another --method
cli-place-undetermined = the points do not determine the position of the part
    .cause = The fit gave no finite position, because points coincide, lie on a line or are far from the job's position.
    .cure = Touch more points spread over the part; give the job a rough offset if it is more than 200 mm off.
cli-place-no-seam = the program has no seam whose surfaces could have been touched
    .cause = The file is a program of points without `[seam]`, so it describes no surfaces.
    .cure = Use the job, or `--method three-point`, `plane-line-point`.
cli-place-no-nozzle = the seam has no nozzle, so it has no run-out
    .cause = The method `chuck` measures the tube of a nozzle or web; this seam has none.
    .cure = Choose `--method best-fit` or `plane-line-point`.
cli-place-nozzle = [seam.nozzle], or another --method
cli-place-no-redundancy = there are no more points than unknowns: nothing would show a bad one
    .cause = The fit has as many unknowns as points, so all residuals are 0.
    .cure = Touch at least one more point.
cli-place-radius-unknown = the points do not determine the radius: the nominal one is used
    .cause = The points cover too little of the tube to separate its radius from its position.
    .cure = Touch six or more points all round, at two heights.
cli-place-radius-off = the radius is { $deviation } off the nominal one: check the tube and the probe
    .cause = The measured radius differs by more than `--largest-mm`: another tube, a wrong `--probe-radius-mm`, or points beside the tube.
    .cure = Measure the tube and the ball of the probe, then correct the job or the option.
cli-place-no-rotary-axis = the machine has no rotary axis about the nozzle's nominal axis: the run-out refers to the nominal axis
    .cause = No rotary axis of the machine turns about the axis of the nozzle as placed in the job.
    .cure = Correct `[placement]`, if the part turns on a rotary axis.
cli-place-unchangeable = { $file }: cannot be changed: { $why }
    .cause = The file is not valid TOML, or its `offsets` is not a table.
    .cure = Correct the file, or write the printed offset into it by hand.
cli-place-touch-again = a residual is larger than { $max }: touch the points again; the sides show which one is off. If the part is no better, allow more with --largest-mm
    .cause = The three sides measured differ from the nominal ones; one point was touched elsewhere or the part is distorted.
    .cure = Clean the three sides and touch them again; if the part is no better, raise `--largest-mm`.
cli-place-touch-again-round = a residual is larger than { $max }: touch the points with the largest residuals again, and check whether the tube is round. If the part is no better, allow more with --largest-mm
    .cause = Points around the tube do not lie on one cylinder within the limit. The tube is out of round, dirty, or a point is beside it.
    .cure = Touch the points with the largest residuals again; if the tube is out of round, raise `--largest-mm`.
cli-place-touch-again-features = a residual is larger than { $max }: touch the points with the largest residuals again; check their features, the probe radius, and whether the part is near its place in the job. If the part is no better, allow more with --largest-mm
    .cause = Touched points do not lie on the nominal surfaces or points within the limit of `--largest-mm`.
    .cure = Check feature and probe radius of the points with the largest residuals, and touch them again.
cli-label-method = method
cli-label-offset = offset
cli-label-residuals = residuals
cli-label-sides = sides
cli-label-run-out = run-out
cli-label-tilt = tilt
cli-label-uncertainty = uncertainty
cli-label-free = not seen
cli-label-warning = warning
cli-place-method = { $method }, { $points ->
        [one] { $points } point
       *[other] { $points } points
    }
cli-place-offset = { $name }: { $offset }
cli-place-residuals = { $rms } RMS, { $max } largest
cli-place-sides = 1-2 { $first }, 2-3 { $second }, 3-1 { $third } longer than nominal
cli-place-run-out = { $eccentricity } { $vector } at { $at } mm
cli-place-run-out-radius = { $run-out }, radius { $deviation }
cli-place-tilt = { $angle } towards { $direction }
cli-place-uncertainty = { $xyz } mm, { $turn } degrees about x, y, z at { $at } mm
cli-place-free = { $motion }: left as the job has it
    .cause = Touches on these surfaces do not change with this motion, like the rotation of a tube about its axis.
    .cure = Touch a surface that this motion displaces, or align the part by a mark.
cli-place-moved = moved { $vector } mm
cli-place-turned = turned { $angle } about { $axis }, then moved { $vector } mm
cli-place-column-line = line
cli-place-column-feature = feature
cli-place-column-residual = residual_mm
cli-place-outlier = outlier
    .cause = The residual is more than three standard deviations off, estimated from the median; the point still counts.
    .cure = Touch this point again, or remove its line.
cli-place-not-accepted = not accepted: { $cure }
    .cause = A residual exceeds `--largest-mm`, 1 mm if missing, so nothing was written.
    .cure = Touch the points with the largest residuals again, or raise `--largest-mm` if the part is no better.
cli-place-for-job = # for the job file, `offset` at its top
cli-at-line = { $file }:{ $line }: { $fault }
    .cause = This line of the table is invalid, for the reason that follows.
    .cure = Correct the line, or remove it.
cli-no-column = there is no column `{ $column }` in `{ $header }`
    .cause = The header line has neither this column nor those of the other forms, often because of semicolons or tabs.
    .cure = Name the columns as listed, separated by commas.
cli-touched-header = a header line with { $columns }, or the machine's axes { $axes }
cli-touched-feature-column = a column feature with { $features }
cli-touched-nominal-columns = columns { $columns } with each point's nominal position in the part's frame
cli-touched-unknown-feature = feature = `{ $feature }` is not known to this method
    .cause = The column `feature` names a surface that this `--method` does not use.
    .cure = Correct the name in this line, or choose the method for which the points were touched.
cli-touched-not-a-number = { $column } = `{ $value }` is not a number that fits here
    .cause = The cell is empty, a text, not finite, or beyond 10,000,000 mm.
    .cure = Correct the line; use a decimal dot.
cli-finite-up-to = a finite number up to { $max }

# Tuning of the axes.
cli-tune-heading = tuning of { $machine }: open loop of each position loop, measured while the axis moves
cli-tune-axis = axis
cli-tune-velocity-loop = vel loop
cli-tune-notches = notches
cli-tune-resonance = resonance
cli-tune-crossover = crossover
cli-tune-bandwidth = bandwidth
cli-tune-gain-margin = gain m.
cli-tune-phase-margin = phase m.
cli-tune-following = following
cli-tune-load = load
cli-tune-counts = counts
cli-label-not-tuned = not tuned
cli-label-assumed = assumed
cli-tune-refused = { $axis }: { $why }
cli-tune-assumed = { $axis }: the machine file describes no drive
    .cause = The machine file has no `[drives.AXIS]` for this axis, so a usual drive was tuned.
    .cure = Add `[drives.AXIS]` with the data of the drive and tune again.
cli-tune-bode = Position loop of axis { $axis }, measured at { $speed }

# Registers of devices, kinematics.
cli-io-no-device = machine `{ $machine }` has no device with registers
    .cause = The verb prints registers of Modbus devices; the machine file has no `[devices.NAME.modbus]`.
    .cure = Give the machine file of the cell, not the supplied machine.
cli-io-machine = a machine file with [devices.NAME.modbus]
cli-no-such-head = there is no such head
    .cause = The machine has no `[[heads]]` of this name; a machine with `[torch]` has one head and needs no `--head`.
    .cure = Give one of the allowed names to `--head`, or leave the option out on a machine with one head.
cli-pose-out-of-reach = no axis positions reach the pose
    .cause = The point lies outside the ranges of the axes, or the direction needs a rotary axis beyond its range.
    .cure = Move the point, or check `range_mm`, `range_deg` and `tip_mm` in the machine file.

# The joint in images.
cli-image-whole-file = a whole PNG, JPEG or PNM file
cli-image-size = { $width } x { $height } pixels
    .cause = The image has less than 16 pixels on a side, or another size than `size_px` of the sensor.
    .cure = Use the uncropped image of the sensor in full size.
cli-image-at-least = at least { $min } pixels to a side
cli-image-saturated = the image is saturated, all white
    .cause = At least 99.9 % of the pixels have the maximum value.
    .cure = Close the aperture, shorten the exposure, or remove reflections.
cli-image-exposure = an exposure that leaves the metal grey: less light, time or gain
cli-finite-numbers = { $n ->
        [one] { $n } finite number
       *[other] { $n } finite numbers
    }, separated by commas
cli-joint-zone = left < right within 0 to { $right }, top < bottom within 0 to { $bottom }
cli-outside-zone = outside the detection zone
    .cause = The point of `--start` lies outside of `--zone-px`.
    .cure = Choose a point inside of `--zone-px` for `--start`, or enlarge the zone.
cli-outside-image = outside the image
    .cause = The point of `--start` lies outside of the image; x counts to the right and y down, from 0.
    .cure = Read the pixel of the joint in an image viewer, and give it to `--start` as x,y.
cli-joint-start = x from { $left } to { $right }, y from { $top } to { $bottom }
cli-joint-none-at-start = no joint at the start: try another --start, --direction-deg or --width-px
    .cause = No dark line of the expected width and direction begins near the start.
    .cure = Open the image, read the pixel of the joint, and give `--start` and `--direction-deg` from x towards y.
cli-stripe-neither = neither an image nor text
    .cause = The file is not PNG, JPEG, PNM, and not UTF-8 text.
    .cure = Convert the image, or export the profile as CSV.
cli-stripe-formats = PNG, JPEG or PNM, or CSV with the columns y_mm,z_mm
cli-not-a-position = not a position
    .cause = The cell is a text, or beyond 10,000,000 mm.
    .cure = Write a number, or leave the cell empty for a missing point.
cli-stripe-position = a number within 1e7 mm of 0, or nothing where it is missing
cli-stripe-profile-in-mm = a profile is in mm already
    .cause = A CSV profile needs no conversion from pixels and has no picture to draw on.
    .cure = Leave out `--machine`, `--mm-per-px` and `--overlay`.
cli-stripe-image-options = --machine, --mm-per-px and --overlay with an image
cli-stripe-sensor-size = { $width } x { $height }, the sensor's
cli-stripe-no-sensors = the machine has none: [sensors.NAME]
cli-stripe-no-such-sensor = { $machine } has no such sensor
    .cause = The machine file has no `[sensors.NAME]` of the name in `--sensor`.
    .cure = Give one of the listed names.
cli-stripe-sees-none = this sensor sees no stripe
    .cause = The sensor has `kind = "camera"`, so it sees a picture without a laser stripe.
    .cure = Choose another `--sensor`.
cli-stripe-kind = a sensor of kind = "stripe"
cli-stripe-hint = hint: upside down the joint is there: turn the image by 180 degrees or mirror it, so that up is away from the plates
    .cause = The image or profile is mirrored or upside down: plates must be below, with up away from them.
    .cure = Turn the image or change the sign of the column `z_mm`.
cli-scan-at = at s = { $s }: { $why }
cli-scan-no-profile = no profile
cli-scan-kind = profiles do not show the sizes of this groove
    .cause = Upright walls and touching round parts are seen edge-on: no profile shows where they are.
    .cure = Measure these joints by hand, or single profiles with `seamwright vision stripe`.
cli-scan-needs-scale = an image needs a map from pixels to mm
cli-scan-scales = --machine and --sensor, or --mm-per-px
cli-scan-mirrored = the profiles show the joint the other way round
    .cause = Most profiles fit the mirrored joint much better.
    .cure = y must run from the second part to the first; with `--mirrored` it runs the other way.
cli-scan-with-mirrored = with --mirrored
cli-scan-without-mirrored = without --mirrored
cli-scan-same-position = another row has this position
cli-scan-one-profile = one profile a position
cli-scan-beside-seam = the position is { $distance } beside the seam
cli-scan-not-measured = no profile shows the joint from s = { $from } to { $to }: more than { $bridge }
    .cause = The groove may change between two measured profiles. Over more than `--bridge-mm` it is not taken as linear.
    .cure = Measure there again, or raise `--bridge-mm` if the groove is even there.
cli-stripe-no-joint = no joint: { $why }
    .cause = The stripe is missing or interrupted, or has no shape of the kind in `--joint`.
    .cure = Look at the image; check `--joint`, the exposure and reflections.
cli-stripe-unsure = confidence { $confidence } is below { $min }, so it is not to be followed
    .cause = Noise, reflections or a flat shape make the joint point uncertain.
    .cure = Reduce exposure or stray light, clean the plates, and check `--joint`.
cli-stripe-unsure-because = confidence { $confidence } is below { $min }, so it is not to be followed: { $why }
    .cause = The joint point was found, but the named feature contradicts the kind in `--joint` or is too weak.
    .cure = Check `--joint` and `--thickness-mm`, the exposure, and reflections.

# Step and direction pulses.
cli-pulses-not-vcd = not a value change dump
    .cause = The option `-o` writes a value change dump for GTKWave.
    .cure = Give a name ending in `.vcd`; for CSV leave out `-o` and redirect standard output.
cli-pulses-vcd = a name that ends in .vcd
cli-pulses-no-stepper = no axis of { $machine } has a stepper
    .cause = The machine file has no `[drives.AXIS.stepper]`.
    .cure = Add the stepper of each axis to the machine file.
cli-pulses-machine = a machine with [drives.<axis>.stepper] in its file, like torch-5axis
cli-pulses-ticks = a period of { $period } is { $ticks } ticks of { $tick }
    .cause = Set-points must fall on ticks of the pulse timer, 1 to 100,000,000,000 of them in a period.
    .cure = Choose `--tick-ns` so that it divides `--period-ms`, such as 100 ns and 1 ms.
cli-pulses-whole-ticks = a whole number of ticks, up to 1e11; see --period-ms and --tick-ns
cli-pulses-lost-steps = the motor of axis { $axis } loses { $steps ->
        [one] { $steps } full step
       *[other] { $steps } full steps
    }, from t = { $time } on
    .cause = The torque that the motion needs exceeds the curve `torque_rpm`, `torque_n_m` of the motor at that speed.
    .cure = Lower speed or acceleration of the axis in the machine file, or describe a stronger motor.
cli-cure-lost-steps = a lower speed or acceleration, or a motor with more torque
cli-pulses-too-fast = { $asked } pulses a second are required with { $microsteps ->
        [one] { $microsteps } microstep
       *[other] { $microsteps } microsteps
    }, { $max } is the maximum
    .cause = With the chosen microsteps one period needs more pulses than `max_pulse_hz` and `min_pulse_us` allow at this tick.
    .cure = Lower `speed_mm_s` in the job or the maximum speed of the axis, or add a coarser setting to `microsteps`.
cli-cure-pulses-too-fast = a lower speed, fewer `microsteps` or a higher `max_pulse_hz` of the driver, or a finer --tick-ns
cli-cure-pulses-crowded = a longer --period-ms, a lower acceleration, or a lower speed
cli-cure-fewer-microsteps = fewer microsteps
cli-pulses-crowded = axis { $axis } at t = { $time }: { $fault }
    .cause = The pulses of one period do not fit between the direction and pulse times of the driver.
    .cure = Lower the acceleration of the axis, or give a longer `--period-ms`; check `direction_setup_us` and `direction_hold_us`.
cli-pulses-crowded-in-transfer = axis { $axis } at t = { $time }, in a transfer move: { $fault }
    .cause = In a transfer move the pulses of one period do not fit between the times of the driver.
    .cure = Lower maximum speed or acceleration of the axis in the machine file.
cli-pulses-bound-frequency = more would need over { $max } pulses a second
    .cause = The next finer setting exceeds `max_pulse_hz`, or `min_pulse_us` at this tick, in the fastest period of the motion.
    .cure = Lower the speed, or raise `max_pulse_hz` if the driver permits it.
cli-pulses-bound-driver = the driver has no finer setting
    .cause = The largest of `microsteps` gives a longer pulse than `resolution_mm` or `resolution_deg`.
    .cure = Choose a driver with finer settings, change the gear, or accept a coarser resolution.
cli-pulses-bound-none = even these are too fast
    .cause = Even the smallest of `microsteps` exceeds the pulse frequency of the driver in the fastest period.
    .cure = Lower the speed of the axis, or choose a faster driver.
cli-pulses-resolution = axis { $axis } moves { $resolution } a pulse with { $microsteps ->
        [one] { $microsteps } microstep
       *[other] { $microsteps } microsteps
    }, { $wanted } is wanted: { $why }
    .cause = The key `resolution_mm` or `resolution_deg` of the stepper is not met, for the reason that follows.
    .cure = Change the gear, add finer `microsteps`, or accept a coarser resolution.
cli-pulses-note = note (resolution): { $note }
cli-pulses-by-resolution = resolution
cli-pulses-by-frequency = frequency
cli-pulses-by-driver = driver
cli-pulses-axis = { $axis }: { $microsteps } microsteps by { $bound }, { $resolution } a pulse ({ $wanted } wanted), { $pulses } pulses from { $start } to { $end } steps, up to { $highest } of { $max }
cli-pulses-axis-loses = { $axis }, motor loses { $steps ->
        [one] { $steps } full step
       *[other] { $steps } full steps
    }
    .cause = The motor model needs more torque than its curve has at that speed.
    .cure = Lower speed or acceleration of the axis, or describe a stronger motor.
cli-pulses-heading = { $job }: { $time } in periods of { $period }, ticks of { $tick }
cli-pulses-without-stepper = without stepper, so without pulses: { $axes }
    .cause = These axes have no `[drives.AXIS.stepper]` in the machine file.
    .cure = If one of them has a step drive, add `[drives.AXIS.stepper]` to the machine file.

# Set-points under an operator's commands.
cli-command-time = a number of seconds from { $from } to { $to }: rows come in the order of time
cli-not-a-command = not a command
    .cause = The column `command` has a word that is not a command.
    .cure = Correct the word in the column `command`, or delete the line.
cli-command-value = does not go with { $command }
    .cause = The value is missing, outside the allowed range, or stands beside a command without value.
    .cure = Correct the value, or leave it empty for a command without value.
cli-command-without-speed = cannot go on at an override of 0
    .cause = The override before is below 0.1 %, at which the run is held.
    .cure = Insert a row `override` with a higher value before this command.
cli-command-override-first = an override of at least { $min } before it
cli-command-percent = 0 to 150 percent
cli-command-step = a finite number of mm, at least 0.001
cli-command-nothing = nothing
cli-motion-coarse = { $parts } periods of { $period }
    .cause = Coarse set-points must lie on fine ones, so the ratio must be a whole number.
    .cure = Choose `--coarse-ms` as a multiple of `--period-ms`.
cli-motion-whole-multiple = a whole multiple of the period, up to 1e6 times
cli-motion-period-with-commands = not allowed with --commands
    .cause = A run under commands is that of a cell, which has a period of 0.25 to 4 ms.
    .cure = Choose `--period-ms` from 0.25 to 4, or leave out `--commands`.
cli-motion-held = note (held): pass { $pass } waits at s = { $at }, and no command is left
    .cause = The last command held the run, or its override is below 0.1 %; the table ends there.
    .cure = Add a row `resume`, or `override` and `resume`, to the file of `--commands`.
cli-cure-commands-or-speed = change the commands, or the job's speed

# Points followed at constant speed.
cli-follow-too-few = fewer than two different points
    .cause = All rows of the file are the same point, or there is only one.
    .cure = Give a file with two or more different points.
cli-follow-done = { $time }, { $way }, fastest { $speed }
cli-follow-slower = the { $speed } asked for are never reached: the axes' limits or the way's length forbid it
    .cause = The limits of an axis or of the tip bind everywhere, or the way is too short to reach the speed.
    .cure = Lower `--speed-mm-s`, allow larger `--corner-mm`, or check the limits in the machine file.
cli-follow-stops = { $stops ->
        [one] { $stops } stop
       *[other] { $stops } stops
    } to plan ahead: a longer --window-s would avoid them
    .cause = The window is too short to see a stop in time at this speed.
    .cure = Enlarge `--window-s`.
cli-no-length = has no length
    .cause = The three components of the direction in this line are 0.
    .cure = Give a direction, or remove these columns if the torch points straight down.
cli-direction = a direction
cli-follow-too-near = { $first } comes too near to { $second }
    .cause = Shapes of the machine come nearer than `least_mm` in `[clearance]` before this point.
    .cure = Move the points away, insert points around the obstacle, or correct the shapes.
cli-follow-something-too-near = something comes too near
    .cause = Bodies come nearer than `least_mm` in `[clearance]`, without one nearest pair.
    .cure = Check the shapes of the machine file with `seamwright machine check`.
cli-follow-point = the point in line { $line }: { $why }
    .cause = This point is out of reach, outside the range of an axis, or too near to an obstacle.
    .cure = Correct this line, or move the work.
cli-cure-follow = change the points, the placement of the work or the machine; the motion ends before this point

# A running cell.
cli-run-rights = note: the cycle runs without real-time rights: { $footing }
    .cause = The system did not grant the cycle real-time priority, locked memory or its processor.
    .cure = Grant them as `docs/how-to/latency.md` describes, before welding metal.
cli-run-missed = note: { $missed } of { $cycles ->
        [one] { $cycles } cycle
       *[other] { $cycles } cycles
    } of { $period } were missed: the worst began { $late } late
    .cause = The system did not run the cycle in time: no real-time rights, other load, or power saving of the processor.
    .cure = Measure with `seamwright machine latency`; choose `--cpu`, or enlarge `servo_period_ms` in the machine file.
cli-run-missed-cure = better: a longer servo_period_ms, or less that runs beside; `seamwright machine latency` measures it
cli-run-nothing-left = there is nothing left to weld
    .cause = The position in `--from` is at or beyond the end of the pass, or the pass does not exist.
    .cure = Give the next pass with 0, or a smaller path length.
cli-run-passes-up-to = passes 1 to { $passes }
cli-run-up-to-in-pass = up to { $length } in that pass
cli-run-outputs-unsafe = device `{ $device }`: its outputs are not confirmed to be safe: { $why }
    .cause = The device did not answer when its outputs were set to their safe states: cable, power or network failed.
    .cure = Switch it off by hand, then check the cable and `seamwright machine io MACHINE`.
cli-run-not-asked = it was not asked
    .cause = The cell ended before the order for safe outputs reached the device.
    .cure = Treat its outputs as on until you have looked at the machine.
cli-run-look-at-once = check at once whether arc and gas are off
cli-two-lines =
    { $first }
    { "   " }{ $second }
cli-run-hangs = ended by { $cause }, but the cycle does not come to its end within { $time }: check that arc, gas and drives are off
    .cause = The cycle waits in a device and did not end within 15 s of the signal; the program was ended nevertheless.
    .cure = Press the emergency stop if anything is on; report the device and its last lines.
cli-run-record-later = the record is made whole by the next `seamwright records recover`
cli-run-state = mode { $mode }, pass { $pass }, s { $s }, inputs { $inputs }
cli-run-cleared = { $alarm } has gone
    .cause = The condition of the alarm has gone; it still needs the order `acknowledge`.
    .cure = Enter `acknowledge`.
cli-run-refused = { $order }: { $why }
    .cause = The cell was not in a mode or state for this order.
    .cure = Do what the reason names, or insert `wait ready` before the order.
cli-run-alarm = { $alarm }: { $reaction }; { $action }
    .cause = The alarm was raised outside of a pass; its reaction and the operator action follow.
    .cure = Do the action named last, then give the orders `acknowledge` and, after a fault, `reset`.
cli-run-alarm-at = { $alarm } at { $at }: { $reaction }; { $action }
    .cause = The alarm was raised in a pass at this path length; its reaction and the operator action follow.
    .cure = Do the action named last, then give the orders `acknowledge` and, after a fault, `reset`.
cli-run-alarm-action = { $alarm }: { $action }
cli-run-stopped-by = the program was stopped by { $cause }; everything is off
    .cause = A signal of the system, such as Ctrl+C, SIGTERM or a shutdown, ended the weld.
    .cure = Continue the weld with `--from` if it was interrupted.
cli-run-stopped-by-alarm = the program was stopped by an alarm: { $alarm }
    .cause = The first alarm that held or stopped the weld is named with its operator action.
    .cure = Remove its cause, inspect the end of the bead, and continue with `--from PASS,MM`.
cli-run-trace-lost = the trace cannot be written
    .cause = The disk of `-o` or `--data` is full or fails, so rows of the simulation are lost.
    .cure = Free disk space or choose another folder, then simulate again.
cli-fault-never-came = note: { $fault } never came: everything was over at { $time }
    .cause = The time of `--fault` is later than the end of the run.
    .cure = Choose an earlier time, in s from switching on.
cli-order-number = `{ $word }` in `{ $line }`; allowed is a number from { $min } to { $max }
    .cause = The number of the order is missing, is not a number, or outside its range.
    .cure = Enter the order again with a number in the allowed range.
cli-order-mode = there is no mode `{ $mode }`; allowed are { $modes }, N s, N mm
    .cause = The word behind `wait` is neither a mode nor a time or length.
    .cure = Enter `wait` with an allowed mode, `wait N s` or `wait N mm`.
cli-order-unknown = `{ $line }` is not an order; allowed are { $orders }, override PERCENT, wait MODE, wait N s, wait N mm, ?
    .cause = The line is misspelled, or has capitals or additional words.
    .cure = Write one order per line; lines that start with # are comments.

# Teaching by camera.
cli-teach-frames = a folder, tcp://HOST:PORT, simulated
cli-teach-source = either --frames or --semi-manual
    .cause = The verb needs frames of a camera or points of the operator.
    .cure = Add `--frames simulated`, a folder or an address, or `--semi-manual POINTS.csv`.
cli-teach-not-here = not allowed here
    .cause = The option belongs to another source of frames than that of `--frames`.
    .cure = Remove the option, or choose that source.
cli-teach-only-with = only with { $source }
cli-teach-new-frames = frames that are not in a folder already
cli-teach-beside = this is the name of a file beside the program
    .cause = Report, drawing and picture are written beside the program, with this name.
    .cure = Give `-o` a name that ends in `.toml`.
cli-teach-file = a file, as taught.toml
cli-teach-camera-machine = a machine with a camera: [sensors.<name>] with kind = "camera" in its file
cli-teach-no-such-camera = { $machine } has no such camera
    .cause = The machine has no sensor with `kind = "camera"` of the name in `--sensor`.
    .cure = Give one of the listed names.
cli-teach-no-camera = { $machine } has no camera
    .cause = The machine file has no `[sensors.NAME]` with `kind = "camera"`.
    .cure = Add the camera with its calibration, or teach with `--semi-manual POINTS.csv`.
cli-teach-several-cameras = { $machine } has several cameras: choose one with --sensor
    .cause = The machine file has two or more sensors with `kind = "camera"`.
    .cure = Add `--sensor NAME` with one of the cameras of the machine file.
cli-teach-numbers = { $n ->
        [one] { $n } number
       *[other] { $n } numbers
    }
    .cause = The options `--start` and `--direction` need three numbers each.
    .cure = Give x,y,z, separated by commas and without spaces.
cli-teach-three-numbers = three, X,Y,Z
cli-teach-start-off-seam = the start { $start } is not near the nominal seam
    .cause = The start is more than 15 mm from the nominal seam of the job, or not a number.
    .cure = Correct `--start`, in the work frame; if the part lies elsewhere, place it with `seamwright machine place`.
cli-teach-start-near = --start within 15 mm of it, in the machine's work frame
cli-direction-without-length = the direction has no length
    .cause = All three components of the direction are 0.
    .cure = Give a rough direction of the joint or torch, of any length.
cli-three-finite-numbers = three finite numbers that are not all 0
cli-teach-answers = X,Y,Z (mm, work frame) or X,Y,Z,DX,DY,DZ to go on there, in that direction; end: the joint ends here; stop: give up
cli-teach-lost = lost after { $way }, at { $point }: { $why }
    .cause = Confidence was too low: a long tack, dirt, bad light, or the joint left the detection zone.
    .cure = Look at the picture named below, then answer with a point, `end` or `stop`.
cli-teach-seen = last frame: { $file }
cli-teach-bad-answer = not three or six numbers, nor end or stop
    .cause = The answer is not three or six numbers separated by commas, nor one of the two words.
    .cure = Answer with x,y,z, with x,y,z and a direction, with `end` or with `stop`.
cli-teach-point-off-seam = the point is not within 15 mm of the nominal seam
    .cause = The given point is farther from the nominal seam than 15 mm, often by another frame than the work frame.
    .cure = Read the position of the tip in the work frame and answer again.
cli-teach-by-points = the nominal seam brought to the operator's points
cli-teach-done = { $ended } after { $way }, { $frames ->
        [one] { $frames } frame
       *[other] { $frames } frames
    } in { $time }; { $points ->
        [one] { $points } point
       *[other] { $points } points
    }
cli-teach-closes = closes within { $gap }
cli-teach-asked = asked: { $why }
    .cause = The joint was lost there, and the operator answered.
cli-teach-spline = a spline of { $pieces ->
        [one] { $pieces } piece
       *[other] { $pieces } pieces
    }
cli-teach-lines-and-arcs = { $lines ->
        [one] { $lines } line
       *[other] { $lines } lines
    } and { $arcs ->
        [one] { $arcs } arc
       *[other] { $arcs } arcs
    }
cli-teach-program = program: { $curves } within { $error } of the taught line
cli-teach-program-of-raw = program: { $curves } within { $error } of the taught line, { $raw } of every raw point
cli-teach-truth = truly { $across } RMS beside the seam, at most { $across-max }; { $height } RMS above or below it, at most { $height-max }
cli-teach-no-address = not an address
    .cause = The text behind `tcp://` has no host, or no port from 1 to 65535.
    .cure = Write `tcp://HOST:PORT`.
cli-teach-address = tcp://HOST:PORT, a port from 1 to 65535
cli-teach-no-frames = no frames
    .cause = The folder has no frame in `frames.csv`, or the sender closed the connection before the first frame.
    .cure = Check the folder, or the program that sends the frames.
cli-teach-not-a-camera = sensor { $sensor } is not a camera
    .cause = Frames are simulated for a camera with a map of heights only.
    .cure = Choose a sensor with `kind = "camera"` in `--sensor`.
cli-teach-not-three-numbers = not three numbers
    .cause = The option `--distortion` needs shift, turn and bend.
    .cure = Give shift in mm, turn in degrees and bend in mm, separated by commas.
cli-teach-distortion = SHIFT,TURN,BEND in mm, degrees, mm
cli-teach-shift = shift { $value }
    .cause = The shift of a simulated part is 0 to 20 mm.
    .cure = Choose a first number of `--distortion` from 0 to 20.
cli-teach-turn = turn { $value }
    .cause = The turn of a simulated part is 0 to 10 degrees.
    .cure = Choose a second number of `--distortion` from 0 to 10.
cli-teach-bend = bend { $value }
    .cause = The bend of a simulated part is 0 to 20 mm.
    .cure = Choose a third number of `--distortion` from 0 to 20.
cli-teach-tack = FROM,TO in mm along the seam, FROM before TO

# The server.
cli-serve-data = --data { $folder }: cannot be made: { $why }
    .cause = The data folder is write-protected, or its path contains a file.
    .cure = Give `--data DIR` with a folder that you may write.
cli-serve-no-job = there is no such job
    .cause = Neither a file, nor a job of the data folder, nor an example has the name in `--job`.
    .cure = Correct the path or the name.
cli-serve-jobs = a file, a job in { $folder }, or an example: { $examples }
cli-serve-other-job = the data folder has another job of that name
    .cause = Files of `--job` are copied to the data folder; a job with other text is there under this name.
    .cure = Rename the file, or give the name alone to use the job there.
cli-serve-other-name = a file of another name, or --job { $name } from there
cli-serve-no-token = there is no token in the file
    .cause = The file is empty, its token is short, or it has spaces or more than one line.
    .cure = Write a random token to it: `openssl rand -hex 32 > monitor-token`.
cli-serve-tokens = one line of at least { $min } letters, digits and signs

# Acceptance benchmarks.
cli-bench-not-shipped = machine { $machine } does not ship
    .cause = The benchmark needs this supplied machine, and the build does not contain it.
    .cure = Report it with the version of the program.
cli-bench-half-ring = the half-ring cannot be planned
    .cause = The benchmark's own weld was not planned, by a fault of this build.
    .cure = Report it with the version of the program.

# Drawings.
cli-draw-points-as-spans = Points as lines and arcs
cli-draw-seen-along = Seen along { $axis }
cli-draw-points = points
cli-draw-lines = lines
cli-draw-arcs = arcs
cli-draw-ends = ends
cli-draw-spline = spline
cli-draw-taught-line = The taught line
cli-draw-from-nominal = From the nominal seam
cli-draw-distance = distance
cli-draw-across = across
cli-draw-above = above
cli-draw-tolerance = tolerance
cli-draw-raw-from-program = Raw points from the program
cli-draw-raw-points = raw points
cli-draw-frame-against-frame = Frame against frame
cli-draw-overlap = overlap
cli-draw-confidence-title = Confidence
cli-draw-confidence = confidence
cli-draw-interpolation = Interpolation methods side by side
cli-draw-true-curve = true curve
cli-draw-paths = Paths, seen along z
cli-draw-close = Pulse by pulse, around the middle of the path
cli-draw-steps = Straight distance travelled in each period, against speed x period
cli-draw-angle = angle travelled
cli-draw-deviation = deviation
cli-draw-max-distance = Maximum distance of the points from the true curve

# Results of recorded welds.
cli-result-running = running
    .cause = The weld runs, or a crash left its record open.
    .cure = If no program runs on the data folder, run `seamwright records recover`.
cli-result-good = good
cli-result-deviating = deviating
    .cause = The weld was completed beyond its tolerance, held by an alarm, or with a heat input outside of its procedure.
    .cure = Look at values and positions with `seamwright records show ID`.
cli-result-stopped = stopped
    .cause = The operator, an alarm or a signal stopped the weld before its end.
    .cure = Inspect the end of the bead, then continue with `seamwright run JOB --from PASS,MM`.
cli-result-interrupted = interrupted
    .cause = The program or the power failed during the weld.
    .cure = Inspect the end of the bead before continuing with `--from PASS,MM`.

# Units in the table of tuning.
cli-tune-hz = Hz
cli-tune-per-s = 1/s
cli-tune-ms = ms
cli-tune-db = dB

# STOP.
cli-stopped = stopped in cycle { $cycle }
cli-no-cell-runs = no cell runs there
    .cause = No process listens on the socket of STOP in this data folder.
    .cure = Name the data folder with which the panel was started.
cli-data-of-running-cell = the data folder of a running panel
cli-stop-unanswered = the stop is not acknowledged: { $why }
    .cause = The cycle stands, or the process of the cell does not answer.
    .cure = Use the emergency stop of the machine, then check that arc, gas and drives are off.

# Machine files of arms.
cli-arm-note = note: { $note }
cli-arm-next = check it: seamwright machine check { $file }
cli-arm-home = the home position of axis `{ $axis }` is outside its range
    .cause = Every axis starts and ends at its home position, so that it must be reachable.
    .cure = Give a position inside the range.
cli-no-configurations = the machine is not an arm whose configurations have names
    .cause = Configurations have names on arms with six or seven axes and a closed form of the inverse.
    .cure = Leave out the option; `seamwright machine check` names the form of the inverse.
cli-no-arm-angle = the machine is not a seven-axis arm
    .cause = Only arms with spherical shoulder and wrist and seven axes have an arm angle.
    .cure = Leave out the option.
# Programs of robots.
cli-not-for-robots = not for robots
    .cause = Robot languages give poses of the tool and its speed. They have no levels, feed words or block types.
    .cure = Leave the option out.
cli-options-of-robots = --tolerance-mm, --speed-percent, --retract-mm
cli-servo-not-here = only URScript has a stream of set-points
    .cause = The other languages get poses and speeds; their controls make the set-points.
    .cure = Leave the option out, or post with `--dialect urscript`.
cli-servo-language = together with --dialect urscript
cli-servo-alone = it belongs to a stream of set-points, and --servo-ms is missing
    .cause = Look-ahead time and gain are settings of servoj.
    .cure = Add `--servo-ms 8`, or leave the option out.
cli-servo-with-period = together with --servo-ms
cli-servo-period = { $step } to { $max } in steps of { $step }

# Search for placements of the work.
cli-progress-reach = searching placements
cli-label-judged = judged
cli-label-budget = budget
cli-label-present = present
cli-label-best = best
cli-label-entry = entry
cli-reach-judged = placements: { $placements }, weldable: { $weldable }
cli-reach-cut-off = { $budget } ended the search: --budget gives it more
cli-reach-interrupted = Ctrl-C ended the search: the result is the best placement so far
cli-label-moved = moved
cli-reach-moves-work = the work, in the work frame
cli-reach-moves-base = the machine's base, in its own frame
cli-reach-base-entry = { $file }: { $key } = { $entry }
cli-reach-supplied = the machine is part of the program, and there is no file to write to
    .cause = The base is moved in the machine file, and a supplied machine has none.
    .cure = Write the machine to machines/NAME.toml beside the job, which then uses it; or enter the displacement yourself.
cli-reach-own-machine = a machine file; `seamwright machine show { $name } > machines/{ $name }.toml` beside the job makes one
cli-reach-at = x { $x }, y { $y }, z { $z } from the present placement, turned { $turn }
cli-reach-margin = axis { $axis } keeps { $margin } of its range free (pass { $pass }, s = { $s })
cli-reach-free = weldable; no axis has a range
cli-reach-fails = not weldable at pass { $pass }, s = { $s }: { $reason }
cli-reach-not-planned = { $placement }: the planner refuses it: { $reason }
    .cause = The axes reach the whole seam there, but clearance, a transfer move or the speed profile fails.
    .cure = No action is needed: the next best placement is tried.
cli-reach-none = no placement is weldable and planned
    .cause = No judged placement passes all checks; the reasons are in reach.html with -o.
    .cure = Widen --x, --y, --z or --turn, or give more cells or a larger --budget.
cli-reach-entry = { $key }: move_mm = { $vector }, angle { $angle }
cli-reach-form = FROM,TO or FROM,TO,CELLS with FROM up to TO and 1 or more cells, such as -300,300,9
cli-reach-ends = ends from { $min } to { $max }
cli-reach-reversed = the range starts above its end
    .cause = The first number of the range is larger than the second.
    .cure = Swap the two numbers.
cli-reach-too-many-cells = the grid has { $cells } places
    .cause = The numbers of cells of --x, --y, --z and --turn are multiplied.
    .cure = Give fewer cells; the local search refines the best ones.
cli-reach-cells-allowed = up to { $max } places in all
cli-reach-no-file = there is no such file to write to
    .cause = An example is part of the program, so the placement cannot be written into it.
    .cure = Copy the example with `seamwright examples NAME > job.toml`, and give that file.
cli-reach-job-file = a job or program file; `seamwright examples NAME > job.toml` makes one
cli-reach-changed = { $file } has changed during the search: nothing was written
    .cause = Somebody else has written the file since it was read.
    .cure = Run the command again.
cli-label-planned = planned
cli-reach-planned = axis { $axis } keeps { $margin } of its range free in the plan
cli-allowed-spark = an address of Spark Connect, as sc://host:15002
