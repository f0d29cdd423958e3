use super::message::MessageView;
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
    /// The weld was simulated.
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
    /// User who started the weld.
    pub welder: Option<String>,
    /// Minimum, mean and maximum heat input, kJ/mm.
    pub heat_input_kj_mm: Option<[f64; 3]>,
    /// Maximum distance of the torch tip from the seam, mm, and its path length, mm.
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
    /// Its events in order: missed cycles, stops and their causes, missing rights.
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
    /// Length of travel outside, mm.
    pub outside_mm: f64,
}

/// An event of a recorded weld.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct RecordedEvent {
    /// Description.
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
    /// `critical`, `high`, `medium`, `low`; empty in records of older versions.
    pub priority: String,
    /// The pass, from 1.
    pub pass: Option<u32>,
    /// Path length, mm.
    pub s_mm: Option<f64>,
    /// Time in the trace, s.
    pub t_s: Option<f64>,
    /// It came first.
    pub first_out: bool,
}

/// `GET /api/records/ID/trace?columns=a,b&most=2000`: evenly spaced rows with the first and the last, and of each
/// stretch the rows with the minimum and with the maximum of every column.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct TraceView {
    /// The columns asked for.
    pub columns: Vec<String>,
    /// Values of each column; null if missing.
    pub values: Vec<Vec<Option<f64>>>,
}

/// A row of `GET /api/audit?most=200&before=1234&after=1000&text=load`, the newest first: optionally only entries
/// before or after a number, or with a text in them.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct AuditRow {
    /// Its number: entries are numbered from 1, without gaps.
    #[ts(type = "number")]
    pub id: i64,
    /// Time: RFC 3339, UTC.
    pub at: String,
    /// User.
    pub user: String,
    /// Origin.
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
