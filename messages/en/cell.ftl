# Modes.
cell-mode-off = off
cell-mode-idle = idle
cell-mode-homing = homing
cell-mode-ready = ready
cell-mode-jog = jog
cell-mode-teach = teach
cell-mode-dry-run = dry run
cell-mode-weld = weld
cell-mode-hold = hold
cell-mode-fault = fault

# Events that change the mode.
cell-trigger-switch-on = switch on
cell-trigger-switch-off = switch off
cell-trigger-home = home
cell-trigger-homed = homed
cell-trigger-jog = jog
cell-trigger-teach = teach
cell-trigger-dry-run = dry run
cell-trigger-weld = weld
cell-trigger-hold = hold
cell-trigger-finish = finish
cell-trigger-abort = abort
cell-trigger-trip = trip
cell-trigger-reset = reset
cell-refused = `{ $event }` is not possible in mode { $mode }: allowed in { $modes }

# Commands.
cell-ask-switch-on = switch on
cell-ask-switch-off = switch off
cell-ask-home = home
cell-ask-home-axis = home axis
cell-ask-start-jog = start jog
cell-ask-start-teach = start teach
cell-ask-jog = jog
cell-ask-start-dry-run = start dry run
cell-ask-arm = arm
cell-ask-start-weld = start weld
cell-ask-hold = hold
cell-ask-resume = resume
cell-ask-reverse = reverse
cell-ask-stop = stop
cell-ask-override = override { $override }
cell-ask-reset = reset
cell-ask-acknowledge = acknowledge
cell-ask-acknowledge-one = acknowledge one
cell-ask-why = why
cell-ask-load = load
cell-ask-quit = quit

# Missing permissives.
cell-missing-rest = the axes are still moving: wait a moment
cell-missing-references = the reference of { $axes } is unknown: home first
cell-missing-homes-first = axis { $axis } must go home first, as set in the machine file
cell-missing-power = the drives have no power yet: wait a moment
cell-missing-answer = no answer from the { $device }: check cable and device
cell-missing-interlock = interlock `{ $interlock }` is not met
cell-missing-acknowledgement = alarm `{ $alarm }`: { $action }, then acknowledge
cell-missing-arming = the process is not armed: arm, then start within a minute
cell-missing-source = the process source is not ready
cell-missing-start = axis { $axis } is not at the start of the approach
cell-missing-program = no program is loaded
cell-missing-value = the number is out of range
cell-missing-motion = this motion is not possible now
cell-device-drives = drives
cell-device-inputs = inputs
cell-device-source = process source

# Events and notes of a weld.
cell-event-mode = { $from } -> { $to }
cell-event-missed =
    { $n ->
        [one] { $n } cycle
       *[other] { $n } cycles
    } missed, up to { $gap } at once
cell-event-pass-ends = pass { $pass } ends at { $at }
cell-event-pass-left = pass { $pass } was left, welded up to { $at }
cell-event-without-rights = without real-time rights: { $rights }
cell-right-priority = priority
cell-right-memory = locked memory
cell-right-cpu = CPU
cell-note-stopped = stopped by: { $cause }
cell-note-left = left in pass { $pass }, welded up to { $at }
cell-note-not-finished = not welded to its end
cell-note-nothing-welded = nothing was welded
cell-shutdown-signal = signal { $signal }
cell-shutdown-panic = a fault of the program (panic)
cell-shutdown-end = the end of the program

# Real-time rights.
cell-realtime-granted = real-time priority, memory locked
cell-realtime-degraded = degraded: { $missing }
cell-realtime-no-priority = no real-time priority ({ $why }; allow it with `ulimit -r` or CAP_SYS_NICE)
cell-realtime-memory-not-locked = memory not locked ({ $why }; allow it with `ulimit -l` or CAP_IPC_LOCK)
cell-realtime-no-cpu = not on the requested CPU ({ $why })
cell-no-such-cpu = CPU { $cpu } does not exist
cell-only-on-linux = only on Linux
cell-cycle-failed = the cycle failed (a fault of the program); its devices were ordered off

# A cell that cannot run.
cell-invalid-drive = drive of axis { $axis }: { $why }
cell-too-many-process-values =
    the program has { $n ->
        [one] { $n } process value
       *[other] { $n } process values
    }
       allowed: up to { $max }
cell-no-stepper = the axis has no stepper
cell-microsteps-too-coarse = the driver's finest microstep setting does not meet the resolution

# Tracking.
cell-no-cross-slide = head { $head } of machine { $machine } has no cross slide: two linear axes of its own
cell-no-stripe-sensor = machine { $machine } has no stripe sensor for head { $head }: tracking needs one ahead of the torch; allowed is [sensors.<name>] with kind = "stripe" in the machine file
cell-sensor-not-leading = sensor { $sensor } of { $machine } does not lead head { $head } along this pass: its look-ahead distance varies from { $min } to { $max }; allowed is a distance constant within a tenth, as of a sensor that turns with the seam
cell-off-line-two-torches = pass `{ $pass }` weaves with two torches: a displaced part can be simulated only if the torch follows the seam line; allowed is a pass without blended corners, woven by one torch if at all, or no distortion file
cell-off-line-beam = pass `{ $pass }` weaves with a beam: a displaced part can be simulated only if the beam follows the seam line; allowed is a pass without blended corners and without weaving, or no distortion file
cell-off-line-blends = pass `{ $pass }` has blended corners: a displaced part can be simulated only if the torch follows the seam line; allowed is a pass without blended corners, woven by one torch if at all, or no distortion file
cell-slides-aside = the cross slides of head { $head } of machine { $machine } cannot move the torch to all sides of this seam; allowed are two [[heads.steps]] whose `move` lies across the seam, in different directions
cell-no-beam-camera = machine { $machine } has no camera that looks through its beam; allowed is [sensors.<name>] with kind = "camera" in the machine file
cell-no-replay = machine { $machine } cannot replay stored deviations: it has no deflected beam; allowed are machines with torch.deflection in their file
cell-gun-not-carried = the axes cannot carry the gun to the side: { $why }
cell-alarm-with-cause = { $alarm }: { $cause }
cell-alarm-of-head = { $alarm }, head { $head }
cell-joint-not-seen = the joint was not seen before the weld
cell-sighting-cut-short = the move to see the start is cut short
cell-sighting-length = { $clear } of { $wanted }, { $why }
cell-end-of-reach = the axes are at the end of their reach
cell-too-close = { $a } and { $b } come too close to each other
cell-something-too-close = two bodies come too close to each other

# Distortion file.
cell-empty-range = empty range: from { $from } to { $to }
cell-allowed-range = `to` greater than `from`
cell-no-head = this head does not exist
cell-allowed-heads = 1 or 2
cell-empty-displacement = the displacement is empty
cell-turn-missing = the axis of this angle is missing
cell-allowed-turn = turn = [x, y, z], the axis

# Teaching.
cell-camera-out-of-reach = the axes cannot bring the camera there: { $remaining } remain
cell-no-points = there are no points; give at least one on the joint
cell-point-off-seam = point { $point } is farther than { $max } from the nominal seam
cell-points-coincide = points { $first } and { $second } are at the same position on the seam

# Frames of cameras.
cell-frame-io = { $what }: { $why }
cell-frames-missing =
    { $what }: { $why }
       allowed: an existing folder of frames with frames.csv in it
cell-frame-list =
    { $file }:{ $line }: { $why }
       allowed: { $allowed }
cell-frame-header =
    frame { $frame }: invalid { $field }: { $found }
       allowed: { $allowed }
cell-frame-magic = first bytes
cell-frame-version = version
cell-frame-depth = pixel depth
cell-frame-width = width
cell-frame-height = height
cell-frame-axes = number of axes
cell-frame-reserved = bytes 18 to 23
cell-frame-work-height = height of the work
cell-frame-position = axis position
cell-frame-depth-allowed = 8 or 16 bits per pixel
cell-frame-position-allowed = a finite number of mm or degrees
cell-frame-work-height-allowed = a finite number of mm, or NaN
cell-frame-machine-axes = { $n }, the machine's axes
cell-frame-header-truncated = frame { $frame }: the stream ends after { $found } of the { $wanted } of its header
cell-frame-axes-truncated = frame { $frame }: the stream ends after { $found } of the { $wanted } of its axis positions
cell-frame-pixels-truncated = frame { $frame }: the stream ends after { $found } of the { $wanted } of its pixels
cell-frame-time = frame { $frame }: invalid time { $time }; times must be finite and increase
cell-frame-time-order = frame { $frame }: invalid time { $time } after a frame at { $before }; times must be finite and increase
cell-frame-shape = frame { $frame }: { $why }
cell-frame-late = frame { $frame } did not come in time
cell-frame-size = the frame has { $size } pixels; allowed: the sensor's size_px, { $allowed }
cell-camera-closed = the camera has closed the connection
cell-no-frame-in-time = no frame came in time
cell-image-format = unknown image format; allowed: PNG, JPEG, PNM
cell-image-broken = unreadable image: { $why }
cell-image-depth = the image has { $bits } bits per channel; allowed: 8 or 16
cell-jpeg-truncated = the JPEG file ends before its picture does
cell-pixel-count = the number of pixels does not match the picture
cell-file-too-large = the file has { $size }; allowed are up to { $max }
cell-list-no-text = not a text file
cell-list-columns = the columns are { $columns }
cell-list-columns-allowed = { $columns }, optionally { $optional }
cell-list-cells =
    { $n ->
        [one] { $n } cell
       *[other] { $n } cells
    }
cell-list-cells-allowed = { $n }, one per column
cell-list-file = invalid file name "{ $name }"
cell-list-file-allowed = the name of an image in this folder
cell-list-number = { $column }: "{ $value }" is not a number
cell-list-time = t_s: { $time } is not after { $before } in the row before
cell-list-time-allowed = increasing times
cell-list-empty = the list has no frames
cell-list-empty-allowed = one row per frame

# Devices on Modbus.
cell-modbus-unreachable = device `{ $device }` at { $address }: { $why }
cell-modbus-no-register = device `{ $device }` has no register that sets the job's process value `{ $value }`
cell-modbus-refused = the device refuses { $what } ({ $code })
cell-modbus-registers = { $table } { $from } to { $to }
cell-modbus-named = { $registers }: { $names }
cell-modbus-cells = { $table } { $at }: { $asked } cells requested, { $answered } received
cell-modbus-no-connection = no connection within { $time }
cell-modbus-no-answer = no answer within { $time }
cell-modbus-no-heartbeat = no heart-beat for { $time }
cell-modbus-closed = the connection was closed
cell-modbus-not-connected = not connected
cell-modbus-second-connection = { $why }, on a second connection; if the device accepts only one: connections = 1

# LinuxCNC's HAL.
cell-hal-not-installed =
    LinuxCNC is not installed: program `{ $program }` is missing
       allowed: Debian's package linuxcnc-uspace (apt install linuxcnc-uspace)
cell-hal-running =
    LinuxCNC's HAL is already running: { $owner }
       allowed: one at a time; end the other, or clear it away with `halrun -U`
cell-hal-of-seamwright = that of Seamwright, process { $process }
cell-hal-foreign = one of another program
cell-hal-refused = LinuxCNC rejects { $file }: { $why }
cell-hal-own-commands = our own commands
cell-hal-too-slow = it takes longer than { $time }; { $said }
cell-hal-no-start = LinuxCNC's HAL does not start: { $why }
cell-hal-no-samples = LinuxCNC's HAL does not run, it sends no samples: { $why }
cell-hal-output = { $sampler }; { $keeper }
cell-hal-no-output = no output
cell-hal-not-run = LinuxCNC's HAL cannot run: { $why }
cell-hal-refuses-root = HAL refuses root, and user `nobody` is missing; run as another user
cell-hal-no-pipes = its streams have no pipes
cell-hal-program-ended = { $program } has ended
cell-hal-no-data = its real-time program sends nothing
cell-hal-ended = LinuxCNC's HAL has ended: { $why }; it is being restarted without power
cell-hal-runs-again = LinuxCNC's HAL runs again: acknowledge, reset, switch on, home
cell-hal-retried =
    { $error }
       trying again every { $time }

# Fault injection.
cell-fault-form = invalid fault; allowed is DEVICE:KIND@TIME[+DURATION], like drives:silent@12.5 or inputs:disconnect@3+0.5
cell-fault-no-device = device `{ $name }` does not exist; allowed are { $names }
cell-fault-no-kind = fault `{ $name }` does not exist; allowed are { $names }
cell-fault-no-time = invalid time `{ $text }`; allowed is a number of seconds, 0 or greater
cell-campaign-summary =
    { $kept } of { $all } cases end as required ({ $faults } in fault); process off after at most { $cycles ->
        [one] { $cycles } cycle
       *[other] { $cycles } cycles
    }; longest stopping distance { $stop }, at most { $bound } of its bound
cell-violation = { $time }: { $what }
cell-violation-no-restart = the cell cannot be switched on again
cell-violation-no-rest = the axes do not come to rest
cell-violation-process-on = the process is on in mode { $mode }
cell-violation-process-after-alarm = the process is on after the alarm
cell-violation-stop = the stopping distance is { $length }; { $max } is allowed
cell-violation-jump = axis { $axis }: the set-point is { $distance } from the actual position
cell-violation-limits = axis { $axis }: speed { $speed }, acceleration { $acceleration } beyond the limits
