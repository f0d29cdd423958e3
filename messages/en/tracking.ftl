# Settings.
tracking-value = { $key } = { $value }: allowed is { $allowed }
tracking-ages = two ages in s: the minimum, then a larger maximum, at most 10
tracking-scan-allowed = less than the period
tracking-speeds-allowed = two speeds greater than 0, the slower one first
tracking-notice-allowed = more than the slides' lag, at most 0.02
tracking-correction-allowed = a path along which the axes can shift the torch to all sides
tracking-look-ahead-too-short = a look-ahead distance of { $distance } is too short at { $speed }: a deviation must be known { $notice } before the torch arrives; allowed are { $min } or more, or { $max } or less

# Frames of the beam.
tracking-frames-too-often = period_s = { $period }: the weld may be interrupted every { $min } at most; allowed is that or more
tracking-frame-too-long = scan_s = { $scan }: the weld may be interrupted for { $max }; allowed is that or less
tracking-zone-outside = at { $speed } the joint must be seen from { $from } to { $to } ahead, and the frame ends at { $reach }; allowed are { $min } to { $max }
tracking-zone-outside-at-any-speed = at { $speed } the joint must be seen from { $from } to { $to } ahead, and the frame ends at { $reach }; no speed works with such a frame

# Stored deviations.
tracking-pass-not-covered = the pass goes from { $from } to { $to } of the stored seam, and deviations are stored from { $first } to { $last }
tracking-stored-deviation-moved = nine of ten of { $points } points lie up to { $within } off (median { $median }), allowed is { $max }; track this pass instead
tracking-stored-deviation-unseen = { $points } points in { $frames } frames, allowed are { $min } or more; check only frames that show the joint
tracking-record = { $file }:{ $line }: { $column } = `{ $value }`: { $wrong }; allowed: { $allowed }
tracking-record-no-column = the header lacks this column
tracking-record-not-finite = not a finite number
tracking-record-out-of-range = out of range
tracking-record-not-increasing = not greater than in the row before
tracking-record-too-short = fewer than two rows
tracking-record-table = a header line with s_mm,lateral_mm,height_mm,confidence, then at least two rows of finite numbers
tracking-record-path-lengths = increasing path lengths

# Faults of a sensor.
tracking-sensor-silent = the sensor sends no data
tracking-sensor-contradictory = the sensor's measurements contradict each other
tracking-sensor-confidence = the sensor's confidence is not a number from 0 to 1
tracking-sensor-faint = the sensor sees the joint too faintly
tracking-sensor-out-of-field = the joint is outside of the sensor's field of view
tracking-sensor-clock = the sensor's time stamps are wrong
tracking-sensor-late = the sensor's measurements arrive too late
tracking-sensor-frozen = the sensor repeats the same measurement

# Alarms of tracking.
tracking-near-stroke-end = correction near its limit
tracking-axes-carry = beyond the beam's deflection: the axes carry the gun
tracking-slowed = slowed down for a steep deviation
tracking-blind = the sensor sees nothing
tracking-coasting = torch beyond the measured part of the joint
tracking-beyond-history = torch farther back than the stored measurements
tracking-fading-out = correction fades out to the taught path
tracking-stroke-end = correction at its limit: the weld misses the joint
tracking-joint-lost = joint lost
tracking-slide-stuck = slide does not follow its set-point
tracking-stored-deviation-misfit = the stored deviation does not fit

# Following a joint with a camera to teach it.
tracking-crawl-not-joined = the detected line does not join the line found before
tracking-crawl-frames-apart = two frames show the joint { $distance } apart
tracking-crawl-not-seen = the joint is not visible
tracking-crawl-not-seen-further = the joint is not visible any further
tracking-crawl-end-or-tack = the joint is not visible any further: it ends here, or a tack longer than the maximum covers it
