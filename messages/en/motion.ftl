# Limits of axes and of the torch tip.
motion-limit-speed = speed limit
motion-limit-acceleration = acceleration limit
motion-limit-jerk = jerk limit

# Speed that the axes do not allow.
motion-speed-axis = axis { $axis } cannot keep { $asked }: its { $limit } of { $value } allows { $reached }
    .cause = At this place the axis uses up its limit: in a tight bend, near a singular position, or far from the axis of rotation.
    .cure = Lower `speed_mm_s`, or set `on_limit = "slow"` in `[weld]`. `seamwright tools motion JOB --certificate FILE` lists every such stretch.
motion-speed-tip = the torch tip cannot keep { $asked }: its { $limit } of { $value } allows { $reached }
    .cause = A limit in `[tip]` of the machine file is used up. In a bend the acceleration is speed squared over radius.
    .cure = Lower `speed_mm_s`, set `on_limit = "slow"` in `[weld]`, or enlarge the radius of the corner.
motion-speed-rounded-off = the tip moves at { $reached } instead of { $asked }: the requested speed changes there, and the speed profile rounds the change off
    .cause = The requested speed has a kink, as between ramps of `[[weld.at]]`. Up to 3 % of loss is a note, more is a finding.
    .cure = Put the stations of `[[weld.at]]` farther apart, or make their speeds less different.
motion-speed-slowed = { $reason }; the weld slows down there, as requested
    .cause = The job has `on_limit = "slow"`, and a limit is used up on this stretch.
    .cure = Look at the heat input there in the report. `least_speed_mm_s` in `[weld]` sets the lowest permitted speed.
motion-too-short = the weld is too short: it reaches { $reached } of { $asked } between acceleration and deceleration phase
    .cause = The distance for acceleration and deceleration is longer than the weld.
    .cure = Lower `speed_mm_s`, or set `on_limit = "slow"`. If the drives allow it, raise the slowest axis' acceleration and jerk limits.
motion-too-short-between-stops = the path between two stops is too short: it reaches { $reached } of { $asked } between acceleration and deceleration phase
    .cause = Two corners with stops are so near that the torch must brake before it reaches its speed.
    .cure = Set `corner` in `[weld]` to a blend, or enlarge the distance of the corners.
motion-no-speed-profile = the axes of { $machine } have no speed profile: { $reason }
    .cause = The planner for the speed got an invalid limit, speed or path. The reason follows.
    .cure = Check the limits of the axes in the machine file, and speed and length of the pass.
motion-profile-limit = the { $limit } of channel { $channel } is { $value }; it must be a finite number greater than 0 (a jerk limit may be infinite)
    .cause = A speed, acceleration or jerk limit is 0, negative or not finite. Channels are the axes in the order of the machine file from 0, then the tip.
    .cure = Correct the limit of that axis or of `[tip]`.
motion-profile-asked = the requested speed at { $at } is { $value }; it must be greater than 0
    .cause = The speed at that path length is 0, negative or not a number.
    .cure = Correct `speed_mm_s` in `[weld]`, `[[weld.at]]` or the span of the program.
motion-profile-range = the path goes from { $from } to { $to }; its end must be a finite number greater than its start
    .cause = The path has no length, or an end that is not finite.
    .cure = Check the seam's dimensions, and `phi_deg` and `end_phi_deg` in `[start]`.
motion-profile-not-smooth = channel { $channel } is not smooth at { $at }: a derivative is not a finite number
    .cause = The axis position has no finite derivative there, as exactly in a singular position or at a repeated point.
    .cure = Remove repeated points of the path, or move the part a little out of the singular position.
motion-profile-still = nothing moves between { $from } and { $to }: no limit bounds the speed there
    .cause = Between two stops no axis and no tip moves, for example over two points at the same position.
    .cure = Remove one of the points, or join the spans.

# Weave that is too fast.
motion-weave-frequency = the weave is too fast: { $reason }; with a width of { $width } its maximum frequency is { $frequency }
    .cause = The weave repeats its lateral acceleration in every period, and an axis or the tip reaches its limit.
    .cure = Lower `frequency_hz` or `width_mm` in `[weld.weave]`. A trapezoid with dwells needs more than a sine.
motion-weave-pitch = the weave is too fast: { $reason }; with a width of { $width } its minimum pitch is { $pitch }
    .cause = A short pitch at this speed gives a high frequency, and an axis or the tip reaches its limit.
    .cure = Enlarge `pitch_mm`, or lower `width_mm` or `speed_mm_s`.

# Corners: stops and blends.
motion-stop = the torch stops at s = { $s } with the arc on: the speed or acceleration of axis { $axis } would jump there
    .cause = The seam or the torch direction has a corner, so the axis would need infinite acceleration at any speed.
    .cure = Set `corner` in `[weld]`: `"stop"` or a blend. With `"stop"` this is a note only.
motion-stop-because = the torch stops at s = { $s } with the arc on: the speed or acceleration of axis { $axis } would jump there; { $reason }
    .cause = `corner` asks for a blend, and no blend fits this corner. The reason follows.
    .cure = Enlarge `blend_mm`, round the corner of the seam, or divide the weld with `parts = "at_corners"` in `[order]`.
motion-blend = the torch rounds the corner at s = { $s }: over { $over } its tip deviates from the seam by up to { $deviation }
    .cause = The job asks for blends with `corner`, and this one leaves the seam by more than 0.005 mm.
    .cure = If this is too much, lower `blend_mm` in `[weld]`. The speed at the corner then falls.
motion-blend-turned = the torch rounds the corner at s = { $s }: over { $over } its tip deviates from the seam by up to { $deviation }, its direction by up to { $turned }
    .cause = The job asks for blends with `corner`, and the torch also leaves its direction by 0.05 degrees or more.
    .cure = If this is too much, lower `blend_mm`, or `attitude_deg` in `[tolerance]`.
motion-blend-no-room = there is no room for a blend: the next corner or end is { $distance } away
    .cause = A blend takes at most half the distance to the next corner or end, and at least 0.001 mm.
    .cure = Remove short edges of the seam, or use `corner = "stop"`.
motion-blend-turns-back = the path turns back on itself there, and no blend is possible
    .cause = The path turns by more than about 168 degrees, and the tip would nearly stop in the blend.
    .cure = Use `corner = "stop"`, or end the weld there.
motion-blend-too-far = the shortest blend, over { $over }, takes the tip more than { $deviation } from the seam, or turns the torch by more than { $turned } from the requested direction
    .cause = Even the shortest blend exceeds `blend_mm`, or `attitude_deg` of `[tolerance]`: the torch direction itself jumps.
    .cure = Give the corner of the seam a radius, or divide the weld with `parts = "at_corners"` in `[order]`.
motion-cure-stop-weave = set corner = "stop" to stop there with the arc on; or weave by pitch_mm instead of a frequency; or round the seam off; or end the weld there and start another after it
motion-cure-stop-or-blend = set corner = "stop" to stop there with the arc on, or corner = {"{ blend_mm = 0.2 }"} to round the corner within that distance of the seam; or round the seam off; or end the weld there and start another after it
motion-cure-stop = set corner = "stop" to stop at corners; or round the seam off; or end the weld there and start another after it

# Minimum speed of the welding procedure with the arc on.
motion-least-speed-stop = the tip moves at { $reached } at s = { $at } with the arc on, and the procedure's minimum speed is { $minimum }: it stops at a corner there
    .cause = A stop at a corner lies inside the weld, and `least_speed_mm_s` is above 0.
    .cure = Blend the corner, or end the weld there. A stop with the arc on may burn through thin sheet.
motion-least-speed-axis = the tip moves at { $reached } at s = { $at } with the arc on, and the procedure's minimum speed is { $minimum }: the { $limit } of axis { $axis }, { $value }, does not allow more
    .cause = With `on_limit = "slow"` the axis slows the torch below `least_speed_mm_s` of `[weld]`.
    .cure = Look at the axis' limit in the machine file, at bends and at singular positions near this place.
motion-least-speed-tip = the tip moves at { $reached } at s = { $at } with the arc on, and the procedure's minimum speed is { $minimum }: the { $limit } of the torch tip, { $value }, does not allow more
    .cause = With `on_limit = "slow"` a limit of `[tip]` slows the torch below `least_speed_mm_s`.
    .cure = Enlarge the radius of the bend, or raise the limit in `[tip]`.
motion-least-speed-short = the tip moves at { $reached } at s = { $at } with the arc on, and the procedure's minimum speed is { $minimum }: the weld is too short to reach more
    .cause = Acceleration and deceleration meet before the torch reaches `least_speed_mm_s`.
    .cure = Make the weld longer, or lower `least_speed_mm_s` if the procedure is qualified for that.
motion-least-speed-start = the torch starts from rest with the arc on: over { $over } it is slower than the procedure's minimum speed of { $minimum }
    .cause = Every weld starts at rest. This phase is not checked against `least_speed_mm_s`.
    .cure = If it is too long, raise acceleration and jerk limits if the drives allow it, or start on a run-on plate.
motion-least-speed-end = the torch comes to rest with the arc on: over { $over } it is slower than the procedure's minimum speed of { $minimum }
    .cause = Every weld ends at rest. This phase is not checked against `least_speed_mm_s`.
    .cure = If it is too long, raise acceleration and jerk limits if the drives allow it, or end on a run-off plate.
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
    .cause = A time of the sequence exceeds 200000 s, usually because it is in ms.
    .cure = Correct the key in `[sequence]`, in seconds.
motion-cure-time = set { $key } to { $limit } or less
motion-travel-too-long = at the requested speed the travel takes { $time }: a pass may take { $limit } at most
    .cause = Length over `speed_mm_s` exceeds 200000 s, usually because the speed has a wrong unit.
    .cure = Give `speed_mm_s` in mm/s: 300 mm/min are 5 mm/s.
motion-cure-travel = ask for a higher speed_mm_s, or divide the weld into several passes
motion-travel-too-long-axes = with the limits of the axes the travel takes { $time }: a pass may take { $limit } at most
    .cause = The axes' limits in the machine file stretch the travel beyond 200000 s.
    .cure = Run `seamwright machine check` on the machine. It reports speeds and accelerations in wrong units.
motion-cure-travel-axes = give the machine's axes higher speeds and accelerations, or divide the weld into several passes

# Reach and ranges of the axes.
motion-unreachable = { $machine }: { $reason }
    .cause = No positions of the axes reach the torch poses on this stretch. The reason follows.
    .cure = Compare `[placement]` with the reach in `check.html` of `seamwright machine check`. Then move the part or change the torch angles.
motion-cure-unreachable = change the placement of the work, the torch angles or the machine
motion-no-solution = no axis positions follow the path
    .cause = None of the start positions led to axis positions along the path.
    .cure = Start elsewhere with `phi_deg`, or change `[placement]` or the torch angles.
motion-no-positions = no axis positions reach it
    .cause = At none of the sampled positions of the redundant axes the other axes reach this point.
    .cure = Move the part towards the middle of the machine with `[placement]`.
motion-axis-beyond = axis { $axis } would have to go { $by } beyond its range
    .cause = This is the smallest excess at all sampled positions of the redundant axes.
    .cure = Move the part against the excess, or release the axes in `hold` of `[spare_axes]`.
motion-unreachable-redundant = { $machine }, at every position of its redundant axes: { $reason }
    .cause = At all sampled positions of the redundant axes the pose is out of reach or out of a range.
    .cure = Move the part, change the torch angles, or remove `hold` from `[spare_axes]`.
motion-cure-unreachable-redundant = change the placement of the work, the torch angles or the axes held
motion-beyond-range = axis { $axis } would go to { $value }, { $by } beyond its limit { $limit }
    .cause = The seam needs the axis beyond the end of its range on this stretch.
    .cure = Move the part, start elsewhere with `phi_deg`, or weld in two parts with `end_phi_deg`.
motion-cure-range = place the work so that the axis stays in its range
motion-attitude = { $machine } has too few axes for the whole torch attitude: it is up to { $error } off the requested one (tolerance { $tolerance })
    .cause = The machine has fewer than five suitable axes, so the torch takes the nearest possible direction. Deviations above 0.5 degrees are reported.
    .cure = Ask for torch angles that the axes reach, or raise `attitude_deg` in `[tolerance]` if the process allows it.
motion-arc-off-line = { $machine } cannot keep the requested torch attitude, and the torch is drawn back by { $back } for its stick-out: the arc would be { $off } beside its line
    .cause = The wire lies along the torch, which is turned away from the requested attitude: a longer wire ends beside the line.
    .cure = Weld with the stick-out of the machine, or on a machine with one more rotary axis.
motion-cure-attitude = change the torch angles, use a machine with one more rotary axis, or allow more with tolerance.attitude_deg
motion-cure-arc-off-line = weld with the stick-out of the machine, change the torch angles, or use a machine with one more rotary axis
motion-not-smooth = the axes of { $machine } cannot follow the torch smoothly here: it passes a singular attitude
    .cause = At a singular attitude an axis would have to turn infinitely fast, or the solution ends between two samples.
    .cure = Lean the torch by a few degrees with `[torch]`, or turn the part with `[placement]`.
motion-not-smooth-redundant = at every position of the redundant axes of { $machine }, the other axes cannot follow the torch smoothly: it passes a singular attitude or leaves their reach
    .cause = All stations are reachable, and no smooth motion of the redundant axes connects them.
    .cure = Lean the torch, move the part, or release axes in `hold` of `[spare_axes]`.
motion-jump = every position can be reached, but not continuously: between s = { $from } and { $to } axis { $axis } would have to jump by { $by }
    .cause = Before and after this place the axes need different branches, as elbow up and down, or a full turn back.
    .cure = Widen the range of the axis if its cables allow it, start elsewhere with `phi_deg`, or weld in two parts.
motion-cure-jump = not tried: welding the seam in parts (start.end_phi_deg), another start or another placement of the work may help
motion-near-singular = { $distance } from a singular attitude, axis { $axis } needs { $used } of what it can do at { $asked }; the seam could hold { $holds } here
    .cause = The attitude is within 15 degrees of a singular one, and an axis uses more than half of its limit.
    .cure = Lean the torch or turn the part away. More speed or a displaced part would make the job a finding.
motion-cure-near-singular = lean the torch or the work a few degrees away to gain room

# Axes that are held.
motion-hold-unknown = there is no axis { $axis } between the work and the torch
    .cause = `hold` names an axis that the machine does not have, or that is not between the work and the first head.
    .cure = Correct the name in `hold` of `[spare_axes]`.
motion-hold-decided = axis { $axis } is not redundant: a torch pose determines all axes here
    .cause = The machine has no redundant axis, or both heads weld at once. Then every axis is needed.
    .cure = Remove `hold` from `[spare_axes]`.
motion-hold-too-few = with { $held } held, the other axes do not reach every torch pose
    .cause = With these axes held, fewer than five independent axes remain.
    .cure = Hold fewer axes, or others, in `[spare_axes]`.
motion-hold-range = axis { $axis } would be held at { $value }, outside its range
    .cause = The position in `hold` is beyond the range of the axis in the machine file.
    .cure = Correct the value in `hold`, in mm or degrees.
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
    .cause = The distance of two solids falls below the minimum on this stretch. For part and fixtures it is `least_mm` of the job, otherwise that of the machine file.
    .cure = Look at the clearance along the pass in the report. Change the torch angles or move the obstacle, or correct shapes that are too large.
motion-collision = { $first } collides with { $second } (at least { $minimum })
    .cause = The distance of two solids is 0.005 mm or less, or they overlap.
    .cure = Move the clamp, change `work_angle_deg`, or correct position and size of the shape. Do not lower `least_mm`.
motion-above-root = { $contact }, { $height } above the root
    .cause = The bodies come too near within the groove. The height counts from the middle of the groove's bottom along the bisector of the faces.
    .cure = Search the angles with `[torch.search]`, use a slimmer torch, or open the groove.
motion-below-root = { $contact }, { $height } below the root
    .cause = As above, behind the groove's bottom.
    .cure = Correct the shapes, or `[joint]`.
motion-no-torch-angle = no angles within { $work } of the work angle and { $travel } of the travel angle keep the torch clear: { $reason }
    .cause = The search found no work angle at one station at least. The position is the one with the least room, the bodies are the nearest with the best angle.
    .cure = Give the torch more room: a slimmer gas cup, a longer stick-out, a wider groove angle. Or widen `[torch.search]`, within the procedure.
motion-no-torch-angle-longer = no angles within { $work } of the work angle and { $travel } of the travel angle, with a stick-out up to { $longer } longer, keep the torch clear: { $reason }
    .cause = No work angle at one station at least keeps the torch clear, even with the longest stick-out. The position is the one with the least room, the bodies are the nearest with the best angle.
    .cure = Give the torch more room: a slimmer gas cup or a wider groove angle. Or widen `[torch.search]`, within the procedure.
motion-angle-none-allowed = the faces of the joint, the procedure or the range of an axis allow none of them
motion-angle-turns-too-fast = those that are clear change by more than { $turn } within { $way }
motion-cure-torch-angle = a slimmer torch or a longer stick-out, a wider groove, wider limits in torch.search, or less clearance with clearance.least_mm
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
    .cause = The machine file has no shapes, so no distance from part or fixtures is computed.
    .cure = Add at least `[[shapes.torch]]`. Until then make a dry run of every new job and watch the torch.
motion-cure-no-shapes = describe torch and links with [[shapes.<link>]] in the machine file

# Transfer moves.
motion-transfer-from-home = the transfer move from home to the weld
motion-transfer-home = the transfer move from the weld back home
motion-transfer-between = the transfer move from pass { $from } to pass { $to }
motion-transfer-too-long = { $move }: it takes { $time }, a move may take { $limit } at most
    .cause = The move takes more than 200000 s, because an axis is extremely slow.
    .cure = Run `seamwright machine check` on the machine and correct the units of the limits.
motion-cure-transfer-too-long = give the machine's axes higher speeds and accelerations, or move the part nearer
motion-transfer-blocked = { $move }: { $reason }
    .cause = Ends of the move are not clear, or a search of 4000 positions found no way around the obstacle.
    .cure = Move the obstacle or the part, set another home position, or start the weld elsewhere with `phi_deg`.
motion-cure-transfer-blocked = not tried: moving the part, the fixture or home, or another start of the weld may help
motion-transfer-start = its start is not clear: { $obstacle }
    .cause = With the axes at the first position of the move two solids are too near.
    .cure = If this is home, change `home_mm` or `home_deg`. Otherwise move the obstacle beside the end of the weld.
motion-transfer-end = its end is not clear: { $obstacle }
    .cause = With the axes at the last position of the move two solids are too near.
    .cure = If this is home, change `home_mm` or `home_deg`. Otherwise move the obstacle beside the start of the weld.
motion-transfer-retract = the retract is not clear: { $obstacle }
    .cause = The torch would hit the obstacle on its way back along its own axis after the weld.
    .cure = Remove the obstacle behind the torch, lower `retract_mm` in `[air]`, or change the torch angle at the end.
motion-transfer-approach = the approach is not clear: { $obstacle }
    .cause = The torch would hit the obstacle on its way along its own axis to the start of the weld.
    .cure = Remove the obstacle, lower `retract_mm` in `[air]`, or change the torch angle at the start.
motion-transfer-none = no clear path was found; on the straight path { $obstacle }
    .cause = The obstacle stands on the straight move, and the search found no detour within the ranges of the axes.
    .cure = Move the obstacle, or make its shape smaller if it is larger than the real body.
motion-retract-short = the torch can retract only { $distance } of { $asked } on { $move }
    .cause = At the full `retract_mm` the axes leave their ranges or reach. Half and a quarter of it are tried next.
    .cure = Check that the torch leaves the groove. Move the part away from the range end, or lower `retract_mm` in `[air]`.
motion-retract-none = no axis can retract the torch along its own direction on { $move }: it leaves laterally
    .cause = Even at a quarter of `retract_mm` the axes leave their ranges or reach, so the transfer move starts at the weld.
    .cure = Watch this move in a dry run with a low override, and place the part where the torch can retract.
motion-cure-retract = make sure that nothing stands beside the seam there, or ask for a smaller retract
motion-unwind = axis { $axis } unwinds by { $by } on { $move }
    .cause = The axis would otherwise reach the end of its range, or wind up cables, in the next pass. It turns by more than half a turn.
    .cure = Lead hoses and cables so that they follow this turn.

# Planning that was stopped.
motion-search-out-of-time = no plan within { $limit } of searching: { $progress }
    .cause = Redundant axes, weaves and obstacles make searches long, and together they exceeded `--time-limit`.
    .cure = Plan with a larger `--time-limit`, for example 300, or hold redundant axes.
motion-search-cancelled = planning was cancelled: { $progress }
    .cause = A newer request replaced this planning, or somebody cancelled it.
    .cure = Plan again.
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
motion-search-torch-angles = trying torch angles
motion-cure-search = allow more time, hold redundant axes (spare_axes.hold), narrow their ranges in the machine file, or weld the seam in parts
motion-cure-plan-again = plan again

# Comparison with the welding procedure specification.
motion-quantity-speed = the speed of the tip
motion-quantity-heat-input = the heat input
motion-quantity-travel-angle = the travel angle
motion-quantity-work-angle = the work angle
motion-quantity-stick-out = the stick-out
motion-run-pass = pass { $passes }
motion-run-passes = passes { $passes }
motion-procedure-outside = { $quantity } is { $found } at s = { $at }; { $procedure } allows ({ $run }) { $min } to { $max }
    .cause = The planned value leaves a range of the procedure on this stretch. The largest excess is at this path length.
    .cure = Change speed, process values or torch angles in the job. Change the range in the procedure only if it is qualified.
motion-procedure-unbounded = { $quantity } is unlimited at s = { $at }, where the torch stops with the arc on; { $procedure } allows ({ $run }) { $min } to { $max }
    .cause = Heat input is power over speed, and the torch stands still there with the arc on.
    .cure = Blend the corner with `corner`, or end the weld there. Crater fill at the ends is not counted.
motion-procedure-no-power = the pass does not give { $keys }, so its heat input is unknown; { $procedure } allows ({ $run }) { $min } to { $max }
    .cause = The heat input needs current and voltage, or the values in `power` of the procedure, and the job does not give all.
    .cure = Add the process values to `[weld.process]`, or to `process` of the run in `[beads]`.
motion-procedure-no-faces = the faces of the joint are unknown, so the work angle is unknown; { $procedure } allows ({ $run }) { $min } to { $max }
    .cause = The procedure limits the work angle, and the path was given as points, without the faces of the joint.
    .cure = Remove `work_angle_deg` from the run, or describe the seam as `[seam]` in a job.
motion-procedure-no-stick-out = the stick-out is unknown; { $procedure } allows ({ $run }) { $min } to { $max }
    .cause = The procedure limits the stick-out, and neither the job nor the machine gives it.
    .cure = Add `stick_out_mm` to `[torch]` of the machine's file.
motion-procedure-missing = the pass does not give { $key }; { $procedure } allows ({ $run }) { $min } to { $max }
    .cause = The run has a range for a process value that the pass does not have.
    .cure = Add the value under the same name and unit to `[weld.process]`, or remove it from `[runs.ranges]`.
motion-implausible = { $key } = { $found } does not go with { $current }: usual is { $expected }, { $percent } more or less
    .cause = Voltage and wire feed follow from the current: conventional load voltages of IEC 60974-1, melting rate of steel wire after Lesnewich. The value is far from these.
    .cure = Check current, voltage, wire feed and `wire_diameter_mm`. For a special arc widen `percent` in `[plausibility]` of the procedure.
motion-cure-implausible = check { $key }, the current and the wire; for a special arc, widen percent in [plausibility] of the procedure
motion-cooling-outside = the weld cools from 800 to 500 °C in { $found }; { $min } to { $max } are allowed
    .cause = The cooling time by EN 1011-2 is outside `t85_s` of `[materials]`.
    .cure = Change the heat input or the temperature of the work before the pass.
motion-cooling-unbounded = the torch stops with the arc on: the cooling time has no bound; { $min } to { $max } are allowed (at most { $found })
    .cause = The torch stops on the path, so that the heat input there has no bound.
    .cure = Let the corner be rounded, or switch the arc off there.
motion-cure-cooling-slow = lower the heat input or the interpass temperature
motion-cure-cooling-fast = raise the heat input or the preheat
motion-preheat-low = the procedure preheats to { $found }; EN 1011-2 (method B) asks for { $needed }
    .cause = Carbon equivalent CET, thickness, hydrogen and heat input ask for more preheat than the minimum of `preheat_c` or `interpass_c` in the run.
    .cure = Raise that minimum, or take a filler metal with less hydrogen or a higher heat input.
motion-pool-too-large = the bead has { $area } at s = { $s } in position { $position }; without a weave up to { $max } stays in place
    .cause = More metal is liquid than surface tension holds against gravity in this position: the bead sags, overlaps its lower toe or drips. The limit is that of the position, or `max_unwoven_mm2` of the procedure's run.
    .cure = Use smaller beads with a higher speed or less wire, or a weave. Or turn the work nearer to flat position. A qualified procedure may give its own `max_unwoven_mm2`.
motion-cure-preheat-low = raise the minimum of preheat_c and interpass_c to { $needed }
motion-cure-pool = use smaller beads (higher speed, less wire) or a weave, or turn the work nearer to flat position
motion-preheat-range = the preheat is extrapolated: method B of EN 1011-2 is for CET 0.2 to 0.5 %, 10 to 90 mm, 1 to 20 ml hydrogen in 100 g and 0.5 to 4 kJ/mm
motion-interpass-wait = waits { $time } until the weld has cooled
motion-interpass-thickness = the wait for the interpass temperature needs the thickness of the parts
    .cause = The joint has no thickness, and `[materials]` gives none.
    .cure = Give `thickness_mm` of `first` or `second` in `[materials]`, or `wait_s` in `[interpass]`.
motion-interpass-power = the wait for the interpass temperature needs the heat input
    .cause = There is no procedure with the thermal efficiency, or a pass has no current or voltage.
    .cure = Name a procedure in the job and give the values of its power, or give `wait_s` in `[interpass]`.
motion-interpass-never = the weld does not cool below the interpass temperature in two days
    .cause = The parts are thin and lose no heat: `transfer_w_m2k` is 0.
    .cure = Set the heat transfer to the air, or a fixed wait.
motion-cure-interpass = complete [materials] and the procedure, or give wait_s instead of below_c in [interpass]
motion-procedure-no-run = no run of { $procedure } is for pass { $pass } ({ $name })
    .cause = No `[[runs]]` of the procedure has the role, the name or the number of this pass. Numbers count over all copies and parts.
    .cure = Add `[[runs]]` for it. Tacks need `name = "tack"`.
motion-procedure-position = the weld is in position { $position }; { $procedure } allows ({ $run }) { $positions }
    .cause = The position follows from the direction of travel and the face of the weld against gravity, `up` in the machine file.
    .cure = Turn the part with `[placement]`, or hold a positioner axis with `hold` in `[spare_axes]`.
motion-procedure-inclination = the weld is in position { $position } (slope { $min_slope } to { $max_slope }, rotation { $min_rotation } to { $max_rotation }); { $procedure } allows ({ $run }) { $positions }
    .cause = Slope and rotation of the weld are outside the permitted positions on this stretch.
    .cure = Turn the part or reverse the weld. Compare the limits with `[position_limits]` of the procedure.
motion-cure-procedure-run = add [[runs]] with the pass's name or number to the procedure file, or rename the pass; or use a procedure that is qualified for it
motion-cure-procedure-power = give { $keys } in weld.process, or set `power` in the procedure to the values that make the power; or use a procedure that is qualified for it
motion-cure-procedure-work-angle = remove work_angle_deg from the run; or use a procedure that is qualified for it
motion-cure-procedure-stick-out = give stick_out_mm in [torch] of the machine's file
motion-cure-procedure-own-stick-out = change stick_out_mm of the run or of [torch]; or use a procedure that is qualified for it
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
    .cause = Following errors of the axes, backlash, a displaced joint or tracking errors move the simulated tip. The limit is `path_mm` in `[tolerance]`.
    .cure = Compare the following errors of the axes in the report. Tune with `seamwright machine tune`, or weld slower.
motion-cure-simulated-path = look at the following errors: tune the position loops, or weld slower
motion-cure-simulated-path-tracked = look at the results of the tracking: sensor, speed and reach of the corrections
motion-cure-simulated-path-untracked = track the seam, or place the part as planned
motion-simulated-speed = the speed of the simulated tip deviates { $deviation } from the planned one; { $tolerance } is allowed
    .cause = Friction at reversals, coarse encoders or a soft axis disturb the speed. The limit is `speed_percent` in `[tolerance]`.
    .cure = Look at the axis that reverses at this path length. Add friction compensation in `[drives.AXIS]`, or tune it.
motion-cure-simulated-speed = use finer encoders, softer position loops, less friction, or a higher speed
motion-simulated-stop = the weld was stopped at { $at }: { $reason }; nothing was welded after it
    .cause = In the simulated weld an alarm stopped the head. The reason follows.
    .cure = Look the alarm up under its code. Reduce the distortion given to `simulate`, or the welding speed.
motion-simulated-other-head = another head stopped
    .cause = With two heads both stop, and the alarm belongs to the other one.
    .cure = Look at the alarms of the other head in the report.
motion-cure-simulated-stop = place the part nearer to its planned position, repair the sensor, or weld slower
motion-simulated-drive = the drive of axis { $axis } reaches its current limit
    .cause = The simulated current exceeded 99.9 % of the peak force or torque. A lower `force_limit_n` or `torque_limit_n_m` is not reported.
    .cure = Lower the axis' acceleration limit, or check mass and peak force in `[drives.AXIS]`.
motion-cure-simulated-drive = use a stronger drive, or a lower max_acceleration in the machine file

# Playing a speed profile under an operator's commands.
motion-override = the override must be from 0 to { $max }, not { $value } (up to 1.5 with a profile planned for that speed)
    .cause = The override is negative, above the limit of the planned profile, or not a number.
    .cure = Give 0 to 100 percent. `tools motion` takes up to 150 percent in its commands file.
motion-override-faster = the override must be from 0 to { $max }, not { $value }
    .cause = The override is negative, above 1.5, or not a number.
    .cure = Give 0 to 150 percent in the commands file.
motion-override-zero = the override is 0: set one above 0 before resuming
    .cause = The operator resumed, reversed or stepped while the override was below 0.1 percent.
    .cure = Raise the override, then resume.
motion-period = the period must be from 0.00025 to 0.004 s, not { $value }
    .cause = A motion under commands needs set-points every 0.25 to 4 ms.
    .cure = Set `servo_period_ms` in the machine file, or `--period-ms`, within 0.25 to 4.
motion-path-length = the path length must be from 0 to { $length }, not { $value }
    .cause = A start or a stop lies before the start or beyond the end of the pass.
    .cure = Give a path length between 0 and the length of the pass.
motion-faster-profile = the faster profile must be planned for more than 1 and up to 1.5 times the speed, not { $value }
    .cause = The factor of the second speed profile is 1 or less, or more than 1.5.
    .cure = Keep overrides in the commands file at 150 percent or less.
motion-step-end = a step must end beyond { $welded }, the end of the welded part, and at { $length } at most, not at { $value }
    .cause = A step continues the weld, and its end lies in the finished part or beyond the pass.
    .cure = Give a positive step in mm. To finish the pass, resume.
motion-stuck = the motion cannot continue at { $s }: the speed profile exceeds the limits of the axes there
    .cause = From this state no set-point within the axes' limits follows for a while, so the process was switched off and the torch held.
    .cure = Resume with a lower override, or lower `speed_mm_s` at this place. Report the job as a defect if it repeats.

# Manual motion.
motion-jog-range = axis { $axis } cannot go to { $value }: its range is { $min } to { $max }
    .cause = The target is beyond the range of the axis in the machine file.
    .cure = Give a position inside the range.
motion-jog-position = the position of axis { $axis } is not a finite number
    .cause = The commanded position is infinite or not a number.
    .cure = Correct the number in the command or script.
motion-jog-speed = the speed of axis { $axis } is not a finite number
    .cause = The commanded speed is infinite or not a number.
    .cure = Correct the number in the command or script.
motion-jog-tip = the velocity of the tip is not a finite number
    .cause = The commanded velocity of the tip is infinite or not a number.
    .cure = Correct the number in the command or script.
motion-jog-period = the period is { $value }; it must be greater than 0 and at most 1 s
    .cause = The period of the set-points is 0, negative, or longer than 1 s.
    .cure = Set `servo_period_ms` in the machine file; a cell runs at 0.25 to 4 ms.
motion-jog-silence = the signal timeout is { $value }; it must be greater than 0 and at most 1 s
    .cause = The time without a signal from the panel is 0, negative, or longer than 1 s.
    .cure = This value is fixed in the program. Report it as a defect.
motion-jog-override = the override is { $value }; it must be greater than 0 and at most 1
    .cause = The override of a jog is 0, negative, or above 1.
    .cure = Give more than 0 and up to 100 percent.
motion-jog-axis = { $axes ->
    [one] the machine has { $axes } axis, and no axis { $axis }
   *[other] the machine has { $axes } axes, and no axis { $axis }
}
    .cause = The number of the axis is too large. Numbers count from 0 in the order of the machine file.
    .cure = Check that panel or script were made for this machine, and load the page again.
motion-jog-not-clear = at the start { $first } and { $second } are { $distance } apart; at least { $minimum } is required
    .cause = Before the first movement two solids are already nearer than their minimum clearance.
    .cure = Check the true position in the shop. Correct shapes or `least_mm` in the machine file, or move the axes by other means.
motion-jog-halted = the jog has halted: command rest before anything else
    .cause = An obstacle or a limit stopped the jog, and the keys have not been released since.
    .cure = Release all jog keys, then move away from the obstacle.
motion-jog-no-motion = no motion within the limits was found from the present state to the target
    .cause = No motion within ranges and limits, up to two hours long, leads from the present state to the target.
    .cure = Raise `--override-percent` of `machine move`, or check the limits with `seamwright machine check`.

# Pulses.
motion-pulses-too-fast = a period needs { $asked } pulses, at most { $max } can be made
    .cause = Steps of the period times the minimum spacing of pulses exceed the period.
    .cure = Lower the axis' maximum speed, or use fewer `microsteps` in `[drives.AXIS.stepper]`.
motion-pulses-crowded = { $pulses ->
    [one] { $pulses } pulse does not fit between the change of direction and the end of the period
   *[other] { $pulses } pulses do not fit between the change of direction and the end of the period
}
    .cause = After a change of direction the driver needs its hold and setup times before the next pulse.
    .cure = Lower `direction_setup_us` and `direction_hold_us` to the data sheet, or use fewer `microsteps`.
motion-pulses-position = the position of { $steps } steps is too far from zero to be counted; allowed: up to 1e11
    .cause = The position in steps exceeds 1e11 or is not a number.
    .cure = Use fewer `microsteps`, or check `mm_per_turn` or `deg_per_turn`.
motion-pulses-period = a period of { $ticks } ticks of the timer; allowed: 1 to 2.7e11
    .cause = The period has no tick of the timer, or too many.
    .cure = Check `--tick-ns` and `--period-ms`, or `tick_ns` and `servo_period_ms`.

# Textbook interpolators.
motion-value-not-positive = { $what } must be a finite number greater than 0, not { $value }
    .cause = A size, speed, period or pulse of `tools interpolate` is 0, negative or not finite.
    .cure = Correct the option that gives it.
motion-value-not-finite = { $what } must be a finite number, not { $value }
    .cause = A coordinate or an angle of `tools interpolate` is infinite or not a number.
    .cure = Correct the option that gives it.
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
    .cause = The start point does not fit `--a-mm` and `--b-mm`. Its distance exceeds the tolerance.
    .cure = Set `--start-mm` to the nearest point in the message.
motion-end-off-ellipse = the end point ({ $x }, { $y }) lies { $distance } off the ellipse; at most { $tolerance } is accepted, the nearest point on it is ({ $near_x }, { $near_y })
    .cause = The end point does not fit `--a-mm` and `--b-mm`. Its distance exceeds the tolerance.
    .cure = Set `--end-mm` to the nearest point in the message, or use `--full-turn`.
motion-nozzle-too-large = the nozzle radius { $nozzle } must be smaller than the shell radius { $shell }
    .cause = A nozzle as wide as the shell does not give one closed seam around it.
    .cure = Lower `--nozzle-radius-mm`, or enlarge `--shell-radius-mm`.
motion-sweep = the sweep must be other than 0 and at most { $limit } either way, not { $sweep }
    .cause = The sweep is 0, or it has more turns than the limit.
    .cure = Set `--sweep-deg`, for example to 360.
motion-step-too-long = a step of { $step } (speed times period) is too long for this path: at most { $max } (the path's length, or an eighth of a full turn's)
    .cause = Speed times period exceeds the length of the path, or an eighth of a full turn.
    .cure = Lower `--speed-mm-s` or `--period-ms`.
motion-pulse-too-large = a pulse of { $pulse } is too large for this shape: at most { $max }
    .cause = The pulse exceeds a quarter of the smaller semi-axis, or the length of the path.
    .cure = Lower `--pulse-mm`.
motion-too-many-steps = this needs about { $steps } steps or pulses; the limit is { $max }
    .cause = Length over step, or size over pulse, exceeds the limit.
    .cure = Enlarge `--speed-mm-s`, `--period-ms` or `--pulse-mm`.

# Check before a motion is played.
motion-not-verified = pass { $pass }: the planned motion cannot be played ({ $why })
    .cause = A motion from another process is incomplete or exceeds a limit of an axis of this machine.
    .cure = Load the job again. If it remains, report it with the job and the machine file.

# Reach of placements.
motion-reach-jump = no continuous motion of the axes leads along the path
    .cause = Each station is reached, but an axis would have to jump to another configuration or another whole turn.
    .cure = Move or turn the work; `seamwright machine reach` searches placements.
motion-reach-speed = axis { $axis } would need { $used } of its speed at { $asked }
    .cause = With this placement the requested speed takes the axis beyond its limit, and the pass does not slow down.
    .cure = Choose another placement, lower the speed, or set `on_limit = "slow"`.
motion-reach-position = the welding position is { $by } outside those that the procedure allows
    .cause = The machine cannot tilt the work far enough with this placement.
    .cure = Choose another placement, or allow the position in the procedure.
