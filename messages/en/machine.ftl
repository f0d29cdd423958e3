# Steps and axes of the machine file.
machine-step-neither = the step is neither an axis nor fixed
machine-step-kinds = either `axis` with its keys, or `fixed` alone
machine-step-fixed-axis = the step has both `axis` and `fixed`
machine-step-fixed-apart = `fixed` in a step of its own
machine-axis-name-invalid = the axis name has invalid characters
machine-plain-letters = lower-case letters, digits and _
machine-axis-name-reserved = the name is reserved for another column of tables
machine-axis-turn-or-move = an axis either turns or moves
machine-turn-or-move = exactly one of `turn` and `move`
machine-axis-key-of-rotary = a linear axis has no such key
machine-only-with-turn = only with `turn`
machine-axis-lacks-key = axis `{ $axis }` lacks `{ $key }`
machine-key-positive = { $key } = a number greater than 0
machine-home-outside-range = the home position is outside the range
machine-letter-invalid = not an axis letter
machine-linear-axis-in-mm = a linear axis is in mm
machine-rotary-axis-in-degrees = a rotary axis is in degrees
machine-range-of-continuous = a continuous axis has no range
machine-continuous-or-range = `continuous` or a range
machine-range-missing = the axis has no range
machine-range-form = { $key } = [minimum, maximum]
machine-range-form-or-continuous = { $key } = [minimum, maximum], or continuous = true
machine-range-empty = the range is empty
machine-axis-name-taken = another axis has this name
machine-axis-letter-taken = another axis has this letter
machine-own-letter = a letter of its own
machine-axes-count = the machine has { $n ->
        [one] { $n } axis
       *[other] { $n } axes
    }
machine-axes-allowed = 1 to { $max } axes in [[tool]] and [[work]]
machine-home-order-twice = the axis is in the list already
machine-each-axis-once = each axis once

# Torch and heads.
machine-torch-and-heads = the machine has both `[torch]` and `[[heads]]`
machine-torch-or-heads = `[torch]` for one head, `[[heads]]` for two
machine-torch-missing = the machine has no torch
machine-torch-form = `[torch]` with `direction`, or two `[[heads]]`
machine-heads-many = the machine has { $n ->
        [one] { $n } head
       *[other] { $n } heads
    }
machine-head-without-steps = head `{ $head }` has no steps of its own: nothing carries it
machine-head-steps = `[[heads.steps]]` for every head
machine-head-name-taken = an axis, another head or a frame has this name

# Outputs and controls.
machine-output-taken = `{ $name }` has this output already
machine-own-output = an output of its own
machine-address-invalid = invalid address
machine-address-form = a capital letter other than G and N, then capitals, digits and _, like X or CW
machine-address-taken = another axis or process value has this address
machine-own-address = an address of its own
machine-code-invalid = invalid G- or M-code
machine-code-form = G or M and a number, like M54
machine-event-invalid = invalid name of an event
machine-event-names = { $names }, or a name of its own in lower-case letters, digits and _
machine-kinematics-output = only LinuxCNC switches the kinematics by an output

# Drives.
machine-drive-of-linear = the drive of a linear axis has mass and force, and lengths in mm
machine-drive-of-rotary = the drive of a rotary axis has inertia and torque, and angles in degrees
machine-drive-key-missing = the drive lacks a key
machine-drive-limit-range = the limit is not between friction and peak
machine-drive-without-resonance = without a resonance, motor and load are one mass
machine-drive-resonance-alone = a resonance needs the ratio of load to motor inertia
machine-together-with = together with `{ $key }`
machine-fraction-too-large = the fraction is greater than 1
machine-notches-many = the position loop has too many notch filters
machine-notch-too-high = { $frequency } is not below half the sampling rate
machine-notch-depth = the gain at the centre is greater than 1
machine-friction-smoothing-alone = there is no friction compensation
machine-backlash-time-alone = there is no backlash compensation

# Steppers and their pulses.
machine-full-steps = a two-phase motor has 4 full steps for each tooth of its rotor
machine-multiple-of-4 = a multiple of 4, usually 200
machine-microsteps-invalid = invalid microstep settings of the driver
machine-microsteps-allowed = whole numbers from 1 to { $max }, increasing, at least one
machine-pulse-time = pulses that are high and low for { $time } each are too long for this frequency
machine-stepper-lacks-key = the stepper lacks `{ $key }`
machine-motor-key-missing = the motor lacks a key
machine-motor-keys = rotor_inertia_kg_m2, torque_rpm and torque_n_m together, or without all three
machine-torque-lengths = speeds: { $speeds }, torques: { $torques }
machine-torque-equal-lengths = as many torques as speeds, at least 2
machine-torque-speeds = the torque curve does not start at rest with increasing speeds
machine-zero-then-increasing = 0 first, then increasing
machine-torque-holding = the motor has no holding torque
machine-torque-first = a holding torque greater than 0 first
machine-stepper-missing = axis `{ $axis }` has no stepper for pulses
machine-stepper-or-other-drives = [drives.{ $axis }.stepper], or drives other than `steps`
machine-resolution-too-fine = the finest setting of the driver is coarser than this
machine-pulse-rate = axis `{ $axis }` needs pulses at { $needed } at its maximum speed ({ $speed }, microsteps: { $microsteps }); the driver takes up to { $possible }
machine-pulse-rate-allowed = a maximum speed up to { $speed }, a coarser `{ $resolution }`, or a faster driver (max_pulse_hz, min_pulse_us)
machine-pulses-after-reversal = after a reversal, { $n ->
        [one] { $n } pulse does
       *[other] { $n } pulses do
    } not fit into the period
machine-direction-times-allowed = direction_setup_us and direction_hold_us of up to { $time } together
machine-tick = the timer has ticks of { $tick }
machine-tick-allowed = 10 to 100000 ns, a whole number of times in the period of { $period }
machine-stream-file = `{ $file }` is not a value change dump
machine-stream-file-allowed = the path of a file that ends in .vcd, or no `stream`

# Pitch errors.
machine-pitch-in-mm = the pitch-error table of axis `{ $axis }` is in mm
machine-pitch-in-degrees = the pitch-error table of axis `{ $axis }` is in degrees
machine-pitch-keys = { $positions } and { $errors }, lists of equal length
machine-pitch-lengths = positions: { $positions }, errors: { $errors }
machine-pitch-equal-lengths = as many errors as positions, at least 2
machine-pitch-positions = invalid positions of the pitch-error table
machine-increasing-positions = increasing positions
machine-increasing-within-a-turn = increasing positions within one turn
machine-pitch-steep = the error changes by { $slope } of the motion: too steep for a pitch error

# Sensors.
machine-image-width = invalid width of the image
machine-image-height = invalid height of the image
machine-image-size = 1 to { $max } columns and rows
machine-frames-of-stripe = a stripe sensor has no stream of frames
machine-frames-invalid = invalid source of frames
machine-frames-form = for a camera: "tcp://HOST:PORT"
machine-stripe-map-missing = a stripe sensor needs `map`, from pixels to mm
machine-stripe-maps = `map.camera`, `map.homography` or `map.scale`
machine-camera-angle = the camera would not see the joint
machine-map-of-camera = this map is for a camera
machine-map-singular = different pixels would have the same position
machine-map-invertible = numbers of an invertible map
machine-map-horizon = the pixel ({ $column }, { $row }) is beyond the horizon: it sees no point of the laser plane
machine-map-every-pixel = a map that gives every pixel of the image a position
machine-camera-map-missing = a camera needs `map.heights`
machine-heights-order = z does not increase from row to row
machine-more-than-before = more than in the row before
machine-heights-rows = rows of one camera, at least one

# Shapes and zones.
machine-zone-watches-nothing = `{ $link }` has no shapes: the zone would watch nothing
machine-shapes-first = a link with [[shapes.{ $link }]]
machine-zone-empty = the zone has no volume
machine-zone-solids = at least one [[zones.solids]]
machine-zone-shape = a permitted zone cannot have this shape
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
machine-interlock-name-empty = the name is empty
machine-interlock-input-empty = the input has no name
machine-a-name = a name
machine-interlock-name-taken = another interlock has this name
machine-interlocks-contradict = `{ $first }` needs input { $input } to be { $first_value }, `{ $second }` needs it to be { $second_value }: nothing could ever run
machine-value-or-other-input = { $value }, or another input
machine-input-taken = `{ $interlock }` watches input { $input } already
machine-one-interlock-an-input = one interlock for each input: for = "{ $level }" is the stronger

# Devices.
machine-out-of-range = the value is out of range
machine-unit-reserved = this unit address is reserved
machine-unit-allowed = 0 to 247, or 255
machine-device-without-registers = the device has no registers
machine-device-without-role = the device is neither process source nor has inputs
machine-device-roles = registers for inputs, or for outputs.on and reports.burning
machine-host-missing = there is no host
machine-port-missing = there is no port from 1 to 65535
machine-host-and-port = host:port, like 192.168.1.20:502 or [fe80::1]:502
machine-fault-code-type = a fault code is a plain u16
machine-exactly-one-of = exactly one of { $names }
machine-register-tables = not exactly one table is named
machine-register-read-only = `{ $table }` can only be read, and this is written
machine-register-single-bit = `{ $table }` is a single bit
machine-bit-with-register = `bit` with holding or input
machine-register-bits = a register has 16 bits
machine-bit-allowed = 0 (lowest) to 15
machine-bit-form = bit = 0 (lowest) to 15
machine-safe-of-input = only outputs have a safe state
machine-safe-with-outputs = `safe` with gas, on and set
machine-safe-state-on = the safe state of arc or beam is off
machine-words-of-16-bits = 16 bits are one register
machine-words-with-32-bits = `words` with u32, i32 and f32
machine-register-last = 32 bits need two registers, and this is the last one
machine-scale-zero = every number would be the same value
machine-not-zero = any number but 0
machine-safe-out-of-range = the register cannot hold this value
machine-register-taken = `{ $register }` is at { $address } already
machine-source-taken = device `{ $device }` is the process source already
machine-one-source = one process source
machine-source-without-register = the process source has no register for `{ $key }`
machine-inputs-taken = device `{ $device }` has inputs already
machine-inputs-on-one-device = all inputs on one device
machine-input-without-register = input `{ $input }` of interlock `{ $interlock }` has no register
machine-register-for-every-input = a register for the input of every interlock
machine-drives-taken = another device has the drives already
machine-one-device-of-drives = one device with `linuxcnc` or `steps`
machine-hal-file = `{ $file }` is not a HAL file
machine-hal-file-allowed = the path of a file that ends in .hal, or no `hal`
machine-base-period = invalid period of the faster thread: { $base }
machine-base-period-allowed = 10 to 1000, a whole number of times in the period of { $period }, at least twice
machine-axis-name-long = the name of axis `{ $axis }` is too long for LinuxCNC's HAL
machine-name-length = up to { $max } characters

# Reasons why a pose is out of reach.
machine-unreachable-direction = the rotary axes cannot turn the torch that way; the nearest direction is { $angle } off
machine-unreachable-point = the axes cannot reach the point; it is { $distance } off
machine-unreachable-flat = the linear axes are parallel to a plane at these positions of the rotary axes
machine-out-of-reach = out of reach by { $distance }: axis { $axis } would be at { $position }, { $excess } beyond its limit { $limit }
machine-axis-out-of-range = axis { $axis } would be at { $position }, { $excess } beyond its limit { $limit }
machine-pair-axes = two heads at once need three linear and three rotary axes that carry both, no two neighbouring ones parallel
machine-pair-same-point = the two torches are at one point: they have no common frame
machine-pair-opposed = the two torches point at each other: they have no common frame

# Check of a machine: inverse kinematics and failures.
machine-method-closed = closed form
machine-method-plane-on-rotary = closed form, a plane on a rotary axis
machine-method-in-plane = closed form, in a plane
machine-method-numeric = numeric (Newton's method)
machine-linear-axes = { $n } linear ({ $axes })
machine-rotary-axes = { $n } rotary ({ $axes })
machine-linear-and-rotary = { $linear } + { $rotary }
machine-structure = { $method }: { $axes }
machine-structure-with-free = { $method }: { $axes }; redundant: { $free }
machine-check-head = head { $head }: { $why }
machine-check-pair = both heads at once: { $why }
machine-check-round-trip = round trip off by { $distance } mm, { $angle }°, { $difference } in an axis; poses unsolved: { $unsolved }, without their own branch: { $missed }
machine-check-jacobian = the Jacobian differs by { $difference } of the column of axis { $axis }

# Check of a machine: singular configurations.
machine-singular-linear = the linear axes { $axes } lie in one plane: the tip cannot leave it
machine-singular-along-axis = the torch lies along axis { $axis }: { $axis } is free there
machine-singular-undone = { $axes } can undo the motion of axis { $axis }: { $axis } is free there
machine-singular-parallel = axes { $first } and { $second } are parallel: one undoes the other
machine-singular-tilt = the torch lies in the plane of axes { $first } and { $second }: both tilt it the same way
machine-singular-undo = axes { $axes } undo one another
machine-singular-following = { $what }, with { $axes } following
machine-singular-wrist = wrist singularity: axes { $first } and { $second } are parallel
machine-singular-elbow = elbow singularity: the arm is stretched or folded
machine-singular-shoulder = shoulder singularity: the wrist is over axis { $axis }
machine-singular-stretched = the arm is stretched or folded: axes { $first } and { $second } move the tip the same way
machine-singular-tip-on-axis = the tip lies on axis { $axis }, which cannot move it
machine-singular-direction = the tip cannot move along ({ $x }, { $y }, { $z }) of the work
machine-singular-position = { $axis } = { $values }
machine-singular-at = { $what }, at { $positions }
machine-singular-for-example = { $what }, for example at { $positions }

# Check of a machine: unusual values and what to do.
machine-remark-period = the position loops would run every { $period }
machine-cure-period = give the period in ms; 1 is usual
machine-remark-displacement = the displacement is longer than { $limit }
machine-cure-displacement = give lengths in mm
machine-remark-no-shapes = the machine has no shapes: collisions are not checked
machine-cure-no-shapes = add [[shapes.torch]], and the same for everything else that may collide
machine-remark-home-collision = at the home position { $first } and { $second } are { $distance } apart, less than the minimum of { $min }
machine-cure-home-collision = change home_mm or home_deg of an axis, or the shapes
machine-remark-range-long = axis { $axis } would travel over { $travel }
machine-cure-range-long = give the range in mm
machine-remark-range-short = axis { $axis } would move by { $travel } in all
machine-cure-range-short = give the range in mm; m may have been meant
machine-remark-turns = axis { $axis } would make { $turns } turns
machine-cure-turns = give the range in degrees, or set continuous = true
machine-remark-range-narrow = axis { $axis } would turn by { $travel } in all
machine-cure-range-narrow = give the range in degrees
machine-remark-range-quarter-turns = axis { $axis } would turn by { $travel } in all; the ends are quarter turns in rad: { $low } to { $high }
machine-remark-range-radians = axis { $axis } would turn by { $travel } in all; in rad this would be { $low } to { $high }
machine-cure-range-radians = give the range in degrees; keep it if so little is meant
machine-remark-speed-high = { $speed } is faster than such an axis moves
machine-remark-speed-low = { $speed } is slower than such an axis moves
machine-cure-linear-speed-high = give the speed in mm/s; mm/min may have been meant
machine-cure-rotary-speed-high = give the speed in deg/s; deg/min may have been meant
machine-cure-linear-speed-low = give the speed in mm/s; m/s may have been meant
machine-cure-rotary-speed-low = give the speed in deg/s; rad/s or rpm may have been meant
machine-remark-speed-unreached = axis { $axis } never reaches it: acceleration and deceleration take { $needed }, and its range is { $travel }
machine-cure-linear-speed-unreached = give the speed in mm/s and the acceleration in mm/s²
machine-cure-rotary-speed-unreached = give the speed in deg/s and the acceleration in deg/s²
machine-remark-acceleration-low = axis { $axis } takes { $time } to reach its maximum speed
machine-remark-acceleration-high = axis { $axis } reaches its maximum speed in { $time }
machine-remark-gravity = { $factor } times gravity is more than such an axis can stand
machine-cure-linear-acceleration = give the acceleration in mm/s²
machine-cure-rotary-acceleration = give the acceleration in deg/s²
machine-cure-linear-acceleration-low = give the acceleration in mm/s²; m/s² may have been meant
machine-cure-rotary-acceleration-low = give the acceleration in deg/s²; rad/s² may have been meant
machine-remark-jerk-missing = axis { $axis } has no jerk limit
machine-cure-jerk-missing = add { $key }; ten times the acceleration is usual
machine-remark-jerk-low = the acceleration takes { $time } to build up
machine-cure-linear-jerk = give the jerk in mm/s³
machine-cure-rotary-jerk = give the jerk in deg/s³
machine-remark-drive-missing = axis { $axis } has no drive: it is simulated with an assumed one
machine-cure-drive-missing = add [drives.{ $axis }]
machine-remark-drive-weak = axis { $axis } needs { $needed } for its acceleration at its maximum speed, friction included
machine-cure-drive-weak = use a stronger drive, or lower max_acceleration
machine-remark-drive-strong = the drive is { $factor } times as strong as its load needs
machine-cure-linear-drive-strong = give the mass in kg and the force in N
machine-cure-rotary-drive-strong = give the inertia in kg m² and the torque in N m
machine-remark-encoder = one count is { $count }
machine-cure-linear-encoder = give the counts per mm at the axis
machine-cure-rotary-encoder = give the counts per degree at the axis
machine-remark-velocity-loop = { $bandwidth } is too fast for a position loop every { $period }
machine-cure-velocity-loop = give the bandwidth in Hz, or a shorter servo_period_ms
machine-remark-pitch = axis { $axis } would be off by up to { $error }
machine-cure-linear-pitch = give the errors in mm
machine-cure-rotary-pitch = give the errors in degrees
