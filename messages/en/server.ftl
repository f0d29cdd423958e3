# Requests.
server-failed = it failed; nothing was changed
server-program-fault = a fault of the program ended it: please report it
server-no-thread = no thread can be started: { $why }
server-panel-ends = the panel is ending
server-slow-down = too many requests of this kind: try again in a moment
server-too-many-requests = too many requests at once: wait a moment
server-request-late = the request took too long to arrive
server-request-too-large = the request is too large; allowed: up to { $max } KiB
server-too-many-pages = too many pages are open: close one
server-cell-ended = the cell has ended
server-cell-silent = the cell does not answer: try again
server-no-machine = there is no machine
server-no-machine-named = there is no machine `{ $name }`
server-no-devices = there are no devices
server-no-axis = there is no axis `{ $axis }`; allowed: { $allowed }
server-no-language = there is no language `{ $language }`; { $allowed }
server-file-trouble = { $file }: { $why }
server-file-unreadable = { $file } cannot be read: { $why }

# Log-in and permissions.
server-unknown-host = this panel is not known as `{ $host }`; allowed: { $allowed }
server-other-origin = requests from pages of other origins are refused
server-not-logged-in = not logged in, or the session is over: log in
server-session-over = the session is over: log in
server-role = the role { $role } does not allow this ({ $action })
server-role-from = the role { $role } does not allow this ({ $action }); allowed: from { $needed } on
server-header = the header `{ $header }` must be `{ $value }`
server-token = the header `{ $header }` must carry the token of the session
server-content-type = content type `{ $kind }` is not accepted; allowed: { $allowed }
server-wrong-passwords = too many wrong passwords: wait { $wait }
server-login-too-long = name or password is too long; allowed: up to { $max }
server-login-wrong = wrong name or password, or an old start-up link
server-no-random = no random numbers: { $why }

# Users.
server-own-password = your own password is needed for this, and it is wrong
server-user-exists = user `{ $user }` already exists
server-no-user = there is no user `{ $user }`
server-user-name = invalid user name; allowed: letters, digits, - _ . and spaces between them, up to { $max }
server-user-owner = `{ $user }` is reserved for the start-up link: choose another name
server-password-length = invalid length of the password; allowed: { $min } to { $max } characters
server-password-needed = a new user needs a password
server-password-hash = the password cannot be hashed: { $why }
server-too-many-users = too many users; allowed: { $max }
server-last-admin = no administrator would be left: make another enabled user administrator first

# Jobs.
server-job-name = invalid name of a job: `{ $name }`; allowed: letters, digits, - _ . ( ) + and spaces, up to { $max }, ending in .toml
server-no-job = there is no job `{ $job }`
server-no-own-job = there is no job `{ $job }` of your own
server-jobs-unreadable = the folder of jobs cannot be read: { $why }
server-template-name = `{ $job }` is the name of a template: save the job under another name
server-other-text = another text is saved as `{ $job }`
server-too-many-jobs = too many jobs; allowed: { $max }
server-job-not-deleted = { $job } cannot be deleted: { $why }
server-too-many-operations = too many operations; allowed: up to { $max } at once
server-operation = operation { $n }: { $why }
server-at-key = { $key }: { $what }
server-at-value = { $key } = { $value }: { $what }
server-and-allowed = { $what }; allowed: { $allowed }
server-and-help = { $what }; { $help }

# Planning.
server-superseded = cancelled, or replaced by a newer request
server-planning-time = planning takes longer than { $max }; use fewer passes, beads or points
server-planning-memory = planning needs more than { $max } GiB of memory; use fewer passes, beads or points
server-plan-too-large = the plan is too large to be shown; allowed: up to { $max }
server-no-process = no process can be started to plan: { $why }
server-no-pipes = no process can be started to plan: it has no pipes
server-planning-failed = planning failed; the cell is not affected: { $why }
server-no-dialect = there is no dialect `{ $name }`; allowed: { $allowed }

# Loading.
server-part-number = invalid part number; allowed: up to { $max } visible characters
server-machine-moves = the machine moves or is held: stop it first
server-no-drawing = the job has no drawing
server-other-devices = the machine file of the job names other devices than the machine file with which the panel was started; allowed: the same [devices], or none
server-devices-held = the devices are not released: restart the panel
server-devices-not-connected = the devices cannot be connected
server-not-connected = the devices are not connected for this job: try again
server-needs-other-devices = the job is for another machine: switch the drives off first
server-loading = another program is being loaded: wait a moment
server-load-announced = a job is being planned for loading: wait until it is in the cell
server-overlap = invalid overlap of { $value }; allowed: up to { $max }
server-nothing-to-weld = pass { $pass }, { $s }: nothing is left to weld; allowed: a pass from 1 to { $passes }, within its length
server-finished-pass = part “{ $part }” is welded up to pass { $pass }, { $s }: this start would weld it again; continue there, or confirm
server-finished-part = part “{ $part }” is completely welded (weld { $weld }): this start would weld it again; confirm, or name another part

# Commands over the socket.
server-message-invalid = invalid message: { $why }
server-unknown-command = unknown command `{ $name }`; allowed: { $allowed }
server-no-control = this page is not in control: take control first
server-control-jogs = axes are being jogged from the page in control: wait until the key is released
server-control-held = { $user } is in control, on page { $page }
server-replayed = command { $n } was received before; allowed: greater than { $last }
server-busy = too many commands at once
server-override-range = override { $value }; allowed: 0 to 1
server-no-alarm = there is no alarm { $number }; allowed: 1 to { $max }
server-step-range = step of { $value }; allowed: up to { $max } in either direction
server-positions-unknown = the positions of the axes are unknown
server-no-such-axis = there is no such axis
server-tip-directions = the tip moves along x, y and z only
server-axis-count = { $n } axes; allowed: { $allowed }
server-axes-moving = the axes are still moving: wait a moment
server-not-homed = axis { $axis } is not homed: home first
server-shelve-time = { $minutes } min; allowed: up to { $max }
server-alarm-not-listed = this alarm is not on the list
server-alarm-reacts = “{ $alarm }” has a reaction ({ $reaction }); only message-only alarms can be shelved

# Set-up.
server-no-job-loaded = no job is loaded: load one of this machine first
server-axis-not-in-file = the axis is not in its file
server-no-parameter = there is no parameter `{ $key }`; allowed: { $allowed }
server-other-kind-of-axis = `{ $key }` belongs to another kind of axis
server-no-head = there is no head { $head }; allowed: 0 to { $max }
server-too-many-touches = { $n } touches; allowed: up to { $max }
server-touch = invalid touch { $touch }; allowed: { $n } positions, mm or degrees, up to 1000000
server-more-touches = { $why }; touch one point three times or more, the torch tilted by 20 degrees or more in between
server-tip-far = tip_mm { $tip }; allowed: up to { $max }
server-no-camera = `{ $sensor }` is not a camera; allowed: a sensor with `map.heights`
server-grid = invalid grid: pitch { $pitch }, height { $z }; allowed: a pitch greater than 0
server-no-sensor = there is no sensor `{ $sensor }`; allowed: { $allowed }
server-not-simulated = not simulated; allowed: simulated devices, up to { $max } pixels
server-scale-differs = the scale differs by { $difference }: check pitch and height
server-picture-size = the picture has { $pixels } pixels; allowed: { $allowed }
server-no-sensor-key = there is no `{ $key }`; allowed: { $allowed }
server-number-count = `{ $key }` has { $n } numbers; allowed: { $allowed }
server-too-many-planes = { $n } planes; allowed: up to { $max }

# Placing the part by touching.
server-probe-radius = probe radius { $value }; allowed: 0 to { $max }
server-too-many-points = { $n } points; allowed: up to { $max }
server-feature = point { $point }: unknown feature `{ $feature }`; allowed: { $allowed }
server-point-far = point { $point } is too far away; allowed: up to { $max }
server-more-points = { $why }; use more points, spread over the surfaces, or another method
server-more-points-round = { $why }; use more points, spread over the face and all round
server-no-surfaces = the job has no seam whose surfaces can be touched: use a job
server-not-determined = not determined: { $what }; unchanged
server-turn-about-axis = the turn about the axis
server-no-spare-points = no more points than unknowns: a bad point would not be noticed
server-three-points-plane = plane: only three points; a bad one would not be noticed
server-three-points-face = face: only three points; a bad one would not be noticed
server-three-points-round = round: only three points; a bad one would not be noticed
server-round-diameter = diameter of the round: { $diameter }
server-no-position = the points determine no position
server-offsets-no-table = `offsets` is not a table; allowed: [offsets.NAME]

# Records and backup.
server-query = { $name }: { $why }
server-too-many-values = { $columns } columns of { $rows } rows are too many; allowed: up to { $max-columns } columns, { $max-values } values
server-row-count = most={ $value }; allowed: { $min } to { $max }
server-no-column = there is no column `{ $column }`; allowed: { $allowed }
server-not-off = the machine is not off: switch the drives off first
server-archive-too-large = the archive is too large; allowed: up to { $max }; `seamwright records restore` takes larger ones
server-archive-broke-off = the transfer of the archive was interrupted
server-archive-no-admin = the archive has no administrator: nobody could use the panel afterwards
server-no-archive = no archive was checked: send one first
server-record-being-written = the record of a weld is still being written: wait
server-backup-runs = a backup is being made or checked: wait until it has ended

# Teaching by camera.
server-no-image = there is no image yet
server-teach-point = a pixel and a position; allowed: one of them, or neither
server-teach-no-work = the image shows no part there
server-teach-range = { $key } { $value }; allowed: { $min } to { $max }
server-teach-above = { $key } { $value }; allowed: above 0, up to { $max }
server-teach-method = unknown method `{ $method }`; allowed: { $allowed }
server-teach-nothing = nothing has been taught yet
server-teach-tack = invalid tack; allowed: the start before the end, both finite
server-teach-order = invalid order
server-teach-real-devices = the devices of the machine are real, and its file names no `frames` of a camera: teach by jogging
server-teach-no-program = no program is loaded: its seam gives the nominal joint
server-teach-is-open = a session is open: stop it first
server-teach-not-open = no session is open
server-teach-not-asked = the position of the joint is not needed now
server-teach-not-paused = nothing is paused
server-teach-far = the position is not near the nominal seam; allowed: within 15 mm of it
server-teach-start-far = the start is not near the nominal seam
server-teach-other-machine = { $job } is for { $machine }, not for this cell
server-teach-no-frames = the devices of the machine are real, and sensors.{ $sensor } has no `frames`
server-teach-no-camera = { $machine } has no camera; allowed: a machine with [sensors.NAME] and kind = "camera" in its file
server-teach-sensor-no-camera = { $sensor } is not a camera
server-teach-blocked = the cell has stopped the axes on the way: see its alarms
server-camera-address = the machine file names a camera at { $address }, to which this cell does not connect; allowed: this computer; more with `seamwright serve --camera HOST:PORT`
server-camera-address-list = the machine file names a camera at { $address }, to which this cell does not connect; allowed: this computer, { $allowed }; more with `seamwright serve --camera HOST:PORT`

# Audit log: where from, what, and result.
server-audit-panel = panel
server-audit-panel-number = panel { $number }
server-audit-panel-at = panel at { $address }
server-audit-save-job = save job { $job }
server-audit-delete-job = delete job { $job }
server-audit-load = load { $job }
server-audit-change-user = change user { $user }
server-audit-delete-user = delete user { $user }
server-audit-own-password = own password
server-audit-log-in = log in
server-audit-log-out = log out
server-audit-backup = download backup
server-audit-restore = restore
server-audit-check-archive = check backup
server-audit-set-axis = set axis { $name } in { $file }
server-audit-set-tool = set tool { $name } in { $file }
server-audit-set-sensor = set sensor { $name } in { $file }
server-audit-shelve = shelve alarm { $alarm } { $detail } for { $minutes } min
server-audit-override = override { $override }
server-audit-acknowledge = acknowledge { $alarm }
server-audit-weld = weld { $weld } of part “{ $part }”
server-audit-others = others
server-audit-teach = teaching: { $order }
server-audit-teach-open = start camera: step { $step }, gaps up to { $tacks }, seed { $seed }
server-audit-teach-open-tack = start camera: step { $step }, gaps up to { $tacks }, seed { $seed }, a tack from { $from } to { $to }
server-audit-teach-pixel = joint is here: pixel { $x }, { $y }
server-audit-teach-point = joint is here: X { $x } Y { $y } Z { $z }
server-audit-teach-middle = joint is at the cross of the camera
server-audit-teach-end = joint ends here
server-audit-teach-pause = pause
server-audit-teach-resume = resume
server-audit-teach-stop = stop
server-audit-accepted = accepted
server-audit-saved = saved
server-audit-deleted = deleted
server-audit-changed = changed
server-audit-kept = saved
server-audit-begun = started
server-audit-checked = checked
server-audit-loaded = loaded
server-audit-logged-in = logged in
server-audit-logged-out = logged out
server-audit-refused = refused
server-audit-refused-role = refused: role
server-audit-reweld = finished welds may be welded again
server-audit-more = { $result }: { $n } more in { $time }
server-audit-left-out = { $n } entries were left out

# Events.
server-event-left = pass { $pass } was left, welded up to { $s }
server-event-mode = { $from } -> { $to }
server-event-order = { $order }
server-event-refused = { $order }: { $reason }
server-event-alarm = { $alarm }: { $reaction }
server-event-alarm-of = { $alarm } ({ $object }): { $reaction }
server-event-alarm-before = { $alarm } of { $time } was not acknowledged before the end
server-event-cleared = { $alarm } cleared
server-event-cleared-of = { $alarm } ({ $object }) cleared
server-event-pass-ends = pass { $pass } ends at { $s }
server-event-left-before = weld { $weld } was interrupted by a failure of power or program: inspect the end of its bead before continuing
server-event-stopped-by = the cell was stopped by { $cause }
server-event-cycles-missed = { $cycles } cycles were missed, up to { $longest } at once
server-event-no-realtime = the cycle runs without real-time rights: { $reason }
server-event-safe-unconfirmed = { $device }: its outputs are not confirmed to be safe: { $reason }
server-event-journal-damaged = the journal of positions is damaged: a weld left by a power failure would not be known; look at the part, then home
server-event-weld-lost = weld { $weld } has files but is not in the library, which is damaged: its entry was lost
server-event-recorded = weld { $weld } recorded: { $result }
server-event-record-not-whole = weld { $weld }: the record is not complete: { $reason }
server-event-record-interrupted = weld { $weld } was interrupted; its record is whole again
server-event-record-fails = the record cannot be written: { $reason }
server-event-not-recorded = this weld is not recorded: { $reason }
server-event-audit-fails = the audit log cannot be written: { $reason }
server-event-restored = all data were restored; what was there before is in { $folder }
server-event-control-taken = control taken
server-event-control-taken-over = control taken over
server-event-control-lost = control lost: panel not responding
server-event-loaded = loaded: { $job }
server-event-not-loaded = nothing is loaded: { $reason }
server-event-teach-ended = teaching { $job } ended: { $result }
server-event-shelved = { $alarm } shelved for { $minutes } min
server-event-unshelved = { $alarm } is no longer shelved
server-event-machine-changed = { $subject } changed in { $file }: takes effect when a job of this machine is loaded again
server-event-tool-changed = tip of { $head } changed in { $file }: takes effect when a job of this machine is loaded again
server-event-sensor-changed = sensor { $sensor } changed in { $file }: takes effect when a job of this machine is loaded again
