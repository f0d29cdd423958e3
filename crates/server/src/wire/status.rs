use super::message::MessageView;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use ts_rs::TS;

/// State of the cell.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct Status {
    /// Time since the start of the executive, s.
    pub t: f64,
    /// `off`, `idle`, `homing`, `ready`, `jog`, `teach`, `dry_run`, `weld`, `hold`, `fault`.
    pub mode: String,
    /// The pass, from 1; 0 beside all passes.
    pub pass: u32,
    /// Path length in the pass, mm.
    pub s_mm: f64,
    /// Path length up to which the pass is welded, mm.
    pub welded_mm: f64,
    /// Commanded speed along the path, with the feed override, mm/s.
    pub speed_mm_s: f64,
    /// The override: part of the planned speed.
    pub override_part: f64,
    /// The next start of the process is allowed.
    pub armed: bool,
    /// Drives have power.
    pub powered: bool,
    /// Arc or beam.
    pub process: ProcessStatus,
    /// The axes are at rest: neither commanded to move nor moved recently.
    pub stands: bool,
    /// In the order of the machine's axes.
    pub axes: Vec<AxisStatus>,
    /// Measured torch tip in the work frame: x, y, z (mm) and the unit vector out of the work along the torch.
    pub tip: [f64; 6],
    /// Measured tool frame in the work frame, with the torch tip as its origin: row by row (3 x 4), mm. z points from the
    /// torch to the work.
    pub tool: [f64; 12],
    /// Configuration of the arm; none for other machines.
    pub arm: Option<ArmView>,
    /// Displacement of each link from its pose with all axes at zero: a frame, row by row (3 x 4), mm.
    pub links: Vec<[f64; 12]>,
    /// In the order of the machine's conditions: met or not.
    pub conditions: Vec<bool>,
    /// Inputs as they are, in the order of the machine's conditions.
    pub inputs: Vec<bool>,
    /// State of tracking of each head that is tracked in this pass.
    pub tracking: Vec<TrackingStatus>,
    /// The pair nearest to its minimum clearance; none if no pair is watched or near.
    pub near: Option<super::NearView>,
    /// Ages of the devices' reports, s.
    pub ages: Ages,
    /// Real-time rights of the cycle.
    pub realtime: RealtimeView,
    /// Longest time without a cycle since the start, ms.
    pub longest_gap_ms: f64,
    /// Total numbers of missed cycles and of unrecorded cycles.
    pub missed: u32,
    /// See `missed`.
    #[ts(type = "number")]
    pub lost: u64,
    /// The weld that a stop, a fault or a power failure interrupted and that can be resumed.
    pub left: Option<LeftView>,
    /// Start of the weld of the program in the cell: pass from 1, and path length, mm; none without a program.
    pub start: Option<(u32, f64)>,
    /// Number of the part for the record of the next weld; empty if it has none. A finished part clears it.
    pub part: String,
    /// Number of the weld in the library while one is recorded.
    #[ts(type = "number | null")]
    pub recording: Option<i64>,
}

/// Configuration of a six- or seven-axis arm: with the tool frame it determines all positions of its axes.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct ArmView {
    /// `front`, `back`: side of the first axis on which the wrist is.
    pub shoulder: String,
    /// `up`, `down`: side of the line from shoulder to wrist on which the elbow is.
    pub elbow: String,
    /// `no_flip`, `flip`: sign of the fifth axis.
    pub wrist: String,
    /// Whole turns of each axis of the arm from its position within (-180, 180] degrees.
    pub turns: Vec<i32>,
    /// Distance from the nearest singularity, 0 (in it) to 1.
    pub margin: f64,
    /// The nearest singularity: `shoulder`, `elbow`, `wrist`.
    pub nearest: String,
}

/// `POST /api/target`: positions of all axes, or a place of the torch tip, to which the axes are to be sent by hand.
#[derive(Debug, Clone, PartialEq, Deserialize, TS, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TargetText {
    /// Positions of all axes, mm or degrees; instead of `tip`.
    pub axes: Option<Vec<f64>>,
    /// Place of the tip; instead of `axes`.
    pub tip: Option<TipTarget>,
}

/// A place of the torch tip.
#[derive(Debug, Clone, PartialEq, Deserialize, TS, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct TipTarget {
    /// Frame of the numbers: see [`super::JogOf`]; in `tool` they are relative to the present tool frame.
    pub frame: String,
    /// Point, mm.
    pub point: [f64; 3],
    /// Orientation of the tool frame as a quaternion w, x, y, z; none: the present one. Only for arms.
    pub turn: Option<[f64; 4]>,
}

/// Its answer; nothing moves.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct TargetAnswer {
    /// Positions of all axes at the target, for [`super::ToCell::Go`]; empty if it cannot be reached.
    pub axes: Vec<f64>,
    /// Reason why it cannot be reached, or why the axes would stop on the way; none if they arrive.
    pub refused: Option<MessageView>,
    /// Positions at which the axes would stop on the way.
    pub stops: Option<Vec<f64>>,
    /// Duration of the motion by hand, s.
    pub time_s: f64,
    /// The nearest pair of bodies on the way; none if nothing comes near.
    pub nearest: Option<super::NearView>,
    /// Path of the torch tip in the work frame, mm.
    pub tips: Vec<[f64; 3]>,
    /// Angle by which the torch's direction misses the wanted one, degrees: the machine lacks axes for it.
    pub tilt_error_deg: f64,
    /// Configuration of the arm at the target.
    pub arm: Option<ArmView>,
}

/// `GET /api/position`: positions of the axes and the tip; refused while an axis moves.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct StandingView {
    /// Measured, in the order of the machine's axes, mm or degrees.
    pub axes: Vec<f64>,
    /// See [`Status::tip`].
    pub tip: [f64; 6],
}

/// Real-time rights of the cycle.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct RealtimeView {
    /// Missing rights: `priority` (real-time scheduling), `memory` (locked), `cpu` (of its own, if requested); empty if
    /// complete.
    pub missing: Vec<String>,
    /// The same in English, with the system's reasons and the remedy.
    pub text: String,
}

/// An interrupted weld.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct LeftView {
    /// The pass, from 1.
    pub pass: u32,
    /// Path length up to which the pass is welded, mm.
    pub s_mm: f64,
    /// Number of finished passes, from the first.
    pub finished: u32,
    /// Number of its record in the library, if it was recorded.
    #[ts(type = "number | null")]
    pub record: Option<i64>,
    /// Title of the job.
    pub title: String,
    /// Number of the part; empty if it has none.
    pub part: String,
    /// The cell holds the same program, for this part or for one without a number: the weld can be resumed.
    pub here: bool,
}

/// Arc or beam.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct ProcessStatus {
    /// `off`, `strikes`, `pauses`, `burns`, `failed`.
    pub state: String,
    /// It is switched on by command.
    pub on: bool,
    /// The source reports that it burns.
    pub burning: bool,
    /// The gas valve is open.
    pub gas: bool,
    /// The source could be switched on.
    pub ready: bool,
    /// The wire sticks.
    pub stuck: bool,
    /// Fault code of the source; 0 means no fault.
    pub fault: u16,
    /// Phase of the pass: `held`, `preflow`, `travel_delay`, `travel`, `run_out`, `crater`, `postflow`, `move`,
    /// `ended`; none between passes.
    pub phase: Option<String>,
    /// Set and measured values in the order of [`super::WorkView::values`]; null if missing.
    pub set: Vec<Option<f64>>,
    /// See `set`.
    pub measured: Vec<Option<f64>>,
}

/// An axis, in mm or degrees.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct AxisStatus {
    /// Measured position.
    pub position: f64,
    /// Set position.
    pub set: f64,
    /// Following error.
    pub error: f64,
    /// Current as a part of the peak.
    pub current: f64,
    /// Its reference is known.
    pub referenced: bool,
    /// The drive has a fault.
    pub fault: bool,
    /// It is on a limit switch.
    pub limit_switch: bool,
}

/// Results of tracking.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct TrackingStatus {
    /// The head, from 1.
    pub head: u32,
    /// Lateral and height deviation of the joint from the program at the torch, mm.
    pub deviation_mm: [f64; 2],
    /// Lateral and height correction carried out, mm.
    pub correction_mm: [f64; 2],
    /// 0 to 1.
    pub confidence: f64,
    /// Standard deviation of the deviation, mm; null if unknown.
    pub sigma_mm: Option<f64>,
    /// Quality: `seen`, `bridged`, `coasted`, `fading`, `unseen`, `lost`.
    pub state: String,
}

/// Ages, s; null: no data yet.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct Ages {
    /// Drives.
    pub drives: Option<f64>,
    /// Process source.
    pub source: Option<f64>,
    /// Inputs.
    pub inputs: Option<f64>,
}

/// An alarm on the list. Texts are English; panels translate by `name`.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct AlarmView {
    /// Number in the catalogue.
    pub number: u8,
    /// Stable name.
    pub name: String,
    /// Axis or condition of the alarm, if any.
    pub of: Option<MessageView>,
    /// Cause, consequence and operator action.
    pub cause: String,
    /// See `cause`.
    pub consequence: String,
    /// See `cause`.
    pub action: String,
    /// Reaction of the cell.
    pub reaction: String,
    /// Index of the axis, condition or process value; with `number` it identifies the alarm.
    pub detail: u8,
    /// `unacknowledged`, `acknowledged`, `returned`; `gone`: not on the list but still shelved.
    pub state: String,
    /// It came first.
    pub first_out: bool,
    /// Time of the executive, s.
    pub t: f64,
    /// Time; RFC 3339, UTC.
    pub at: String,
    /// User and time of the acknowledgement.
    pub acknowledged: Option<WhoWhen>,
    /// User and end of the shelving.
    pub shelved: Option<WhoWhen>,
    /// It only informs, and may be shelved.
    pub tells: bool,
    /// `critical`, `high`, `medium`, `low`.
    pub priority: String,
    /// It came three times or more within a minute.
    pub chattering: bool,
    /// Position: pass from 1 (0: outside of passes) and path length.
    pub pass: u32,
    /// See `pass`.
    pub s_mm: f64,
}

/// A user and a time.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, TS, JsonSchema)]
pub struct WhoWhen {
    /// Name of the user.
    pub by: String,
    /// RFC 3339, UTC.
    pub at: String,
}

/// `POST /api/alarms/shelve`: shelves a message-only alarm for a while, or ends the shelving.
#[derive(Debug, Clone, PartialEq, Eq, Deserialize, TS, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Shelving {
    /// See [`AlarmView::number`].
    pub number: u8,
    /// See [`AlarmView::detail`].
    pub detail: u8,
    /// Duration, up to 480; 0 ends the shelving.
    pub minutes: u32,
}

/// An event.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct EventView {
    /// Counts up, without gaps.
    #[ts(type = "number")]
    pub number: u64,
    /// Time of the executive, s.
    pub t: f64,
    /// RFC 3339, UTC.
    pub at: String,
    /// `mode`, `order`, `refused`, `alarm`, `cleared`, `pass`, `left`, `record`, `control`, `work`, `teach`.
    pub what: String,
    /// Stable key: the code of the message without `server-event-`, with `_` for `-`.
    pub key: String,
    /// Description.
    #[serde(flatten)]
    pub message: MessageView,
    /// User who gave the command, if any.
    pub user: Option<String>,
}

/// A missing condition of a command.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct LackView {
    /// Stable key.
    pub key: String,
    /// Description with the operator action.
    #[serde(flatten)]
    pub message: MessageView,
}
