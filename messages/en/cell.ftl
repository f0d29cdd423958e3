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
    .cause = Each mode accepts only the events of its row in the table of modes.
    .cure = Bring the cell to one of the listed modes first: `on`, then `home`, then `dry`, or `arm` and `weld`. After a fault acknowledge, then `reset`.

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
    .cause = A program, a jog or a move of homing is not at rest, a program is held, or `quit` comes while the drives have power.
    .cure = Wait until the axes stand. End a held program with `stop`, and switch off before `quit`.
cell-missing-references = the reference of { $axes } is unknown: home first
    .cause = The drives report no reference of these axes: no homing yet, or an interrupted supply.
    .cure = Send `home`. If it fails, see alarm 8.
cell-missing-homes-first = axis { $axis } must go home first, as set in the machine file
    .cause = `home_order` of the machine file names that axis earlier, and it is more than 0.01 mm or rad from home.
    .cure = Send that axis home first, or all of them with `home`.
cell-missing-power = the drives have no power yet: wait a moment
    .cause = Power is not ordered, or the drives have not confirmed it yet. After 1 s without confirmation alarm 5 follows.
    .cure = Switch on and wait for the drives. If power does not come, check contactor and emergency stop.
cell-missing-answer = no answer from the { $device }: check cable and device
    .cause = The last report of the device is older than 0.1 s.
    .cure = Check its supply, cable and address. `seamwright machine io MACHINE` reads a Modbus device without a cell.
cell-missing-interlock = interlock `{ $interlock }` is not met
    .cause = The input of this entry of `[[interlocks]]` differs from its `is`. Motion needs the conditions of power too, the process needs all.
    .cure = Restore the condition and watch its input under Set-up, Inputs and outputs. If it is met, correct `is` or the register of the input.
cell-missing-acknowledgement = alarm `{ $alarm }`: { $action }, then acknowledge
    .cause = The alarm does more than report, and it is active or not acknowledged.
    .cure = Remove its cause and send `acknowledge`; in mode fault also `reset`.
cell-missing-arming = the process is not armed: arm, then start within a minute
    .cause = `arm` is missing or older than 60 s, or a start, a hold or another mode has ended it.
    .cure = Send `arm`, then `weld` or `resume` within a minute.
cell-missing-source = the process source is not ready
    .cause = The source reports not ready, or a fault code other than 0.
    .cure = Switch it on and read its fault code. Check the registers `ready` and `fault` of `[devices.NAME.modbus.reports]`.
cell-missing-start = axis { $axis } is not at the start of the approach
    .cause = The axis is more than 0.01 mm or rad from the first position of the approach, which usually is home.
    .cure = In the panel load the program again: its way starts at the present position. For `run` name the axis in `home_order` and send `home`.
cell-missing-program = no program is loaded
    .cause = Dry run and weld need a loaded job or program with at least one pass.
    .cure = Load a job on the page Weld. If it is refused, correct its findings first.
cell-missing-value = the number is out of range
    .cause = A feed override is outside of 0 to 100 %, or the machine has no axis of this number.
    .cure = Give an override from 0 to 100, or an axis of the machine file.
cell-missing-motion = this motion is not possible now
    .cause = `reverse` works only in a hold. `arm` does not work in the hold of a dry run.
    .cure = Hold the program first. To weld after a dry run end it with `stop`, then arm and start.
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
    .cause = The longest gap is 20 ms or more, or alarm 19 has come: other work or missing real-time rights delay the cycle.
    .cure = Measure with `seamwright machine latency` under the usual load, stop other programs and grant real-time rights.
cell-event-pass-ends = pass { $pass } ends at { $at }
cell-event-pass-left = pass { $pass } was left, welded up to { $at }
    .cause = A stop, an abort or a fault has ended the program in this pass.
    .cure = Inspect the end of the bead. Then continue with Continue pass in the panel, or with `run --from PASS,MM`.
cell-event-without-rights = without real-time rights: { $rights }
    .cause = The system refuses real-time priority, locked memory or the CPU of `--cpu`. Cycles may come late.
    .cure = Grant them with `ulimit -r` and `ulimit -l`, or with CAP_SYS_NICE and CAP_IPC_LOCK, and start again.
cell-right-priority = priority
cell-right-memory = locked memory
cell-right-cpu = CPU
cell-note-stopped = stopped by: { $cause }
    .cause = This alarm, signal or fault of the program held or ended the weld.
    .cure = Look the cause up on this page and remove it. Then inspect the weld and continue it from its position.
cell-note-left = left in pass { $pass }, welded up to { $at }
    .cause = The program ended before the end of this pass. The length is the part of the pass that is welded.
    .cure = Inspect and grind the end of the bead. Then continue with Continue pass in the panel, or with `run --from PASS,MM`.
cell-note-not-finished = not welded to its end
    .cause = The record was closed before the last pass ended, and without a position to continue from.
    .cure = Measure the welded length on the part. Then start there with `run --from PASS,MM`.
cell-note-nothing-welded = nothing was welded
    .cause = No pass has ended and none has a welded part: the orders ended too early, or an alarm came before the weld.
    .cure = Give `run` all orders: `on`, `home`, `wait ready`, `arm`, `weld`, `wait ready`.
cell-shutdown-signal = signal { $signal }
    .cause = A terminal, Ctrl-C, a service manager or a power supply has sent the signal. The cell stopped and switched off in order.
    .cure = Find its sender. Then start again and continue the weld from the reported position.
cell-shutdown-panic = a fault of the program (panic)
    .cause = A thread of the program failed. The cell stopped and switched off in order.
    .cure = Keep standard error and the record for a report. Then start again and continue the weld from the reported position.
cell-shutdown-end = the end of the program
cell-shutdown-cycle-stopped = the cycle stopped and does not come back
    .cause = For 1 s no cycle has run, while the rest of the program went on: a device's driver hangs, or the computer is overloaded.
    .cure = Check that arc, gas and drives are off. Keep standard error and the record for a report; then start again.

# Real-time rights.
cell-realtime-granted = real-time priority, memory locked
cell-realtime-degraded = degraded: { $missing }
    .cause = The system refuses at least one right to the thread of the cycle. Cycles may come late under load.
    .cure = Grant the named rights and start again. Check the result with `seamwright machine latency`.
cell-realtime-no-priority = no real-time priority ({ $why }; allow it with `ulimit -r` or CAP_SYS_NICE)
    .cause = The user may not run a thread under SCHED_FIFO at priority 80.
    .cure = Set `rtprio` to 80 or more for this user in /etc/security/limits.conf, and log in again.
cell-realtime-memory-not-locked = memory not locked ({ $why }; allow it with `ulimit -l` or CAP_IPC_LOCK)
    .cause = The user's limit of locked memory is smaller than the memory of the program.
    .cure = Set `memlock` to `unlimited` for this user in /etc/security/limits.conf, and log in again.
cell-realtime-no-cpu = not on the requested CPU ({ $why })
    .cause = The CPU of `--cpu` does not exist, is offline, or is not permitted to this process.
    .cure = Choose another CPU with `--cpu`. `lscpu` lists those online.
cell-no-such-cpu = CPU { $cpu } does not exist
    .cause = The number exceeds the CPUs that the operating system can name. CPUs count from 0.
    .cure = Give `--cpu` a number below the one that `nproc --all` prints.
cell-only-on-linux = only on Linux
    .cause = Priority, locked memory and the CPU of the cycle are requested on Linux only.
    .cure = Run real devices on a Linux computer. Simulation needs no such rights.
cell-cycle-failed = the cycle failed (a fault of the program); its devices were ordered off
    .cause = The thread of the cycle panicked. Its devices got the orders of a cell that is off.
    .cure = Check that arc and drives are off. Keep standard error for a report, then start again.

# A cell that cannot run.
cell-invalid-drive = drive of axis { $axis }: { $why }
    .cause = A value of `[drives.AXIS]` or its `stepper` is invalid, or no stable position loop follows from these values.
    .cure = Correct the named value. `seamwright machine tune MACHINE` finds gains that work.
cell-too-many-process-values =
    the program has { $n ->
        [one] { $n } process value
       *[other] { $n } process values
    }
       allowed: up to { $max }
    .cause = All passes together use more names of process values than a cell carries.
    .cure = Use fewer names in `[weld.process]` and in the `process` of passes.
cell-no-stepper = the axis has no stepper
    .cause = With `[devices.NAME.steps]` every axis of the machine needs a stepper.
    .cure = Add `[drives.AXIS.stepper]` for this axis, or remove `[devices.NAME.steps]`.
cell-microsteps-too-coarse = the driver's finest microstep setting does not meet the resolution
    .cause = At the largest number in `microsteps` a pulse is longer than `resolution_mm` or `resolution_deg`.
    .cure = Add a finer setting that the driver has, or raise the resolution key.

# Tracking.
cell-no-cross-slide = head { $head } of machine { $machine } has no cross slide: two linear axes of its own
    .cause = The pass has two heads, and one has fewer than two movable axes in its `steps`. Axes in `spare_axes.hold` do not count.
    .cure = Give the head two linear `[[heads.steps]]`, release them in `hold`, or use `--no-tracking`.
cell-no-stripe-sensor = machine { $machine } has no stripe sensor for head { $head }: tracking needs one ahead of the torch; allowed is [sensors.<name>] with kind = "stripe" in the machine file
    .cause = The machine has no deflected beam, so that tracking needs a stripe sensor, and its file has none.
    .cure = Add `[sensors.NAME]` with `map`, and with an `at` whose x leads the torch. Without a sensor use `--no-tracking`.
cell-sensor-not-leading = sensor { $sensor } of { $machine } does not lead head { $head } along this pass: its look-ahead distance varies from { $min } to { $max }; allowed is a distance constant within a tenth, as of a sensor that turns with the seam
    .cause = Along the pass the minimum is 0 or less, or below 90 % of the maximum. The sensor does not turn with the seam, or leads another head.
    .cure = Mount the sensor on a link that turns with the seam (`on`, `at`), or use `--no-tracking`.
cell-off-line-two-torches = pass `{ $pass }` weaves with two torches: a displaced part can be simulated only if the torch follows the seam line; allowed is a pass without blended corners, woven by one torch if at all, or no distortion file
    .cause = Deviations are measured from the seam line, and two weaving torches leave it.
    .cure = Remove `weave` from this pass, or start without `--distortion` and `--replay`.
cell-off-line-beam = pass `{ $pass }` weaves with a beam: a displaced part can be simulated only if the beam follows the seam line; allowed is a pass without blended corners and without weaving, or no distortion file
    .cause = Deviations are measured from the seam line, and a weaving beam leaves it.
    .cure = Remove `weave` from this pass, or start without `--distortion` and `--replay`.
cell-off-line-blends = pass `{ $pass }` has blended corners: a displaced part can be simulated only if the torch follows the seam line; allowed is a pass without blended corners, woven by one torch if at all, or no distortion file
    .cause = A `corner` with `blend_mm` lets the torch leave the seam line, from which deviations are measured.
    .cure = Set `corner` to `"stop"` or `"refuse"`, or start without `--distortion` and `--replay`.
cell-slides-aside = the cross slides of head { $head } of machine { $machine } cannot move the torch to all sides of this seam; allowed are two [[heads.steps]] whose `move` lies across the seam, in different directions
    .cause = Somewhere along the pass both slides move the torch nearly in one direction across the seam.
    .cure = Turn a `move` of the two `[[heads.steps]]`, or choose other positions of redundant axes in `[spare_axes]`.
cell-no-beam-camera = machine { $machine } has no camera that looks through its beam; allowed is [sensors.<name>] with kind = "camera" in the machine file
    .cause = The machine has `torch.deflection` but no camera, or the camera's `map` has no height 0.
    .cure = Add `[sensors.NAME]` with `kind = "camera"` and rows of `map.heights` that include `z_mm = 0`.
cell-no-replay = machine { $machine } cannot replay stored deviations: it has no deflected beam; allowed are machines with torch.deflection in their file
    .cause = Only a machine with `torch.deflection` stores and replays deviations.
    .cure = Leave `--replay` out. Other machines track with stripe sensors.
cell-gun-not-carried = the axes cannot carry the gun to the side: { $why }
    .cause = Beside the planned path the inverse kinematics has no axis positions for the corrected pose.
    .cure = Place the work farther from range ends and singular positions of the axes.
cell-alarm-with-cause = { $alarm }: { $cause }
cell-alarm-of-head = { $alarm }, head { $head }
cell-joint-not-seen = the joint was not seen before the weld
    .cause = While the beam looked at the start for 1.5 s, no frame showed a usable line: focus, contrast, a tack, or a displaced part.
    .cure = Check focus and clamping, or move `[start]` off the tack. Then acknowledge, arm and resume; the look is repeated.
cell-sighting-cut-short = the move to see the start is cut short
    .cause = Before a tracked pass the torch goes back by the look-ahead distance and 6 mm. Here the way is shorter.
    .cure = Check the first millimetres of the weld, which start without measurements. Make room behind the start or move `[start]`.
cell-sighting-length = { $clear } of { $wanted }, { $why }
cell-end-of-reach = the axes are at the end of their reach
    .cause = On the way back from the start an axis would leave its range, or the axes have no way.
    .cure = Move the work with `[placement]`, or move `[start]`, so that the axes have room before the seam.
cell-too-close = { $a } and { $b } come too close to each other
    .cause = On this way their distance would be less than the minimum: `least_mm` of `[clearance]` or of a zone.
    .cure = Move the fixture, the start or the camera. Lower `least_mm` only if the real distance permits it.
cell-something-too-close = two bodies come too close to each other
    .cause = A position of this way is not clear, and no pair within its minimum distance is found for a name.
    .cure = Jog the camera to a position with more room, then continue.

# Distortion file.
cell-empty-range = empty range: from { $from } to { $to }
    .cause = In the distortion file a `ramp`, a `sag` or an entry of `tacks_mm` starts at or behind its end.
    .cure = Write the smaller path length first, in mm from the start of the weld.
cell-allowed-range = `to` greater than `from`
cell-no-head = this head does not exist
    .cause = `head` of a `[[displacement]]` is neither 1 nor 2.
    .cure = Write 1 or 2, or leave `head` out to displace all heads.
cell-allowed-heads = 1 or 2
cell-empty-displacement = the displacement is empty
    .cause = A `[[displacement]]` has no key that displaces; `head` alone does nothing.
    .cure = Add one of the allowed keys, or remove the table.
cell-turn-missing = the axis of this angle is missing
    .cause = `placement.angle_deg` is not 0, and `placement.turn` is missing.
    .cure = Add `turn = [0, 0, 1]` or another axis to `[placement]`, or remove `angle_deg`.
cell-allowed-turn = turn = [x, y, z], the axis

# Teaching.
cell-camera-out-of-reach = the axes cannot bring the camera there: { $remaining } remain
    .cause = The inverse kinematics ends with the optical axis 0.5 mm or more from the point of the joint.
    .cure = Place the work nearer to the middle of the axes' ranges, or mount the camera elsewhere (`at`).
cell-no-points = there are no points; give at least one on the joint
    .cause = The file of `--semi-manual` has no row of coordinates.
    .cure = Jog to the joint and add `x_mm,y_mm,z_mm` of at least one position.
cell-point-off-seam = point { $point } is farther than { $max } from the nominal seam
    .cause = The point is in another frame or unit, the part lies elsewhere, or the job describes another seam.
    .cure = Give points in the work frame in mm. Correct `[placement]` or the seam of the job if the part lies elsewhere.
cell-points-coincide = points { $first } and { $second } are at the same position on the seam
    .cause = The nearest positions of both points on the nominal seam are less than 0.01 mm apart.
    .cure = Remove one of the two points.

# Frames of cameras.
cell-frame-io = { $what }: { $why }
    .cause = A file, folder or connection fails, or a picture is invalid.
    .cure = Check path, disk and address. For `tcp://HOST:PORT` start the sender first.
cell-frames-missing =
    { $what }: { $why }
       allowed: an existing folder of frames with frames.csv in it
    .cause = The path does not exist, is of another kind, or is not accessible to this user.
    .cure = Correct the path or its rights. `seamwright teach --record DIR` writes such a folder.
cell-frame-list =
    { $file }:{ $line }: { $why }
       allowed: { $allowed }
    .cause = A line of `frames.csv` differs from the format of the list.
    .cure = Correct this line. The page on frame sources describes the columns.
cell-frame-header =
    frame { $frame }: invalid { $field }: { $found }
       allowed: { $allowed }
    .cause = The sender uses another format or version, or bytes are missing before this frame. All numbers are little-endian.
    .cure = Compare the sender with the table of the header (frame sources). Send as many axes as the machine has.
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
    .cause = The sender ended within the 40 bytes of a header.
    .cure = Read the sender's own messages. A stream may end only between two frames.
cell-frame-axes-truncated = frame { $frame }: the stream ends after { $found } of the { $wanted } of its axis positions
    .cause = The sender ended within the axis positions, or byte 16 announces more axes than it sends.
    .cure = Send 8 bytes (f64) for each announced axis.
cell-frame-pixels-truncated = frame { $frame }: the stream ends after { $found } of the { $wanted } of its pixels
    .cause = The sender ended within the picture, or its header announces a larger picture or more bits.
    .cure = Send width times height pixels: one byte each for 8 bits, two for 16 bits.
cell-frame-time = frame { $frame }: invalid time { $time }; times must be finite and increase
    .cause = The time of the exposure (f64 at byte 24, or `t_s` in a list) is not a finite number.
    .cure = Send the time of the middle of the exposure in s.
cell-frame-time-order = frame { $frame }: invalid time { $time } after a frame at { $before }; times must be finite and increase
    .cause = Two frames have the same time, or the sender's clock went back.
    .cure = Stamp frames with a clock that is never set back, and send each frame once.
cell-frame-shape = frame { $frame }: { $why }
    .cause = The picture of this frame has an invalid size or number of pixels.
    .cure = Send the width and height of the actual picture, each from 1 to 16384.
cell-frame-late = frame { $frame } did not come in time
    .cause = The sender paused for longer than `--timeout-s` (10 s if missing), in the panel for longer than 5 s.
    .cure = Check that the camera runs and sends. Raise `--timeout-s` for a slow machine.
cell-frame-size = the frame has { $size } pixels; allowed: the sensor's size_px, { $allowed }
    .cause = The camera has another resolution than `size_px` of its `[sensors.NAME]`.
    .cure = Set the camera to this size, or change `size_px` and find its map again (Set-up, Sensors).
cell-camera-closed = the camera has closed the connection
    .cause = The sender ended the connection during teaching.
    .cure = Restart the camera's program, then start teaching again.
cell-no-frame-in-time = no frame came in time
    .cause = No frame arrived in the 5 s and `latency_ms` after the axes came to rest.
    .cure = Check that the camera sends frames by itself, and that the network carries its rate.
cell-image-format = unknown image format; allowed: PNG, JPEG, PNM
    .cause = The first bytes of the file belong to another format; its extension does not count.
    .cure = Convert the picture to PNG with 8 or 16 bits.
cell-image-broken = unreadable image: { $why }
    .cause = The file is damaged, or the picture has more than 16384 pixels to a side.
    .cure = Copy or record the file again.
cell-jpeg-truncated = the JPEG file ends before its picture does
    .cause = The end marker behind the picture is missing: a copy or a recording was cut off.
    .cure = Copy the file again. Prefer PNG for measurements.
cell-pixel-count = the number of pixels does not match the picture
    .cause = A frame to be recorded has another number of pixels than its width times its height.
    .cure = Check width and height in the header of the sender.
cell-file-too-large = the file has { $size }; allowed are up to { $max }
    .cause = A list may have 256 MiB, a picture 1 GiB.
    .cure = Split the recording into several folders, or record smaller pictures.
cell-list-no-text = not a text file
    .cause = At this line `frames.csv` is not UTF-8.
    .cure = Save the file as UTF-8 text.
cell-list-columns = the columns are { $columns }
    .cause = The header must name `file`, `t_s`, then each axis in the order of the machine file.
    .cure = Rename or reorder the columns, or name the machine with which the frames were recorded.
cell-list-columns-allowed = { $columns }, optionally { $optional }
cell-list-cells =
    { $n ->
        [one] { $n } cell
       *[other] { $n } cells
    }
    .cause = The row has more or fewer commas than the header.
    .cure = Write one cell per column. A height that was not measured is an empty cell.
cell-list-cells-allowed = { $n }, one per column
cell-list-file = invalid file name "{ $name }"
    .cause = The name is empty, or leads out of the folder by `..` or an absolute path.
    .cure = Put the picture into the folder of `frames.csv`, and write its name alone.
cell-list-file-allowed = the name of an image in this folder
cell-list-number = { $column }: "{ $value }" is not a number
    .cause = The cell is empty or text, has a decimal comma, or is not finite.
    .cure = Write a number with a decimal point, like `12.5`.
cell-list-time = t_s: { $time } is not after { $before } in the row before
    .cause = Two rows have the same time, or the rows are not in the order of time.
    .cure = Sort the rows by `t_s` and remove duplicates.
cell-list-time-allowed = increasing times
cell-list-empty = the list has no frames
    .cause = `frames.csv` has only a header: the recording ended before its first frame.
    .cure = Record again, or add a row for each picture.
cell-list-empty-allowed = one row per frame

# Devices on Modbus.
cell-modbus-unreachable = device `{ $device }` at { $address }: { $why }
    .cause = The device is not connected, refuses a register, or its heart-beat stands. The reason follows its address.
    .cure = Check supply, cable, `address` and `unit`. Then read all registers with `seamwright machine io MACHINE`.
cell-modbus-no-register = device `{ $device }` has no register that sets the job's process value `{ $value }`
    .cause = The job sets this process value, and `[devices.NAME.modbus.set]` of the process source lacks it.
    .cure = Add the value with its register to `set`, or remove it from `process` in the job.
cell-modbus-refused = the device refuses { $what } ({ $code })
    .cause = The device answers with a Modbus exception: unknown address, read-only register, invalid value, or busy.
    .cure = Compare table and address with the device's manual. Addresses count from 0: register 40001 is `holding = 0`.
cell-modbus-registers = { $table } { $from } to { $to }
cell-modbus-named = { $registers }: { $names }
cell-modbus-cells = { $table } { $at }: { $asked } cells requested, { $answered } received
    .cause = The answer has another number of cells than the request. The connection is closed and made anew.
    .cure = Check that `unit` is that of this device, and that no gateway mixes answers.
cell-modbus-no-connection = no connection within { $time }
    .cause = Within 1 s the host does not answer: device off, wrong host, firewall, or a broken cable.
    .cure = Ping the host, and check `address` and the network.
cell-modbus-no-answer = no answer within { $time }
    .cause = A request stays without an answer for `timeout_s`; at the end of the program for 3 s.
    .cure = Check network and `unit`. Raise `timeout_s` for a slow device, to 1 s at most if it switches the process.
cell-modbus-no-heartbeat = no heart-beat for { $time }
    .cause = The register `heartbeat` keeps its value for `heartbeat_s`: the program in the device stands.
    .cure = Restart the device. If the register changes more slowly, raise `heartbeat_s`.
cell-modbus-closed = the connection was closed
    .cause = The device has closed the connection: restart, idle limit, or too many clients.
    .cure = Close other clients. If the device takes one connection only, set `connections = 1`.
cell-modbus-not-connected = not connected
    .cause = The connection was lost before and is made anew, at intervals of up to 1 s.
    .cure = Wait a moment. If it stays, check supply and cable of the device.
cell-modbus-second-connection = { $why }, on a second connection; if the device accepts only one: connections = 1
    .cause = Orders and reports have a connection each, and the device does not serve the second one.
    .cure = Set `connections = 1` in `[devices.NAME.modbus]`. Switching off may then take twice `timeout_s`.

# LinuxCNC's HAL.
cell-hal-not-installed =
    LinuxCNC is not installed: program `{ $program }` is missing
       allowed: Debian's package linuxcnc-uspace (apt install linuxcnc-uspace)
    .cause = No folder of PATH has this program.
    .cure = Install the package, then check with `which halrun`.
cell-hal-running =
    LinuxCNC's HAL is already running: { $owner }
       allowed: one at a time; end the other, or clear it away with `halrun -U`
    .cause = A computer runs one HAL: another Seamwright, LinuxCNC itself, or the rest of a crash (process `rtapi_app`).
    .cure = End the named program. If only a rest is there, clear it with `halrun -U`.
cell-hal-of-seamwright = that of Seamwright, process { $process }
cell-hal-foreign = one of another program
cell-hal-refused = LinuxCNC rejects { $file }: { $why }
    .cause = A line of the file names a missing component, pin or function, connects a pin twice, or waits for more than 30 s.
    .cure = Correct the line that LinuxCNC names. `threads`, `streamer`, `sampler`, `weighted_sum`, `watchdog` and `lut5` are already loaded.
cell-hal-own-commands = our own commands
cell-hal-too-slow = it takes longer than { $time }; { $said }
    .cause = A command of the file waits, for example for a program that never becomes ready.
    .cure = Run the file by hand with `halrun`, and remove or repair the waiting line.
cell-hal-no-start = LinuxCNC's HAL does not start: { $why }
    .cause = `halrun` does not answer within 5 s.
    .cure = Start `halrun` in a terminal as the same user, and read its messages.
cell-hal-no-samples = LinuxCNC's HAL does not run, it sends no samples: { $why }
    .cause = HAL accepted the files, but its thread delivered nothing within 3 s.
    .cure = Read LinuxCNC's words behind the colon. Grant real-time rights, or set `LINUXCNC_FORCE_REALTIME=1`.
cell-hal-output = { $sampler }; { $keeper }
cell-hal-no-output = no output
cell-hal-not-run = LinuxCNC's HAL cannot run: { $why }
    .cause = The system refuses to start a program of HAL, or to open its streams or its folder.
    .cure = Check the rights of the user and the path in `hal`, then start again.
cell-hal-refuses-root = HAL refuses root, and user `nobody` is missing; run as another user
    .cause = Started by root, HAL runs as `nobody`, and /etc/passwd has no such user.
    .cure = Start Seamwright as an ordinary user who has real-time rights.
cell-hal-no-pipes = its streams have no pipes
    .cause = The programs of HAL started without their standard streams.
    .cure = Start again. If it recurs, check the limit of open files with `ulimit -n`.
cell-hal-program-ended = { $program } has ended
    .cause = The program crashed or was killed, or HAL ended under it.
    .cure = Look for it in the system's log (`journalctl`).
cell-hal-no-data = its real-time program sends nothing
    .cause = No sample came for 2 s although the programs run: the real-time thread stands.
    .cure = Check the hardware's driver in the HAL file and the kernel's log (`dmesg`).
cell-hal-ended = LinuxCNC's HAL has ended: { $why }; it is being restarted without power
    .cause = A program of HAL ended, or sent nothing for 2 s. Process and power are off.
    .cure = Wait until HAL runs again. Find the reason in the system's log before the next weld.
cell-hal-runs-again = LinuxCNC's HAL runs again: acknowledge, reset, switch on, home
    .cause = HAL ended and was started anew. The references are lost.
    .cure = Afterwards inspect the weld and continue it from the reported position.
cell-hal-retried =
    { $error }
       trying again every { $time }
    .cause = HAL does not start again after its end. Each attempt ends with this reason.
    .cure = Remove the reason; Seamwright itself needs no restart.

# Fault injection.
cell-fault-form = invalid fault; allowed is DEVICE:KIND@TIME[+DURATION], like drives:silent@12.5 or inputs:disconnect@3+0.5
    .cause = The text of `--fault` lacks its `:` or its `@`.
    .cure = Write for example `--fault source:silent@20`.
cell-fault-no-device = device `{ $name }` does not exist; allowed are { $names }
    .cause = The word before `:` is not a device of fault injection.
    .cure = Take one of the allowed words. `sensors` needs a tracked weld (`--distortion`).
cell-fault-no-kind = fault `{ $name }` does not exist; allowed are { $names }
    .cause = The word between `:` and `@` is not a kind of fault.
    .cure = Take one of the allowed words; the guide to fault injection describes them.
cell-fault-no-time = invalid time `{ $text }`; allowed is a number of seconds, 0 or greater
    .cause = The number behind `@` or `+` is negative, not finite, or no number.
    .cure = Write seconds with a decimal point, like `@12.5+0.25`.
cell-fault-injection-summary =
    { $kept } of { $all } cases end as required ({ $faults } in fault); process off after at most { $cycles ->
        [one] { $cycles } cycle
       *[other] { $cycles } cycles
    }; longest stopping distance { $stop }, at most { $bound } of its bound
cell-violation = { $time }: { $what }
    .cause = A case of `seamwright tools bench faults` does not end as required, at this time of its run.
    .cure = Do not weld with this program and machine file. Repeat the case with the same seed and report it.
cell-violation-no-restart = the cell cannot be switched on again
    .cause = Within 3 s after a temporary fault, acknowledge, reset and switch on bring no power.
    .cure = See `cell-violation`.
cell-violation-no-rest = the axes do not come to rest
    .cause = At the end of the observation the set-points have rested for less than 0.5 s, in a mode without motion.
    .cure = See `cell-violation`.
cell-violation-process-on = the process is on in mode { $mode }
    .cause = Arc or beam is ordered on outside of the modes weld and hold.
    .cure = See `cell-violation`.
cell-violation-process-after-alarm = the process is on after the alarm
    .cause = Arc or beam is still ordered on in a cycle after that of an alarm which switches it off.
    .cure = See `cell-violation`.
cell-violation-stop = the stopping distance is { $length }; { $max } is allowed
    .cause = The allowed distance is twice the shortest one within the axes' acceleration and jerk.
    .cure = See `cell-violation`.
cell-violation-jump = axis { $axis }: the set-point is { $distance } from the actual position
    .cause = Before the fault the set-point is more than 0.2 mm or rad, plus 20 ms of its speed, from the reported position. Axes count from 0.
    .cure = See `cell-violation`.
cell-violation-limits = axis { $axis }: speed { $speed }, acceleration { $acceleration } beyond the limits
    .cause = By differences of set-points the axis exceeds its maximum speed by 0.1 % or its acceleration by 1 %. Axes count from 0.
    .cure = See `cell-violation`.

# Process of the cell.
cell-program-damaged = the program arrived damaged: { $why }
    .cause = The planned motion does not match its checksum, or is not in the form of this version.
    .cure = Load the job again; after an update, restart the panel first.
cell-program-changed = { $job } or a file it names has changed since it was planned: load it again
    .cause = The cell reads the files again and found another machine or another number of passes than the planner.
    .cure = Load the job again.
cell-program-panicked = a thread of the cell ended by a fault of the program
    .cause = The preparation of a program or the cell itself hit a fault of the software.
    .cure = Report it with the job and the machine file.
cell-socket = no sockets in { $folder }: { $why }
    .cause = The folder cannot be written, or its path is longer than the 100 characters that a socket may have.
    .cure = Choose a data folder with a shorter path on a local disk, with `--data DIR`.
cell-already-runs = a cell runs already with its sockets in { $folder }
    .cause = Another panel uses this data folder, or its cell has outlived it.
    .cure = End the other panel. A cell without a panel ends by itself a minute after it came to rest; `seamwright stop` stops it.
cell-no-process = the process of the cell cannot be started: { $why }
    .cause = The system refuses a new process or its connection: memory, number of processes, or a program file that has gone.
    .cure = Check the limits of the service and the installed program, then start the panel again.
cell-process-ended-early = the process of the cell ended without a report
    .cause = The process was ended from outside, or by a fault of the program.
    .cure = Look at the last lines of the log; check that arc, gas and drives are off.
cell-process-silent = the process of the cell did not answer and was ended
    .cause = The process stood still for longer than its time limit: stopped by a debugger, or out of processor time.
    .cure = Check that arc, gas and drives are off; look for programs that stop or slow down the computer.
cell-process-signal = its process was ended by signal { $signal }
    .cause = Signal 9 comes from a user, the panel or the kernel when memory runs short; 6 and 11 are faults of the program.
    .cure = Look at the log of the system (`journalctl -k`) for the reason.
cell-process-code = its process ended with code { $code }
    .cause = The cell ended by itself after a fault that it has printed.
    .cure = Look at its last lines in the log.
cell-safe-not-asked = it was not asked
    .cause = The device was dropped before its outputs were set to their safe states.
    .cure = Check arc, gas and drives at the machine.
cell-outputs-unconfirmed = device { $device }: its outputs are not confirmed to be safe: { $why }
    .cause = The device did not answer when its outputs were set to their safe states.
    .cure = Check arc, gas and drives at the machine, then cable and power of the device.
cell-record-not-saved = the last rows of weld { $weld } were not written in time
    .cause = The disk of the data folder hung or was too slow when the cell ended.
    .cure = Check the disk. The next start of the panel closes the record with the rows that are there.
cell-does-not-end = the cycle does not come to its end: check that arc, gas and drives are off
    .cause = The thread of the cycle hangs in a device for more than 15 s after the request to end.
    .cure = Switch off at the machine; then check the named devices.
cell-program-too-large = the planned motion has { $size }, more than the { $max } that a cell takes
    .cause = The job has so many passes or such long ones that its set-points do not fit into one program.
    .cure = Divide the job into several, each with some of the passes.

# Robot controls that take set-points.
cell-robot-unusable = device `{ $device }` ({ $protocol }) at { $address }: { $why }
    .cause = The robot control is not reached, sends nothing, or refuses the protocol. The reason follows its address.
    .cure = Check cable, address and port, and that the program on the control runs: see `docs/how-to/stream-to-robot.md`.
cell-robot-lost = no connection: { $why }
    .cause = The control does not answer under this address, or the connection broke.
    .cure = Check the control's supply, the cable, and `address` in the machine file. Port 30004 of a Universal Robots control must be enabled under *Security*.
cell-robot-port-in-use = another program listens on this port
    .cause = Another cell or another program on this computer has opened the UDP port of `listen`.
    .cure = End the other program, or choose another port here and on the control.
cell-robot-not-listening = this computer cannot listen there: { $why }
    .cause = The address of `listen` is not one of this computer, or the port may not be used.
    .cure = Write `listen = "0.0.0.0:PORT"` to listen on all its addresses, with a port above 1023.
cell-robot-no-reports = the control sends nothing
    .cause = No report arrived in time: the program on the control does not run, or it sends to another address or port.
    .cure = Start the program on the control. Compare the address and port that it sends to with this computer's, check `from`, and allow the UDP port in the firewall.
cell-robot-closed = the control has closed the connection
    .cause = The control accepts no further client, or it was restarted.
    .cure = End other programs that use RTDE, then start the cell again.
cell-robot-malformed = the control sends bytes that are no message of this protocol
    .cause = Another service answers on this port, or the message lacks a required element.
    .cure = Check port and protocol. RSI needs the elements AIPos and IPOC, with external joints also EIPos.
cell-robot-version = the control refuses version 2 of RTDE
    .cause = The software of the control is too old.
    .cure = Update it to PolyScope 3.10, 5.4 or newer.
cell-robot-unknown-fields = the control does not know { $fields }
    .cause = RTDE answers NOT_FOUND: the software of the control is too old for these fields.
    .cure = Update it to PolyScope 3.10, 5.4 or newer.
cell-robot-fields-in-use = another program uses { $fields }
    .cause = RTDE answers IN_USE: a fieldbus, an URCap or another client writes these registers.
    .cure = End the other client, or switch off the fieldbus or URCap that uses registers 24 to 29.
cell-robot-not-started = the control does not start its reports
    .cause = RTDE refuses to start although it accepts the fields.
    .cure = Restart the control.
cell-robot-joints = the control reports { $reported } joints, and the machine file needs { $needed }
    .cause = The arm has another number of joints, or external joints are missing in the control's messages.
    .cure = Correct `axes` (and `joints` of EGM), or add the external joints to the message on the control.
cell-robot-not-stopped = the robot has not confirmed its stop
    .cause = The connection was lost before the stop was confirmed. The control's own watchdog stops the robot.
    .cure = Check at the robot that it stands.
cell-robot-motors-off = the motors of the robot are off
    .cause = The control reports motors off, brakes on, or no automatic mode.
    .cure = Switch the motors on at the control.
cell-robot-protective-stop = protective stop of the robot
    .cause = The control has stopped the arm: a collision, or a motion beyond its limits.
    .cure = Find the cause, unlock the stop at the pendant, and start the program on the control again.
cell-robot-safeguard-stop = safeguard stop of the robot
    .cause = A safeguard input of the control is open.
    .cure = Close the guard, and start the program on the control again.
cell-robot-emergency-stop = emergency stop of the robot
    .cause = An emergency stop of the control is pressed.
    .cure = Release it, switch the robot on, and start the program on the control again.
cell-robot-safety-fault = the safety system of the robot reports a fault
    .cause = The control reports recovery, a violation or a fault of its safety system.
    .cure = See the message at the pendant.
cell-robot-program-stopped = the program on the robot control does not run
    .cause = The program that takes the set-points was stopped or has ended.
    .cure = Start it at the pendant, then reset the cell.
cell-robot-other-program = another program runs on the robot control
    .cause = The program does not confirm the version that this version of Seamwright needs.
    .cure = Load the program of `seamwright machine robot-program` onto the control, and start it.
cell-robot-control-error = the motion interface of the robot control reports an error
    .cause = EGM has ended with an error, for example after `CommTimeout` or beyond a limit.
    .cure = See the event log of the control, then start the program again.
cell-robot-starved = set-points for the robot were missing
    .cause = The cycle was late for longer than the store lasts. The axes braked together.
    .cure = Enlarge `store`, or give the computer real-time rights.
cell-robot-jump = a set-point is too far from where the robot stands
    .cause = Set-points would move the robot faster than its axes allow, or positions are not those of the robot.
    .cure = Compare the axes of the machine file with those of the control: zero, direction and order.
cell-robot-disconnected = the connection with the robot is lost
    .cause = No report came for half a second, or the control began a new session.
    .cure = Restore the connection, then reset the cell and switch it on again.
