use super::message::MessageView;
use super::weld::SolidView;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use ts_rs::TS;

/// `GET /api/machine`.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct MachineView {
    /// Short name.
    pub name: String,
    /// Title.
    pub title: String,
    /// True: the devices are simulated.
    pub simulated: bool,
    /// Period of the cycle, s.
    pub period_s: f64,
    /// Axes in their order.
    pub axes: Vec<AxisView>,
    /// Conditions in their order.
    pub conditions: Vec<ConditionView>,
    /// Solids of the links.
    pub solids: Vec<SolidView>,
    /// Zones.
    pub zones: Vec<ZoneView>,
    /// Named frames: axes, `base`, `work`, torches.
    pub frames: Vec<FrameView>,
    /// Index of the base among the links, and of the first torch.
    pub base: usize,
    /// See `base`.
    pub torch: usize,
    /// Tool frame of the first torch in the work frame with all axes at zero, row by row (3 x 4), mm: the tip, z from the
    /// torch to the work.
    pub tool: [f64; 12],
    /// Unit vector up in the base frame.
    pub up: [f64; 3],
    /// Highest speed of the tip by hand, mm/s.
    pub jog_mm_s: f64,
    /// Highest rate of the torch about its tip by hand, degrees/s.
    pub jog_deg_s: f64,
    /// The torch can be turned about its tip by hand, about x, y and z of the tool frame.
    pub turns: [bool; 3],
    /// It is an arm whose configuration has names: see [`super::Status::arm`].
    pub arm: bool,
    /// User frames.
    pub user_frames: Vec<UserFrameView>,
    /// Joint of each link, in the order of [`super::Status::links`].
    pub joints: Vec<Option<JointView>>,
    /// Its sensors.
    pub sensors: Vec<SensorView>,
    /// The process is a beam (else an arc).
    pub beam: bool,
    /// Distance from the work to the source of a beam, mm; none for an arc.
    pub beam_mm: Option<f64>,
}

/// A user frame of the machine file.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct UserFrameView {
    /// Its name.
    pub name: String,
    /// In the base frame, row by row (3 x 4), mm.
    pub frame: [f64; 12],
}

/// Joint by which a link moves on the next one towards the work.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct JointView {
    /// Index of the next link: less than that of this link.
    pub on: usize,
    /// The axis that moves it.
    pub axis: usize,
    /// Unit vector in the work frame with all axes at zero: direction of motion of an axis in mm, axis of rotation of
    /// one in degrees.
    pub direction: [f64; 3],
    /// A point on the axis there, mm.
    pub at: [f64; 3],
}

/// A sensor for the joint.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct SensorView {
    /// Name.
    pub name: String,
    /// `stripe`, `camera`.
    pub kind: String,
    /// The link that carries it.
    pub link: usize,
    /// Corners of the field of view in the work frame with all axes at zero, mm: of a camera in its nominal plane, of a
    /// stripe sensor in the plane of its laser. Empty if a corner of the picture does not meet that plane.
    pub field: Vec<[f64; 3]>,
    /// Its frames come from the machine's own camera.
    pub frames: bool,
}

/// An axis, in mm or degrees.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct AxisView {
    /// Name.
    pub name: String,
    /// `mm` or `deg`.
    pub unit: String,
    /// Lowest and highest position; none: it turns without end.
    pub range: Option<(f64, f64)>,
    /// Home.
    pub home: f64,
    /// Highest speed.
    pub max_speed: f64,
}

/// A row of `GET /api/alarms/catalogue`, in English.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct AlarmEntry {
    /// Number.
    pub number: u8,
    /// Stable name.
    pub name: String,
    /// Cause.
    pub cause: String,
    /// Consequence.
    pub consequence: String,
    /// Operator action.
    pub action: String,
    /// Reaction of the cell.
    pub reaction: String,
    /// `critical`, `high`, `medium`, `low`.
    pub priority: String,
    /// Severity of the consequence without an action: `minor`, `moderate`, `major`, `severe`.
    pub severity: String,
    /// Time to respond: `minute`, `ten minutes`, `longer`.
    pub response: String,
    /// It may be shelved.
    pub shelvable: bool,
}

/// A condition of the machine file.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct ConditionView {
    /// Name.
    pub name: String,
    /// `power`, `motion`, `process`.
    pub level: String,
}

/// A zone.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct ZoneView {
    /// Name.
    pub name: String,
    /// Stay in (else keep out).
    pub permitted: bool,
    /// Its volume.
    pub solids: Vec<SolidView>,
}

/// A named frame on a link.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct FrameView {
    /// Name.
    pub name: String,
    /// The link.
    pub link: usize,
    /// In the work frame with all axes at zero, row by row (3 x 4), mm.
    pub frame: [f64; 12],
}

/// Answer to `POST /api/stop`: the server has passed the stop on. If the mode is current, it shows whether the cell has
/// stopped.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct Stopped {
    /// Mode of the cell at that time: [`super::Status::mode`]; empty if it is not known yet.
    pub mode: String,
    /// Age of the last status of the cycle, s; none before the first one. It grows if the cycle hangs or has ended.
    pub cycle_age_s: Option<f64>,
    /// Number of the cycle in which the cell acted on the stop, counted from its start; none if no cycle has acted within
    /// half a second.
    #[ts(type = "number | null")]
    pub cycle: Option<u64>,
}

/// `GET /api/session`, and the answer of `POST /api/login`.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct SessionView {
    /// Name of the user.
    pub user: String,
    /// Role.
    pub role: Role,
    /// Everything that the role may do: names of commands and of routes' permissions.
    pub may: Vec<String>,
    /// Value of the header `x-seamwright` that every request with an effect must carry.
    pub token: String,
    /// No password is set yet: the printed address gives the rights of the owner.
    pub first_run: bool,
}

/// Role of a user. Each role includes the rights of those before.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Deserialize, Serialize, TS, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Role {
    /// Watches.
    Viewer,
    /// Runs the loaded job, jogs, acknowledges.
    Operator,
    /// Writes and loads jobs, teaches.
    Programmer,
    /// Sets up the machine.
    Service,
    /// Users.
    Admin,
}

/// `POST /api/login`.
#[derive(Clone, PartialEq, Deserialize, TS, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Login {
    /// Name; empty with a key.
    pub user: String,
    /// Password, or the key of the printed address.
    pub password: String,
}

/// A row of `GET /api/users`.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct UserRow {
    /// Name.
    pub name: String,
    /// Role.
    pub role: Role,
    /// It can log in.
    pub enabled: bool,
}

/// `PUT /api/users/NAME`: makes or changes a user.
#[derive(Clone, PartialEq, Deserialize, TS, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct UserChange {
    /// Role.
    pub role: Role,
    /// A new password, if it is to change; at least ten characters.
    pub password: Option<String>,
    /// It can log in.
    pub enabled: bool,
    /// Password of the user who sends the request.
    pub own_password: Option<String>,
    /// Refuse an existing name as `exists` instead of changing its user.
    pub only_new: Option<bool>,
}

/// `DELETE /api/users/NAME`, `POST /api/restore`.
#[derive(Clone, PartialEq, Deserialize, TS, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct OwnPassword {
    /// Password of the user who sends the request.
    pub own_password: Option<String>,
}

/// `PUT /api/restore`: contents of a checked archive.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct ArchiveView {
    /// Welds.
    pub welds: usize,
    /// Start of the newest of them; RFC 3339, UTC.
    pub newest: Option<String>,
    /// Jobs.
    pub jobs: usize,
    /// Users.
    pub users: usize,
    /// Entries of the audit log, whose chain is whole.
    #[ts(type = "number")]
    pub audit: u64,
}

/// `GET /api/devices`: a device of the cell with its present values.
#[derive(Debug, Clone, PartialEq, Default, Serialize, TS, JsonSchema)]
pub struct DeviceView {
    /// Its name in the machine file; empty: simulated.
    pub name: String,
    /// Host and port; empty: simulated.
    pub address: String,
    /// Unit address.
    pub unit: u8,
    /// Time from poll to poll, s.
    pub poll_s: f64,
    /// Time without a cycle after which outputs go to their safe states, s.
    pub watchdog_s: f64,
    /// Its named signals.
    pub signals: Vec<SignalView>,
    /// Traffic on the line; none without a line.
    pub traffic: Option<TrafficView>,
}

/// An input, an output or a number of a device.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct SignalView {
    /// Its name, like `inputs.door_closed`, `outputs.gas`, `set.current_a`.
    pub name: String,
    /// `input`, `output`, `set`, `report`, `actual`.
    pub kind: String,
    /// Address, like `holding 12 bit 3`; empty: simulated.
    pub place: String,
    /// It is on or off, not a number.
    pub bit: bool,
    /// Unit of a number.
    pub unit: String,
    /// Present value: of a bit 0 or 1; null if unknown.
    pub value: Option<f64>,
    /// Of an output, its safe value.
    pub safe: Option<f64>,
    /// Of an input, the value that its condition needs.
    pub wanted: Option<bool>,
    /// Condition of an input.
    pub condition: Option<String>,
}

/// Traffic with a device since it was connected.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct TrafficView {
    /// Polls that were answered.
    #[ts(type = "number")]
    pub polls: u64,
    /// Polls left out, because the one before took too long.
    #[ts(type = "number")]
    pub missed: u64,
    /// Polls that were refused or not answered.
    #[ts(type = "number")]
    pub failed: u64,
    /// Connections made.
    pub connections: u32,
    /// Time without a connection, s.
    pub away_s: f64,
    /// Duration of a poll: median, 99.9 % quantile and maximum, microseconds.
    pub round_us: [f64; 3],
    /// Last error.
    pub trouble: Option<String>,
}

/// `GET /api/tuning?axis=NAME`: the position loop of an axis, tuned and measured on its drive in simulation.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct TuningView {
    /// Its name.
    pub axis: String,
    /// `mm` or `deg`.
    pub unit: String,
    /// The machine file describes no drive: an assumed one was tuned.
    pub assumed_drive: bool,
    /// Reason why it cannot be tuned.
    pub refused: Option<MessageView>,
    /// Open loop: frequency, Hz, gain, dB, phase, degrees.
    pub response: Vec<[f64; 3]>,
    /// Gain margin, dB, and its frequency, Hz; none: the phase does not reach -180 degrees.
    pub gain_margin: Option<[f64; 2]>,
    /// Phase margin, degrees, and its frequency, Hz.
    pub phase_margin: Option<[f64; 2]>,
    /// Settings and measured values, with the keys of machine files.
    pub values: Vec<(String, f64)>,
    /// The settings, as [`super::ParameterChange::values`] takes them over.
    pub settings: Vec<(String, f64)>,
    /// See [`super::ParameterChange::notches`].
    pub notches: Vec<[f64; 3]>,
}

/// Answer to every failed request.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct Trouble {
    /// Stable key: `login`, `password`, `role`, `origin`, `token`, `size`, `input`, `not_found`, `busy`, `slow_down`,
    /// `server`.
    pub key: String,
    /// Description with the allowed values.
    #[serde(flatten)]
    pub message: MessageView,
}
