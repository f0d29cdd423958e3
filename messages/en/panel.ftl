# Words of the panel, in the order of its pages.

# Words for several pages.
panel-least = Min
panel-mean = Mean
panel-greatest = Max
panel-allowed = Allowed
panel-program = Program
panel-pass = Pass
panel-alarm = Alarm
panel-language = Language
panel-tabs = Tabs
panel-cancel = Cancel
panel-close = Close
panel-search = Search
panel-all = All
panel-on = on
panel-off = off
panel-undo = Undo
panel-redo = Redo
panel-set = Set
panel-actual = Actual
panel-abort = Abort
panel-stop = STOP: software stop
panel-mode = State
panel-armed = Armed
panel-recording = Record { $weld }
panel-simulated = simulated
panel-commands = Commands
panel-refused = Refused:
panel-why = Why can't I start?
panel-passes = Passes
panel-progress = Progress
panel-time-left = { $time } left
panel-readouts = Read-outs
panel-process = Process
panel-gas = Gas
panel-speed = Speed
panel-override = Override
panel-bottom = Alarms and plots
panel-scene = The cell in 3D
panel-clearance = Clearance
panel-section = Cross-section of the joint
panel-axis = Axis
panel-conditions = Conditions (interlocks)
panel-condition = Condition

# Alarms.
panel-alarm-cause = Cause
panel-alarm-state = State
panel-alarm-consequence = Consequence
panel-alarm-action = What to do
panel-alarm-reaction = Reaction
panel-alarm-priority = Priority
panel-alarm-severity = Severity
panel-alarm-response = Time to respond
panel-alarm-shelvable = Shelving
panel-alarm-chattering = CHATTERING
panel-alarm-first = FIRST
panel-alarm-one = Acknowledge this alarm
panel-alarm-shelve = Shelve
panel-alarm-shelve-for = Shelve for
panel-alarm-minutes = { $minutes } min
panel-alarm-unshelve = Take back
panel-alarm-shelved = Shelved: { $alarm }
panel-alarm-until = until { $time }, by { $user }
panel-alarm-shelve-how = Only message-only alarms can be shelved. Alarms that stop or hold are always shown.

# Process values.
panel-value-tip-speed = Tip speed
panel-value-speed = Tip speed

# States.
panel-mode-off = Off
panel-mode-idle = Not homed
panel-mode-homing = Homing
panel-mode-ready = Ready
panel-mode-jog = Jog
panel-mode-teach = Teach
panel-mode-dry-run = Dry run
panel-mode-weld = Weld
panel-mode-hold = Hold
panel-mode-fault = Fault

# Commands.
panel-do-hold = Hold
panel-do-resume = Resume
panel-do-reverse = Reverse
panel-do-stop = Stop
panel-do-switch-on = Switch on
panel-do-switch-off = Switch off
panel-do-home = Home
panel-do-start-jog = Start jogging
panel-do-start-teach = Start teaching
panel-do-start-dry-run = Dry run
panel-do-arm = Arm arc
panel-do-arm-beam = Arm beam
panel-do-start-weld = Start weld
panel-do-start-beam = Start weld
panel-do-reset = Reset fault
panel-do-acknowledge = Acknowledge all
panel-do-override = Override
panel-do-acknowledge-one = Acknowledge one alarm
panel-do-home-axis = Home one axis

# Interlocks of supplied machines.
panel-interlock-emergency-stop-chain = emergency stop chain
panel-interlock-light-curtain = light curtain
panel-interlock-shielding-gas = shielding gas
panel-interlock-torch-coolant = torch coolant
panel-interlock-doors = doors
panel-interlock-cooling-water = cooling water
panel-interlock-gun-pressure = gun pressure
panel-interlock-chamber-pressure = chamber pressure
panel-interlock-chamber-door = chamber door
panel-interlock-laser-interlocks = laser interlocks
panel-interlock-cabin-doors = cabin doors

# Records.
panel-record-part = Part
panel-record-begun = Started
panel-record-machine = Machine
panel-record-procedure = Procedure
panel-record-welder = Welder
panel-record-list = Records
panel-record-no-hit = No records match.
panel-record-none = No welds yet.
panel-record-no = No.
panel-record-result = Result
panel-record-worst = Max. deviation
panel-record-outside = outside over { $length } mm
panel-record-from = From
panel-record-compare = Compare
panel-record-report = Report
panel-record-facts = Summary
panel-record-trace = Trace
panel-record-columns = Choose signals
panel-record-no-values = This pass has no such values.

# Events.
panel-event-time = Time
panel-event-text = Event
panel-event-what = What
panel-event-mode = State
panel-event-order = Command
panel-event-refused = Refused
panel-event-alarm = Alarm
panel-event-cleared = Cleared
panel-event-pass = Pass
panel-event-left = Left
panel-event-record = Record
panel-event-control = Control
panel-event-work = Program
panel-event-teach = Teaching

# Bottom.
panel-bottom-alarms = Alarms
panel-bottom-events = Events
panel-bottom-plots = Plots
panel-bottom-tracking = Tracking

# Jobs.
panel-job-head = Job
panel-job-list = Jobs
panel-job-own = My jobs
panel-job-examples = Templates
panel-job-example = Template – save as your own job
panel-job-title = Title
panel-job-name-how = Letters A–Z, digits, and . _ -
panel-job-name = Name
panel-job-open = Open
panel-job-use = New from template
panel-job-load = Load
panel-job-loaded = loaded
panel-job-part = Part number (for the record)
panel-job-part-why = The program is planned, checked and loaded into the cell. Nothing moves.
panel-job-lies = Simulated misplacement
panel-job-lies-planned = none
panel-job-lies-why = With an offset the seam is tracked.
panel-job-delete = Delete
panel-job-delete-sure = Delete { $job }? This cannot be undone.
panel-job-save = Save
panel-job-save-as = Save as …
panel-job-unsaved = not saved
panel-job-leave = There are unsaved changes.
panel-job-discard = Discard changes
panel-job-replace = Replace
panel-job-other = { $job } exists with other text: another job, or changed by someone else since. Replace it with this one?
panel-job-edit = Edit
panel-job-preview = Preview
panel-job-form = Form
panel-job-parts = Part and fixtures
panel-job-points = Points
panel-job-text = Text
panel-job-post = G-code
panel-job-findings = Findings
panel-job-section = Cross-section
panel-job-plots = Plots
panel-job-limits = Limits

# Tracking.
panel-track-lateral = Lateral
panel-track-height = Height
panel-track-head = Head
panel-track-none = Tracking off
panel-track-confidence = Confidence
panel-track-sigma = Std. deviation
panel-track-guessed = not seen

# Pages.
panel-tab-weld = Weld
panel-tab-teach = Jog · Teach
panel-tab-jobs = Jobs
panel-tab-records = Records
panel-tab-setup = Set-up

panel-theme-light = Light
panel-theme-dark = Dark

# Connection.
panel-link-opening = Connecting …
panel-link-open = Connected
panel-link-closed = No connection
panel-link-stale = Data { $age } s old

# Log-in.
panel-login-user = User
panel-login-password = Password
panel-login-go = Log in
panel-login-out = Log out
panel-login-over = The session has ended: it was closed, changed or has expired. The cell keeps running; STOP works here too. Log in again.
panel-login-runs = The cell is running and continues without you.
panel-login-stopped = STOP was sent. State then: { $state }.
panel-login-made = Log in as this user now. The start-up link no longer works.
panel-login-wrong = User or password is wrong.
panel-login-key = First start: open the start-up link that the program has printed.
panel-login-owner = Owner

# Control.
panel-control-mine = In control: you
panel-control-give = Give up control
panel-control-take = Take control
panel-control-free = No one in control
panel-control-unknown = Control unknown
panel-control-theirs = In control: { $user } (station { $station })
panel-control-over = { $user } is in control. Take control away?
panel-control-needed = Take control to operate this cell.

# Roles.
panel-role-viewer = Viewer
panel-role-operator = Operator
panel-role-programmer = Programmer
panel-role-service = Service
panel-role-admin = Administrator

# STOP.
panel-stop-failed = STOP DID NOT REACH THE CELL
panel-stop-emergency = Press the emergency stop.
panel-stop-late = STOP reached the cell late
panel-stop-check = Check that the machine is at rest and the process is off.
panel-stop-unanswered = The page is connected, but the cell was not seen to stop in time.
panel-stop-no-connection = There is no connection to the cell. This page keeps trying to connect.
panel-stop-read = I have read this

# Process.
panel-process-arc-on = ARC ON
panel-process-beam-on = BEAM ON
panel-process-arc-off = Arc off
panel-process-beam-off = Beam off
panel-process-ordered = Commanded on

# Phases of a pass.
panel-phase-held = at rest
panel-phase-preflow = gas preflow
panel-phase-travel-delay = travel delay
panel-phase-travel = welding
panel-phase-run-out = ramp-down
panel-phase-crater = crater fill
panel-phase-postflow = gas postflow
panel-phase-move = transfer move
panel-phase-ended = done

panel-timing-no-realtime = No real-time rights
panel-timing-missed = { $cycles } cycles missed, up to { $longest } ms

# Program.
panel-work-none = No program loaded
panel-work-part = Part { $part }
panel-work-load-again = Re-plan from here
panel-work-load-first = Load a program in Jobs.

# Why can't I start?.
panel-why-for = Missing for “{ $command }”
panel-why-nothing = { $command }: ready to start.
panel-why-runs = It is running.

# Interlocks and permissives: why a command is refused.
panel-lack-moving = The axes are still moving: wait a moment.
panel-lack-lost = The connection was lost. No command is repeated automatically.

# Roles of passes.
panel-pass-role-tack = Tack
panel-pass-role-root = Root
panel-pass-role-fill = Fill
panel-pass-role-cap = Cap
panel-pass-role-cosmetic = Cosmetic

# Unfinished welds.
panel-left-button = Continue pass { $pass } at { $s } mm …
panel-left-elsewhere = Weld { $weld } ({ $title }, part { $part }) is unfinished: pass { $pass }, { $s } mm. Load its job and part to continue.
panel-left-title = Continue the unfinished weld
panel-left-of = Weld { $weld }: { $title }, part { $part }.
panel-left-where = Stopped in pass { $pass }, welded up to { $s } mm.
panel-left-overlap = Overlap, mm
panel-left-from = Restarts in pass { $pass } at { $s } mm.
panel-left-ground = Crater ground out and inspected
panel-left-arm = Nothing starts automatically: arm and start as usual afterwards.
panel-left-go = Load from there

# Welding again.
panel-again-title = Weld finished work again?
panel-again-left = To continue instead, cancel and press “Continue pass { $pass }” (stopped at { $s } mm).
panel-again-go = Weld it again

# Positions.
panel-position-tip = Tool tip (work frame)
panel-position-tip-in = Tool tip (frame { $frame })
panel-position-machine = Machine axes
panel-position-unreferenced = not homed

panel-override-less = Override less
panel-override-more = Override more

# Plots.
panel-plot-path = Path speed
panel-plot-greatest = Max. following error
panel-plot-position = Position
panel-plot-axis = Axis
panel-plot-choose = Choose plots
panel-plot-speed = Speed
panel-plot-error = Following error
panel-plot-deviation = Seam deviation
panel-plot-seen = seen
panel-plot-done = corrected

# State of tracking.
panel-sight-seen = Joint found
panel-sight-bridged = Joint found, tack bridged
panel-sight-coasted = No view, holding
panel-sight-fading = No view, returning to plan
panel-sight-unseen = No view yet
panel-sight-lost = Joint lost

# Alarms.
panel-alarms-none = No alarms
panel-alarms-unknown = Alarms unknown: no current data
panel-alarms-more = and { $n } more

# Alarm state.
panel-alarm-state-unacknowledged = active
panel-alarm-state-acknowledged = active, acknowledged
panel-alarm-state-returned = cleared, not acknowledged
panel-alarm-state-gone = cleared, shelved

# Reactions.
panel-reaction-told = message only
panel-reaction-hold = hold
panel-reaction-process-off-hold = process off, hold
panel-reaction-process-off-stop-power-off = process off, stop, power off
panel-reaction-process-and-power-off = process and power off

# Devices.
panel-device-drives = drives
panel-device-source = process source
panel-device-process-source = process source
panel-device-inputs = inputs

# 3D view.
panel-scene-fails = This browser cannot show 3D (WebGL 2).
panel-scene-views = Views
panel-scene-show = Show
panel-scene-colour = Passes coloured by
panel-scene-cut = Section plane
panel-scene-measure = Measure
panel-scene-heat = Arc energy
panel-scene-no-heat = Arc energy unknown: the program gives neither current and voltage nor power.
panel-scene-no-value = Not known for this program.
panel-scene-off-beam = Beam deviation
panel-scene-off-torch = Deviation
panel-scene-measure-how = Pick two points.

panel-spot-span = Span
panel-spot-pass = Whole pass

panel-clearance-least = (min. { $min } mm)

# Views.
panel-view-fit = Fit
panel-view-fit-how = The seam; again: everything
panel-view-top = Top
panel-view-front = Front
panel-view-side = Side
panel-view-torch = Torch

# Layers.
panel-layer-machine = Machine
panel-layer-part = Part and fixtures
panel-layer-zones = Zones
panel-layer-air = Transfer moves
panel-layer-near = Closest approach
panel-layer-sensors = Sensors' fields
panel-layer-trace = Trace of the tip

# Jogging.
panel-jog-frame = Move by
panel-jog-joints = Axes
panel-jog-tip = Torch tip
panel-jog-turn = About the tip
panel-jog-turn-how = Turns the torch with its tip at rest.
panel-jog-speed = Jog speed
panel-jog-end = End jogging
panel-jog-how = Moves while held. Arrow keys: first two rows, page keys: third.
panel-jog-step = Step
panel-jog-held = continuous
panel-jog-step-how = One step of { $step } mm or degrees a press; it ends early if you let go.

# Go to.
panel-go-title = Go to
panel-go-begin = Start of pass { $pass }
panel-go-spot = Picked point
panel-go-home = Home position
panel-go-how = All axes move while the key is held and arrive together. No collision-free path is planned: the cell stops before an obstacle.
panel-frame-title = Frame
panel-frame-work = Work
panel-frame-base = Base
panel-frame-tool = Tool
panel-frame-flange = Flange
panel-frames-kind-base = Base
panel-frames-kind-mount = Mount
panel-frames-kind-flange = Flange
panel-frames-kind-adapter = Adapter
panel-frames-kind-tool = Tool
panel-frames-kind-tcp = Tool centre point (TCP)
panel-frames-kind-table = Positioner
panel-frames-kind-work = Work
panel-frames-within-base = in the base
panel-frames-within-flange = in the flange
panel-frames-within-work = in the work frame, all axes at zero
panel-frames-within-before = in the frame before it
panel-frames-how = Positions in mm. The tip itself is found under Tool. A change is kept in { $file }; what was there before stays beside it.
panel-frames-change = Change
panel-frames-keep = Save
panel-frames-remove = Remove
panel-frames-was = before: { $frame }
panel-frames-back = Put the old one back
panel-frames-new = New user frame
panel-frames-taken = This name is taken.
panel-frames-teach = Teach by three points
panel-frames-teach-how = Under Jog bring the tip to each point and record it here. The frame is given in the base.
panel-frames-point-1 = Origin
panel-frames-point-2 = Point on the x axis
panel-frames-point-3 = Point on the side of y
panel-frames-record = Record
panel-frames-jog = Start jogging to record points.
panel-frames-taught = Points { $distance } mm apart, { $angle }° between them
panel-frames-large = Large change: { $distance } mm, { $angle }°. Save again to confirm.
panel-rotation-title = Orientation
panel-rotation-kept = as it is
panel-rotation-xyz = RX RY RZ (fixed axes X, Y, Z)
panel-rotation-abc = A B C (axes Z, Y, X, turned)
panel-rotation-quaternion = Quaternion Q1 to Q4
panel-rotation-next = Show the orientation in another convention
panel-rotation-none = The numbers are no orientation: the squares of a quaternion's numbers add up to 1.
panel-target-title = Typed target
panel-target-present = Present position
panel-target-check = Check
panel-target-go = Go there (hold)
panel-target-clear = nothing near on the way
panel-target-missed = The torch misses this direction by { $angle }°: the machine lacks axes for it.
panel-target-how = Check shows target, way and clearance in 3D before anything moves. In the frame of the tool the numbers are relative.
panel-arm-title = Configuration
panel-arm-shoulder-front = Front
panel-arm-shoulder-back = Back
panel-arm-elbow-up = Elbow up
panel-arm-elbow-down = Elbow down
panel-arm-wrist-no-flip = No flip
panel-arm-wrist-flip = Flip
panel-arm-turns = Turns { $turns }
panel-arm-no-turns = Turns 0
panel-arm-turns-how = Whole turns of axes 1 to 6 beyond 180 degrees
panel-arm-near-shoulder = near the shoulder singularity
panel-arm-near-elbow = near the elbow singularity
panel-arm-near-wrist = near the wrist singularity
panel-job-reach = Reach
panel-reach-moved = Moved
panel-reach-work = Work
panel-reach-base = Machine base
panel-reach-budget = Time
panel-reach-search = Search the best place
panel-reach-from = from
panel-reach-to = to
panel-reach-cells = places
panel-reach-how = { $n } places about the present one. The margin is the smallest distance of an axis from an end of its range.
panel-reach-too-many = { $n } places; at most { $max }.
panel-reach-judged = { $done } of { $total } places judged
panel-reach-refines = Refining and planning the best place
panel-reach-best = Best place
panel-reach-margin = Margin
panel-reach-apply = Put into the job
panel-reach-is-best = The present place is the best.
panel-reach-none = No place of these ranges can be welded and planned.
panel-reach-base-how = The base is moved in the machine file: { $key } = { $move } mm, rotation { $angle }°.
panel-reach-changed = The job was changed after the search: search again.
panel-reach-cut-off = The time was over before everything was judged: best place so far.
panel-reach-failed = Not planned at { $place }: { $reason }
panel-reach-weldable = { $n } of { $total } judged places can be welded.
panel-reach-map = Margin over x and y
panel-reach-legend = Numbers: margin in per cent. Hatched: the seam cannot be welded, with the axis that is the reason. ○ present place, ★ best.
panel-arm-from = from { $s } mm
panel-schedule-title = Schedules
panel-schedule-jobs = Jobs
panel-schedule-import = Import a table
panel-schedule-import-how = CSV or TOML with a row for each seam: a template, its changed values, and the machines that may weld it. Files in jobs/schedules of the data folder are listed too.
panel-schedule-none = No table yet.
panel-schedule-open = Open
panel-schedule-delete = Delete the table and its results?
panel-schedule-replace = { $name } exists already. Replace it? Rows that do not change keep their results.
panel-schedule-run = Plan all rows
panel-schedule-go-on = Plan the missing rows
panel-schedule-post = Part programs
panel-schedule-no-post = none
panel-schedule-limit = Time limit a plan
panel-schedule-progress = { $done } of { $total } rows
panel-schedule-kept = { $kept } were planned before
panel-schedule-rate = { $rate } rows/min
panel-schedule-counting = Reading the table
panel-schedule-other = { $name } is being planned; one table at a time.
panel-schedule-failed = The last run ended early: { $why }
panel-schedule-planned = planned
panel-schedule-new = not planned
panel-schedule-filter = Show
panel-schedule-all = all
panel-schedule-of = { $n } of { $total } rows
panel-schedule-more = Further { $n } rows are in the result files.
panel-schedule-row = Row
panel-schedule-name = Seam
panel-schedule-status = Result
panel-schedule-machine = Machine
panel-schedule-count = Parts
panel-schedule-passes = Passes
panel-schedule-time = Time, min
panel-schedule-arc = Arc, min
panel-schedule-wire = Wire, kg
panel-schedule-clearance = Clearance, mm
panel-schedule-reason = Findings
panel-schedule-job = Open as a job
panel-schedule-parts-of = Parts on the machines
panel-schedule-gantt-how = Hatched: set-up. A press on a part shows its row.
panel-schedule-total = { $parts } parts · { $weld } h welding · last part after { $end } h
panel-schedule-export = Export
panel-schedule-export-how = The files are written when all rows are planned.
panel-schedule-report = Report
panel-schedule-waiting = waiting
panel-schedule-weldable = can be welded
panel-schedule-not-weldable = cannot be welded
panel-schedule-out-of-time = out of time
panel-schedule-invalid = invalid
panel-schedule-invalid-table = The table has a fault: { $why }

# Teaching by camera.
panel-teach-by = Teach
panel-teach-by-hand = By hand
panel-teach-by-eye = By camera
panel-teach-open = Start camera
panel-teach-pause = Pause
panel-teach-resume = Continue
panel-teach-stop = Stop teaching
panel-teach-here-spot = Joint is at the point picked in 3D
panel-teach-here-begin = Joint starts at the start of the program
panel-teach-here-eye = Joint is at the cross
panel-teach-here-how = Touch the joint in the image, pick it in 3D, or jog the cross onto it. The machine will move.
panel-teach-end-here = The joint ends here
panel-teach-picture = Camera image
panel-teach-no-picture = No picture yet
panel-teach-way = { $done } of { $length } mm
panel-teach-confidence = Confidence
panel-teach-least = Min
panel-teach-frames = Frames
panel-teach-step = Step, mm
panel-teach-tack = Bridge gaps up to, mm
panel-teach-seed = Simulation seed
panel-teach-points = Taught points
panel-teach-tolerance = Tolerance, mm
panel-teach-method = Curves
panel-teach-greedy = lines, arcs
panel-teach-fewest = fewest lines, arcs
panel-teach-spline = spline
panel-teach-make = Fit curves
panel-teach-made = { $lines } lines, { $arcs } arcs, { $splines } spline pieces; { $length } mm
panel-teach-error = Fit error
panel-teach-from-nominal = Joint from the program: across / above
panel-teach-truth = From the true joint (simulated)

# Teach phase.
panel-teach-phase-closed = Camera off
panel-teach-phase-plans = Planning along the seam …
panel-teach-phase-places = Point at the start of the joint. The machine will move.
panel-teach-phase-runs = Following the joint
panel-teach-phase-paused = Paused
panel-teach-phase-asks = Joint lost. Show where it continues.
panel-teach-phase-ended = Ended

# Teach pause.
panel-teach-pause-operator = by the operator
panel-teach-pause-hand = the axes were jogged
panel-teach-pause-control = this page lost control
panel-teach-pause-mode = the cell is not in jogging or teaching

# Teach end.
panel-teach-end-closed = back at its start
panel-teach-end-joint-end = at the end of the joint
panel-teach-end-operator = ended by the operator
panel-teach-end-lost = the joint was lost
panel-teach-end-limit = end of the machine’s range
panel-teach-end-too-long = longer than the nominal seam allows
panel-teach-end-out-of-frames = no more frames
panel-teach-end-stopped = stopped
panel-teach-end-failed = failed

# Teaching by hand.
panel-taught-title = Teach by hand
panel-taught-record = Record point
panel-taught-clear = Clear
panel-taught-back = Bring back { $n } points
panel-taught-of = These points were recorded on { $machine }: they are of no use on this machine. Clear them, or load a program of that machine.
panel-taught-remove = Remove point { $point }
panel-taught-save = Save as program
panel-taught-saved = Saved: { $file }. It is in Jobs.

panel-lies-misplaced = 2 mm and half a degree off, wavy, two tacks
panel-lies-half-ring = 2 mm and half a degree off, oval, one tack

# Form of a job.
panel-form-add-what = Add a section
panel-form-add = Add
panel-form-add-key = Add a value
panel-form-values = { $n } values
panel-form-in-text = Show in the text
panel-form-remove = Remove
panel-form-kind = Kind of joint
panel-form-procedure = Procedure
panel-form-ships = This procedure is supplied with the program. Make a copy to change it.
panel-form-copy = Make a copy
panel-form-whose = Every job that names this file is checked against it.
panel-form-allowed = Allowed: { $allowed }
panel-form-no-number = Not a number. Keeping { $value }.
panel-form-keep = Save procedure

# Limits of the speed.
panel-bound-title = Speed limited by
panel-bound-at-asked = Programmed speed held on { $share } %.
panel-bound-everywhere = Machine limit: { $speed } mm/s.
panel-bound-asked = programmed speed
panel-bound-speed = speed
panel-bound-acceleration = acceleration
panel-bound-jerk = jerk
panel-bound-tip = torch tip
panel-bound-ends = acceleration or deceleration
panel-bound-more = { $n } more stretches are in the report.
panel-bound-used = Limits of the axes and how much of them is used
panel-bound-of = ≤ { $share } % of { $limit }

# Cross-section.
panel-section-where = Place along the seam
panel-section-dihedral = Between the faces
panel-section-gap = Root gap
panel-section-mismatch = Mismatch
panel-section-area = Area
panel-section-beads = beads
panel-section-bead = Bead
panel-section-role = Role
panel-section-no-beads = No beads are planned: one pass along the seam.
panel-section-none = The job describes no joint.

# Part and fixtures.
panel-parts-add = Add a body
panel-parts-add-go = Add
panel-parts-shape = Shape
panel-parts-as = What it is
panel-parts-fixture = Fixture
panel-parts-part = Part
panel-parts-part-why = Bodies of the part are added to the one that is made from the seam.
panel-parts-replaced = The part made from the seam is replaced (part.replace): collisions are checked with the bodies below only.
panel-parts-none = The job has no bodies of its own: the part is made from the seam.
panel-parts-fixed = Change it in the text.
panel-parts-unnamed = unnamed
panel-parts-at = At
panel-parts-turn = Turned about
panel-parts-tip = To the torch tip

# Shapes.
panel-shape-box = box
panel-shape-cylinder = cylinder
panel-shape-sphere = sphere
panel-shape-cone = cone
panel-shape-capsule = capsule
panel-shape-ellipsoid = ellipsoid
panel-shape-half-space = half space

# Size.
panel-size-size = Size
panel-size-radius = Radius
panel-size-top-radius = Top radius
panel-size-length = Length
panel-size-semi-axes = Semi-axis

# Placing the part by touching.
panel-touch-title = Place the part by touching
panel-touch-how = Under Jog · Teach touch the part with the tip and record { $n } points or more; they are listed here then.
panel-touch-other = The job is for another machine than this cell has.
panel-touch-method = Method
panel-touch-radius = Probe radius, mm
panel-touch-on = Point { $point } is on
panel-touch-go = Compute the position
panel-touch-moved = The part is moved by
panel-touch-rms = Points off it by (RMS)
panel-touch-use = Put it into the job

# Touch method.
panel-touch-method-best-fit = Best fit on both parts
panel-touch-method-plane-line-point = Plane, line, point
panel-touch-method-three-points = Plane, origin, direction
panel-touch-method-chuck = Chuck axis: face and round

# Features.
panel-feature-nozzle = nozzle / first part
panel-feature-body = shell / second part
panel-feature-plane = plane z = 0
panel-feature-line = face y = 0
panel-feature-point = face x = 0
panel-feature-origin = origin
panel-feature-direction = point on x
panel-feature-face = face z = 0
panel-feature-round = round about z

# Plan.
panel-plan-plans = Planning …
panel-plan-cancelled = Planning was cancelled.
panel-plan-again = Plan again
panel-plan-wrong = Job has errors
panel-plan-good = Can be welded
panel-plan-report = Report of the plan
panel-plan-report-with-appendix = Report with appendix
panel-plan-before = The job has errors. This is the plan before the change.
panel-plan-none = No plan (see Findings). The job’s own geometry is shown.
panel-plan-line = line { $line }
panel-plan-whole = The whole message
panel-plan-bad = Cannot be welded as programmed
panel-plan-time = { $time } s in total

# Kinds of findings.
panel-finding-access = No room for the torch
panel-finding-air = Transfer move is blocked
panel-finding-attitude = Torch angle out of tolerance
panel-finding-bead = Bead does not fit its run
panel-finding-blend = Corner is rounded
panel-finding-clearance = Collision or clearance too small
panel-finding-cooling = Cooling time out of range
panel-finding-drive = Drive at its current limit
panel-finding-hold = Axis cannot be held there
panel-finding-interpass = Wait between passes
panel-finding-jump = Axis would have to jump
panel-finding-joint = Joint beside its standard
panel-finding-least-speed = Slower than the WPS allows
panel-finding-oscillation = Oscillation leaves gaps
panel-finding-plausible = Value is not plausible
panel-finding-pool = Bead too large for its position
panel-finding-preheat = Preheat too low
panel-finding-path = Deviates from the seam
panel-finding-procedure = Outside WPS limits
panel-finding-range = Axis beyond its travel range
panel-finding-reach = Out of reach
panel-finding-retract = Torch is retracted
panel-finding-ripple = Speed is uneven
panel-finding-singular = Near a singularity
panel-finding-speed = Programmed speed is not reached
panel-finding-stop = Torch stops on the way
panel-finding-stopped = Weld was stopped
panel-finding-time = Takes too long
panel-finding-turn = Torch would jump at a corner
panel-finding-search = Search ended without a plan
panel-finding-unchecked = Collisions are not checked
panel-finding-unwind = Axis rewinds between passes

# Part programs.
panel-post-dialect = Control
panel-post-make = Make part program
panel-post-save = Download
panel-post-old = The job has changed since: make the program again.
panel-post-proof = Verification

# Table of points.
panel-points-point = Point
panel-points-along = Move
panel-points-column = Column
panel-points-value = Value
panel-points-insert = Insert after
panel-points-delete = Delete ({ $n })
panel-points-set = Apply to { $n } { $n ->
    [one] point
   *[other] points
 }
panel-points-split = Split here
panel-points-several = Multi-select
panel-points-reduce = Reduce
panel-points-tolerance = Tolerance of reducing, mm
panel-points-way = Interpolation
panel-points-way-set = Set interpolation ({ $n })
panel-points-why-row = Choose consecutive points, without the start.
panel-points-why-two = An arc is made of two points: it goes through the first to the second.
panel-points-why-place = An arc needs x, y and z; these points have none.
panel-points-start = start

# Interpolation.
panel-along-line = line
panel-along-arc = arc
panel-along-spline = spline
panel-along-taught = taught
panel-along-rapid = rapid
panel-along-cubic = cubic

# Columns.
panel-column-n = Block
panel-column-time = Time
panel-column-speed = Speed

# Signals of a record.
panel-trace-welded = Welded so far
panel-trace-tip-s = Position of the tip
panel-trace-path-error = Path deviation
panel-trace-attitude-error = Attitude error
panel-trace-process-state = State of the process
panel-trace-burning = Arc or beam is on
panel-trace-steady = Steady travel
panel-trace-power = Power of the drives
panel-trace-inputs = Inputs (bits)
panel-trace-true = True position
panel-trace-deviation = Seam deviation
panel-trace-correction = Correction
panel-trace-miss = Deviation from the joint
panel-trace-rows = Plot thinned to { $shown } of { $samples } samples; peaks kept.
panel-trace-move = Arrow keys move the cursor.

# Results.
panel-result-good = good
panel-result-deviating = out of tolerance
panel-result-stopped = stopped
panel-result-interrupted = interrupted
panel-result-running = running

# Set-up.
panel-setup-machine = Machine
panel-setup-devices = Inputs and outputs
panel-setup-tuning = Tuning
panel-setup-alarms = Alarm catalogue
panel-setup-users = Users
panel-setup-audit = Audit log
panel-setup-backup = Download backup
panel-setup-data = Backup
panel-setup-timing = Timing and devices
panel-setup-period = Cycle
panel-setup-missed = Cycles missed
panel-setup-lost = Cycles not recorded
panel-setup-age = Data age
panel-setup-status-age = Age of the status
panel-setup-answers = Response time ({ $devices }): median / max
panel-setup-station = Station
panel-setup-sensors = Sensors
panel-setup-parameters = Axes and drives
panel-setup-tool = Tool
panel-setup-frames = Frames
panel-setup-pages = Pages of the set-up
panel-setup-diagnostics = Diagnostics

# Backup.
panel-data-backup-how = All welds, jobs, users and logs as one file. Keys of encrypted connections are not in it.
panel-data-restore = Restore
panel-data-restore-how = Replaces all data with a backup. The file is checked first; nothing changes until you confirm. The current data are kept in a folder beside it.
panel-data-off = Switch the machine off first.
panel-data-file = Backup file (.tar)
panel-data-check = Send and check
panel-data-checks = Sending and checking …
panel-data-whole = The backup is complete:
panel-data-welds = Welds
panel-data-newest = Newest weld
panel-data-jobs = Jobs
panel-data-users = Users
panel-data-audit = Entries of the audit log
panel-data-replace = Replace all data
panel-data-sure = All data of this cell are replaced by the backup. The panel restarts and everybody has to log in as one of its users.
panel-data-begins = The panel restarts with the restored data. Log in again in a moment.

# Inputs and outputs.
panel-io-signal = Signal
panel-io-kind = Kind
panel-io-safe = Safe
panel-io-place = Register
panel-io-unit = unit
panel-io-watchdog = outputs safe after { $time } s
panel-io-polls = Polls
panel-io-missed = left out
panel-io-failed = failed
panel-io-connections = Connections
panel-io-away = Away
panel-io-round = Poll: median / 99.9 % / max
panel-io-trouble = Last error:
panel-io-wants = must be { $state }

# Io name.
panel-io-name-gas = Gas valve
panel-io-name-on = Arc or beam on
panel-io-name-watchdog = Sign of life of the cell
panel-io-name-ready = Source is ready
panel-io-name-burning = Arc or beam is on
panel-io-name-stuck = Wire or electrode is stuck
panel-io-name-fault = Fault of the source (its code; 0: none)
panel-io-name-heartbeat = Sign of life of the device

# Io kind.
panel-io-kind-input = input
panel-io-kind-output = output
panel-io-kind-set = set value
panel-io-kind-report = report
panel-io-kind-actual = actual value

# Tuning.
panel-tune-go = Tune and measure
panel-tune-waits = Measuring …
panel-tune-how = The position loop on its drive in simulation; nothing moves, nothing is changed.
panel-tune-assumed = The machine file describes no drive: an assumed one was tuned.
panel-tune-gain = Gain of the open loop
panel-tune-phase = Phase of the open loop
panel-tune-gain-margin = Gain margin
panel-tune-phase-margin = Phase margin
panel-tune-take = Save these settings

# Audit log.
panel-audit-command = Command
panel-audit-values = Values
panel-audit-newest = Newest { $n } entries; older ones exist.
panel-audit-whole = { $n } { $n ->
    [one] entry
   *[other] entries
 }
panel-audit-none = No entry contains this text.
panel-audit-older = Show older ones
panel-audit-english = Search covers codes, names and values of the entries.

# Axes.
panel-axis-current = Current
panel-axis-range = Range
panel-axis-max-speed = Max. speed
panel-axis-fault = fault
panel-axis-limit = limit switch
panel-axis-referenced = homed
panel-axis-home = Home axis { $axis }
panel-axis-home-how = Moves one axis to home. Referencing is done for all axes.

# Condition.
panel-condition-for = Needed for
panel-condition-met = met
panel-condition-unmet = not met

# Level.
panel-level-power = power
panel-level-motion = motion
panel-level-process = process

# Users.
panel-user-role = Role
panel-user-enabled = May log in
panel-user-password = New password (10 characters or more)
panel-user-own-password = Your own password
panel-user-first-run = No password is set yet. Create an administrator account.
panel-user-deleted = Deleted: { $user }.
panel-user-saved = Saved: { $user }.
panel-user-password-again = New password once more
panel-user-password-differs = The two passwords differ.
panel-user-new = New user
panel-user-edits = Change user { $user }
panel-user-exists = User { $user } already exists.
panel-user-over = Change them? Role: { $role }, may log in: { $enabled }. The password stays.
panel-user-over-password = Change them? Role: { $role }, may log in: { $enabled }. The password becomes the new one.
panel-user-change = Change

# Parameters.
panel-par-how = Values of the machine file. They are checked together and saved in { $file }; the old file is kept beside it. Grey = default.
panel-par-pending = Saved, takes effect after reload: switch the drives off and load the job again.
panel-par-reload = Load the job again
panel-par-keep = Save
panel-par-kept = Saved in { $file }
panel-par-wild = Large change – please confirm:
panel-par-wrong = Not a number: { $value }
panel-par-no-drive = The machine file describes no drive of this axis.
panel-par-notches = Notch filters
panel-par-notch = { $frequency } Hz, width { $width } Hz, gain { $gain }
panel-par-group-axis = Axis
panel-par-group-loop = Position loop and drive
panel-par-group-feedforward = Compensation
panel-par-group-mechanics = Mechanics and scale
panel-par-group-pose = Where it sits
panel-par-group-map = Pixels to mm
panel-par-group-timing = Times and noise
panel-par-home = Home position
panel-par-max-speed = Max. speed
panel-par-max-acceleration = Max. acceleration
panel-par-max-jerk = Max. jerk
panel-par-velocity-bandwidth = Bandwidth of the velocity loop
panel-par-kp = Proportional gain (kp)
panel-par-ki = Integral gain (ki)
panel-par-kd = Derivative gain (kd)
panel-par-kvff = Velocity feed-forward
panel-par-kaff = Acceleration feed-forward
panel-par-limit = Limit of force or torque
panel-par-current-time-constant = Time constant of the current loop
panel-par-current-delay = Dead time of the current
panel-par-friction-compensation = Friction compensation
panel-par-friction-smoothing = … smoothing speed
panel-par-backlash-compensation = Backlash compensation
panel-par-backlash-time = … compensation time
panel-par-encoder-counts = Encoder counts per unit
panel-par-inertia = Moved mass or inertia
panel-par-peak = Peak force or torque
panel-par-friction = Friction
panel-par-viscous = Viscous friction
panel-par-resonance = Resonance
panel-par-load-ratio = Inertia of load over motor
panel-par-bandwidth = Bandwidth of the position loop
panel-par-measured-at = Measured at
panel-par-following-counts = Following error, encoder counts
panel-par-load-error = Error at the load
panel-par-notch-at = Notch filter at

# TCP calibration.
panel-tool-title = TCP calibration by touching one point
panel-tool-how = Clamp a pointer. Touch it with the tip and record; tilt or turn the torch and touch it again: from { $n } directions or more, 20° apart.
panel-tool-head = Head
panel-tool-record = Record this touch
panel-tool-jog = Touches are recorded in Jog or Teach.
panel-tool-touch = Touch { $touch }
panel-tool-remove = Remove touch { $touch }
panel-tool-find = Compute the TCP
panel-tool-was = Current TCP
panel-tool-found = TCP found
panel-tool-deviation = Standard deviation
panel-tool-rms = Touches off the point (RMS)
panel-tool-apart = Attitudes apart
panel-tool-keep = Save this TCP
panel-tool-verdict-good = The touches agree; the tip is determined in all directions.
panel-tool-verdict-unseen = The touches agree, but do not determine the tip in all directions.
panel-tool-verdict-far = The tip would move by more than 20 mm: was it always the same point?
panel-tool-verdict-poor = The touches do not agree within 0.5 mm: touch again.
panel-tool-unseen = Not determined along ({ $direction }): unchanged there.
panel-tool-old = Back to the current TCP

# Sensors.
panel-sensor-none = The machine has no sensors.
panel-sensor-title = Find the camera’s map from a grid
panel-sensor-how = Lay a plate with a grid of dark dots square before the camera, at a known height: it has to fill half of the picture or more.
panel-sensor-pitch = Dots apart, mm
panel-sensor-z = Height of the plate (z), mm
panel-sensor-file = Picture of the grid
panel-sensor-simulated = Simulated picture
panel-sensor-find = Find the map
panel-sensor-picture = Picture with the dots that were found
panel-sensor-residuals = Net: the map. Red lines: how far each dot is from it, { $factor } times.
panel-sensor-dots = Dots
panel-sensor-off = Dots off the map (RMS / max)
panel-sensor-was = Current
panel-sensor-found = Found
panel-sensor-scale = Scale x / y, mm per pixel
panel-sensor-rotation = Rotation
panel-sensor-shear = Shear
panel-sensor-barrel = Distortion (negative: barrel)
panel-sensor-centre = Optical axis at (column, row)
panel-sensor-middle = middle
panel-sensor-aligned = The plate lies along the sensor’s axes: its rotation is the camera’s
panel-sensor-in-place = In place of the plane at z = { $z } mm
panel-sensor-new = As a new plane at z = { $z } mm
panel-sensor-keep = Save this map
panel-sensor-planes = Planes of the camera
panel-sensor-remove = Remove the plane at z = { $z } mm
panel-sensor-verdict-good = The picture fits the grid.
panel-sensor-move = Position on its link x, y, z
panel-sensor-turn = Turned about the direction x, y, z
panel-sensor-angle = … by the angle
panel-sensor-distance = Camera from the origin
panel-sensor-laser-angle = Camera’s axis to the laser’s plane
panel-sensor-focal = Focal length
panel-sensor-homography = Homography h1 … h8
panel-sensor-origin = Origin at (column, row)
panel-sensor-period = Frame period
panel-sensor-latency = From exposure to result
panel-sensor-noise = Noise of the joint’s position

# Paused dry run.
panel-pause-jog = Jog from here
panel-pause-where = Dry run paused in pass { $pass } at { $s } mm. Jog and record; then press “Plan return” and “Dry run”.
panel-pause-begin = Dry run paused before its first pass. Jog and record; then press “Plan return” and “Dry run”.
panel-pause-back = Plan return
panel-pause-forget = Cancel dry run

# Tour.
panel-tour-title = Your first weld
panel-tour-close = Skip
panel-tour-control = Press “Take control” (top right): one panel is in control at a time.
panel-tour-on = Press “Switch on”: the drives get power.
panel-tour-home = Press “Home”: the axes find their references.
panel-tour-load = Open Jobs and load “First weld”. It is planned and checked; nothing moves.
panel-tour-again = The axes have moved. Press “Re-plan from here”: the approach then starts where they are.
panel-tour-dry = A dry run: the same path without the arc. Let it finish; STOP, bottom right, stops it at once.
panel-tour-jog = Jogging. When the axes stand where you want them, press “End jogging”.
panel-tour-fault = A fault. The alarms below say what to do: acknowledge them, then press “Reset fault”.
panel-tour-arm = Press “Arm arc”: it allows one start within a minute. “Why can’t I start?” says what is missing.
panel-tour-weld = Press “Start weld”. STOP is always at the bottom right.
panel-tour-watch = Watch the torch. Try Hold and Resume (arm again first), and the views in 3D.
panel-tour-hold = Held, the arc is off. Press “Arm arc” again, then “Resume”.
panel-tour-left = The weld is unfinished. Press “Continue pass …” on the left: it continues from there, with overlap.
panel-tour-record = Done. Open Records: every weld is kept there.
panel-tour-end = Done. Next: Jobs > New from template.

# Kinds of refusals.
panel-trouble-login = Log in again
panel-trouble-password = Refused
panel-trouble-role = Your role does not allow it
panel-trouble-origin = The address of the page is not allowed
panel-trouble-token = The session is not valid: load the page again
panel-trouble-size = Too large
panel-trouble-input = Wrong input
panel-trouble-not-found = Not found
panel-trouble-busy = Not now
panel-trouble-other = Another text exists there
panel-trouble-exists = Already exists
panel-trouble-slow-down = Too many requests: wait a moment
panel-trouble-server = The server failed
panel-trouble-lost = No connection to the cell
panel-trouble-archive = Not a complete Seamwright backup
panel-trouble-archive-newer = The backup is from a later version of Seamwright
panel-trouble-archive-room = Not enough disk space for it

# Allowed values.
panel-allowed-not-negative = a number, 0 or greater
panel-allowed-positive = a number greater than 0
panel-allowed-up-to = more than 0, up to { $max }

# Actions that roles allow.
panel-action-take-control = take control
panel-action-watch = watch
panel-action-jobs-read = read jobs
panel-action-jobs-write = change jobs
panel-action-plan = plan
panel-action-edit = edit
panel-action-post = make part programs
panel-action-load = load
panel-action-records-read = read records
panel-action-tune = tune
panel-action-set-up = set up
panel-action-shelve = shelve alarms
panel-action-audit = audit log
panel-action-audit-read = read the audit log
panel-action-backup = download backups
panel-action-restore = restore
panel-action-users-read = read users
panel-action-users-write = change users
panel-action-diagnose = look at diagnostics
panel-action-jog = jog
panel-action-teach = teach

# Diagnostics.
panel-diag-state = State
panel-diag-ready = The cell is ready to be used.
panel-diag-version = Version
panel-diag-uptime = Running for (min:s)
panel-diag-latency = Lateness of cycles
panel-diag-latency-how = Cycles since the start of the server, by how late they began. Heights are logarithmic.
panel-diag-most = Maximum
panel-diag-gap = Longest gap
panel-diag-cycles = Cycles
panel-diag-rights = Real-time rights
panel-diag-granted = granted
panel-diag-missing = missing
panel-diag-right-priority = Real-time priority
panel-diag-right-memory = Locked memory
panel-diag-right-cpu = CPU of its own
panel-diag-grant-priority = Priority: set LimitRTPRIO=80 in the service, or rtprio to 80 in /etc/security/limits.conf, then start again.
panel-diag-grant-memory = Memory: set LimitMEMLOCK=infinity in the service, or memlock to unlimited in /etc/security/limits.conf, then start again.
panel-diag-grant-cpu = CPU: choose one that exists and is permitted, then start again.
panel-diag-devices = Age of the devices’ reports
panel-diag-devices-how = More about each device: Inputs and outputs.
panel-diag-device-latency = latency
panel-diag-disk = Disk and memory
panel-diag-free = Free / size
panel-diag-write = A small write
panel-diag-look = Looked at before
panel-diag-resident = Memory of the panel
panel-diag-cell-resident = Memory of the cell
panel-diag-locked = of it locked
panel-diag-queues = Queues
panel-diag-waiting = Waiting
panel-diag-room = Room
panel-diag-queue-cycles = Cycles
panel-diag-queue-notes = Events
panel-diag-queue-commands = Commands
panel-diag-queue-audit = Audit log
panel-diag-alarms = Alarms by priority
panel-diag-priority = Priority
panel-diag-active = Active
panel-diag-unacknowledged = Not acknowledged
panel-priority-critical = critical
panel-priority-high = high
panel-priority-medium = medium
panel-priority-low = low
panel-diag-workers = Planner processes
panel-diag-runs = running for
panel-question-draft = Draft
panel-question-plan = Plan
panel-question-recorded = Plan of a record
panel-question-report = Report
panel-question-post = Part program
panel-question-load = Load
panel-question-place = Work offset
panel-question-reach = Search of the best place
panel-question-schedule = Schedule
panel-worker-answered = Answered
panel-worker-refused = Job has errors
panel-worker-superseded = Ended for a newer request
panel-worker-late = Killed: too long
panel-worker-memory = Killed: too much memory
panel-worker-failed = Failed
panel-diag-since = Since the start of the server
panel-diag-welds = Welds
panel-diag-clients = Connections / pages / sessions
panel-diag-logins = Logins / refused
panel-diag-answers = Answers by HTTP status
