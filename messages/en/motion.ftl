# Limits of axes and of the torch tip.
motion-limit-speed = speed limit
motion-limit-acceleration = acceleration limit
motion-limit-jerk = jerk limit

# Speed that the axes do not allow.
motion-speed-axis = axis { $axis } cannot keep { $asked }: its { $limit } of { $value } allows { $reached }
motion-speed-tip = the torch tip cannot keep { $asked }: its { $limit } of { $value } allows { $reached }
motion-speed-rounded-off = the tip moves at { $reached } instead of { $asked }: the requested speed changes there, and the speed profile rounds the change off
motion-speed-slowed = { $reason }; the weld slows down there, as requested
motion-too-short = the weld is too short: it reaches { $reached } of { $asked } between acceleration and deceleration phase
motion-too-short-between-stops = the path between two stops is too short: it reaches { $reached } of { $asked } between acceleration and deceleration phase
motion-no-speed-profile = the axes of { $machine } have no speed profile: { $reason }
motion-profile-limit = the { $limit } of channel { $channel } is { $value }; it must be a finite number greater than 0 (a jerk limit may be infinite)
motion-profile-asked = the requested speed at { $at } is { $value }; it must be greater than 0
motion-profile-range = the path goes from { $from } to { $to }; its end must be a finite number greater than its start
motion-profile-not-smooth = channel { $channel } is not smooth at { $at }: a derivative is not a finite number
motion-profile-still = nothing moves between { $from } and { $to }: no limit bounds the speed there

# Weave that is too fast.
motion-weave-frequency = the weave is too fast: { $reason }; with a width of { $width } its maximum frequency is { $frequency }
motion-weave-pitch = the weave is too fast: { $reason }; with a width of { $width } its minimum pitch is { $pitch }

# Corners: stops and blends.
motion-stop = the torch stops at s = { $s } with the arc on: the speed or acceleration of axis { $axis } would jump there
motion-stop-because = the torch stops at s = { $s } with the arc on: the speed or acceleration of axis { $axis } would jump there; { $reason }
motion-blend = the torch rounds the corner at s = { $s }: over { $over } its tip deviates from the seam by up to { $deviation }
motion-blend-turned = the torch rounds the corner at s = { $s }: over { $over } its tip deviates from the seam by up to { $deviation }, its direction by up to { $turned }
motion-blend-no-room = there is no room for a blend: the next corner or end is { $distance } away
motion-blend-turns-back = the path turns back on itself there, and no blend is possible
motion-blend-too-far = the shortest blend, over { $over }, takes the tip more than { $deviation } from the seam, or turns the torch by more than { $turned } from the requested direction
motion-cure-stop-weave = set corner = "stop" to stop there with the arc on; or weave by pitch_mm instead of a frequency; or round the seam off; or end the weld there and start another after it
motion-cure-stop-or-blend = set corner = "stop" to stop there with the arc on, or corner = {"{ blend_mm = 0.2 }"} to round the corner within that distance of the seam; or round the seam off; or end the weld there and start another after it
motion-cure-stop = set corner = "stop" to stop at corners; or round the seam off; or end the weld there and start another after it

# Minimum speed of the welding procedure with the arc on.
motion-least-speed-stop = the tip moves at { $reached } at s = { $at } with the arc on, and the procedure's minimum speed is { $minimum }: it stops at a corner there
motion-least-speed-axis = the tip moves at { $reached } at s = { $at } with the arc on, and the procedure's minimum speed is { $minimum }: the { $limit } of axis { $axis }, { $value }, does not allow more
motion-least-speed-tip = the tip moves at { $reached } at s = { $at } with the arc on, and the procedure's minimum speed is { $minimum }: the { $limit } of the torch tip, { $value }, does not allow more
motion-least-speed-short = the tip moves at { $reached } at s = { $at } with the arc on, and the procedure's minimum speed is { $minimum }: the weld is too short to reach more
motion-least-speed-start = the torch starts from rest with the arc on: over { $over } it is slower than the procedure's minimum speed of { $minimum }
motion-least-speed-end = the torch comes to rest with the arc on: over { $over } it is slower than the procedure's minimum speed of { $minimum }
motion-cure-least-speed-blend = set corner = {"{ blend_mm = 0.2 }"} to round corners within that distance of the seam; or end the weld before it and start another after it; or lower least_speed_mm_s if the procedure is qualified for that
motion-cure-least-speed-axis = place the work or turn the torch so that axis { $axis } moves less there; or end the weld before it and start another after it; or lower least_speed_mm_s if the procedure is qualified for that
motion-cure-least-speed-tip = raise the limits of the tip in the machine file, if the torch allows it; or end the weld before it and start another after it; or lower least_speed_mm_s if the procedure is qualified for that
motion-cure-least-speed-longer = make the weld longer; or end the weld before it and start another after it; or lower least_speed_mm_s if the procedure is qualified for that

# Operator actions against a speed that the axes do not allow.
motion-cure-longer-change = let the speed change over a longer distance, or set weld.on_limit = "slow" to slow down there
motion-cure-speed = ask for { $speed }, which every axis can keep everywhere, or set weld.on_limit = "slow" to slow down there
motion-cure-speed-or-blend = ask for { $speed }, which every axis can keep everywhere, or set weld.on_limit = "slow" to slow down there, or allow a longer blend
motion-cure-speed-part = ask for { $part } of the speed, which every axis can keep everywhere, or set weld.on_limit = "slow" to slow down there
motion-cure-speed-part-or-blend = ask for { $part } of the speed, which every axis can keep everywhere, or set weld.on_limit = "slow" to slow down there, or allow a longer blend
motion-cure-slow = set weld.on_limit = "slow" to slow down there
motion-cure-slow-or-blend = set weld.on_limit = "slow" to slow down there, or allow a longer blend
motion-cure-speed-at-most = ask for { $speed } or less, or set weld.on_limit = "slow"
motion-cure-weave-frequency = ask for a frequency_hz of { $frequency } or a smaller width, or set weld.on_limit = "slow" to slow down there
motion-cure-weave-pitch = ask for a pitch_mm of { $pitch }, a smaller width or a lower speed, or set weld.on_limit = "slow" to slow down there
motion-cure-limits = give the machine's axes finite limits greater than 0, and the pass a speed and a length

# Times.
motion-time-too-long = { $key } = { $time }: a pass may take { $limit } at most
motion-cure-time = set { $key } to { $limit } or less
motion-travel-too-long = at the requested speed the travel takes { $time }: a pass may take { $limit } at most
motion-cure-travel = ask for a higher speed_mm_s, or divide the weld into several passes
motion-travel-too-long-axes = with the limits of the axes the travel takes { $time }: a pass may take { $limit } at most
motion-cure-travel-axes = give the machine's axes higher speeds and accelerations, or divide the weld into several passes

# Reach and ranges of the axes.
motion-unreachable = { $machine }: { $reason }
motion-cure-unreachable = change the placement of the work, the torch angles or the machine
motion-no-solution = no axis positions follow the path
motion-no-positions = no axis positions reach it
motion-axis-beyond = axis { $axis } would have to go { $by } beyond its range
motion-unreachable-redundant = { $machine }, at every position of its redundant axes: { $reason }
motion-cure-unreachable-redundant = change the placement of the work, the torch angles or the axes held
motion-beyond-range = axis { $axis } would go to { $value }, { $by } beyond its limit { $limit }
motion-cure-range = place the work so that the axis stays in its range
motion-attitude = { $machine } has too few axes for the whole torch attitude: it is up to { $error } off the requested one (tolerance { $tolerance })
motion-cure-attitude = change the torch angles, use a machine with one more rotary axis, or allow more with tolerance.attitude_deg
motion-not-smooth = the axes of { $machine } cannot follow the torch smoothly here: it passes a singular attitude
motion-not-smooth-redundant = at every position of the redundant axes of { $machine }, the other axes cannot follow the torch smoothly: it passes a singular attitude or leaves their reach
motion-jump = every position can be reached, but not continuously: between s = { $from } and { $to } axis { $axis } would have to jump by { $by }
motion-cure-jump = not tried: welding the seam in parts (start.end_phi_deg), another start or another placement of the work may help
motion-near-singular = { $distance } from a singular attitude, axis { $axis } needs { $used } of what it can do at { $asked }; the seam could hold { $holds } here
motion-cure-near-singular = lean the torch or the work a few degrees away to gain room

# Axes that are held.
motion-hold-unknown = there is no axis { $axis } between the work and the torch
motion-hold-decided = axis { $axis } is not redundant: a torch pose determines all axes here
motion-hold-too-few = with { $held } held, the other axes do not reach every torch pose
motion-hold-range = axis { $axis } would be held at { $value }, outside its range
motion-hold-allowed-none = no axis
motion-hold-allowed-count = { $axes ->
    [1] one axis, or another one
   *[other] up to { $axes } axes, or others
}

# Changes of the job that were tried as cures.
motion-change-move = move the work by { $x }, { $y }, { $z } along x, y, z (placement.move_mm)
motion-change-work-angle = change torch.work_angle_deg by { $by }
motion-change-work-angles = change work_angle_deg of every [[torch.at]] by { $by }
motion-cure-range-weld = { $change }: tried, every axis then stays in its range
motion-cure-range-pass = { $change }: tried for this pass, every axis then stays in its range
motion-cure-range-none = none was found: moving the work and changing the work angle were tried
motion-cure-range-none-moved = none was found: moving the work was tried
motion-cure-range-none-angle = none was found: changing the work angle was tried
motion-cure-range-none-stroke = { $tried }; axis { $axis } would need { $needed } along the seam, its range is { $stroke }
motion-cure-redundant = no change was tried with redundant axes: place the work nearer to the middle of the axes' ranges
motion-cure-range-no-time = no change was tried in the allowed time
motion-cure-range-stopped = { $changes ->
    [one] none was found in the allowed time: { $tried } of { $changes } change was tried
   *[other] none was found in the allowed time: { $tried } of { $changes } changes were tried
}
motion-cure-not-tried = not tried: other torch angles or another placement of the work may help

# Clearance.
motion-too-near = { $first } comes within { $distance } of { $second } (at least { $minimum })
motion-collision = { $first } collides with { $second } (at least { $minimum })
motion-cure-clearance = change the torch angles or the placement, or allow less with clearance.least_mm if the shapes are right
motion-cure-clearance-weld = { $change }: tried, nothing then comes too near; or allow less with clearance.least_mm if the shapes are right
motion-cure-clearance-pass = { $change }: tried for this pass, nothing then comes too near; or allow less with clearance.least_mm if the shapes are right
motion-cure-clearance-none = none was found: work angles up to { $angle } from this one do not clear it; move the obstacle, or allow less with clearance.least_mm if the shapes are right
motion-cure-clearance-stopped = { $angles ->
    [one] none was found in the allowed time: { $tried } of { $angles } work angle was tried; move the obstacle, or allow less with clearance.least_mm if the shapes are right
   *[other] none was found in the allowed time: { $tried } of { $angles } work angles were tried; move the obstacle, or allow less with clearance.least_mm if the shapes are right
}
motion-cure-clearance-move = move the obstacle, or allow less with clearance.least_mm if the shapes are right
motion-no-shapes = { $machine } has no shapes: nothing is checked for collisions, and transfer moves go straight
motion-cure-no-shapes = describe torch and links with [[shapes.<link>]] in the machine file

# Transfer moves.
motion-transfer-from-home = the transfer move from home to the weld
motion-transfer-home = the transfer move from the weld back home
motion-transfer-between = the transfer move from pass { $from } to pass { $to }
motion-transfer-too-long = { $move }: it takes { $time }, a move may take { $limit } at most
motion-cure-transfer-too-long = give the machine's axes higher speeds and accelerations, or move the part nearer
motion-transfer-blocked = { $move }: { $reason }
motion-cure-transfer-blocked = not tried: moving the part, the fixture or home, or another start of the weld may help
motion-transfer-start = its start is not clear: { $obstacle }
motion-transfer-end = its end is not clear: { $obstacle }
motion-transfer-retract = the retract is not clear: { $obstacle }
motion-transfer-approach = the approach is not clear: { $obstacle }
motion-transfer-none = no clear path was found; on the straight path { $obstacle }
motion-retract-short = the torch can retract only { $distance } of { $asked } on { $move }
motion-retract-none = no axis can retract the torch along its own direction on { $move }: it leaves sideways
motion-cure-retract = make sure that nothing stands beside the seam there, or ask for a smaller retract
motion-unwind = axis { $axis } unwinds by { $by } on { $move }

# Planning that was stopped.
motion-search-out-of-time = no plan within { $limit } of searching: { $progress }
motion-search-cancelled = planning was cancelled: { $progress }
motion-search-progress = { $positions ->
    [one] { $stage } was { $part } done after { $positions } tried position
   *[other] { $stage } was { $part } done after { $positions } tried positions
}
motion-search-reach = solving poses along the seam
motion-search-sampling = sampling redundant axes
motion-search-joining = joining sampled positions
motion-search-refining = refining redundant axes
motion-search-speed = planning the speed profile
motion-search-weave = trying weave frequencies
motion-search-transfer = searching a transfer move
motion-search-cure = trying cures
motion-cure-search = allow more time, hold redundant axes (spare_axes.hold), narrow their ranges in the machine file, or weld the seam in parts
motion-cure-plan-again = plan again

# Comparison with the welding procedure specification.
motion-quantity-speed = the speed of the tip
motion-quantity-heat-input = the heat input
motion-quantity-travel-angle = the travel angle
motion-quantity-work-angle = the work angle
motion-run-pass = pass { $passes }
motion-run-passes = passes { $passes }
motion-procedure-outside = { $quantity } is { $found } at s = { $at }; { $procedure } allows ({ $run }) { $min } to { $max }
motion-procedure-unbounded = { $quantity } is unlimited at s = { $at }, where the torch stops with the arc on; { $procedure } allows ({ $run }) { $min } to { $max }
motion-procedure-no-power = the pass does not give { $keys }, so its heat input is unknown; { $procedure } allows ({ $run }) { $min } to { $max }
motion-procedure-no-faces = the faces of the joint are unknown, so the work angle is unknown; { $procedure } allows ({ $run }) { $min } to { $max }
motion-procedure-missing = the pass does not give { $key }; { $procedure } allows ({ $run }) { $min } to { $max }
motion-procedure-no-run = no run of { $procedure } is for pass { $pass } ({ $name })
motion-procedure-position = the weld is in position { $position }; { $procedure } allows ({ $run }) { $positions }
motion-procedure-inclination = the weld is in position { $position } (slope { $min_slope } to { $max_slope }, rotation { $min_rotation } to { $max_rotation }); { $procedure } allows ({ $run }) { $positions }
motion-cure-procedure-run = add [[runs]] with the pass's name or number to the procedure file, or rename the pass; or use a procedure that is qualified for it
motion-cure-procedure-power = give { $keys } in weld.process, or set `power` in the procedure to the values that make the power; or use a procedure that is qualified for it
motion-cure-procedure-work-angle = remove work_angle_deg from the run; or use a procedure that is qualified for it
motion-cure-procedure-missing = give { $key } in weld.process, or remove it from [runs.ranges]; or use a procedure that is qualified for it
motion-cure-procedure-slower = ask for less speed there; or use a procedure that is qualified for it
motion-cure-procedure-faster = ask for more speed there, or place the work so that the axes can keep it; or use a procedure that is qualified for it
motion-cure-procedure-less-heat = weld faster or with less power there; or use a procedure that is qualified for it
motion-cure-procedure-more-heat = weld slower or with more power there; or use a procedure that is qualified for it
motion-cure-procedure-angles = change the torch angles there, or use a machine with enough axes for them; or use a procedure that is qualified for it
motion-cure-procedure-lower = lower { $key } there (weld.process of the job, or spans of the program); or use a procedure that is qualified for it
motion-cure-procedure-raise = raise { $key } there (weld.process of the job, or spans of the program); or use a procedure that is qualified for it
motion-cure-procedure-position = turn or tilt the part otherwise (placement, work offset, spare_axes), or weld in the opposite direction where that makes uphill of downhill; or use a procedure that is qualified for it

# Simulated weld.
motion-simulated-path = the simulated torch tip deviates { $deviation } from the seam; { $tolerance } is allowed
motion-cure-simulated-path = look at the following errors: tune the position loops, or weld slower
motion-cure-simulated-path-tracked = look at the results of the tracking: sensor, speed and reach of the corrections
motion-cure-simulated-path-untracked = track the seam, or place the part as planned
motion-simulated-speed = the speed of the simulated tip deviates { $deviation } from the planned one; { $tolerance } is allowed
motion-cure-simulated-speed = use finer encoders, softer position loops, less friction, or a higher speed
motion-simulated-stop = the weld was stopped at { $at }: { $reason }; nothing was welded after it
motion-simulated-other-head = another head stopped
motion-cure-simulated-stop = place the part nearer to its planned position, repair the sensor, or weld slower
motion-simulated-drive = the drive of axis { $axis } reaches its current limit
motion-cure-simulated-drive = use a stronger drive, or a lower max_acceleration in the machine file

# Playing a speed profile under an operator's commands.
motion-override = the override must be from 0 to { $max }, not { $value } (up to 1.5 with a profile planned for that speed)
motion-override-faster = the override must be from 0 to { $max }, not { $value }
motion-override-zero = the override is 0: set one above 0 before resuming
motion-axis-limit = the { $limit } of axis { $axis } must be greater than 0, not { $value }
motion-too-many-axes = { $axes } axes are given, { $max } are allowed at most
motion-period = the period must be from 0.00025 to 0.004 s, not { $value }
motion-path-length = the path length must be from 0 to { $length }, not { $value }
motion-faster-profile = the faster profile must be planned for more than 1 and up to 1.5 times the speed, not { $value }
motion-step-end = a step must end beyond { $welded }, the end of the welded part, and at { $length } at most, not at { $value }
motion-stuck = the motion cannot continue at { $s }: the speed profile exceeds the limits of the axes there

# Manual motion.
motion-jog-range = axis { $axis } cannot go to { $value }: its range is { $min } to { $max }
motion-jog-position = the position of axis { $axis } is not a finite number
motion-jog-speed = the speed of axis { $axis } is not a finite number
motion-jog-tip = the velocity of the tip is not a finite number
motion-jog-period = the period is { $value }; it must be greater than 0 and at most 1 s
motion-jog-silence = the signal timeout is { $value }; it must be greater than 0 and at most 1 s
motion-jog-override = the override is { $value }; it must be greater than 0 and at most 1
motion-jog-axis = { $axes ->
    [one] the machine has { $axes } axis, and no axis { $axis }
   *[other] the machine has { $axes } axes, and no axis { $axis }
}
motion-jog-not-clear = at the start { $first } and { $second } are { $distance } apart; at least { $minimum } is required
motion-jog-halted = the jog has halted: command rest before anything else
motion-jog-no-motion = no motion within the limits was found from the present state to the target

# Pulses.
motion-pulses-too-fast = a period needs { $asked } pulses, at most { $max } can be made
motion-pulses-crowded = { $pulses ->
    [one] { $pulses } pulse does not fit between the change of direction and the end of the period
   *[other] { $pulses } pulses do not fit between the change of direction and the end of the period
}
motion-pulses-position = the position of { $steps } steps is too far from zero to be counted; allowed: up to 1e11
motion-pulses-period = a period of { $ticks } ticks of the timer; allowed: 1 to 2.7e11

# Textbook interpolators.
motion-value-not-positive = { $what } must be a finite number greater than 0, not { $value }
motion-value-not-finite = { $what } must be a finite number, not { $value }
motion-value-semi-axis-a = semi-axis a
motion-value-semi-axis-b = semi-axis b
motion-value-x = a point's x
motion-value-y = a point's y
motion-value-nozzle-radius = the nozzle radius
motion-value-shell-radius = the shell radius
motion-value-start-angle = the start angle
motion-value-sweep = the sweep
motion-value-speed = the speed
motion-value-period = the period
motion-value-step = speed times period
motion-value-pulse = the pulse
motion-start-off-ellipse = the start point ({ $x }, { $y }) lies { $distance } off the ellipse; at most { $tolerance } is accepted, the nearest point on it is ({ $near_x }, { $near_y })
motion-end-off-ellipse = the end point ({ $x }, { $y }) lies { $distance } off the ellipse; at most { $tolerance } is accepted, the nearest point on it is ({ $near_x }, { $near_y })
motion-nozzle-too-large = the nozzle radius { $nozzle } must be smaller than the shell radius { $shell }
motion-sweep = the sweep must be other than 0 and at most { $limit } either way, not { $sweep }
motion-step-too-long = a step of { $step } (speed times period) is too long for this path: at most { $max } (the path's length, or an eighth of a full turn's)
motion-pulse-too-large = a pulse of { $pulse } is too large for this shape: at most { $max }
motion-too-many-steps = this needs about { $steps } steps or pulses; the limit is { $max }
