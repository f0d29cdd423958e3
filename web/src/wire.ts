// Made from crates/server/src/wire by its test: do not change by hand.

/**
 * A message as data, and its English text.
 */
export type MessageView = { 
/**
 * Identifier of the words in the catalogues; `text` is text as it stands.
 */
code: string, 
/**
 * English text.
 */
text: string, 
/**
 * Arguments by name.
 */
arguments: Array<[string, ArgumentView]>, };

/**
 * An argument of a message.
 */
export type ArgumentView = { "type": "quantity", "value": QuantityView } | { "type": "range", "value": [QuantityView, QuantityView] } | { "type": "count", "value": number } | { "type": "axis", "value": string } | { "type": "key", "value": string } | { "type": "pass", "value": number } | { "type": "text", "value": string } | { "type": "message", "value": MessageView } | { "type": "list", "value": Array<ArgumentView> };

/**
 * A value with its unit.
 */
export type QuantityView = { 
/**
 * Value in `unit`.
 */
value: number, 
/**
 * Identifier of the unit in the catalogues, like `unit-mm-per-s`; empty for a number without a unit.
 */
unit: string, 
/**
 * Number of decimals to show.
 */
decimals: number, };

/**
 * `GET /api/machine`.
 */
export type MachineView = { 
/**
 * Short name.
 */
name: string, 
/**
 * Title.
 */
title: string, 
/**
 * True: the devices are simulated.
 */
simulated: boolean, 
/**
 * Period of the cycle, s.
 */
period_s: number, 
/**
 * Axes in their order.
 */
axes: Array<AxisView>, 
/**
 * Conditions in their order.
 */
conditions: Array<ConditionView>, 
/**
 * Solids of the links.
 */
solids: Array<SolidView>, 
/**
 * Zones.
 */
zones: Array<ZoneView>, 
/**
 * Named frames: axes, `base`, `work`, torches.
 */
frames: Array<FrameView>, 
/**
 * Index of the base among the links, and of the first torch.
 */
base: number, 
/**
 * See `base`.
 */
torch: number, 
/**
 * Unit vector up in the base frame.
 */
up: [number, number, number], 
/**
 * Highest speed of the tip by hand, mm/s.
 */
jog_mm_s: number, 
/**
 * Joint of each link, in the order of [`super::Status::links`].
 */
joints: Array<JointView | null>, 
/**
 * Its sensors.
 */
sensors: Array<SensorView>, 
/**
 * The process is a beam (else an arc).
 */
beam: boolean, 
/**
 * Distance from the work to the source of a beam, mm; none for an arc.
 */
beam_mm: number | null, };

/**
 * An axis, in mm or degrees.
 */
export type AxisView = { 
/**
 * Name.
 */
name: string, 
/**
 * `mm` or `deg`.
 */
unit: string, 
/**
 * Lowest and highest position; none: it turns without end.
 */
range: [number, number] | null, 
/**
 * Home.
 */
home: number, 
/**
 * Highest speed.
 */
max_speed: number, };

/**
 * A row of `GET /api/alarms/catalogue`, in English.
 */
export type AlarmEntry = { 
/**
 * Number.
 */
number: number, 
/**
 * Stable name.
 */
name: string, 
/**
 * Cause.
 */
cause: string, 
/**
 * Consequence.
 */
consequence: string, 
/**
 * Operator action.
 */
action: string, 
/**
 * Reaction of the cell.
 */
reaction: string, };

/**
 * A condition of the machine file.
 */
export type ConditionView = { 
/**
 * Name.
 */
name: string, 
/**
 * `power`, `motion`, `process`.
 */
level: string, };

/**
 * A zone.
 */
export type ZoneView = { 
/**
 * Name.
 */
name: string, 
/**
 * Stay in (else keep out).
 */
permitted: boolean, 
/**
 * Its volume.
 */
solids: Array<SolidView>, };

/**
 * A named frame on a link.
 */
export type FrameView = { 
/**
 * Name.
 */
name: string, 
/**
 * The link.
 */
link: number, 
/**
 * In the work frame with all axes at zero, row by row (3 x 4), mm.
 */
frame: [number, number, number, number, number, number, number, number, number, number, number, number], };

/**
 * Joint by which a link moves on the next one towards the work.
 */
export type JointView = { 
/**
 * Index of the next link: less than that of this link.
 */
on: number, 
/**
 * The axis that moves it.
 */
axis: number, 
/**
 * Unit vector in the work frame with all axes at zero: direction of motion of an axis in mm, axis of rotation of
 * one in degrees.
 */
direction: [number, number, number], 
/**
 * A point on the axis there, mm.
 */
at: [number, number, number], };

/**
 * A sensor for the joint.
 */
export type SensorView = { 
/**
 * Name.
 */
name: string, 
/**
 * `stripe`, `camera`.
 */
kind: string, 
/**
 * The link that carries it.
 */
link: number, 
/**
 * Corners of the field of view in the work frame with all axes at zero, mm: of a camera in its nominal plane, of a
 * stripe sensor in the plane of its laser. Empty if a corner of the picture does not meet that plane.
 */
field: Array<[number, number, number]>, 
/**
 * Its frames come from the machine's own camera.
 */
frames: boolean, };

/**
 * `GET /api/devices`: a device of the cell with its present values.
 */
export type DeviceView = { 
/**
 * Its name in the machine file; empty: simulated.
 */
name: string, 
/**
 * Host and port; empty: simulated.
 */
address: string, 
/**
 * Unit address.
 */
unit: number, 
/**
 * Time from poll to poll, s.
 */
poll_s: number, 
/**
 * Time without a cycle after which outputs go to their safe states, s.
 */
watchdog_s: number, 
/**
 * Its named signals.
 */
signals: Array<SignalView>, 
/**
 * Traffic on the line; none without a line.
 */
traffic: TrafficView | null, };

/**
 * An input, an output or a number of a device.
 */
export type SignalView = { 
/**
 * Its name, like `inputs.door_closed`, `outputs.gas`, `set.current_a`.
 */
name: string, 
/**
 * `input`, `output`, `set`, `report`, `actual`.
 */
kind: string, 
/**
 * Address, like `holding 12 bit 3`; empty: simulated.
 */
place: string, 
/**
 * It is on or off, not a number.
 */
bit: boolean, 
/**
 * Unit of a number.
 */
unit: string, 
/**
 * Present value: of a bit 0 or 1; null if unknown.
 */
value: number | null, 
/**
 * Of an output, its safe value.
 */
safe: number | null, 
/**
 * Of an input, the value that its condition needs.
 */
wanted: boolean | null, 
/**
 * Condition of an input.
 */
condition: string | null, };

/**
 * Traffic with a device since it was connected.
 */
export type TrafficView = { 
/**
 * Polls that were answered.
 */
polls: number, 
/**
 * Polls left out, because the one before took too long.
 */
missed: number, 
/**
 * Polls that were refused or not answered.
 */
failed: number, 
/**
 * Connections made.
 */
connections: number, 
/**
 * Time without a connection, s.
 */
away_s: number, 
/**
 * Duration of a poll: median, 99.9 % quantile and maximum, microseconds.
 */
round_us: [number, number, number], 
/**
 * Last error.
 */
trouble: string | null, };

/**
 * `GET /api/tuning?axis=NAME`: the position loop of an axis, tuned and measured on its drive in simulation.
 */
export type TuningView = { 
/**
 * Its name.
 */
axis: string, 
/**
 * `mm` or `deg`.
 */
unit: string, 
/**
 * The machine file describes no drive: an assumed one was tuned.
 */
assumed_drive: boolean, 
/**
 * Reason why it cannot be tuned.
 */
refused: MessageView | null, 
/**
 * Open loop: frequency, Hz, gain, dB, phase, degrees.
 */
response: Array<[number, number, number]>, 
/**
 * Gain margin, dB, and its frequency, Hz; none: the phase does not reach -180 degrees.
 */
gain_margin: [number, number] | null, 
/**
 * Phase margin, degrees, and its frequency, Hz.
 */
phase_margin: [number, number] | null, 
/**
 * Settings and measured values, with the keys of machine files.
 */
values: Array<[string, number]>, 
/**
 * The settings, as [`super::ParameterChange::values`] takes them over.
 */
settings: Array<[string, number]>, 
/**
 * See [`super::ParameterChange::notches`].
 */
notches: Array<[number, number, number]>, };

/**
 * `GET /api/parameters`: axes, drives and tools in the machine file of the cell's job.
 */
export type ParametersView = { 
/**
 * Title of the machine.
 */
machine: string, 
/**
 * The file, among the jobs, in which changes are kept.
 */
file: string, 
/**
 * A change is not in force yet: it takes effect when the job is loaded again with the drives off.
 */
pending: boolean, 
/**
 * In the order of the machine's axes.
 */
axes: Array<AxisParameters>, 
/**
 * Torches, beams or lasers.
 */
heads: Array<HeadView>, };

/**
 * An axis with its drive.
 */
export type AxisParameters = { 
/**
 * Its name.
 */
name: string, 
/**
 * `mm` or `deg`.
 */
unit: string, 
/**
 * The machine file describes its drive.
 */
has_drive: boolean, 
/**
 * All possible values, with the keys of machine files.
 */
values: Array<ParameterView>, 
/**
 * Notch filters of the speed command: frequency, Hz, depth (gain at the centre), width, Hz.
 */
notches: Array<[number, number, number]>, };

/**
 * A number of the machine file.
 */
export type ParameterView = { 
/**
 * Its key.
 */
key: string, 
/**
 * `axis`, `loop`, `feedforward`, `mechanics`.
 */
group: string, 
/**
 * Its value; none: the key is missing.
 */
value: number | null, 
/**
 * Value in force without the key. None: the key is required, or the thing it belongs to is missing (a drive, a
 * second mass, a compensation, gains of the machine's own).
 */
without: number | null, };

/**
 * A torch, beam or laser.
 */
export type HeadView = { 
/**
 * Its name.
 */
name: string, 
/**
 * Its tip in the last frame of its steps, mm.
 */
tip_mm: [number, number, number], };

/**
 * `PUT /api/parameters`: numbers of an axis and its drive, all checked as the loader checks them.
 */
export type ParameterChange = { 
/**
 * Name of the axis.
 */
axis: string, 
/**
 * Keys with their new values; null takes the key away.
 */
values: Array<[string, number | null]>, 
/**
 * Notch filters that replace the present ones, if they change.
 */
notches: Array<[number, number, number]> | null, };

/**
 * `POST /api/tool`: one fixed point was touched with the tip of a head from several attitudes.
 */
export type ToolTouches = { 
/**
 * The head, from 0.
 */
head: number, 
/**
 * Positions of all axes at each touch, mm or degrees.
 */
touches: Array<Array<number>>, };

/**
 * Its answer; nothing is saved.
 */
export type ToolAnswer = { 
/**
 * The tip in the last frame of the head's steps, mm: before and as found.
 */
was_mm: [number, number, number], 
/**
 * See `was_mm`.
 */
tip_mm: [number, number, number], 
/**
 * The point that was touched, in the work frame, mm.
 */
point_mm: [number, number, number], 
/**
 * Distance of the tip from that point at each touch, mm.
 */
residuals_mm: Array<number>, 
/**
 * Touches that are far off the others.
 */
outliers: Array<boolean>, 
/**
 * Root of the mean square of the residuals, mm.
 */
rms_mm: number, 
/**
 * Standard deviation of the tip, estimated from the residuals, mm.
 */
deviation_mm: [number, number, number], 
/**
 * Largest angle between two attitudes, degrees.
 */
apart_deg: number, 
/**
 * Directions in the head's frame that the poses leave undetermined: there the tip stays as it was.
 */
unseen: Array<[number, number, number]>, 
/**
 * `good`; `unseen`: good, but undetermined in some directions; `far`: the tip moved by more than a tool bends;
 * `poor`: the touches do not agree.
 */
verdict: string, };

/**
 * `PUT /api/tool`: new position of a tip.
 */
export type ToolTip = { 
/**
 * The head, from 0.
 */
head: number, 
/**
 * In the last frame of its steps, mm.
 */
tip_mm: [number, number, number], };

/**
 * `GET /api/sensors`: sensors in the machine file of the cell's job.
 */
export type SensorsView = { 
/**
 * The file, among the jobs, in which changes are kept.
 */
file: string, 
/**
 * See [`ParametersView::pending`].
 */
pending: boolean, 
/**
 * Its devices are simulated: so is the picture of a grid.
 */
simulated: boolean, 
/**
 * All of them.
 */
sensors: Array<SensorSetUp>, };

/**
 * A sensor as the machine file has it.
 */
export type SensorSetUp = { 
/**
 * Its name.
 */
name: string, 
/**
 * `stripe`, `camera`.
 */
kind: string, 
/**
 * Columns and rows of its images.
 */
size_px: [number, number], 
/**
 * All possible values, with the keys of machine files.
 */
values: Array<SensorValue>, 
/**
 * Of a camera: its maps of planes square to its axis.
 */
heights: Array<HeightView>, };

/**
 * Numbers of a sensor.
 */
export type SensorValue = { 
/**
 * Keys from the sensor's table on, with dots between.
 */
key: string, 
/**
 * `pose`, `map`, `timing`.
 */
group: string, 
/**
 * Number of values of the key.
 */
count: number, 
/**
 * Its values; empty if the key is missing.
 */
numbers: Array<number>, };

/**
 * View of a camera on one plane square to its axis.
 */
export type HeightView = { 
/**
 * The plane's z in the sensor's frame, mm: towards the camera.
 */
z_mm: number, 
/**
 * mm a column, and mm a row.
 */
mm_per_px: [number, number], 
/**
 * Column and row of the optical axis; none: the middle.
 */
centre_px: [number, number] | null, 
/**
 * Turn of the picture's x from the sensor's x towards its rows, degrees.
 */
rotation_deg: number, 
/**
 * Shift along the picture's x per mm down the picture, mm.
 */
shear: number, 
/**
 * Relative radial displacement of pixels half a width from the centre by distortion.
 */
barrel: number, };

/**
 * `PUT /api/sensor`: new values of a sensor, all checked as the loader checks them.
 */
export type SensorChange = { 
/**
 * Name of the sensor.
 */
name: string, 
/**
 * Keys with their new numbers; none takes the key away.
 */
values: Array<[string, Array<number>]>, 
/**
 * Planes of a camera that replace the present ones, if they change.
 */
heights: Array<HeightView> | null, };

/**
 * `POST /api/sensor`, a picture of a grid of dots: the camera's map from it; nothing is saved.
 */
export type SensorAnswer = { 
/**
 * `good`; `far`: the scale differs by more than a lens is moved; else the reason for no map: `picture`, `size`,
 * `plain`, `few`, `tangled`, `corner`, `residual`, `map`.
 */
verdict: string, 
/**
 * Details of the verdict.
 */
of: Array<string>, 
/**
 * The plane at that height as in the machine file, and as found; none if not found.
 */
was: HeightView | null, 
/**
 * See `was`.
 */
found: HeightView | null, 
/**
 * Each dot: measured column and row, and its residual in the map from there, pixels.
 */
dots: Array<[number, number, number, number]>, 
/**
 * Root mean square of the residuals, and their maximum, pixels.
 */
rms_px: number, 
/**
 * See `rms_px`.
 */
max_px: number, 
/**
 * Identifier of the words in the catalogues; `text` is text as it stands.
 */
code: string, 
/**
 * English text.
 */
text: string, 
/**
 * Arguments by name.
 */
arguments: Array<[string, ArgumentView]>, };

/**
 * `GET /api/session`, and the answer of `POST /api/login`.
 */
export type SessionView = { 
/**
 * Name of the user.
 */
user: string, 
/**
 * Role.
 */
role: Role, 
/**
 * Everything that the role may do: names of commands and of routes' permissions.
 */
may: Array<string>, 
/**
 * Value of the header `x-seamwright` that every request with an effect must carry.
 */
token: string, 
/**
 * No password is set yet: the printed address gives the rights of the owner.
 */
first_run: boolean, };

/**
 * Answer to `POST /api/stop`: the server has passed the stop on. If the mode is current, it shows whether the cell has
 * stopped.
 */
export type Stopped = { 
/**
 * Mode of the cell at that time: [`super::Status::mode`]; empty if it is not known yet.
 */
mode: string, 
/**
 * Age of the last status of the cycle, s; none before the first one. It grows if the cycle hangs or has ended.
 */
cycle_age_s: number | null, };

/**
 * Role of a user. Each role includes the rights of those before.
 */
export type Role = "viewer" | "operator" | "programmer" | "service" | "admin";

/**
 * `POST /api/login`.
 */
export type Login = { 
/**
 * Name; empty with a key.
 */
user: string, 
/**
 * Password, or the key of the printed address.
 */
password: string, };

/**
 * A row of `GET /api/users`.
 */
export type UserRow = { 
/**
 * Name.
 */
name: string, 
/**
 * Role.
 */
role: Role, 
/**
 * It can log in.
 */
enabled: boolean, };

/**
 * `PUT /api/users/NAME`: makes or changes a user.
 */
export type UserChange = { 
/**
 * Role.
 */
role: Role, 
/**
 * A new password, if it is to change; at least ten characters.
 */
password: string | null, 
/**
 * It can log in.
 */
enabled: boolean, 
/**
 * Password of the user who sends the request.
 */
own_password: string | null, 
/**
 * Refuse an existing name as `exists` instead of changing its user.
 */
only_new: boolean | null, };

/**
 * `DELETE /api/users/NAME`, `POST /api/restore`.
 */
export type OwnPassword = { 
/**
 * Password of the user who sends the request.
 */
own_password: string | null, };

/**
 * `PUT /api/restore`: contents of a checked archive.
 */
export type ArchiveView = { 
/**
 * Welds.
 */
welds: number, 
/**
 * Start of the newest of them; RFC 3339, UTC.
 */
newest: string | null, 
/**
 * Jobs.
 */
jobs: number, 
/**
 * Users.
 */
users: number, 
/**
 * Entries of the audit log, whose chain is whole.
 */
audit: number, };

/**
 * Answer to every failed request.
 */
export type Trouble = { 
/**
 * Stable key: `login`, `password`, `role`, `origin`, `token`, `size`, `input`, `not_found`, `busy`, `slow_down`,
 * `server`.
 */
key: string, 
/**
 * Identifier of the words in the catalogues; `text` is text as it stands.
 */
code: string, 
/**
 * English text.
 */
text: string, 
/**
 * Arguments by name.
 */
arguments: Array<[string, ArgumentView]>, };

/**
 * State of the cell.
 */
export type Status = { 
/**
 * Time since the start of the executive, s.
 */
t: number, 
/**
 * `off`, `idle`, `homing`, `ready`, `jog`, `teach`, `dry_run`, `weld`, `hold`, `fault`.
 */
mode: string, 
/**
 * The pass, from 1; 0 beside all passes.
 */
pass: number, 
/**
 * Path length in the pass, mm.
 */
s_mm: number, 
/**
 * Path length up to which the pass is welded, mm.
 */
welded_mm: number, 
/**
 * Commanded speed along the path, with the feed override, mm/s.
 */
speed_mm_s: number, 
/**
 * The override: part of the planned speed.
 */
override_part: number, 
/**
 * The next start of the process is allowed.
 */
armed: boolean, 
/**
 * Drives have power.
 */
powered: boolean, 
/**
 * Arc or beam.
 */
process: ProcessStatus, 
/**
 * The axes are at rest: neither commanded to move nor moved recently.
 */
stands: boolean, 
/**
 * In the order of the machine's axes.
 */
axes: Array<AxisStatus>, 
/**
 * Measured torch tip in the work frame: x, y, z (mm) and the unit vector out of the work along the torch.
 */
tip: [number, number, number, number, number, number], 
/**
 * Displacement of each link from its pose with all axes at zero: a frame, row by row (3 x 4), mm.
 */
links: Array<[number, number, number, number, number, number, number, number, number, number, number, number]>, 
/**
 * In the order of the machine's conditions: met or not.
 */
conditions: Array<boolean>, 
/**
 * Inputs as they are, in the order of the machine's conditions.
 */
inputs: Array<boolean>, 
/**
 * State of tracking of each head that is tracked in this pass.
 */
tracking: Array<TrackingStatus>, 
/**
 * The pair nearest to its minimum clearance; none if no pair is watched or near.
 */
near: NearView | null, 
/**
 * Ages of the devices' reports, s.
 */
ages: Ages, 
/**
 * Real-time rights of the cycle.
 */
realtime: RealtimeView, 
/**
 * Longest time without a cycle since the start, ms.
 */
longest_gap_ms: number, 
/**
 * Total numbers of missed cycles and of unrecorded cycles.
 */
missed: number, 
/**
 * See `missed`.
 */
lost: number, 
/**
 * The weld that a stop, a fault or a power failure interrupted and that can be resumed.
 */
left: LeftView | null, 
/**
 * Start of the weld of the program in the cell: pass from 1, and path length, mm; none without a program.
 */
start: [number, number] | null, 
/**
 * Number of the part for the record of the next weld; empty if it has none. A finished part clears it.
 */
part: string, 
/**
 * Number of the weld in the library while one is recorded.
 */
recording: number | null, };

/**
 * `GET /api/position`: positions of the axes and the tip; refused while an axis moves.
 */
export type StandingView = { 
/**
 * Measured, in the order of the machine's axes, mm or degrees.
 */
axes: Array<number>, 
/**
 * See [`Status::tip`].
 */
tip: [number, number, number, number, number, number], };

/**
 * An interrupted weld.
 */
export type LeftView = { 
/**
 * The pass, from 1.
 */
pass: number, 
/**
 * Path length up to which the pass is welded, mm.
 */
s_mm: number, 
/**
 * Number of finished passes, from the first.
 */
finished: number, 
/**
 * Number of its record in the library, if it was recorded.
 */
record: number | null, 
/**
 * Title of the job.
 */
title: string, 
/**
 * Number of the part; empty if it has none.
 */
part: string, 
/**
 * The cell holds the same program, for this part or for one without a number: the weld can be resumed.
 */
here: boolean, };

/**
 * Real-time rights of the cycle.
 */
export type RealtimeView = { 
/**
 * Missing rights: `priority` (real-time scheduling), `memory` (locked), `cpu` (of its own, if requested); empty if
 * complete.
 */
missing: Array<string>, 
/**
 * The same in English, with the system's reasons and the remedy.
 */
text: string, };

/**
 * Arc or beam.
 */
export type ProcessStatus = { 
/**
 * `off`, `strikes`, `pauses`, `burns`, `failed`.
 */
state: string, 
/**
 * It is switched on by command.
 */
on: boolean, 
/**
 * The source reports that it burns.
 */
burning: boolean, 
/**
 * The gas valve is open.
 */
gas: boolean, 
/**
 * The source could be switched on.
 */
ready: boolean, 
/**
 * The wire sticks.
 */
stuck: boolean, 
/**
 * Fault code of the source; 0 means no fault.
 */
fault: number, 
/**
 * Phase of the pass: `held`, `preflow`, `travel_delay`, `travel`, `run_out`, `crater`, `postflow`, `move`,
 * `ended`; none between passes.
 */
phase: string | null, 
/**
 * Set and measured values in the order of [`super::WorkView::values`]; null if missing.
 */
set: Array<number | null>, 
/**
 * See `set`.
 */
measured: Array<number | null>, };

/**
 * An axis, in mm or degrees.
 */
export type AxisStatus = { 
/**
 * Measured position.
 */
position: number, 
/**
 * Set position.
 */
set: number, 
/**
 * Following error.
 */
error: number, 
/**
 * Current as a part of the peak.
 */
current: number, 
/**
 * Its reference is known.
 */
referenced: boolean, 
/**
 * The drive has a fault.
 */
fault: boolean, 
/**
 * It is on a limit switch.
 */
limit_switch: boolean, };

/**
 * Results of tracking.
 */
export type TrackingStatus = { 
/**
 * The head, from 1.
 */
head: number, 
/**
 * Lateral and height deviation of the joint from the program at the torch, mm.
 */
deviation_mm: [number, number], 
/**
 * Lateral and height correction carried out, mm.
 */
correction_mm: [number, number], 
/**
 * 0 to 1.
 */
confidence: number, 
/**
 * Standard deviation of the deviation, mm; null if unknown.
 */
sigma_mm: number | null, 
/**
 * Quality: `seen`, `bridged`, `coasted`, `fading`, `unseen`, `lost`.
 */
state: string, };

/**
 * Ages, s; null: no data yet.
 */
export type Ages = { 
/**
 * Drives.
 */
drives: number | null, 
/**
 * Process source.
 */
source: number | null, 
/**
 * Inputs.
 */
inputs: number | null, };

/**
 * An alarm on the list. Texts are English; panels translate by `name`.
 */
export type AlarmView = { 
/**
 * Number in the catalogue.
 */
number: number, 
/**
 * Stable name.
 */
name: string, 
/**
 * Axis or condition of the alarm, if any.
 */
of: MessageView | null, 
/**
 * Cause, consequence and operator action.
 */
cause: string, 
/**
 * See `cause`.
 */
consequence: string, 
/**
 * See `cause`.
 */
action: string, 
/**
 * Reaction of the cell.
 */
reaction: string, 
/**
 * Index of the axis, condition or process value; with `number` it identifies the alarm.
 */
detail: number, 
/**
 * `unacknowledged`, `acknowledged`, `returned`; `gone`: not on the list but still shelved.
 */
state: string, 
/**
 * It came first.
 */
first_out: boolean, 
/**
 * Time of the executive, s.
 */
t: number, 
/**
 * Time; RFC 3339, UTC.
 */
at: string, 
/**
 * User and time of the acknowledgement.
 */
acknowledged: WhoWhen | null, 
/**
 * User and end of the shelving.
 */
shelved: WhoWhen | null, 
/**
 * It only informs, and may be shelved.
 */
tells: boolean, 
/**
 * Position: pass from 1 (0: outside of passes) and path length.
 */
pass: number, 
/**
 * See `pass`.
 */
s_mm: number, };

/**
 * A user and a time.
 */
export type WhoWhen = { 
/**
 * Name of the user.
 */
by: string, 
/**
 * RFC 3339, UTC.
 */
at: string, };

/**
 * `POST /api/alarms/shelve`: shelves a message-only alarm for a while, or ends the shelving.
 */
export type Shelving = { 
/**
 * See [`AlarmView::number`].
 */
number: number, 
/**
 * See [`AlarmView::detail`].
 */
detail: number, 
/**
 * Duration, up to 480; 0 ends the shelving.
 */
minutes: number, };

/**
 * An event.
 */
export type EventView = { 
/**
 * Counts up, without gaps.
 */
number: number, 
/**
 * Time of the executive, s.
 */
t: number, 
/**
 * RFC 3339, UTC.
 */
at: string, 
/**
 * `mode`, `order`, `refused`, `alarm`, `cleared`, `pass`, `left`, `record`, `control`, `work`, `teach`.
 */
what: string, 
/**
 * Stable key: the code of the message without `server-event-`, with `_` for `-`.
 */
key: string, 
/**
 * User who gave the command, if any.
 */
user: string | null, 
/**
 * Identifier of the words in the catalogues; `text` is text as it stands.
 */
code: string, 
/**
 * English text.
 */
text: string, 
/**
 * Arguments by name.
 */
arguments: Array<[string, ArgumentView]>, };

/**
 * A missing condition of a command.
 */
export type LackView = { 
/**
 * Stable key.
 */
key: string, 
/**
 * Identifier of the words in the catalogues; `text` is text as it stands.
 */
code: string, 
/**
 * English text.
 */
text: string, 
/**
 * Arguments by name.
 */
arguments: Array<[string, ArgumentView]>, };

/**
 * A planned program.
 */
export type WorkView = { 
/**
 * Number of this plan; each plan has its own.
 */
id: number, 
/**
 * Name of the job in the folder of jobs.
 */
job: string, 
/**
 * Its title.
 */
title: string, 
/**
 * Name of the job's machine; the cell's may be another.
 */
machine: string, 
/**
 * Axes of that machine, in the order of [`PathPoint::axes`].
 */
axes: Array<AxisView>, 
/**
 * Names of process values, ending in their units.
 */
values: Array<string>, 
/**
 * Passes in order.
 */
passes: Array<PassView>, 
/**
 * Transfer moves, one more than passes: positions of the tip.
 */
air: Array<Array<[number, number, number]>>, 
/**
 * Times of the transfer moves, s.
 */
air_s: Array<number>, 
/**
 * The part and the fixtures.
 */
part: Array<SolidView>, 
/**
 * See `part`.
 */
fixtures: Array<SolidView>, 
/**
 * Cross-sections of the joint at stations along the seam.
 */
sections: Array<SectionView>, 
/**
 * Findings about it.
 */
findings: Array<FindingView>, 
/**
 * It can be welded: no finding prevents it.
 */
good: boolean, 
/**
 * Total time, s.
 */
time_s: number, 
/**
 * Start of a resumed weld: pass from 1, and path length.
 */
from: [number, number] | null, 
/**
 * Number of tracked heads.
 */
tracked: number, 
/**
 * Distortion of the simulated part against the planned one: TOML, as of `simulate --distortion`.
 */
distortion: string | null, };

/**
 * A pass.
 */
export type PassView = { 
/**
 * Its name in the program; empty if it has none.
 */
name: string, 
/**
 * Role: `root`, `fill`, `cap` ..; empty if the program does not say.
 */
role: string, 
/**
 * Path length, mm.
 */
length_mm: number, 
/**
 * Time from the gas preflow to the end of the postflow, s.
 */
time_s: number, 
/**
 * Overlap onto the finished weld after a stop, mm.
 */
overlap_mm: number, 
/**
 * Requested speed at its start, mm/s.
 */
speed_mm_s: number, 
/**
 * It is closed.
 */
closed: boolean, 
/**
 * Samples all along.
 */
path: Array<PathPoint>, 
/**
 * Start and end of each span, path lengths in mm: of a pass along the seam, or of runs of points.
 */
spans: Array<[number, number]>, 
/**
 * Path lengths at which its points are reached, mm, the start first; empty along a seam.
 */
points_mm: Array<number>, 
/**
 * Its certificate; none if it cannot be welded as requested.
 */
certificate: CertificateView | null, 
/**
 * Smallest clearance of the pass; none if nothing comes near.
 */
nearest: NearView | null, 
/**
 * Path length of the smallest clearance, mm.
 */
nearest_at_mm: number | null, };

/**
 * A sample of a pass.
 */
export type PathPoint = { 
/**
 * Path length, mm.
 */
s_mm: number, 
/**
 * Tip in the work frame, mm.
 */
tip: [number, number, number], 
/**
 * Unit vector out of the work along the torch.
 */
torch: [number, number, number], 
/**
 * Speed along the path, mm/s; the requested one if the pass cannot be welded.
 */
speed_mm_s: number, 
/**
 * Axes, mm or degrees; empty if it cannot be welded, as `used`.
 */
axes: Array<number>, 
/**
 * Speed, acceleration and jerk of each axis in per cent of its limits.
 */
used: Array<[number, number, number]>, 
/**
 * Process values; null if missing.
 */
values: Array<number | null>, 
/**
 * Minimum distance of the watched pairs, mm; null if none is near.
 */
clearance_mm: number | null, };

/**
 * Certificate of a pass: its speeds and their limits, as `tools motion --certificate` writes them.
 */
export type CertificateView = { 
/**
 * Part of the path's length at the requested speed, %.
 */
at_asked_percent: number, 
/**
 * A speed of the tip that every axis can hold everywhere, mm/s.
 */
everywhere_mm_s: number, 
/**
 * Stretches of the path in order, each with the bound on its speed.
 */
bounds: Array<BoundView>, 
/**
 * Maximum use of each axis' limits over the whole path; after the axes that of the torch tip, if it has limits.
 */
uses: Array<UseView>, };

/**
 * A stretch of a pass with one bound.
 */
export type BoundView = { 
/**
 * Path length at its start, mm.
 */
from_mm: number, 
/**
 * Path length at its end, mm.
 */
to_mm: number, 
/**
 * Minimum planned speed of the tip in it, mm/s.
 */
least_speed_mm_s: number, 
/**
 * False in the acceleration and deceleration phase.
 */
between: boolean, 
/**
 * `asked` (nothing else binds), `speed`, `acceleration` or `jerk`.
 */
what: string, 
/**
 * The axis whose limit binds; none: the torch tip's, or nothing.
 */
axis: string | null, 
/**
 * The limit that binds, in mm or degrees per s, s^2 or s^3.
 */
limit: number | null, 
/**
 * Its unit.
 */
unit: string | null, };

/**
 * Maximum use of the limits of an axis or of the torch tip: of speed, acceleration and jerk; none without a limit.
 */
export type UseView = { 
/**
 * The axis; none: the torch tip.
 */
axis: string | null, 
/**
 * `mm` or `deg`.
 */
unit: string, 
/**
 * Of each limit, %.
 */
percent: [number | null, number | null, number | null], 
/**
 * The limits, in mm or degrees per s, s^2 and s^3.
 */
limit: [number | null, number | null, number | null], };

/**
 * The nearest pair of bodies with a minimum clearance.
 */
export type NearView = { 
/**
 * Their distance, mm; less than 0 where a zone is left.
 */
distance_mm: number, 
/**
 * Minimum clearance, mm.
 */
least_mm: number, 
/**
 * Names of the two.
 */
between: [string, string], 
/**
 * Their nearest points in the work frame, mm.
 */
at: [[number, number, number], [number, number, number]], };

/**
 * A cross-section of the joint: mm, x to the first part's side, y up.
 */
export type SectionView = { 
/**
 * Path length along the seam, mm.
 */
s_mm: number, 
/**
 * Angle between the two faces, degrees.
 */
dihedral_deg: number, 
/**
 * Root gap and misalignment of the second part, mm.
 */
root_gap_mm: number, 
/**
 * See `root_gap_mm`.
 */
mismatch_mm: number, 
/**
 * Area of the groove, and of the cap over it, mm^2.
 */
area_mm2: number, 
/**
 * See `area_mm2`.
 */
cap_mm2: number, 
/**
 * Outlines of the two parts.
 */
parts: [Array<[number, number]>, Array<[number, number]>], 
/**
 * Fusion faces of the two parts, from the root to the toe.
 */
edges: [Array<[number, number]>, Array<[number, number]>], 
/**
 * Beads in the order of welding.
 */
beads: Array<BeadView>, };

/**
 * A bead in a cross-section.
 */
export type BeadView = { 
/**
 * First part of the names of its passes, such as `fill 2.1`.
 */
name: string, 
/**
 * `root`, `fill`, `cap` ..
 */
role: string, 
/**
 * Area, mm^2.
 */
area_mm2: number, 
/**
 * Outline, mm.
 */
outline: Array<[number, number]>, 
/**
 * Point on which the wire points, mm.
 */
tip: [number, number], 
/**
 * Unit vector from there to the torch.
 */
back: [number, number], };

/**
 * Drawing of a job's text before any motion is planned: see `POST /api/draft`.
 */
export type DraftAnswer = { "kind": "drawn", 
/**
 * The part and the fixtures.
 */
part: Array<SolidView>, 
/**
 * See `part`.
 */
fixtures: Array<SolidView>, 
/**
 * The joint.
 */
sections: Array<SectionView>, } | { "kind": "wrong", 
/**
 * Fault and position, with the allowed values.
 */
message: MessageView, };

/**
 * `POST /api/place`: position of the part from touched points.
 */
export type PlaceText = { 
/**
 * TOML of a job.
 */
text: string, 
/**
 * Method of placing.
 */
method: PlaceMethod, 
/**
 * Radius of the probe's ball, mm; 0: the tip itself was on the surface.
 */
probe_radius_mm: number, 
/**
 * Touched points.
 */
points: Array<TouchedPoint>, };

/**
 * Methods of placing a part by touched points.
 */
export type PlaceMethod = "best_fit" | "plane_line_point" | "three_points" | "chuck";

/**
 * A touched point.
 */
export type TouchedPoint = { 
/**
 * Touched feature.
 */
feature: string, 
/**
 * The tip in the work frame, mm.
 */
tip: [number, number, number], };

/**
 * Its answer; nothing is saved.
 */
export type PlaceAnswer = { 
/**
 * The job with the offset in force.
 */
text: string, 
/**
 * Translation of the part, mm.
 */
move_mm: [number, number, number], 
/**
 * Rotation of the part, degrees.
 */
angle_deg: number, 
/**
 * Distance of each point from its nominal surface with this offset, mm: positive outside.
 */
residuals_mm: Array<number>, 
/**
 * Points that are far off the others.
 */
outliers: Array<boolean>, 
/**
 * Root of their mean square, mm.
 */
rms_mm: number, 
/**
 * Directions that the points leave undetermined, and other remarks.
 */
notes: Array<MessageView>, };

/**
 * A finding.
 */
export type FindingView = { 
/**
 * Stable kind: `reach`, `range`, `speed`, ...
 */
kind: string, 
/**
 * Text with the value found and the value allowed.
 */
message: MessageView, 
/**
 * From 1.
 */
pass: number, 
/**
 * Path length, mm.
 */
from_mm: number, 
/**
 * See `from_mm`.
 */
to_mm: number, 
/**
 * Operator action, if one is needed.
 */
cure: MessageView | null, 
/**
 * The weld can be made in spite of it.
 */
allowed: boolean, 
/**
 * Positions of the axes there, in the order of [`WorkView::axes`]; empty if unknown.
 */
axes: Array<number>, 
/**
 * The pair nearest to its minimum clearance there.
 */
nearest: NearView | null, };

/**
 * A solid, in the work frame with all axes at zero.
 */
export type SolidView = { 
/**
 * Name.
 */
name: string, 
/**
 * Its shape.
 */
shape: ShapeView, 
/**
 * Its frame, row by row (3 x 4), mm.
 */
frame: [number, number, number, number, number, number, number, number, number, number, number, number], 
/**
 * The link that it moves with, as an index into [`super::Status::links`].
 */
link: number, };

/**
 * A shape in its own frame, mm.
 */
export type ShapeView = { "kind": "box", 
/**
 * Lengths of its sides.
 */
size: [number, number, number], } | { "kind": "sphere", 
/**
 * Radius.
 */
radius: number, } | { "kind": "cone", 
/**
 * At 0.
 */
radius: number, 
/**
 * At `length`.
 */
top_radius: number, 
/**
 * Along z.
 */
length: number, } | { "kind": "capsule", 
/**
 * Radius.
 */
radius: number, 
/**
 * Along z.
 */
length: number, } | { "kind": "ellipsoid", 
/**
 * Along x, y, z.
 */
semi_axes: [number, number, number], } | { "kind": "half_space", } | { "kind": "mesh", 
/**
 * Corners.
 */
triangles: Array<number>, };

/**
 * Plan of a job's text before it is saved: see `POST /api/plan`.
 */
export type PlanAnswer = { "kind": "planned", 
/**
 * The plan.
 */
work: WorkView, } | { "kind": "wrong", 
/**
 * Fault and position, with the allowed values.
 */
message: MessageView, 
/**
 * The same in parts, if the fault is in a file.
 */
at: WrongView | null, };

/**
 * Fault of a file, in parts.
 */
export type WrongView = { 
/**
 * Name of the file, if it is not the job's own text.
 */
file: string | null, 
/**
 * From 1, in the job's own text.
 */
line: number | null, 
/**
 * Path of the key, like `weld.speed_mm_s`; may be empty.
 */
key: string, 
/**
 * Value as written; may be empty.
 */
value: string, 
/**
 * Description of the fault.
 */
what: MessageView, 
/**
 * Allowed values.
 */
allowed: MessageView | null, 
/**
 * A suggestion.
 */
help: MessageView | null, };

/**
 * `POST /api/form`: a text, and changes of its entries that are made first; nothing is saved.
 */
export type FormText = { 
/**
 * TOML of a job, a program, a procedure or a machine.
 */
text: string, 
/**
 * Changes, one after the other.
 */
changes: Array<FormChange>, };

/**
 * A change of an entry; everything else of the text stays as it is. Paths are like `passes[0].points.start[2]`.
 */
export type FormChange = { "op": "set", 
/**
 * Path of the value.
 */
path: string, 
/**
 * Number, text, truth, list or table.
 */
value: unknown, } | { "op": "add", 
/**
 * Path of the key.
 */
path: string, } | { "op": "choose", 
/**
 * Path of the table, the kind is its last key.
 */
path: string, 
/**
 * The new kind.
 */
kind: string, } | { "op": "remove", 
/**
 * Its path.
 */
path: string, } | { "op": "insert", 
/**
 * Path of the new element.
 */
path: string, 
/**
 * A value; a table in a list of tables.
 */
value: unknown, } | { "op": "move", 
/**
 * Path of the element.
 */
path: string, 
/**
 * Its new index.
 */
to: number, };

/**
 * Its answer.
 */
export type FormAnswer = { 
/**
 * The text with the changes.
 */
text: string, 
/**
 * Its form; none if the text is not TOML.
 */
form: FormView | null, 
/**
 * First fault that reading finds.
 */
wrong: WrongView | null, };

/**
 * What a text contains, and what its format allows beside that.
 */
export type FormView = { 
/**
 * Tables in the order of the text.
 */
tables: Array<FormTable>, 
/**
 * Passes through points.
 */
passes: Array<PointsView>, };

/**
 * A table with the entries under its header, or the root.
 */
export type FormTable = { 
/**
 * Path of the table; empty for the root.
 */
path: string, 
/**
 * Its values.
 */
entries: Array<FormEntry>, 
/**
 * Keys that it can still be given.
 */
addable: Array<AddableView>, 
/**
 * The kinds that the table can be of, if its last key is one of several; empty otherwise.
 */
kinds: Array<string>, 
/**
 * Whether the format allows to remove it.
 */
removable: boolean, };

/**
 * A key with its value, and what the format says of it.
 */
export type FormEntry = { 
/**
 * The key.
 */
key: string, 
/**
 * Its path.
 */
path: string, 
/**
 * The value.
 */
value: FormValue, 
/**
 * Line, from 1.
 */
line: number, 
/**
 * Comment behind the value.
 */
comment: string, 
/**
 * Description in the format.
 */
help: string, 
/**
 * Allowed texts; empty if any text is allowed.
 */
choices: Array<string>, 
/**
 * Allowed numbers.
 */
range: RangeView | null, };

/**
 * Allowed numbers.
 */
export type RangeView = { 
/**
 * Smallest number.
 */
min: number | null, 
/**
 * Whether the smallest number itself is excluded.
 */
open: boolean, 
/**
 * Largest number.
 */
max: number | null, };

/**
 * A value.
 */
export type FormValue = { "kind": "number", 
/**
 * The number.
 */
number: number, } | { "kind": "text", 
/**
 * The text.
 */
text: string, } | { "kind": "truth", 
/**
 * The value.
 */
truth: boolean, } | { "kind": "list", 
/**
 * Its elements.
 */
items: Array<FormValue>, } | { "kind": "long", 
/**
 * Number of its elements.
 */
count: number, } | { "kind": "table", 
/**
 * Its entries.
 */
entries: Array<FormEntry>, 
/**
 * Keys that it can still be given.
 */
addable: Array<AddableView>, };

/**
 * A key that a table can be given.
 */
export type AddableView = { 
/**
 * The key.
 */
key: string, 
/**
 * Its path.
 */
path: string, 
/**
 * Description in the format.
 */
help: string, 
/**
 * Whether its value is a table.
 */
is_table: boolean, };

/**
 * The points of a pass as they are written.
 */
export type PointsView = { 
/**
 * From 1.
 */
pass: number, 
/**
 * Names of the columns.
 */
columns: Array<string>, 
/**
 * Whether arc or beam is on.
 */
arc: boolean, 
/**
 * Columns that cubics have speeds of; empty without cubics.
 */
moving: Array<string>, 
/**
 * The start and the points.
 */
rows: Array<PointRow>, };

/**
 * A point.
 */
export type PointRow = { 
/**
 * The way to it; empty for the start.
 */
along: string, 
/**
 * Its span, from 1; 0 for the start.
 */
span: number, 
/**
 * A number for each column; null for an expression.
 */
numbers: Array<number | null>, 
/**
 * Speeds of `moving` where a cubic ends or begins; null for an expression.
 */
speeds: Array<number | null>, };

/**
 * `POST /api/plan`, `POST /api/draft`, `GET /api/jobs/NAME`.
 */
export type JobText = { 
/**
 * TOML of a job or program.
 */
text: string, };

/**
 * A running plan of a page: see `GET /api/planning`.
 */
export type PlanningView = { 
/**
 * `draft`, `plan`, `recorded`, `report`, `post`, `load` or `place`.
 */
kind: string, 
/**
 * Time since the request, s.
 */
elapsed_s: number, };

/**
 * `PUT /api/jobs/NAME`.
 */
export type JobKept = { 
/**
 * TOML of a job or program.
 */
text: string, 
/**
 * Text that the page expects to replace; empty for a new job. If the stored text differs, the request is refused
 * (`other`), so that no changes of other users are lost. If missing, any stored text is replaced.
 */
over: string | null, };

/**
 * A row of `GET /api/jobs`.
 */
export type JobRow = { 
/**
 * Name, ends in `.toml`.
 */
name: string, 
/**
 * Title, or its fault.
 */
title: string, 
/**
 * A supplied example: it can be copied, not changed.
 */
example: boolean, };

/**
 * `GET /api/choices`: machines and procedures for jobs, the supplied ones first.
 */
export type ChoicesView = { 
/**
 * Values of `machine`.
 */
machines: Array<Choice>, 
/**
 * Values of `procedure`.
 */
procedures: Array<Choice>, };

/**
 * One of them.
 */
export type Choice = { 
/**
 * Name in jobs; that of a file among the jobs ends in `.toml`.
 */
name: string, 
/**
 * Its title.
 */
title: string, 
/**
 * It is a file among the jobs, which can be changed.
 */
own: boolean, 
/**
 * Its text, of a procedure.
 */
text: string | null, };

/**
 * `GET /api/distortions`: a distortion of the simulated part.
 */
export type DistortionRow = { 
/**
 * Its name.
 */
name: string, 
/**
 * TOML, as of `simulate --distortion`.
 */
text: string, };

/**
 * `POST /api/load`.
 */
export type Load = { 
/**
 * Name of a job.
 */
job: string, 
/**
 * Start of a resumed weld: pass from 1, and the path length up to which it is welded.
 */
from: [number, number] | null, 
/**
 * Overlap onto the finished weld before `from`, mm: the start needs no confirmation for it.
 */
overlap_mm?: number | null, 
/**
 * Name of the part that is welded, for the record.
 */
part: string | null, 
/**
 * Distortion of the simulated part against the planned one: TOML, as of `simulate --distortion`. It is tracked
 * then.
 */
distortion?: string | null, };

/**
 * `POST /api/post`: a part program for a control.
 */
export type PostText = { 
/**
 * TOML of a job or program.
 */
text: string, 
/**
 * `sinumerik`, `linuxcnc`, `grblhal`, `pmac`.
 */
dialect: string, };

/**
 * Its answer.
 */
export type PostAnswer = { 
/**
 * The part program.
 */
text: string, 
/**
 * Proof, a message for each check.
 */
proof: Array<MessageView>, };

/**
 * The answer of `POST /api/edit`, which takes `{ text, operations }` as `seamwright edit --script` does.
 */
export type EditAnswer = { 
/**
 * The text as it is now.
 */
text: string, 
/**
 * Description of the edits.
 */
words: Array<MessageView>, };

/**
 * A row of `GET /api/audit?most=200&before=1234&after=1000&text=load`, the newest first: optionally only entries
 * before or after a number, or with a text in them.
 */
export type AuditRow = { 
/**
 * Its number: entries are numbered from 1, without gaps.
 */
id: number, 
/**
 * Time: RFC 3339, UTC.
 */
at: string, 
/**
 * User.
 */
user: string, 
/**
 * Origin.
 */
station: MessageView, 
/**
 * The command.
 */
command: MessageView, 
/**
 * The value before, and after.
 */
old: string, 
/**
 * See `old`.
 */
new: string, 
/**
 * Result.
 */
result: MessageView, };

/**
 * A row of `GET /api/records`, and the head of `GET /api/records/ID`.
 */
export type RecordRow = { 
/**
 * Its number.
 */
id: number, 
/**
 * Name of the part.
 */
part: string, 
/**
 * The job's title.
 */
title: string, 
/**
 * The weld was simulated.
 */
simulated: boolean, 
/**
 * RFC 3339, UTC.
 */
begun: string, 
/**
 * See `begun`; none: not yet.
 */
ended: string | null, 
/**
 * `running`, `good`, `deviating`, `stopped`, ...
 */
result: string, 
/**
 * Remark.
 */
note: MessageView, 
/**
 * Name of the machine.
 */
machine: string, 
/**
 * Number of the procedure.
 */
procedure: string | null, 
/**
 * User who started the weld.
 */
welder: string | null, 
/**
 * Minimum, mean and maximum heat input, kJ/mm.
 */
heat_input_kj_mm: [number, number, number] | null, 
/**
 * Maximum distance of the torch tip from the seam, mm, and its path length, mm.
 */
worst_deviation_mm: [number, number] | null, };

/**
 * `GET /api/records/ID`.
 */
export type RecordView = { 
/**
 * The weld.
 */
weld: RecordRow, 
/**
 * Process values against their windows.
 */
values: Array<JudgedView>, 
/**
 * Its alarms in order.
 */
alarms: Array<RecordedAlarm>, 
/**
 * Its events in order: missed cycles, stops and their causes, missing rights.
 */
events: Array<RecordedEvent>, 
/**
 * Columns of its trace with their units.
 */
columns: Array<[string, string]>, 
/**
 * Rows of its trace.
 */
rows: number, };

/**
 * A process value while the arc was on.
 */
export type JudgedView = { 
/**
 * The pass, from 1.
 */
pass: number, 
/**
 * Its name, which ends in its unit.
 */
name: string, 
/**
 * Minimum, mean and maximum.
 */
least: number, 
/**
 * See `least`.
 */
mean: number, 
/**
 * See `least`.
 */
greatest: number, 
/**
 * Minimum and maximum value allowed.
 */
allowed: [number, number] | null, 
/**
 * Time outside, s.
 */
outside_s: number, 
/**
 * Length of travel outside, mm.
 */
outside_mm: number, };

/**
 * An alarm of a recorded weld.
 */
export type RecordedAlarm = { 
/**
 * Name.
 */
name: MessageView, 
/**
 * Cause.
 */
cause: MessageView, 
/**
 * The pass, from 1.
 */
pass: number | null, 
/**
 * Path length, mm.
 */
s_mm: number | null, 
/**
 * Time in the trace, s.
 */
t_s: number | null, 
/**
 * It came first.
 */
first_out: boolean, };

/**
 * An event of a recorded weld.
 */
export type RecordedEvent = { 
/**
 * The pass, from 1.
 */
pass: number | null, 
/**
 * Path length, mm.
 */
s_mm: number | null, 
/**
 * Time in the trace, s.
 */
t_s: number | null, 
/**
 * Identifier of the words in the catalogues; `text` is text as it stands.
 */
code: string, 
/**
 * English text.
 */
text: string, 
/**
 * Arguments by name.
 */
arguments: Array<[string, ArgumentView]>, };

/**
 * `GET /api/records/ID/trace?columns=a,b&most=2000`: evenly spaced rows with the first and the last, and of each
 * stretch the rows with the minimum and with the maximum of every column.
 */
export type TraceView = { 
/**
 * The columns asked for.
 */
columns: Array<string>, 
/**
 * Values of each column; null if missing.
 */
values: Array<Array<number | null>>, };

/**
 * Commands for teaching by camera, see [`super::ToCell::Teach`].
 */
export type TeachOrder = { "do": "open", 
/**
 * Maximum step from frame to frame, mm: 1 to 100.
 */
step_mm: number, 
/**
 * Maximum length of a tack that is bridged without a question, mm: above 0, up to 100.
 */
longest_tack_mm: number, 
/**
 * Simulation: seed of the actual position of the seam, and of the noise.
 */
seed: number, 
/**
 * Simulation: a tack hides the joint between these path lengths, mm.
 */
tack_mm: [number, number] | null, } | { "do": "here", 
/**
 * Pixel of the newest picture, right and down.
 */
px: [number, number] | null, 
/**
 * Position in the work frame, mm. If both are missing: the centre of the picture.
 */
at: [number, number, number] | null, } | { "do": "end", } | { "do": "pause", } | { "do": "resume", } | { "do": "stop", };

/**
 * Phase of teaching by camera.
 */
export type TeachPhase = "closed" | "plans" | "places" | "runs" | "paused" | "asks" | "ended";

/**
 * State of teaching by camera: to all connections, whenever it changes.
 */
export type TeachView = { 
/**
 * Phase.
 */
phase: TeachPhase, 
/**
 * Name of the job with the seam.
 */
job: string, 
/**
 * Reason of a pause: `operator`, `hand`, `control`, `mode`; result of the session: `closed`, `joint-end`,
 * `operator`, `lost`, `limit`, `too-long`, `stopped`, `failed`.
 */
key: string | null, 
/**
 * Details of `key`.
 */
why: MessageView | null, 
/**
 * Taught length along the joint, and length of the nominal seam, mm.
 */
way_mm: number, 
/**
 * See `way_mm`.
 */
nominal_mm: number, 
/**
 * Number of frames.
 */
frames: number, 
/**
 * Mean confidence of the last frame, and the minimum over all points, 0 to 1.
 */
confidence: number, 
/**
 * See `confidence`.
 */
least_confidence: number, 
/**
 * Number of the newest picture; 0: no picture yet.
 */
picture: number, 
/**
 * Width and height of a picture, pixels.
 */
size_px: [number, number], };

/**
 * `GET /api/teach`: taught points and frames.
 */
export type TaughtView = { 
/**
 * Points of the joint, about 1 mm apart.
 */
points: Array<TaughtPointView>, 
/**
 * A row for each frame.
 */
looks: Array<TaughtLook>, };

/**
 * A point of the joint.
 */
export type TaughtPointView = { 
/**
 * Path length along the joint, mm.
 */
s_mm: number, 
/**
 * In the work frame, mm.
 */
at: [number, number, number], 
/**
 * 0 to 1.
 */
confidence: number, 
/**
 * Lateral and height deviation from the nominal seam, mm; null if far from it.
 */
from_nominal_mm: [number, number] | null, };

/**
 * An evaluated frame.
 */
export type TaughtLook = { 
/**
 * Path length along the joint at the centre of the frame, mm.
 */
s_mm: number, 
/**
 * That position in the work frame, mm.
 */
at: [number, number, number], 
/**
 * Positions of the axes at that time, mm or degrees.
 */
axes: Array<number>, 
/**
 * Mean confidence of its rows, 0 to 1.
 */
confidence: number, 
/**
 * The frame agrees with the earlier ones.
 */
believed: boolean, };

/**
 * `POST /api/teach/program`: settings for a program of the taught points.
 */
export type TeachProgram = { 
/**
 * Maximum distance of the curves from the taught line, mm: above 0, up to 5.
 */
tolerance_mm: number, 
/**
 * Maximum deviation of the torch attitude from the one found, degrees: above 0, up to 90.
 */
attitude_deg: number, 
/**
 * `greedy`, `fewest`: lines and arcs; `spline`.
 */
method: string, };

/**
 * Its answer.
 */
export type TaughtProgram = { 
/**
 * TOML of the program.
 */
text: string, 
/**
 * Numbers of lines, arcs, and pieces of a spline.
 */
counts: [number, number, number], 
/**
 * Its length, mm.
 */
length_mm: number, 
/**
 * Maximum distance of the taught line from its curves, mm.
 */
error_mm: number, 
/**
 * Maximum distance of an unsmoothed point from its curves, mm.
 */
raw_error_mm: number | null, 
/**
 * Maximum lateral and height deviation from the nominal seam, mm.
 */
from_nominal_mm: [number, number] | null, 
/**
 * Total length of unseen stretches, mm.
 */
bridged_mm: number, 
/**
 * Simulation: maximum lateral and height deviation from the actual seam, mm.
 */
truth_mm: [number, number] | null, 
/**
 * Points of its path in the work frame, mm.
 */
path: Array<[number, number, number]>, };

/**
 * From the panel over the socket.
 */
export type ToCell = { "kind": "command", 
/**
 * Counts up from 1 in a connection; one that is not greater than the last is refused.
 */
seq: number, 
/**
 * The command.
 */
ask: AskView, } | { "kind": "jog", 
/**
 * See [`ToCell::Command`]; jogs count by themselves.
 */
seq: number, 
/**
 * By joints or by the tip.
 */
of: JogOf, 
/**
 * For joints: part of the maximum speed of each axis, -1 to 1. For the tip: x, y, z in the work frame as parts
 * of the maximum jogging speed; its direction is kept. The cell slows all axes so that the tip keeps to that
 * speed.
 */
speeds: Array<number>, } | { "kind": "step", 
/**
 * See [`ToCell::Jog`].
 */
seq: number, 
/**
 * By joints or by the tip.
 */
of: JogOf, 
/**
 * Axis, or x, y, z of the work frame, from 0.
 */
index: number, 
/**
 * Distance with sign: mm or degrees, 10 at most. A step beyond an axis' end stops at the end.
 */
by: number, } | { "kind": "go", 
/**
 * See [`ToCell::Jog`].
 */
seq: number, 
/**
 * Positions of all axes, mm or degrees; all axes arrive at the same time.
 */
axes: Array<number>, } | { "kind": "teach", 
/**
 * See [`ToCell::Command`].
 */
seq: number, 
/**
 * The command.
 */
order: TeachOrder, } | { "kind": "beat", } | { "kind": "take_control", 
/**
 * Take it from another connection (never while an axis is jogged).
 */
over: boolean, } | { "kind": "give_control", } | { "kind": "why", 
/**
 * The command: `switch_on`, `home`, `start_jog`, `start_dry_run`, `start_weld`, `resume`, `reset`.
 */
ask: string, };

/**
 * Target of a jog.
 */
export type JogOf = "joints" | "tip";

/**
 * Commands to the executive. Stop and hold need no control token; stop no role either.
 */
export type AskView = { "do": "switch_on", } | { "do": "switch_off", } | { "do": "home", 
/**
 * The axis, counted from 0; all if missing.
 */
axis?: number, } | { "do": "start_jog", } | { "do": "start_teach", } | { "do": "start_dry_run", } | { "do": "arm", } | { "do": "start_weld", 
/**
 * The operator confirmed that finished work may be welded again. No if missing.
 */
reweld?: boolean, } | { "do": "hold", } | { "do": "resume", } | { "do": "reverse", } | { "do": "stop", } | { "do": "override", 
/**
 * 0 to 1.
 */
part: number, } | { "do": "reset", } | { "do": "acknowledge", 
/**
 * Number and detail of the alarm; all if missing.
 */
one?: [number, number], };

/**
 * To the panel over the socket.
 */
export type FromCell = { "kind": "hello", 
/**
 * Number of this connection.
 */
station: number, 
/**
 * Version of the program.
 */
version: string, } | { "kind": "status" } & Status | { "kind": "event" } & EventView | { "kind": "alarms", 
/**
 * All active or unacknowledged alarms, the first one first.
 */
list: Array<AlarmView>, } | { "kind": "machine" } | { "kind": "work", 
/**
 * The program.
 */
work: WorkView | null, } | { "kind": "control", 
/**
 * The connection; none: no one has control.
 */
station: number | null, 
/**
 * Its user's name.
 */
user: string | null, 
/**
 * True for this connection.
 */
mine: boolean, } | { "kind": "teach" } & TeachView | { "kind": "answer", 
/**
 * Its number.
 */
seq: number, 
/**
 * True if it was accepted.
 */
ok: boolean, 
/**
 * Reason of a refusal: a stable key (`mode`, `moving`, `references`, `power`, `silent`, `condition`, `alarm`,
 * `arming`, `source`, `not_at_start`, `work`, `value`, `motion`, `role`, `control`, `replayed`,
 * `silent_cycle`: a stop was passed on to a cycle that sends no status), and words.
 */
why: LackView | null, } | { "kind": "why", 
/**
 * The command.
 */
ask: string, 
/**
 * Its missing conditions.
 */
lacks: Array<LackView>, };
