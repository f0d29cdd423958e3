# Steps and axes of the machine file.
machine-step-neither = the step is neither an axis nor fixed
    .cause = A step has neither `axis` nor `fixed`, or it has `fixed` together with keys of an axis.
    .cure = In this `[[tool]]`, `[[work]]` or `[[heads.steps]]`, add the name of the axis, or keep only `fixed`.
machine-step-kinds = either `axis` with its keys, or `fixed` alone
machine-step-fixed-axis = the step has both `axis` and `fixed`
    .cause = One table describes a motion and a fixed displacement, so their order is unknown.
    .cure = Move `fixed` to a `[[tool]]` or `[[work]]` step of its own, before or after the axis.
machine-step-fixed-apart = `fixed` in a step of its own
machine-axis-name-invalid = the axis name has invalid characters
    .cause = The name is empty, or it has capital letters, spaces or other characters.
    .cure = Change `axis`, for example to `c2`. Change it also in `home_order`, `[drives]`, `[pitch_error]`, `[[shapes]]` and `[controls]`.
machine-plain-letters = lower-case letters, digits and _
machine-axis-name-reserved = the name is reserved for another column of tables
    .cause = Tables and traces already have a column of this name: `t_s`, `pass`, `s_mm`, `speed_mm_s`, `arc` or `error`, for example.
    .cure = Rename the axis, usually to its letter: `x`, `c`, `u`.
machine-axis-turn-or-move = an axis either turns or moves
    .cause = The axis has both `turn` and `move`, or neither of them.
    .cure = Keep `turn` for a rotary axis, `move` for a linear one. Its value is the direction, as `[0, 0, 1]`.
machine-turn-or-move = exactly one of `turn` and `move`
machine-axis-key-of-rotary = a linear axis has no such key
    .cause = `at_mm` and `continuous` describe a rotary axis, and this axis has `move`.
    .cure = Remove the key, or replace `move` by `turn` if the axis turns.
machine-only-with-turn = only with `turn`
machine-axis-lacks-key = axis `{ $axis }` lacks `{ $key }`
    .cause = Each axis needs a maximum speed and a maximum acceleration, and they have no default.
    .cure = Add the key to the axis, with the value from the data sheet of its drive.
machine-key-positive = { $key } = a number greater than 0
machine-home-outside-range = the home position is outside the range
    .cause = The home position is beyond an end of the range. Without `home_mm` or `home_deg` it is 0.
    .cure = Set `home_mm` or `home_deg` to a position inside the range, or correct the range if the axis reaches farther.
machine-letter-invalid = not an axis letter
    .cause = `letter` is not exactly one capital letter of this list.
    .cure = Give one letter of the list, or remove `letter` if part programs do not use the axis.
machine-linear-axis-in-mm = a linear axis is in mm
    .cause = A key of this axis ends in `_deg`, and the axis has `move`.
    .cure = Write the key in mm, or replace `move` by `turn` if the axis turns.
machine-rotary-axis-in-degrees = a rotary axis is in degrees
    .cause = A key of this axis ends in `_mm`, and the axis has `turn`.
    .cure = Write the key in degrees, or replace `turn` by `move` if the axis is linear.
machine-range-of-continuous = a continuous axis has no range
    .cause = The axis has `continuous = true` and `range_deg`.
    .cure = Remove `range_deg` if neither stops nor cables limit the axis, else remove `continuous`.
machine-continuous-or-range = `continuous` or a range
machine-range-missing = the axis has no range
    .cause = Each axis needs its end positions, unless it turns without end.
    .cure = Add the range between the limit switches. Only a rotary axis without end stops gets `continuous = true`.
machine-range-form = { $key } = [minimum, maximum]
machine-range-form-or-continuous = { $key } = [minimum, maximum], or continuous = true
machine-range-empty = the range is empty
    .cause = The first number of the range is not less than the second, usually because both are swapped.
    .cure = Give the lower end first: `range_mm = [-200, 200]`.
machine-axis-name-taken = another axis has this name
    .cause = Two axes of tool, work and heads have the same name, often after a step was copied.
    .cure = Rename one of them, also in the tables that refer to it.
machine-axis-letter-taken = another axis has this letter
    .cause = Two axes have the same letter. Without `letter`, an axis named `x` has the letter X.
    .cure = Give one of them another `letter`, as in the parameters of the control.
machine-own-letter = a letter of its own
machine-axes-count = the machine has { $n ->
        [one] { $n } axis
       *[other] { $n } axes
    }
    .cause = `[[tool]]`, `[[work]]` and `[[heads.steps]]` together have no axis, or more than 12.
    .cure = Add the missing axes, or replace axes that stay clamped by `fixed` steps.
machine-axes-allowed = 1 to { $max } axes in [[tool]] and [[work]]
machine-home-order-twice = the axis is in the list already
    .cause = `home_order` has the same axis twice.
    .cure = Remove the second entry from `home_order`.
machine-each-axis-once = each axis once

# Torch and heads.
machine-torch-and-heads = the machine has both `[torch]` and `[[heads]]`
    .cause = `[torch]` is the only head of a machine, and `[[heads]]` lists heads too.
    .cure = Remove `[torch]` and give each head its `direction`, or remove `[[heads]]`.
machine-torch-or-heads = `[torch]` for one head, `[[heads]]` for two
machine-torch-missing = the machine has no torch
    .cause = The file has neither `[torch]` nor `[[heads]]`, so the tool steps end without a tool.
    .cure = Add `[torch]` with `direction = [0, 0, -1]` for a torch that points down.
machine-torch-form = `[torch]` with `direction`, or two `[[heads]]`
machine-heads-many = the machine has { $n ->
        [one] { $n } head
       *[other] { $n } heads
    }
    .cause = A machine has at most two heads.
    .cure = Remove the other `[[heads]]`. Describe a third head in a machine file of its own.
machine-head-without-steps = head `{ $head }` has no steps of its own: nothing carries it
    .cause = Every head of `[[heads]]` needs at least one step, which separates it from the other head.
    .cure = Add `[[heads.steps]]` below it: its cross slide, or a `fixed` displacement to its mounting.
machine-head-steps = `[[heads.steps]]` for every head
machine-head-name-taken = an axis, another head or a frame has this name
    .cause = Names of links are unique. `base` and `work` are links of every machine.
    .cure = Change `name` of the head, also in `[[shapes]]`, `[sensors]` and `[[zones]]`.
machine-frame-name = user frame with the name "{ $name }"
    .cause = Each user frame has a short name of its own; names of frames that every machine has are taken.
    .cure = Give the table `[frames.NAME]` another name, like `table` or `fixture-2`.
machine-frame-name-allowed = up to { $max } characters, none of { $names }

# Outputs and controls.
machine-output-taken = `{ $name }` has this output already
    .cause = Two signals of `[io]` have the same output, so one would switch the other.
    .cure = Look the output up in the wiring diagram, and correct `arc`, `gas`, `wire` or `analog`.
machine-own-output = an output of its own
machine-address-invalid = invalid address
    .cause = The address has lower-case letters, or starts with a digit. G and N are reserved for codes and block numbers.
    .cure = Correct it in `axes` or `process` of this `[controls]` table, as the control has it.
machine-address-form = a capital letter other than G and N, then capitals, digits and _, like X or CW
machine-address-taken = another axis or process value has this address
    .cause = Two axes or process values of this control have the same address.
    .cure = Give each its own address in `axes` and `process` of the `[controls]` table.
machine-own-address = an address of its own
machine-code-invalid = invalid G- or M-code
    .cause = The key of `codes` is not G or M with a number below 10000.
    .cure = Correct the key in `codes` of the `[controls]` table, as `M54 = "arc_on"`.
machine-code-form = G or M and a number, like M54
machine-event-invalid = invalid name of an event
    .cause = The value of a code is empty, or it has capital letters, spaces or other characters.
    .cure = Change the value in `codes` to the name that events of the program have.
machine-event-names = { $names }, or a name of its own in lower-case letters, digits and _
machine-kinematics-output = only LinuxCNC switches the kinematics by an output
    .cause = Only programs for LinuxCNC switch between axes and torch tip by an analogue output.
    .cure = Remove `kinematics_output` here, or move it to `[controls.linuxcnc]`.

# Drives.
machine-drive-of-linear = the drive of a linear axis has mass and force, and lengths in mm
    .cause = This `[drives.AXIS]` has keys with degrees, N m or kg m², and the axis moves along a line.
    .cure = Write `mass_kg`, `peak_force_n` and `encoder_counts_per_mm`, reflected to the axis through screw or rack.
machine-drive-of-rotary = the drive of a rotary axis has inertia and torque, and angles in degrees
    .cause = This `[drives.AXIS]` has keys with mm, N or kg, and the axis turns.
    .cure = Write `inertia_kg_m2`, `peak_torque_n_m` and `encoder_counts_per_deg`, reflected to the axis through the gear.
machine-drive-key-missing = the drive lacks a key
    .cause = Mass or inertia, peak force or torque, and encoder counts have no default.
    .cure = Add the missing key to `[drives.AXIS]`, or remove the table for an assumed drive.
machine-drive-limit-range = the limit is not between friction and peak
    .cause = `force_limit_n` or `torque_limit_n_m` exceeds the peak of the motor, or does not exceed the friction.
    .cure = Set the limit above `friction_n` or `friction_n_m`, and up to the peak, or remove it.
machine-drive-without-resonance = without a resonance, motor and load are one mass
    .cause = Damping, load ratio, backlash, friction at the motor and the encoder's side need an elastic shaft between motor and load.
    .cure = Add `resonance_hz` and `load_ratio` to `[drives.AXIS]`, or remove this key.
machine-drive-resonance-alone = a resonance needs the ratio of load to motor inertia
    .cause = `resonance_hz` is given without `load_ratio`, so motor and load are not separated.
    .cure = Add `load_ratio`, the inertia of the load over that of the motor, seen at the motor.
machine-together-with = together with `{ $key }`
machine-fraction-too-large = the fraction is greater than 1
    .cause = `resonance_damping` and `motor_friction` are parts of a whole, from 0 to 1.
    .cure = Write 2 % as 0.02.
machine-notches-many = the position loop has too many notch filters
    .cause = The position loop has two notch filters at most.
    .cure = Keep the two for the strongest resonances in `notches`. `seamwright machine tune` finds them.
machine-notch-too-high = { $frequency } is not below half the sampling rate
    .cause = `frequency_hz` or `width_hz` reaches 99.9 % of half the sampling rate: 500 Hz at a period of 1 ms.
    .cure = Lower it, or shorten `servo_period_ms` at the top of the file.
machine-notch-depth = the gain at the centre is greater than 1
    .cause = `depth` is the gain at the centre of the notch, from 0 to 1.
    .cure = Write a part of 1, not decibels: 20 dB are 0.1.
machine-friction-smoothing-alone = there is no friction compensation
    .cause = The smoothing has an effect only with a force or torque to smooth.
    .cure = Add `friction_compensation_n` or `friction_compensation_n_m` to `[drives.AXIS]`, or remove the smoothing.
machine-backlash-time-alone = there is no backlash compensation
    .cause = The duration has an effect only with a lost motion to compensate.
    .cure = Add `backlash_compensation_mm` or `backlash_compensation_deg` to `[drives.AXIS]`, or remove `backlash_compensation_ms`.

# Steppers and their pulses.
machine-full-steps = a two-phase motor has 4 full steps for each tooth of its rotor
    .cause = `full_steps_per_turn` is 0 or not a multiple of 4.
    .cure = Give the full steps of the motor, not the microsteps: 200 for a motor of 1.8 degrees.
machine-multiple-of-4 = a multiple of 4, usually 200
machine-microsteps-invalid = invalid microstep settings of the driver
    .cause = The list is empty, does not increase, or has a number outside 1 to 4096.
    .cure = Copy the settings of the driver's switches in increasing order: `microsteps = [1, 2, 4, 8, 16]`.
machine-microsteps-allowed = whole numbers from 1 to { $max }, increasing, at least one
machine-pulse-time = pulses that are high and low for { $time } each are too long for this frequency
    .cause = A pulse takes `min_pulse_us` high and as long low. Their sum exceeds one period of `max_pulse_hz`.
    .cure = Compare both with the data sheet of the driver. Lower `max_pulse_hz` or shorten `min_pulse_us`.
machine-stepper-lacks-key = the stepper lacks `{ $key }`
    .cause = The travel per turn and the resolution have no default.
    .cure = Add the key to `[drives.AXIS.stepper]`, in mm for a linear axis, in degrees for a rotary one.
machine-motor-key-missing = the motor lacks a key
    .cause = Some keys of the motor model are present, and `rotor_inertia_kg_m2`, `torque_rpm` or `torque_n_m` is missing.
    .cure = Complete them from the data sheet, or remove all. Only `tools pulses --motors` needs them.
machine-motor-keys = rotor_inertia_kg_m2, torque_rpm and torque_n_m together, or without all three
machine-torque-lengths = speeds: { $speeds }, torques: { $torques }
    .cause = `torque_rpm` and `torque_n_m` have different lengths, or fewer than two points.
    .cure = Give one torque for each speed, read from the pull-out curve of the motor.
machine-torque-equal-lengths = as many torques as speeds, at least 2
machine-torque-speeds = the torque curve does not start at rest with increasing speeds
    .cause = The first entry of `torque_rpm` is not 0, or an entry is not greater than the one before.
    .cure = Sort the points by speed and start with the holding torque at 0 rpm.
machine-zero-then-increasing = 0 first, then increasing
machine-torque-holding = the motor has no holding torque
    .cause = The first entry of `torque_n_m` is 0.
    .cure = Put the holding torque of the data sheet first, at 0 rpm.
machine-torque-first = a holding torque greater than 0 first
machine-stepper-missing = axis `{ $axis }` has no stepper for pulses
    .cause = `[devices.NAME.steps]` drives all axes of the machine, and this axis has no pulse data.
    .cure = Describe the motor in `[drives.AXIS.stepper]`, or use another device for the drives.
machine-stepper-or-other-drives = [drives.{ $axis }.stepper], or drives other than `steps`
machine-resolution-too-fine = the finest setting of the driver is coarser than this
    .cause = At the finest setting in `microsteps` a pulse moves the axis farther than `resolution_mm` or `resolution_deg`.
    .cure = Allow a coarser resolution, add a finer setting of the driver, or use a smaller travel per turn.
machine-pulse-rate = axis `{ $axis }` needs pulses at { $needed } at its maximum speed ({ $speed }, microsteps: { $microsteps }); the driver takes up to { $possible }
    .cause = Maximum speed divided by the travel of a pulse exceeds the pulse frequency of driver and timer.
    .cure = Lower `max_speed_mm_s` or `max_speed_deg_s`, or coarsen the resolution. Compare `max_pulse_hz` and `min_pulse_us` with the data sheet.
machine-pulse-rate-allowed = a maximum speed up to { $speed }, a coarser `{ $resolution }`, or a faster driver (max_pulse_hz, min_pulse_us)
machine-pulses-after-reversal = after a reversal, { $n ->
        [one] { $n } pulse does
       *[other] { $n } pulses do
    } not fit into the period
    .cause = After a reversal the direction line must settle, and the rest of the servo period is too short for the pulses.
    .cure = Reduce `direction_setup_us` and `direction_hold_us` to the driver's data sheet, or lower the maximum acceleration.
machine-direction-times-allowed = direction_setup_us and direction_hold_us of up to { $time } together
machine-tick = the timer has ticks of { $tick }
    .cause = `tick_ns` is outside 10 to 100000, or the servo period is not a whole number of ticks.
    .cure = Set `tick_ns` to the tick of the pulse timer, for example 100, with a `servo_period_ms` that it divides.
machine-tick-allowed = 10 to 100000 ns, a whole number of times in the period of { $period }
machine-stream-file = `{ $file }` is not a value change dump
    .cause = `stream` does not end in `.vcd`, or it is only the ending.
    .cure = Rename the file or pipe, for example `stream = "pulses.vcd"`, or remove the key.
machine-stream-file-allowed = the path of a file that ends in .vcd, or no `stream`

# Pitch errors.
machine-pitch-in-mm = the pitch-error table of axis `{ $axis }` is in mm
    .cause = The table lacks `at_mm` or `error_mm`, or has keys in degrees.
    .cure = Write the positions to `at_mm` and the errors to `error_mm`, both in mm.
machine-pitch-in-degrees = the pitch-error table of axis `{ $axis }` is in degrees
    .cause = The table lacks `at_deg` or `error_deg`, or has keys in mm.
    .cure = Write the positions to `at_deg` and the errors to `error_deg`, both in degrees.
machine-pitch-keys = { $positions } and { $errors }, lists of equal length
machine-pitch-lengths = positions: { $positions }, errors: { $errors }
    .cause = The lists of positions and errors differ in length, or have fewer than two entries.
    .cure = Give each measured position its error, and at least two of them.
machine-pitch-equal-lengths = as many errors as positions, at least 2
machine-pitch-positions = invalid positions of the pitch-error table
    .cause = Positions repeat or decrease. On a continuous axis the first and the last are a full turn or more apart.
    .cure = Sort the table by position. On a continuous axis leave out the point at 360 degrees.
machine-increasing-positions = increasing positions
machine-increasing-within-a-turn = increasing positions within one turn
machine-pitch-steep = the error changes by { $slope } of the motion: too steep for a pitch error
    .cause = Between two positions the error changes by more than a tenth of the motion.
    .cure = Check the units: laser interferometers print micrometres. Check signs and slipped rows of the table.

# Sensors.
machine-image-width = invalid width of the image
    .cause = The first number of `size_px` is 0 or greater than 16384.
    .cure = Give the columns of the image: `size_px = [1280, 1024]`.
machine-image-height = invalid height of the image
    .cause = The second number of `size_px` is 0 or greater than 16384.
    .cure = Give the rows of the image: `size_px = [1280, 1024]`.
machine-image-size = 1 to { $max } columns and rows
machine-frames-of-stripe = a stripe sensor has no stream of frames
    .cause = `frames` is given for a sensor of `kind = "stripe"`.
    .cure = Remove `frames`, or set `kind = "camera"`.
machine-frames-invalid = invalid source of frames
    .cause = The address lacks `tcp://`, the host, or a port from 1 to 65535.
    .cure = Correct `frames`, for example `frames = "tcp://192.168.1.20:7000"`.
machine-frames-form = for a camera: "tcp://HOST:PORT"
machine-stripe-map-missing = a stripe sensor needs `map`, from pixels to mm
    .cause = Without a map the stripe in the image has no position in the laser plane.
    .cure = Add `map.camera` from the mounting, or `map.homography` from a calibration.
machine-stripe-maps = `map.camera`, `map.homography` or `map.scale`
machine-camera-angle = the camera would not see the joint
    .cause = `angle_deg` is 90 or more, so the camera lies in the surface of the work or behind it.
    .cure = Give the angle between the camera's axis and the laser plane, for example 25 degrees.
machine-map-of-camera = this map is for a camera
    .cause = `map.heights` describes a camera, and this sensor has `kind = "stripe"`.
    .cure = Use `map.camera`, `map.homography` or `map.scale`, or set `kind = "camera"`.
machine-map-singular = different pixels would have the same position
    .cause = The matrix of the map has no inverse, for example because a scale is 0 or two rows are proportional.
    .cure = Correct the numbers of `map`. Calibrate with points that do not lie on one line.
machine-map-invertible = numbers of an invertible map
machine-map-horizon = the pixel ({ $column }, { $row }) is beyond the horizon: it sees no point of the laser plane
    .cause = At this corner of the image the map divides by 0 or a negative number.
    .cure = Check the signs of h7 and h8 in `map.homography`. For `map.camera`, check `angle_deg`, `focal_px` and `size_px`.
machine-map-every-pixel = a map that gives every pixel of the image a position
machine-camera-map-missing = a camera needs `map.heights`
    .cause = A sensor of `kind = "camera"` has no map, or the map of a stripe sensor.
    .cure = Add one row `[[sensors.NAME.map.heights]]` with `mm_per_px`. The panel's Sensors page finds it from a grid.
machine-heights-order = z does not increase from row to row
    .cause = `z_mm` of this row is not greater than that of the row before.
    .cure = Sort the rows by `z_mm`. It counts towards the camera, so the farthest plane is first.
machine-more-than-before = more than in the row before
machine-heights-rows = rows of one camera, at least one

# Shapes and zones.
machine-zone-watches-nothing = `{ $link }` has no shapes: the zone would watch nothing
    .cause = `watch` names a link without `[[shapes.LINK]]`, so no distance exists.
    .cure = Describe the link's shape, or remove it from `watch`.
machine-shapes-first = a link with [[shapes.{ $link }]]
machine-zone-empty = the zone has no volume
    .cause = The zone has no `[[zones.solids]]`.
    .cure = Add a box or a half space as `[[zones.solids]]` below the zone.
machine-zone-solids = at least one [[zones.solids]]
machine-zone-shape = a permitted zone cannot have this shape
    .cause = Only box, cylinder, sphere and half space have a margin inside them.
    .cure = Replace the shape, or keep several zones: inside one of them is sufficient.
machine-part = part
machine-fixtures = fixtures
machine-solid-of-part = { $name } (part)
machine-solid-of-fixtures = { $name } (fixtures)
machine-forbidden-zone = forbidden zone { $zone }
machine-permitted-zone = permitted zone { $zone }

# Interlocks.
machine-interlocks-many = the machine has { $n ->
        [one] { $n } interlock
       *[other] { $n } interlocks
    }
    .cause = A machine has at most 64 interlocks.
    .cure = Combine conditions in the safety relay or PLC, and watch its output as one input.
machine-interlock-name-empty = the name is empty
    .cause = `name` of this interlock is empty, and alarms would have no words for it.
    .cure = Give it the name that the operator knows: `name = "chamber door"`.
machine-interlock-input-empty = the input has no name
    .cause = `input` of this interlock is empty, so no device could report it.
    .cure = Name the input, with the same name in `[devices.NAME.modbus.inputs]`.
machine-a-name = a name
machine-interlock-name-taken = another interlock has this name
    .cause = Two `[[interlocks]]` have the same `name`, so an alarm would be ambiguous.
    .cure = Rename one of them.
machine-interlocks-contradict = `{ $first }` needs input { $input } to be { $first_value }, `{ $second }` needs it to be { $second_value }: nothing could ever run
    .cause = Two `[[interlocks]]` watch the same input with opposite values of `is`.
    .cure = Look at the wiring: set `is` the same in both, or name the other input.
machine-value-or-other-input = { $value }, or another input
machine-input-taken = `{ $interlock }` watches input { $input } already
    .cause = Two `[[interlocks]]` watch the same input with the same value of `is`.
    .cure = Remove one, and keep `for` of the earlier level: power, then motion, then process.
machine-one-interlock-an-input = one interlock for each input: for = "{ $level }" is the stronger

# Devices.
machine-out-of-range = the value is out of range
    .cause = A number of a device is outside its range: `poll_hz` 20 to 1000, `watchdog_s` 0.01 to 2, for example.
    .cure = Set the key within the range in the message. A device that switches the process has `timeout_s` up to 1.
machine-unit-reserved = this unit address is reserved
    .cause = Modbus reserves the unit addresses 248 to 254.
    .cure = Set `unit` to the address in the device's settings, usually 1. Devices with their own network port often take 255.
machine-unit-allowed = 0 to 247, or 255
machine-device-without-registers = the device has no registers
    .cause = `[devices.NAME.modbus]` has an address and no registers, so nothing would be read or written.
    .cure = Add registers from the device's manual, or remove the device. Without it a simulated device is used.
machine-device-without-role = the device is neither process source nor has inputs
    .cause = The device has only a watchdog or a heart-beat.
    .cure = Add registers to `inputs`, or `outputs.on` and `reports.burning`.
machine-device-roles = registers for inputs, or for outputs.on and reports.burning
machine-host-missing = there is no host
    .cause = `address` has no host, has a space, or is an IPv6 address without brackets.
    .cure = Correct `address` of the device, as in the message.
machine-port-missing = there is no port from 1 to 65535
    .cause = The part after the last colon of `address` is not a number from 1 to 65535.
    .cure = Correct the port, or leave it out for 502.
machine-host-and-port = host:port, like 192.168.1.20:502 or [fe80::1]:502
machine-fault-code-type = a fault code is a plain u16
    .cause = `reports.fault` has another `type`, or `scale` or `offset`. The code is a whole number without a unit.
    .cure = Remove `type`, `scale` and `offset` from `reports.fault`.
machine-exactly-one-of = exactly one of { $names }
machine-register-tables = not exactly one table is named
    .cause = The register names no table, or several of `coil`, `discrete`, `holding` and `input`.
    .cure = Keep the table in which the device's manual lists it. "40001" of a manual is `holding = 0`.
machine-register-read-only = `{ $table }` can only be read, and this is written
    .cause = Outputs and values in `set` are written, and this table of a Modbus device is read-only.
    .cure = Use `coil` or `holding`, as in the device's manual.
machine-register-single-bit = `{ $table }` is a single bit
    .cause = `bit` is given for a coil or a discrete input.
    .cure = Remove `bit`, or name the register with `holding` or `input`.
machine-bit-with-register = `bit` with holding or input
machine-register-bits = a register has 16 bits
    .cause = `bit` is greater than 15.
    .cure = Count bits from 0. Bit 16 of a 32-bit value is bit 0 of its other register.
machine-bit-allowed = 0 (lowest) to 15
machine-bit-form = bit = 0 (lowest) to 15
machine-safe-of-input = only outputs have a safe state
    .cause = `safe` is given for an input, a report, a measured value or the watchdog.
    .cure = Remove `safe` here.
machine-safe-with-outputs = `safe` with gas, on and set
machine-safe-state-on = the safe state of arc or beam is off
    .cause = `outputs.on` has `safe = true`, which would strike the arc after a failure.
    .cure = Remove `safe`. If the device needs an inverted signal, invert it in the device.
machine-words-of-16-bits = 16 bits are one register
    .cause = `words` orders the two registers of a 32-bit number, and this number has one.
    .cure = Remove `words`, or set `type` to `u32`, `i32` or `f32`.
machine-words-with-32-bits = `words` with u32, i32 and f32
machine-register-last = 32 bits need two registers, and this is the last one
    .cause = A 32-bit number starts at address 65535.
    .cure = Correct the address. Manuals often count from 1, the file counts from 0.
machine-scale-zero = every number would be the same value
    .cause = `scale` is 0.
    .cure = Set `scale` to the value of one count, for example 0.1 for tenths of an ampere, or remove it.
machine-not-zero = any number but 0
machine-safe-out-of-range = the register cannot hold this value
    .cause = `safe` is a value in the unit of the process value. With `scale` and `offset` it exceeds the numbers of `type`.
    .cure = Set `safe` within the range in the message, or choose a larger `type`.
machine-register-taken = `{ $register }` is at { $address } already
    .cause = Two entries share a bit of the device. A 32-bit number occupies two addresses.
    .cure = Compare both with the device's manual, and correct address, `bit` or `type`.
machine-source-taken = device `{ $device }` is the process source already
    .cause = Two devices have registers of the process source: `gas`, `on`, `set`, reports of the source or `actual`.
    .cure = Keep these registers on one device. The other one may have `inputs`, `watchdog` and `heartbeat`.
machine-one-source = one process source
machine-source-without-register = the process source has no register for `{ $key }`
    .cause = A process source needs `outputs.on` to switch it, and `reports.burning` to see whether arc or beam burns.
    .cure = Add the register from the device's manual, usually "current flow" or "process active" for `burning`.
machine-inputs-taken = device `{ $device }` has inputs already
    .cause = Two devices have `inputs`.
    .cure = Wire all inputs to one device, and list them in its `inputs`.
machine-inputs-on-one-device = all inputs on one device
machine-input-without-register = input `{ $input }` of interlock `{ $interlock }` has no register
    .cause = A device has `inputs`, and the input of this interlock is missing there.
    .cure = Add the input to `[devices.NAME.modbus.inputs]`, or remove the interlock from the machine file.
machine-register-for-every-input = a register for the input of every interlock
machine-drives-taken = another device has the drives already
    .cause = Two devices have `linuxcnc`, `steps`, `rtde`, `egm` or `rsi`. One device drives all axes.
    .cure = Remove one of the two `[devices.NAME]`.
machine-one-device-of-drives = one device with `linuxcnc`, `steps`, `rtde`, `egm` or `rsi`
machine-robot-axis-twice = axis `{ $axis }` is named twice
    .cause = `axes` of the robot's device names an axis twice. Each joint of the control moves one axis.
    .cure = Name every axis of the machine once, in the order of the control's joints.
machine-robot-axis-missing = axis `{ $axis }` has no joint of the robot control
    .cause = One device drives all axes, and `axes` lacks this one.
    .cure = Name every axis of the machine once, in the order of the control's joints, or remove the axis from the machine.
machine-robot-axis-once = every axis of the machine once, in the order of the control's joints
machine-robot-axis-count = { $n } { $n ->
        [one] axis does
       *[other] axes do
    } not fit the joints of the robot control
    .cause = RTDE takes exactly the joints of the arm. EGM and RSI take up to six external joints beside them.
    .cure = Describe exactly the joints that the control moves. A positioner beside a Universal Robots arm cannot be driven over RTDE.
machine-robot-axis-count-allowed = { $arm } joints of the arm, and up to { $external } external joints
machine-robot-axis-linear = axis `{ $axis }` is linear, but it is a joint of the arm
    .cause = The first axes of the device are the joints of the arm, and these turn.
    .cure = Put the joints of the arm first in `axes`, then the external joints.
machine-robot-axis-rotary = rotary axes as the first { $arm }
machine-robot-listen = not an IP address with a port
    .cause = `listen` is the address of this computer to which the control sends its packets, with the UDP port.
    .cure = Write `listen = "0.0.0.0:6510"`, with the port that is configured on the control.
machine-robot-listen-allowed = an IP address of this computer and a port, as 0.0.0.0:6510
machine-robot-from = not an IP address
    .cause = `from` is the address of the robot control, without a port.
    .cure = Write the control's IP address, or remove `from`.
machine-robot-from-allowed = the IP address of the control, as 192.168.125.1
machine-hal-file = `{ $file }` is not a HAL file
    .cause = `hal` does not end in `.hal`, or it is only the ending.
    .cure = Put the HAL file beside the machine file and name it, as `hal = "mesa.hal"`.
machine-hal-file-allowed = the path of a file that ends in .hal, or no `hal`
machine-base-period = invalid period of the faster thread: { $base }
    .cause = `base_period_us` is outside 10 to 1000, or the servo period is not two or more whole base periods.
    .cure = Choose a divisor of the servo period, for example 50 for 1 ms, or remove the key.
machine-base-period-allowed = 10 to 1000, a whole number of times in the period of { $period }, at least twice
machine-axis-name-long = the name of axis `{ $axis }` is too long for LinuxCNC's HAL
    .cause = HAL names have 47 characters at most, so an axis name has 24.
    .cure = Shorten `axis`, also in the tables and in the HAL file that refer to it.
machine-name-length = up to { $max } characters

# Reasons why a pose is out of reach.
machine-unreachable-direction = the rotary axes cannot turn the torch that way; the nearest direction is { $angle } off
    .cause = Two rotary axes that are not square to each other leave out a cone of directions.
    .cure = Turn the part with `[placement]`, or change `work_angle_deg` and `travel_angle_deg` in `[torch]`.
machine-unreachable-point = the axes cannot reach the point; it is { $distance } off
    .cause = The axes move the tip only on a plane or ring, or between a nearest and a farthest point.
    .cure = Move the part with `[placement]`. If machine and part do not differ in reality, correct `at_mm` and `move_mm` of the machine file.
machine-unreachable-flat = the linear axes are parallel to a plane at these positions of the rotary axes
    .cause = A rotary axis between the slides has turned one of them parallel to the plane of the others.
    .cure = Choose other torch angles or another start `phi_deg`, so that this axis stays away from that position.
machine-out-of-reach = out of reach by { $distance }: axis { $axis } would be at { $position }, { $excess } beyond its limit { $limit }
    .cause = Every solution needs a linear axis beyond its range. The distance counts all linear axes together.
    .cure = Move the part with `[placement]` or the work offset. Compare the range with the limit switches before you change it.
machine-axis-out-of-range = axis { $axis } would be at { $position }, { $excess } beyond its limit { $limit }
    .cause = Every position for this pose, or the requested target, is beyond the range, also after whole turns back.
    .cure = Move or turn the part, or start elsewhere with `phi_deg`. An axis without end stops has `continuous = true`.
machine-pair-axes = two heads at once need three linear and three rotary axes that carry both, no two neighbouring ones parallel
    .cause = Both fillets at once need three slides and three rotary axes that carry both heads.
    .cure = Weld one side after the other: `fillet = "left"`, then `"right"`. Otherwise choose a machine with such axes.
machine-pair-same-point = the two torches are at one point: they have no common frame
    .cause = The points of both heads coincide, for example because `web_mm` is far too small.
    .cure = Check `web_mm` in `[seam.t_joint]` and `tip_mm` of both heads.
machine-pair-opposed = the two torches point at each other: they have no common frame
    .cause = The directions of both torches cancel, or their sum lies on the line through both points.
    .cure = Change `work_angle_deg` so that both torches lean to the same side of the web.

# Check of a machine: inverse kinematics and failures.
machine-method-closed = closed form
machine-method-plane-on-rotary = closed form, a plane on a rotary axis
machine-method-in-plane = closed form, in a plane
machine-method-numeric = numeric (Newton's method)
machine-method-spherical-wrist = closed form of an arm with spherical wrist
machine-method-three-parallel = closed form of an arm with three parallel axes
machine-method-spherical-shoulder = closed form of an arm with spherical shoulder and wrist
machine-free-roll = rotation about the torch
machine-linear-axes = { $n } linear ({ $axes })
machine-rotary-axes = { $n } rotary ({ $axes })
machine-linear-and-rotary = { $linear } + { $rotary }
machine-structure = { $method }: { $axes }
machine-structure-with-free = { $method }: { $axes }; redundant: { $free }
machine-check-head = head { $head }: { $why }
    .cause = A self-test of this head failed in `machine check`. The reason follows.
    .cure = Open `check.html`, and compare directions and points of the steps with the machine.
machine-check-pair = both heads at once: { $why }
    .cause = The self-test of both heads together failed in `machine check`. The reason follows.
    .cure = Open `check.html`, and compare the steps of `[[heads]]` with the machine.
machine-check-round-trip = round trip off by { $distance } mm, { $angle }°, { $difference } in an axis; poses unsolved: { $unsolved }, without their own branch: { $missed }
    .cause = Position, pose and position again differ by more than 1e-9 mm or rad per metre, or a pose has no solution.
    .cure = Look for parallel rotary axes or slides in one plane among the steps. Report a correct file as a defect of the program.
machine-check-jacobian = the Jacobian differs by { $difference } of the column of axis { $axis }
    .cause = The derivative of an axis differs by more than 1e-6 from differences of the tip position.
    .cure = Check units of `at_mm`, `move_mm` and `pitch_error` of this axis. Report a correct file as a defect of the program.

# Check of a machine: singular configurations.
machine-singular-linear = the linear axes { $axes } lie in one plane: the tip cannot leave it
    .cause = The directions of these slides are dependent, so together they have only two directions.
    .cure = Correct `move` of one of them. If a rotary axis turned it, keep welds away from that position.
machine-singular-along-axis = the torch lies along axis { $axis }: { $axis } is free there
    .cause = The torch is parallel to the axis, which then turns without moving the torch direction.
    .cure = Lean torch or part by the distance that `check.html` gives, with `[torch]` angles or `[placement]`.
machine-singular-undone = { $axes } can undo the motion of axis { $axis }: { $axis } is free there
    .cause = Slides or other axes move the torch exactly as this axis does.
    .cure = Keep welds away from the positions given, or hold the axis with `hold` in `[spare_axes]`.
machine-singular-parallel = axes { $first } and { $second } are parallel: one undoes the other
    .cause = Another rotary axis has turned the two until they are parallel, so only their sum counts.
    .cure = Keep the torch away by the distance in `check.html`. Near it one axis would exceed its speed.
machine-singular-tilt = the torch lies in the plane of axes { $first } and { $second }: both tilt it the same way
    .cause = Both axes tilt the torch in the same plane, so it does not lean to the other side there.
    .cure = Turn the part with `[placement]` so that the weld stays away from the positions given.
machine-singular-undo = axes { $axes } undo one another
    .cause = At these positions the rotary axes together have one motion that leaves the torch at rest.
    .cure = Keep welds away from the positions given, or hold one axis with `hold` in `[spare_axes]`.
machine-singular-following = { $what }, with { $axes } following
machine-singular-wrist = wrist singularity: axes { $first } and { $second } are parallel
    .cause = Joint 5 has turned the axes of joints 4 and 6 into one line.
    .cure = Lean the torch by a few degrees, or turn the part, so that joint 5 keeps the distance in `check.html`.
machine-singular-elbow = elbow singularity: the arm is stretched or folded
    .cause = Upper arm and forearm lie on one line, so the tip does not move away from or towards the base.
    .cure = Place the part nearer to the robot, or farther away if the arm is folded.
machine-singular-shoulder = shoulder singularity: the wrist is over axis { $axis }
    .cause = The centre of the wrist lies on the axis of joint 1, which then turns without moving it.
    .cure = Place the part farther from the column of the robot.
machine-singular-stretched = the arm is stretched or folded: axes { $first } and { $second } move the tip the same way
    .cause = Tip and both parallel axes lie in one plane.
    .cure = Place the part nearer, or farther away if the arm is folded.
machine-singular-tip-on-axis = the tip lies on axis { $axis }, which cannot move it
    .cause = The weld point lies on the line of a rotary axis.
    .cure = Place the weld away from the middle of the turntable, with `[placement]` and the fixture.
machine-singular-direction = the tip cannot move along ({ $x }, { $y }, { $z }) of the work
    .cause = All axes together move the tip only in a plane at these positions.
    .cure = Place the part so that the weld stays away from the positions given.
machine-singular-position = { $axis } = { $values }
machine-singular-at = { $what }, at { $positions }
machine-singular-for-example = { $what }, for example at { $positions }

# Check of a machine: unusual values and what to do.
machine-remark-period = the position loops would run every { $period }
    .cause = `servo_period_ms` is outside 0.02 to 10 ms, usually because it was given in s or us.
    .cure = Set `servo_period_ms`. A cell runs at 0.25 to 4 ms.
machine-cure-period = give the period in ms; 1 is usual
machine-remark-displacement = the displacement is longer than { $limit }
    .cause = A `fixed` step moves by more than 100 m.
    .cure = Check `move_mm` of the step: a value in micrometres is a thousand times too large.
machine-cure-displacement = give lengths in mm
machine-remark-no-shapes = the machine has no shapes: collisions are not checked
    .cause = Neither `[[shapes.torch]]` nor shapes of other links exist, so the collision monitor has nothing to compare.
    .cure = Measure torch, slides and table roughly, and add them as cylinders and boxes, slightly too large.
machine-cure-no-shapes = add [[shapes.torch]], and the same for everything else that may collide
machine-remark-home-collision = at the home position { $first } and { $second } are { $distance } apart, less than the minimum of { $min }
    .cause = Two shapes overlap or nearly touch at the home positions, or their position in the file is wrong.
    .cure = Look at `machine.svg` of `machine check`. Correct `at` of the shapes, or list pairs that may touch in `ignore` of `[clearance]`.
machine-cure-home-collision = change home_mm or home_deg of an axis, or the shapes
machine-remark-range-long = axis { $axis } would travel over { $travel }
    .cause = The range spans more than 100 m.
    .cure = Check the unit of `range_mm`.
machine-cure-range-long = give the range in mm
machine-remark-range-short = axis { $axis } would move by { $travel } in all
    .cause = The range spans less than 0.1 mm.
    .cure = Check the unit of `range_mm`.
machine-cure-range-short = give the range in mm; m may have been meant
machine-remark-turns = axis { $axis } would make { $turns } turns
    .cause = The range spans more than 100 turns.
    .cure = Correct `range_deg` to what the cables allow.
machine-cure-turns = give the range in degrees, or set continuous = true
machine-remark-range-narrow = axis { $axis } would turn by { $travel } in all
    .cause = The range spans less than 0.01 degrees.
    .cure = Check the unit of `range_deg`.
machine-cure-range-narrow = give the range in degrees
machine-remark-range-quarter-turns = axis { $axis } would turn by { $travel } in all; the ends are quarter turns in rad: { $low } to { $high }
    .cause = The range spans at most 12.6 degrees, and both ends are multiples of 1.571, a quarter turn in rad.
    .cure = Convert `range_deg` to degrees: multiply by 57.2958.
machine-remark-range-radians = axis { $axis } would turn by { $travel } in all; in rad this would be { $low } to { $high }
    .cause = The range spans at most 12.6 degrees, two turns in rad.
    .cure = Compare `range_deg` with the limit switches. Convert rad by multiplying with 57.2958.
machine-cure-range-radians = give the range in degrees; keep it if so little is meant
machine-remark-speed-high = { $speed } is faster than such an axis moves
    .cause = A linear axis is faster than 5 m/s, or a rotary axis turns faster than ten times a second.
    .cure = Divide a value in mm/min or deg/min by 60.
machine-remark-speed-low = { $speed } is slower than such an axis moves
    .cause = A linear axis is slower than 0.5 mm/s, or a rotary axis slower than 1 deg/s.
    .cure = Convert the value of the data sheet to mm/s or deg/s.
machine-cure-linear-speed-high = give the speed in mm/s; mm/min may have been meant
machine-cure-rotary-speed-high = give the speed in deg/s; deg/min may have been meant
machine-cure-linear-speed-low = give the speed in mm/s; m/s may have been meant
machine-cure-rotary-speed-low = give the speed in deg/s; rad/s or rpm may have been meant
machine-remark-speed-unreached = axis { $axis } never reaches it: acceleration and deceleration take { $needed }, and its range is { $travel }
    .cause = Speed squared over acceleration is longer than the range, so the maximum speed is never used.
    .cure = Compare speed and acceleration with the data sheet. Often one of them is in another unit.
machine-cure-linear-speed-unreached = give the speed in mm/s and the acceleration in mm/s²
machine-cure-rotary-speed-unreached = give the speed in deg/s and the acceleration in deg/s²
machine-remark-acceleration-low = axis { $axis } takes { $time } to reach its maximum speed
    .cause = The axis needs more than 60 s from rest to its maximum speed.
    .cure = Check the unit of the acceleration, and that the maximum speed is not in mm/min.
machine-remark-acceleration-high = axis { $axis } reaches its maximum speed in { $time }
    .cause = The axis reaches its maximum speed within 1 ms, about one servo period.
    .cure = Check the unit of the acceleration, and that the maximum speed is not in m/s or rad/s.
machine-remark-gravity = { $factor } times gravity is more than such an axis can stand
    .cause = The acceleration exceeds 100 m/s², ten times gravity.
    .cure = Check `max_acceleration_mm_s2` against the data sheet of the drive.
machine-cure-linear-acceleration = give the acceleration in mm/s²
machine-cure-rotary-acceleration = give the acceleration in deg/s²
machine-cure-linear-acceleration-low = give the acceleration in mm/s²; m/s² may have been meant
machine-cure-rotary-acceleration-low = give the acceleration in deg/s²; rad/s² may have been meant
machine-remark-jerk-missing = axis { $axis } has no jerk limit
    .cause = Without a jerk limit the program assumes 50 times the acceleration per second, which may excite vibrations.
    .cure = Set the jerk limit that drive or tests gave. Start low if the machine vibrates.
machine-cure-jerk-missing = add { $key }; ten times the acceleration is usual
machine-remark-jerk-low = the acceleration takes { $time } to build up
    .cause = Acceleration over jerk exceeds 2 s.
    .cure = Check the unit of the jerk against the acceleration.
machine-cure-linear-jerk = give the jerk in mm/s³
machine-cure-rotary-jerk = give the jerk in deg/s³
machine-remark-drive-missing = axis { $axis } has no drive: it is simulated with an assumed one
    .cause = The assumed drive has three times the force that the acceleration needs, and 5 % of it friction.
    .cure = Add mass or inertia, peak, friction and encoder from data sheets before you trust simulated deviations.
machine-cure-drive-missing = add [drives.{ $axis }]
machine-remark-drive-weak = axis { $axis } needs { $needed } for its acceleration at its maximum speed, friction included
    .cause = Mass times maximum acceleration plus friction exceeds `peak_force_n` or `peak_torque_n_m`.
    .cure = Check mass and peak, both as seen at the axis. Otherwise lower the maximum acceleration.
machine-cure-drive-weak = use a stronger drive, or lower max_acceleration
machine-remark-drive-strong = the drive is { $factor } times as strong as its load needs
    .cause = The peak is more than 300 times the need of the load.
    .cure = Check that mass is not in t or g, and that both values are seen at the axis.
machine-cure-linear-drive-strong = give the mass in kg and the force in N
machine-cure-rotary-drive-strong = give the inertia in kg m² and the torque in N m
machine-remark-encoder = one count is { $count }
    .cause = One count of the encoder is coarser than 0.1 mm or 0.1 degrees.
    .cure = Multiply its lines per turn by four and by the gear ratio, and divide by the travel per turn of the axis.
machine-cure-linear-encoder = give the counts per mm at the axis
machine-cure-rotary-encoder = give the counts per degree at the axis
machine-remark-velocity-loop = { $bandwidth } is too fast for a position loop every { $period }
    .cause = The bandwidth is more than a quarter of the rate of the position loop.
    .cure = Convert rad/s to Hz by dividing by 6.283. Supplied machines have 20 to 60 Hz at 1 ms.
machine-cure-velocity-loop = give the bandwidth in Hz, or a shorter servo_period_ms
machine-remark-pitch = axis { $axis } would be off by up to { $error }
    .cause = Somewhere in the range the error exceeds 1 mm or 0.5 degrees.
    .cure = Check the unit of the table: interferometers print micrometres, autocollimators arc seconds.
machine-cure-linear-pitch = give the errors in mm
machine-cure-rotary-pitch = give the errors in degrees

# Import of arms.
machine-urdf-not-xml = the file is not XML: { $why }
    .cause = The text of the URDF file breaks the rules of XML at this position, or it has a document type definition.
    .cure = Correct the element at this position, or export the robot again.
machine-urdf-cure-xml = Correct the XML here, or export the file again.
machine-urdf-attribute-missing = the element lacks the attribute `{ $name }`
    .cause = URDF requires this attribute.
    .cure = Add the attribute to the element.
machine-urdf-cure-attribute = Add `{ $name }="…"` to the element.
machine-urdf-element-missing = the element lacks `<{ $name }>`
    .cause = A joint connects a parent link with a child link, and both must be named.
    .cure = Add the element to the joint.
machine-urdf-cure-element = Add `<{ $name } link="…"/>` to the joint.
machine-urdf-not-numbers = invalid numbers
    .cause = The attribute has another count of numbers than it needs, or a part of it is not a finite number.
    .cure = Write the numbers with a decimal point and blanks between them.
machine-urdf-cure-numbers = Numbers needed here: { $n }, with blanks between them, as `0.1 0 0.25`.
machine-urdf-root = the root element is `{ $name }`, not `robot`
    .cause = The file is XML, but not a URDF file: it may be SDF, MJCF or Collada.
    .cure = Convert it to URDF first.
machine-urdf-empty = the file has no links
    .cause = The element `robot` has no `link`.
    .cure = Export the robot again; or expand the macros of a xacro file.
machine-urdf-cure-root = Give a URDF file: its root is `<robot>`, with `<link>` and `<joint>` in it.
machine-urdf-xacro = the file has xacro macros
    .cause = A xacro file is a program that generates a URDF file, and the import reads the result only.
    .cure = Expand it first: `xacro robot.urdf.xacro > robot.urdf`.
machine-urdf-cure-xacro = Expand the macros first: `xacro robot.urdf.xacro > robot.urdf`.
machine-urdf-two-parents = link `{ $link }` is already the child of joint `{ $joint }`
    .cause = The links of a URDF file are a tree: one joint carries each link.
    .cure = Remove one of the joints. Leave out the rod of a parallelogram.
machine-urdf-loop = link `{ $link }` is part of a closed loop
    .cause = The joints lead around in a circle, so that no link is the base.
    .cure = Remove the joint that closes the loop.
machine-urdf-cure-tree = Remove one of the joints: every link has one joint that carries it.
machine-urdf-name-taken = the name `{ $name }` is used twice
    .cause = Links have names of their own, and so have joints.
    .cure = Rename one of the two.
machine-urdf-cure-name = Rename one of the two.
machine-urdf-link-unknown = there is no link `{ $link }`
    .cause = The name differs from those of all links, also by capitals.
    .cure = Give the name of a link of the file.
machine-urdf-cure-link = Give one of the links of the file.
machine-urdf-axis-zero = the axis has no direction
    .cause = All three numbers of `xyz` are 0.
    .cure = Give the direction of the axis in the frame of the joint, as `0 0 1`.
machine-urdf-cure-axis = Give a direction, as `xyz="0 0 1"`.
machine-urdf-size = the size is not greater than 0
    .cause = A box, cylinder or sphere for collision checks has no volume.
    .cure = Correct the size in metres, or import without shapes: `--no-shapes`.
machine-urdf-cure-size = Give sizes in metres greater than 0.
machine-urdf-roots = the file has several base links: { $links }
    .cause = More than one link is carried by no joint, so that the base is not known.
    .cure = Choose one with `--base LINK`.
machine-urdf-cure-roots = Choose the base: `--base LINK`.
machine-urdf-tips = the tree has { $n } ends that axes move: { $links }
    .cause = A machine file has one chain to the torch, and this robot has several arms, fingers or frames at its end.
    .cure = Choose the link that carries the torch with `--tip LINK`.
machine-urdf-cure-tips = Choose the link that carries the torch: `--tip LINK`.
machine-urdf-no-axes = no axis moves a link that is carried by `{ $link }`
    .cause = All joints behind the base are fixed.
    .cure = Choose another base, or give the joints their types.
machine-urdf-cure-no-axes = Choose another base with `--base LINK`, or make joints `revolute` or `prismatic`.
machine-urdf-not-carried = the base `{ $base }` does not carry the link `{ $tip }`
    .cause = The joints from this link towards the root do not lead to the chosen base.
    .cure = Choose base and tip on one branch of the tree.
machine-urdf-cure-not-carried = Choose another `--base` or `--tip`.
machine-urdf-axes = number of axes up to link `{ $link }`: { $n }
    .cause = A machine file has at least one axis, and at most as many as stated.
    .cure = Choose base and tip around the axes of the arm.
machine-urdf-cure-axes = Choose `--base` and `--tip` with 1 to { $max } axes between them.
machine-urdf-too-long = the chain from base to tip is { $length } long: no arm in metres
    .cause = Lengths of URDF are in metres. These are probably in mm: the robot is 1,000 times too large.
    .cure = Import with `--scale 0.001`, or export the file in metres.
machine-urdf-too-short = the chain from base to tip is { $length } long: no arm in metres
    .cause = Lengths of URDF are in metres. The robot is probably 1,000 times too small.
    .cure = Import with `--scale 1000`, or export the file in metres.
machine-urdf-cure-scale = URDF is in metres. Import with `--scale { $factor }`, or export the file in metres.
machine-urdf-degrees = the angles of joint `{ $joint }` are no angles in rad
    .cause = Positions of rotary joints are in rad and speeds in rad/s. These are probably in degrees.
    .cure = Divide the limits by 57.29578, or give the joint the type `continuous` if it has no end stops.
machine-urdf-cure-degrees = Write limits in rad and rad/s: degrees divided by 57.29578.
machine-urdf-joint-type = the type of joint `{ $joint }` is not an axis
    .cause = Machine files have rotary and linear axes. The joint is `floating`, `planar`, or of an unknown type.
    .cure = Make it `fixed`, or choose a base behind it.
machine-urdf-cure-joint-type = Allowed between base and tip: `revolute`, `continuous`, `prismatic`, `fixed`.
machine-urdf-mimic = joint `{ $joint }` follows joint `{ $other }`
    .cause = A joint with `mimic` has no position of its own, and machine files have no coupled axes.
    .cure = Choose a tip before it; or make it `fixed`; or remove `mimic` if it has a drive of its own.
machine-urdf-cure-mimic = Choose a `--tip` before this joint, or make it `fixed`, or remove `<mimic>` if it has a drive of its own.
machine-urdf-limit-missing = joint `{ $joint }` has no limits
    .cause = An axis needs a range and a maximum speed, and they have no default.
    .cure = Add `<limit lower="…" upper="…" velocity="…" effort="…"/>` with the values of the data sheet.
machine-urdf-limit-empty = the range of joint `{ $joint }` is empty
    .cause = The lower limit is not below the upper one; a missing limit counts as 0.
    .cure = Correct `lower` and `upper`, or give the joint the type `continuous` if it has no end stops.
machine-urdf-cure-limit = Write `<limit lower="…" upper="…" velocity="…" effort="…"/>` in rad, rad/s and N m, or in m, m/s and N, as on the data sheet.
machine-urdf-velocity = joint `{ $joint }` has no maximum speed
    .cause = `velocity` is missing or not greater than 0.
    .cure = Add `velocity` to `limit`, with the value of the data sheet in rad/s or m/s.
machine-urdf-cure-velocity = Give `velocity` of the data sheet, in rad/s or m/s.
machine-urdf-mesh-missing = there is no mesh `{ $mesh }`
    .cause = The file names a mesh of another package or folder, and it is not there.
    .cure = Give the folder of the package with `--package NAME=DIR`, or import without shapes: `--no-shapes`.
machine-urdf-mesh-tried = a file at one of: { $files }
machine-urdf-cure-mesh = Give the folder of its package, `--package NAME=DIR`, or import without shapes, `--no-shapes`.
machine-import-rounded-angles = { $n } angles of the source are rounded multiples of 15 degrees, as 1.5708; they were read as exact ones
machine-import-flange = of several ends ({ $links }) the flange `tool0` was chosen; `--tip` chooses another
machine-import-held = joints beside the chain stay at zero: { $joints }
machine-import-no-shapes = there are no shapes: clearance is not checked
machine-import-shape-kind = a shape of link { $link } was left out: `{ $kind }` is not a box, cylinder, sphere or mesh
machine-import-mesh-format = the mesh { $file } of link { $link } was left out: convert it to STL
machine-import-mesh-unusable = the mesh { $file } of link { $link } was left out: { $why }
machine-import-mesh-stretched = its scale differs along x, y and z
