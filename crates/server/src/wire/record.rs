use super::MessageView;
use schemars::JsonSchema;
use serde::Serialize;
use ts_rs::TS;

/// A row of `GET /api/records`, and the head of `GET /api/records/ID`.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct RecordRow {
    /// Its number.
    #[ts(type = "number")]
    pub id: i64,
    /// Name of the part.
    pub part: String,
    /// The job's title.
    pub title: String,
    /// No metal was welded.
    pub simulated: bool,
    /// RFC 3339, UTC.
    pub begun: String,
    /// See `begun`; none: not yet.
    pub ended: Option<String>,
    /// `running`, `good`, `deviating`, `stopped`, ...
    pub result: String,
    /// Remark.
    pub note: MessageView,
    /// Name of the machine.
    pub machine: String,
    /// Number of the procedure.
    pub procedure: Option<String>,
    /// Name of the welder.
    pub welder: Option<String>,
    /// Minimum, mean and maximum heat input, kJ/mm.
    pub heat_input_kj_mm: Option<[f64; 3]>,
    /// Maximum distance of the torch tip from the seam (mm), and where (mm).
    pub worst_deviation_mm: Option<(f64, f64)>,
}

/// `GET /api/records/ID`.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct RecordView {
    /// The weld.
    pub weld: RecordRow,
    /// Process values against their windows.
    pub values: Vec<JudgedView>,
    /// Its alarms in order.
    pub alarms: Vec<RecordedAlarm>,
    /// Its events in order: cycles that were missed, what was stopped and by what, rights that were missing.
    pub events: Vec<RecordedEvent>,
    /// Columns of its trace with their units.
    pub columns: Vec<(String, String)>,
    /// Rows of its trace.
    #[ts(type = "number")]
    pub rows: u64,
}

/// A process value while the arc was on.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct JudgedView {
    /// The pass, from 1.
    pub pass: u32,
    /// Its name, which ends in its unit.
    pub name: String,
    /// Minimum, mean and maximum.
    pub least: f64,
    /// See `least`.
    pub mean: f64,
    /// See `least`.
    pub greatest: f64,
    /// Minimum and maximum value allowed.
    pub allowed: Option<(f64, f64)>,
    /// Time outside, s.
    pub outside_s: f64,
    /// Over how much of the way it was outside, mm.
    pub outside_mm: f64,
}

/// An event of a recorded weld.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct RecordedEvent {
    /// Description of the event.
    #[serde(flatten)]
    pub message: MessageView,
    /// The pass, from 1.
    pub pass: Option<u32>,
    /// Path length, mm.
    pub s_mm: Option<f64>,
    /// Time in the trace, s.
    pub t_s: Option<f64>,
}

/// An alarm of a recorded weld.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct RecordedAlarm {
    /// Name.
    pub name: MessageView,
    /// Cause.
    pub cause: MessageView,
    /// The pass, from 1.
    pub pass: Option<u32>,
    /// Path length, mm.
    pub s_mm: Option<f64>,
    /// Time in the trace, s.
    pub t_s: Option<f64>,
    /// It came first.
    pub first_out: bool,
}

/// `GET /api/records/ID/trace?columns=a,b&most=2000`: rows evenly taken, the first and the last among them, and of each
/// stretch the rows with the minimum and with the maximum of every column.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct TraceView {
    /// The columns asked for.
    pub columns: Vec<String>,
    /// Values of each column; null if missing.
    pub values: Vec<Vec<Option<f64>>>,
}

/// A row of `GET /api/audit?most=200&before=1234&after=1000&text=load`, the newest first: of those that are older or newer than an
/// entry and have a text in them, if that is asked for.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct AuditRow {
    /// Its number: entries are numbered from 1, without gaps.
    #[ts(type = "number")]
    pub id: i64,
    /// Time: RFC 3339, UTC.
    pub at: String,
    /// User of the command.
    pub user: String,
    /// Station of the command.
    pub station: MessageView,
    /// The command.
    pub command: MessageView,
    /// The value before, and after.
    pub old: String,
    /// See `old`.
    pub new: String,
    /// Result.
    pub result: MessageView,
}
