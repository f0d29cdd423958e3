# Notes and errors of every command.
cli-more-time = { $cure }; more time: --time-limit S
cli-verb-renamed = note: `seamwright { $former }` is now `seamwright { $present }`
cli-folder-not-written = { $folder }: cannot be written: { $why }
cli-unknown-language = note: there is no language `{ $language }`, so this is English; available: { $known }
cli-error = error: { $error }
cli-option = { $option }: { $fault }
cli-not-allowed = not allowed
cli-with-cure =
    { $failure }
    { "   " }{ $cure }
cli-range = { $from } to { $to }
cli-plus = +{ $value }
cli-wrote = wrote { $files }
cli-no-such-axis = there is no such axis
cli-cycle-ended-early = the thread of the cycle ended early
cli-jobs-unreadable = not every job could be read
cli-at-least-two = at least two

# Progress.
cli-progress-planning = planning
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
cli-summary-transfers = { $time }, home to home { $total }
cli-summary-speed = { $from } to { $to } planned, { $asked-from } to { $asked-to } asked
cli-summary-time = { $travel } travel, { $arc } arc on, { $total } in all
cli-summary-passes = { $passes }, { $length } in all
cli-summary-clearance = clearance { $clearance }
cli-summary-arc-energy = arc energy { $energy }
cli-summary-heat-input = heat input { $heat }
cli-clearance-between = { $distance }: { $first } and { $second }
cli-clearance-none = { $distance }: nothing watched comes nearer
cli-summary-not-welded = nothing of it (simulated)
cli-summary-path-error = { $max } maximum, { $rms } RMS (simulated)
cli-summary-tip-speed = { $from } to { $to }, RMS deviation { $rms } (simulated)
cli-summary-too-short = the weld is too short to judge
cli-summary-following-error = following error { $error }, RMS { $rms }
cli-summary-tracked = { $p99 } from the joint for 99 % of the weld, { $max } at most; untracked { $plain-p99 } and { $plain-max }
cli-summary-untracked = { $p99 } from the joint for 99 % of the weld, { $max } at most; not tracked
cli-summary-stopped = stopped at { $at }
cli-summary-alarm = at { $at }: { $alarm }
cli-summary-beam = deflected by up to { $deflection } of { $range }, gun carried by { $carried }; beam away { $away } of the time, { $longest } at most
cli-summary-beam-replayed = replayed: { $beam }
cli-summary-beam-fit = { $beam }; 90 % of { $points ->
        [one] { $points } point
       *[other] { $points } points
    } within { $distance } of the stored deviations

# Positions along the seam.
cli-no-such-angle = this seam has no such angle
cli-angle-not-welded = this angle is not on the welded part
cli-too-many-points = too many points
cli-at-least-step = at least { $step }: { $points } points
cli-section-no-joint = the job has no joint, so there is no section
cli-section-joint = a [joint] with its preparation

# Lists.
cli-list-machine = machine
cli-list-axes = axes
cli-list-example = example
cli-list-procedure = procedure
cli-list-process = process
cli-list-title = title
cli-no-machine = { $name }: there is no such machine
cli-no-example = { $name }: there is no such example
cli-no-procedure = { $name }: there is no such procedure

# Lateness of the cycle.
cli-latency-cycles = { $cycles ->
        [one] { $cycles } cycle
       *[other] { $cycles } cycles
    } of { $period }, { $missed } missed
cli-latency-late = { $part } begin at most { $late } late

# Moves from point to point.
cli-motions-up-to-two-hours = motions of up to two hours
cli-move-set-points = { $count } set-points
cli-longer-period = up to { $max }, with a longer period
cli-move-done = { $time }, { $count ->
        [one] { $count } set-point
       *[other] { $count } set-points
    }; { $clearance }
cli-axis-value-of = AXIS=VALUE with axis { $axes }
cli-any-number-of = any number of { $unit }
cli-axis-twice = axis { $axis } is given twice
cli-each-axis-once = each axis once
cli-axis-position-not-a-number = the position of axis { $axis } is not a number
cli-axis-outside = outside the range of axis { $axis }
cli-move-no-shapes = no collision check: the machine file has no shapes that could meet
cli-move-min-distance = minimum distance { $distance } at { $time }: { $first } and { $second }
cli-move-clear = nothing comes nearer than { $distance }
cli-move-impossible = the move cannot be made as asked: { $findings ->
        [one] { $findings } finding
       *[other] { $findings } findings
    }
cli-move-times = t = { $from } to { $to }
cli-move-in-parts = go round the obstacle, in several moves

# Part programs.
cli-as-far-as-axes-reach = a distance that the axes reach
cli-post-differs = the part program differs from the plan, and is not written:
cli-too-coarse = too coarse
cli-finer-than-decimals = finer than the words' six decimals
cli-no-such-blocks = this control has no such blocks
cli-interpolations = pvt, spline1, linear for PMAC; linear, poly for Sinumerik; linear for LinuxCNC and grblHAL
cli-too-far = too far
cli-up-to-pass-tolerance = up to { $max }, the tolerance of a pass
cli-import = { $file }: { $dialect } program, { $moves ->
        [one] { $moves } move
       *[other] { $moves } moves
    }, { $time } by its feeds; passes: { $passes }
cli-import-left-out = left out: { $place }: { $words }: { $why }

# Points to lines and arcs, and interpolators.
cli-cure-line-or-column = correct the line, or remove a column that is not an axis from the file
cli-cure-line-in-mm = correct the line; coordinates are in mm
cli-cure-line-per-point = one line of numbers per point, below the header line
cli-too-far-away = too far away
cli-points-found = { $points ->
        [one] { $points } point
       *[other] { $points } points
    }
cli-reduced = { $points ->
        [one] { $points } point
       *[other] { $points } points
    }; lines: { $lines }, arcs: { $arcs }; maximum error { $error }; minimum number of spans: { $min }
cli-not-a-point = not a point
cli-point-form = x,y in mm, like { $example }
cli-too-many-to-draw = { $method } has more than { $max } points to draw
cli-coarser-or-no-drawing = a coarser pulse or period, or no drawing

# Edits of a program file.
cli-edit-no-operation = no operation is given, or several
cli-edit-operations = one operation, undo, redo, history, or --script OPS.json; see `seamwright edit --help`
cli-edit-new-history = note: { $file } was changed by hand since its last edit: a new history begins
cli-edit-of-operation = operation { $number }: { $why }
cli-edit-job = { $file }: this is a job; edits are of programs
cli-edit-plan-first = plan it first: seamwright plan { $file }; then edit { $program }
cli-edit-by-hand = { $file }: the file was changed by hand since its last edit
cli-edit-force = --force, which goes as far as it can
cli-edit-nothing-to-undo = { $file }: there is nothing to be undone
cli-edit-nothing-to-redo = { $file }: there is nothing to be redone
cli-edit-see-history = see `history`
cli-edit-undone = undone: { $edit }
cli-edit-redone = redone: { $edit }
cli-edit-unchanged = { $edit } (nothing changed)
cli-edit-undone-entry = { $edit } (undone)
cli-edit-by-hand-since = the file was changed by hand since
cli-edit-none = no edits
cli-edit-value = one number, or two for a ramp
cli-edit-see-schema = see `seamwright schema operation`

# Records of welds.
cli-no-data-folder = there is no data folder
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
cli-problem = problem: { $problem }

# Position of the work in the machine.
cli-place-more-points = more points, spread over the touched features, or another --method
cli-place-side-unknown = the side on which the probe touched a single point is not known
cli-place-radius-with-three-points = 0 with three-point, or another --method
cli-place-undetermined = the points do not determine the position of the part
cli-place-no-seam = the program has no seam whose surfaces could have been touched
cli-place-no-nozzle = the seam has no nozzle, so it has no run-out
cli-place-nozzle = [seam.nozzle], or another --method
cli-place-no-redundancy = there are no more points than unknowns: nothing would show a bad one
cli-place-radius-unknown = the points do not determine the radius: the nominal one is used
cli-place-radius-off = the radius is { $deviation } off the nominal one: check the tube and the probe
cli-place-no-rotary-axis = the machine has no rotary axis about the nozzle's nominal axis: the run-out refers to the nominal axis
cli-place-unchangeable = { $file }: cannot be changed: { $why }
cli-place-touch-again = a residual is larger than { $max }: touch the points again; the sides show which one is off. If the part is no better, allow more with --largest-mm
cli-place-touch-again-round = a residual is larger than { $max }: touch the points with the largest residuals again, and check whether the tube is round. If the part is no better, allow more with --largest-mm
cli-place-touch-again-features = a residual is larger than { $max }: touch the points with the largest residuals again; check their features, the probe radius, and whether the part is near its place in the job. If the part is no better, allow more with --largest-mm
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
cli-place-moved = moved { $vector } mm
cli-place-turned = turned { $angle } about { $axis }, then moved { $vector } mm
cli-place-column-line = line
cli-place-column-feature = feature
cli-place-column-residual = residual_mm
cli-place-outlier = outlier
cli-place-not-accepted = not accepted: { $cure }
cli-place-for-job = # for the job file, `offset` at its top
cli-at-line = { $file }:{ $line }: { $fault }
cli-no-column = there is no column `{ $column }` in `{ $header }`
cli-touched-header = a header line with { $columns }, or the machine's axes { $axes }
cli-touched-feature-column = a column feature with { $features }
cli-touched-nominal-columns = columns { $columns } with each point's nominal position in the part's frame
cli-touched-unknown-feature = feature = `{ $feature }` is not known to this method
cli-touched-not-a-number = { $column } = `{ $value }` is not a number that fits here
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
cli-tune-bode = Position loop of axis { $axis }, measured at { $speed }

# Registers of devices, kinematics.
cli-io-no-device = machine `{ $machine }` has no device with registers
cli-io-machine = a machine file with [devices.NAME.modbus]
cli-no-such-head = there is no such head
cli-pose-out-of-reach = no axis positions reach the pose

# The joint in images.
cli-image-whole-file = a whole PNG, JPEG or PNM file
cli-image-size = { $width } x { $height } pixels
cli-image-at-least = at least { $min } pixels to a side
cli-image-saturated = the image is saturated, all white
cli-image-exposure = an exposure that leaves the metal grey: less light, time or gain
cli-finite-numbers = { $n ->
        [one] { $n } finite number
       *[other] { $n } finite numbers
    }, separated by commas
cli-joint-zone = left < right within 0 to { $right }, top < bottom within 0 to { $bottom }
cli-outside-zone = outside the detection zone
cli-outside-image = outside the image
cli-joint-start = x from { $left } to { $right }, y from { $top } to { $bottom }
cli-joint-none-at-start = no joint at the start: try another --start, --direction-deg or --width-px
cli-stripe-neither = neither an image nor text
cli-stripe-formats = PNG, JPEG or PNM, or CSV with the columns y_mm,z_mm
cli-not-a-position = not a position
cli-stripe-position = a number within 1e7 mm of 0, or nothing where it is missing
cli-stripe-profile-in-mm = a profile is in mm already
cli-stripe-image-options = --machine, --mm-per-px and --overlay with an image
cli-stripe-sensor-size = { $width } x { $height }, the sensor's
cli-stripe-no-sensors = the machine has none: [sensors.NAME]
cli-stripe-no-such-sensor = { $machine } has no such sensor
cli-stripe-sees-none = this sensor sees no stripe
cli-stripe-kind = a sensor of kind = "stripe"
cli-stripe-hint = hint: upside down the joint is there: turn the image by 180 degrees or mirror it, so that up is away from the plates
cli-stripe-no-joint = no joint: { $why }
cli-stripe-unsure = confidence { $confidence } is below { $min }, so it is not to be followed
cli-stripe-unsure-because = confidence { $confidence } is below { $min }, so it is not to be followed: { $why }

# Step and direction pulses.
cli-pulses-not-vcd = not a value change dump
cli-pulses-vcd = a name that ends in .vcd
cli-pulses-no-stepper = no axis of { $machine } has a stepper
cli-pulses-machine = a machine with [drives.<axis>.stepper] in its file, like torch-5axis
cli-pulses-ticks = a period of { $period } is { $ticks } ticks of { $tick }
cli-pulses-whole-ticks = a whole number of ticks, up to 1e11; see --period-ms and --tick-ns
cli-pulses-lost-steps = the motor of axis { $axis } loses { $steps ->
        [one] { $steps } full step
       *[other] { $steps } full steps
    }, from t = { $time } on
cli-cure-lost-steps = a lower speed or acceleration, or a motor with more torque
cli-pulses-too-fast = { $asked } pulses a second are required with { $microsteps ->
        [one] { $microsteps } microstep
       *[other] { $microsteps } microsteps
    }, { $max } is the maximum
cli-cure-pulses-too-fast = a lower speed, fewer `microsteps` or a higher `max_pulse_hz` of the driver, or a finer --tick-ns
cli-cure-pulses-crowded = a longer --period-ms, a lower acceleration, or a lower speed
cli-cure-fewer-microsteps = fewer microsteps
cli-pulses-crowded = axis { $axis } at t = { $time }: { $fault }
cli-pulses-crowded-in-transfer = axis { $axis } at t = { $time }, in a transfer move: { $fault }
cli-pulses-bound-frequency = more would need over { $max } pulses a second
cli-pulses-bound-driver = the driver has no finer setting
cli-pulses-bound-none = even these are too fast
cli-pulses-resolution = axis { $axis } moves { $resolution } a pulse with { $microsteps ->
        [one] { $microsteps } microstep
       *[other] { $microsteps } microsteps
    }, { $wanted } is wanted: { $why }
cli-pulses-note = note (resolution): { $note }
cli-pulses-by-resolution = resolution
cli-pulses-by-frequency = frequency
cli-pulses-by-driver = driver
cli-pulses-axis = { $axis }: { $microsteps } microsteps by { $bound }, { $resolution } a pulse ({ $wanted } wanted), { $pulses } pulses from { $start } to { $end } steps, up to { $highest } of { $max }
cli-pulses-axis-loses = { $axis }, motor loses { $steps ->
        [one] { $steps } full step
       *[other] { $steps } full steps
    }
cli-pulses-heading = { $job }: { $time } in periods of { $period }, ticks of { $tick }
cli-pulses-without-stepper = without stepper, so without pulses: { $axes }

# Set-points under an operator's commands.
cli-command-time = a number of seconds from { $from } to { $to }: rows come in the order of time
cli-not-a-command = not a command
cli-command-value = does not go with { $command }
cli-command-without-speed = cannot go on at an override of 0
cli-command-override-first = an override of at least { $min } before it
cli-command-percent = 0 to 150 percent
cli-command-step = a finite number of mm, at least 0.001
cli-command-nothing = nothing
cli-motion-coarse = { $parts } periods of { $period }
cli-motion-whole-multiple = a whole multiple of the period, up to 1e6 times
cli-motion-period-with-commands = not allowed with --commands
cli-motion-held = note (held): pass { $pass } waits at s = { $at }, and no command is left
cli-cure-commands-or-speed = change the commands, or the job's speed

# Points followed at constant speed.
cli-follow-too-few = fewer than two different points
cli-follow-done = { $time }, { $way }, fastest { $speed }
cli-follow-slower = the { $speed } asked for are never reached: the axes' limits or the way's length forbid it
cli-follow-stops = { $stops ->
        [one] { $stops } stop
       *[other] { $stops } stops
    } to plan ahead: a longer --window-s would avoid them
cli-no-length = has no length
cli-direction = a direction
cli-follow-too-near = { $first } comes too near to { $second }
cli-follow-something-too-near = something comes too near
cli-follow-point = the point in line { $line }: { $why }
cli-cure-follow = change the points, the placement of the work or the machine; the motion ends before this point

# A running cell.
cli-run-rights = note: the cycle runs without real-time rights: { $footing }
cli-run-missed = note: { $missed } of { $cycles ->
        [one] { $cycles } cycle
       *[other] { $cycles } cycles
    } of { $period } were missed: the worst began { $late } late
cli-run-missed-cure = better: a longer servo_period_ms, or less that runs beside; `seamwright machine latency` measures it
cli-run-nothing-left = there is nothing left to weld
cli-run-passes-up-to = passes 1 to { $passes }
cli-run-up-to-in-pass = up to { $length } in that pass
cli-run-outputs-unsafe = device `{ $device }`: its outputs are not confirmed to be safe: { $why }
cli-run-not-asked = it was not asked
cli-run-look-at-once = check at once whether arc and gas are off
cli-two-lines =
    { $first }
    { "   " }{ $second }
cli-run-hangs = ended by { $cause }, but the cycle does not come to its end within { $time }: check that arc, gas and drives are off
cli-run-record-later = the record is made whole by the next `seamwright records recover`
cli-run-state = mode { $mode }, pass { $pass }, s { $s }, inputs { $inputs }
cli-run-cleared = { $alarm } has gone
cli-run-refused = { $order }: { $why }
cli-run-alarm = { $alarm }: { $reaction }; { $action }
cli-run-alarm-at = { $alarm } at { $at }: { $reaction }; { $action }
cli-run-alarm-action = { $alarm }: { $action }
cli-run-stopped-by = the program was stopped by { $cause }; everything is off
cli-run-stopped-by-alarm = the program was stopped by an alarm: { $alarm }
cli-run-trace-lost = the trace cannot be written
cli-fault-never-came = note: { $fault } never came: everything was over at { $time }
cli-order-number = `{ $word }` in `{ $line }`; allowed is a number from { $min } to { $max }
cli-order-mode = there is no mode `{ $mode }`; allowed are { $modes }, N s, N mm
cli-order-unknown = `{ $line }` is not an order; allowed are { $orders }, override PERCENT, wait MODE, wait N s, wait N mm, ?

# Teaching by camera.
cli-teach-frames = a folder, tcp://HOST:PORT, simulated
cli-teach-source = either --frames or --semi-manual
cli-teach-not-here = not allowed here
cli-teach-only-with = only with { $source }
cli-teach-new-frames = frames that are not in a folder already
cli-teach-beside = this is the name of a file beside the program
cli-teach-file = a file, as taught.toml
cli-teach-camera-machine = a machine with a camera: [sensors.<name>] with kind = "camera" in its file
cli-teach-no-such-camera = { $machine } has no such camera
cli-teach-no-camera = { $machine } has no camera
cli-teach-several-cameras = { $machine } has several cameras: choose one with --sensor
cli-teach-numbers = { $n ->
        [one] { $n } number
       *[other] { $n } numbers
    }
cli-teach-three-numbers = three, X,Y,Z
cli-teach-start-off-seam = the start { $start } is not near the nominal seam
cli-teach-start-near = --start within 15 mm of it, in the machine's work frame
cli-direction-without-length = the direction has no length
cli-three-finite-numbers = three finite numbers that are not all 0
cli-teach-answers = X,Y,Z (mm, work frame) or X,Y,Z,DX,DY,DZ to go on there, in that direction; end: the joint ends here; stop: give up
cli-teach-lost = lost after { $way }, at { $point }: { $why }
cli-teach-seen = last frame: { $file }
cli-teach-bad-answer = not three or six numbers, nor end or stop
cli-teach-point-off-seam = the point is not within 15 mm of the nominal seam
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
cli-teach-address = tcp://HOST:PORT, a port from 1 to 65535
cli-teach-no-frames = no frames
cli-teach-not-a-camera = sensor { $sensor } is not a camera
cli-teach-not-three-numbers = not three numbers
cli-teach-distortion = SHIFT,TURN,BEND in mm, degrees, mm
cli-teach-shift = shift { $value }
cli-teach-turn = turn { $value }
cli-teach-bend = bend { $value }
cli-teach-tack = FROM,TO in mm along the seam, FROM before TO

# The server.
cli-serve-data = --data { $folder }: cannot be made: { $why }
cli-serve-no-job = there is no such job
cli-serve-jobs = a file, a job in { $folder }, or an example: { $examples }
cli-serve-other-job = the data folder has another job of that name
cli-serve-other-name = a file of another name, or --job { $name } from there

# Acceptance benchmarks.
cli-bench-not-shipped = machine { $machine } does not ship
cli-bench-half-ring = the half-ring cannot be planned

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
cli-result-good = good
cli-result-deviating = deviating
cli-result-stopped = stopped
cli-result-interrupted = interrupted

# Units in the table of tuning.
cli-tune-hz = Hz
cli-tune-per-s = 1/s
cli-tune-ms = ms
cli-tune-db = dB
