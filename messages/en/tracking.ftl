# Settings.
tracking-value = { $key } = { $value }: allowed is { $allowed }
    .cause = A value from the sensor, the speeds or the axes' limits is invalid for tracking. With key `correction` the axes do not move the torch to all sides.
    .cure = Correct this value in `[sensors.NAME]` or of the axis. For `correction` avoid singular positions, or release axes of `spare_axes.hold`.
tracking-ages = two ages in s: the minimum, then a larger maximum, at most 10
tracking-scan-allowed = less than the period
tracking-speeds-allowed = two speeds greater than 0, the slower one first
tracking-notice-allowed = more than the slides' lag, at most 0.02
tracking-correction-allowed = a path along which the axes can shift the torch to all sides
tracking-look-ahead-too-short = a look-ahead distance of { $distance } is too short at { $speed }: a deviation must be known { $notice } before the torch arrives; allowed are { $min } or more, or { $max } or less
    .cause = With a stripe sensor its latency, 2.5 periods and 70 ms for the slides must fit into three quarters of the look-ahead distance.
    .cure = Lower `speed_mm_s` of the pass, or mount the sensor farther ahead and enter it in `at.move_mm` of `[sensors.NAME]`.

# Frames of the beam.
tracking-frames-too-often = period_s = { $period }: the weld may be interrupted every { $min } at most; allowed is that or more
    .cause = `period_ms` of the beam's camera is shorter than the weld permits between two interruptions.
    .cure = Set `period_ms = 300` or more in `[sensors.NAME]`.
tracking-frame-too-long = scan_s = { $scan }: the weld may be interrupted for { $max }; allowed is that or less
    .cause = The weld may be interrupted for 5 ms. Files have no key for the time of a frame: only programs that use the library set it.
    .cure = Set `scan_s` to 0.005 or less.
tracking-zone-outside = at { $speed } the joint must be seen from { $from } to { $to } ahead, and the frame ends at { $reach }; allowed are { $min } to { $max }
    .cause = The zone starts beyond pool and heat, 3 mm and 24 mm²/s divided by the speed. It is so long that four frames show each position.
    .cure = Set `speed_mm_s` within the allowed range. Otherwise enlarge the picture (`size_px`, `mm_per_px`), or lower `period_ms` to 300.
tracking-zone-outside-at-any-speed = at { $speed } the joint must be seen from { $from } to { $to } ahead, and the frame ends at { $reach }; no speed works with such a frame
    .cause = The frame ends at half the smaller side of the picture less 1.6 mm. That is less than pool, heat and a zone of 5 mm need.
    .cure = Enlarge the picture on the work: `size_px` and `mm_per_px` of the camera. Lower `period_ms` to 300.

# Stored deviations.
tracking-pass-not-covered = the pass goes from { $from } to { $to } of the stored seam, and deviations are stored from { $first } to { $last }
    .cause = The record starts later or ends earlier than the pass by more than 2 mm: another seam, or a pass that was stopped.
    .cure = Give `--replay` the `deviations-pass-N.csv` of a whole pass over this seam, or leave `--replay` out.
tracking-stored-deviation-moved = nine of ten of { $points } points lie up to { $within } off (median { $median }), allowed is { $max }; track this pass instead
    .cause = The part has moved or warped since the stored pass, or the record is of another part.
    .cure = Check the clamping. Leave `--replay` out to track this pass.
tracking-stored-deviation-unseen = { $points } points in { $frames } frames, allowed are { $min } or more; check only frames that show the joint
    .cause = Three frames at the start showed too little of the joint: a bead or tack covers it, focus is wrong, or the camera is silent.
    .cure = Check focus and camera. If the joint is covered there, start elsewhere or store deviations anew.
tracking-record = { $file }:{ $line }: { $column } = `{ $value }`: { $wrong }; allowed: { $allowed }
    .cause = A line of the file of `--replay` differs from its format.
    .cure = Take `deviations-pass-N.csv` as an earlier weld has written it, or correct this line.
tracking-record-no-column = the header lacks this column
    .cause = The first line that is not empty must name all four columns, in any order.
    .cure = Add this column, or take a file that a tracked weld has written.
tracking-record-not-finite = not a finite number
    .cause = The cell is empty or text, has a decimal comma, or is nan or inf.
    .cure = Write a finite number with a decimal point.
tracking-record-out-of-range = out of range
    .cause = Path lengths go to 1,000,000 mm to both sides, deviations to 1,000 mm, and confidence from 0 to 1.
    .cure = Check the unit (mm) and the order of the columns.
tracking-record-not-increasing = not greater than in the row before
    .cause = Two rows have the same path length, or the rows are not sorted.
    .cure = Sort the rows by `s_mm` and remove duplicates.
tracking-record-too-short = fewer than two rows
    .cause = The earlier pass was stopped at once, or the file is cut off.
    .cure = Take the record of a pass that was welded to its end.
tracking-record-table = a header line with s_mm,lateral_mm,height_mm,confidence, then at least two rows of finite numbers
tracking-record-path-lengths = increasing path lengths

# Faults of a sensor.
tracking-sensor-silent = the sensor sends no data
    .cause = For ten periods and over more than 15 mm (or 1.5 times the longest tack) no measurement arrives.
    .cure = Check supply, laser and cable of the sensor. Then reverse past the place of the loss and resume.
tracking-sensor-contradictory = the sensor's measurements contradict each other
    .cause = Measurements arrive, but they differ from the prediction by more than three standard deviations, and from each other.
    .cure = Clean the sensor's window, shield it from arc light and spatter, and check the clamping.
tracking-sensor-confidence = the sensor's confidence is not a number from 0 to 1
    .cause = The sensor sends a confidence below 0, above 1, or nan.
    .cure = Correct the scale of the confidence in the sensor's program.
tracking-sensor-faint = the sensor sees the joint too faintly
    .cause = The confidence of the measurements is below 0.4.
    .cure = Clean the window; check exposure, laser and focus. Remove what hides the joint.
tracking-sensor-out-of-field = the joint is outside of the sensor's field of view
    .cause = The joint is more than 10 mm to a side or in height from the middle of the sensor, or the value is not finite.
    .cure = Correct the position of the part or `[placement]`, and check that the sensor aims at the joint.
tracking-sensor-clock = the sensor's time stamps are wrong
    .cause = A time stamp is younger than latency less 1.5 periods permit, or older than the stored positions of the axes.
    .cure = Set the sensor's clock by the cell's clock, and stamp the middle of the exposure.
tracking-sensor-late = the sensor's measurements arrive too late
    .cause = Measurements are older than the latency of the sensor plus 1.5 periods.
    .cure = Find the delay in the sensor or on its connection. If it is permanent, choose a sensor that is faster.
tracking-sensor-frozen = the sensor repeats the same measurement
    .cause = Five measurements in a row have exactly the same value, as no real sensor has.
    .cure = Restart the sensor. Then reverse past the place of the loss and resume.

# Alarms of tracking.
tracking-near-stroke-end = correction near its limit
    .cause = The joint, here or up to the sensor, needs more than 80 % of the permitted correction. The torch slows down.
    .cure = Be ready to hold. For the next part correct its position or `[placement]`, or teach the seam again.
tracking-axes-carry = beyond the beam's deflection: the axes carry the gun
    .cause = The joint needs more than 80 % of `torch.deflection.range_mm`. The axes correct the rest, within their own range.
    .cure = Let the weld continue. For the next part correct its position or `[placement]`.
tracking-slowed = slowed down for a steep deviation
    .cause = Ahead the joint leaves the taught path faster than 80 % of the maximum correction speed.
    .cure = Check the weld where it was slower. Teach the seam again, or lower `speed_mm_s` of the pass.
tracking-blind = the sensor sees nothing
    .cause = No usable measurement for ten periods and over more than 15 mm; with a beam no usable frame for 2.5 periods.
    .cure = Look at the cause behind the colon, and clear the view before the torch reaches the end of the measured part.
tracking-coasting = torch beyond the measured part of the joint
    .cause = The torch follows the last slope, for up to 15 mm or 1.5 times the longest tack.
    .cure = If no tack hides the joint here, hold. Clear the view, acknowledge, reverse past the place of the loss and resume.
tracking-beyond-history = torch farther back than the stored measurements
    .cause = After reversing, the torch is where measurements are no longer stored; a beam has not yet seen the joint here. The correction stays.
    .cure = Resume forwards. To weld more again, end with `stop` and continue from there: the start is then measured again.
tracking-fading-out = correction fades out to the taught path
    .cause = Without measurements for more than 15 mm or 1.5 tacks, the correction returns to zero over 15 mm, at a quarter of the speed.
    .cure = Hold now. Clear the view, acknowledge, reverse past the place of the loss and resume.
tracking-stroke-end = correction at its limit: the weld misses the joint
    .cause = The joint is farther away than slides, axes or beam reach together, or an axis is at the end of its range.
    .cure = Correct the position of the part or `[placement]`, or teach the seam again. Then continue the pass with overlap.
tracking-joint-lost = joint lost
    .cause = The correction has faded out, or no measurement has been usable since the start of the joint.
    .cure = Inspect sensor, light and joint. Then acknowledge, reverse past the place of the loss, hold, arm and resume.
tracking-slide-stuck = slide does not follow its set-point
    .cause = For 20 ms the correction is more than 0.1 mm off its set-point: blocked slide, weak drive, or wrong feedback.
    .cure = Free the slide and check its drive. Then end with `stop` and continue the pass from its position; resuming does not clear it.
tracking-stored-deviation-misfit = the stored deviation does not fit
    .cause = The look before the pass compared stored deviations with the joint: see `tracking-stored-deviation-moved` and `tracking-stored-deviation-unseen`.
    .cure = Leave `--replay` out to track this pass, or correct the clamping and start again.

# Following a joint with a camera to teach it.
tracking-crawl-not-joined = the detected line does not join the line found before
    .cause = Fewer than five points of the new frame lie beside the known line: the follower found a scratch, an edge or a shadow.
    .cure = Give a point on the joint (`X,Y,Z`, or a touch in the picture). Clean the surface or change the light.
tracking-crawl-frames-apart = two frames show the joint { $distance } apart
    .cause = In the overlap of two frames the median distance exceeds 0.2 mm: wrong height, wrong `map`, moving axes, or another line.
    .cure = Give a point on the joint. If it recurs, find the camera's map again (Set-up, Sensors) and measure the height of the work.
tracking-crawl-not-seen = the joint is not visible
    .cause = No row of two frames has a confidence of 0.5 or more.
    .cure = Check light, focus and aim, and give a point on the joint. Answer `end` if the joint ends here.
tracking-crawl-not-seen-further = the joint is not visible any further
    .cause = Two frames add less than 0.5 mm to the line: shadow, dirt, a scratch across the joint, or a tack.
    .cure = Give a point on the joint behind the obstacle. Answer `end` if the joint ends here.
tracking-crawl-end-or-tack = the joint is not visible any further: it ends here, or a tack longer than the maximum covers it
    .cause = The visible joint ends more than 15 mm before the end of the nominal seam, or the nominal seam is closed.
    .cure = Answer `end` if it ends here. Over a tack give a point behind it, or raise `--longest-tack-mm`.
