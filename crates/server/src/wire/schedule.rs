use super::message::MessageView;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use ts_rs::TS;

/// A row of `GET /api/schedules`: a table of seams among the jobs.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct ScheduleRow {
    /// Its file in `schedules/` of the folder of jobs: ends in `.csv` or `.toml`.
    pub name: String,
    /// It was planned to the end at least once.
    pub has_results: bool,
    /// How far it is; none if it is not being planned.
    pub run: Option<ScheduleRun>,
    /// Reason for the end of the last run before all rows were planned, since the panel was started.
    pub failed: Option<MessageView>,
}

/// A schedule that is being planned.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct ScheduleRun {
    /// Rows done, with those that an earlier run had planned.
    #[ts(type = "number")]
    pub done: u64,
    /// All rows; 0 while they are counted.
    #[ts(type = "number")]
    pub total: u64,
    /// Rows among those done that were not planned again.
    #[ts(type = "number")]
    pub kept: u64,
    /// Time since the start, s.
    pub elapsed_s: f64,
    /// Rows planned per minute; none before the first.
    pub rows_per_min: Option<f64>,
    /// Time left at this rate, s.
    pub left_s: Option<f64>,
}

/// `PUT /api/schedules/NAME`: a table, checked before it is saved.
#[derive(Debug, Clone, PartialEq, Deserialize, TS, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ScheduleText {
    /// Text of the table: CSV or TOML, as its name ends.
    pub text: String,
    /// Replace a table of this name.
    pub replace: bool,
}

/// `POST /api/schedules/NAME/run`.
#[derive(Debug, Clone, PartialEq, Deserialize, Serialize, TS, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ScheduleOptions {
    /// Control or robot language to write part programs for; none: no part programs.
    pub post: Option<String>,
    /// Time limit of the searches of each plan, 1 to 3600 s.
    pub limit_s: f64,
    /// Language of the report.
    pub language: String,
}

/// `GET /api/schedules/NAME`: a table with what is known of its rows.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct ScheduleView {
    /// Its file.
    pub name: String,
    /// Fault of the table; the rows before it are listed.
    pub wrong: Option<MessageView>,
    /// Its rows, up to 5000.
    pub rows: Vec<SeamRow>,
    /// Number of further rows.
    #[ts(type = "number")]
    pub more: u64,
    /// Machines with their parts in order, of rows that can be welded; up to 2000 parts.
    pub machines: Vec<MachineParts>,
    /// Result files: `schedule.csv`, `schedule.parquet`, `machines.csv`, `report.html`.
    pub files: Vec<String>,
    /// Options of the last run.
    pub options: Option<ScheduleOptions>,
}

/// A seam of a schedule. Figures are of one part.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct SeamRow {
    /// Number, from 1.
    #[ts(type = "number")]
    pub number: u64,
    /// Name.
    pub name: String,
    /// Template: a job, or the name of an example.
    pub template: String,
    /// Machines that may weld it; empty: that of the template.
    pub machines: Vec<String>,
    /// Number of equal parts.
    pub count: u32,
    /// Time to set up a part, min.
    pub setup_min: f64,
    /// `waiting`, `weldable`, `not_weldable`, `out_of_time`, `invalid`, `failed`.
    pub status: String,
    /// The machine of these figures.
    pub machine: String,
    /// Number of passes.
    pub passes: u32,
    /// Length of all passes, mm.
    pub length_mm: f64,
    /// Time from home to home, s.
    pub total_s: f64,
    /// Time with the arc or beam on, s.
    pub arc_s: f64,
    /// Wire, kg.
    pub wire_kg: Option<f64>,
    /// Shielding gas, l.
    pub gas_l: Option<f64>,
    /// Arc energy, kJ.
    pub energy_kj: Option<f64>,
    /// Cost by the job's rates.
    pub cost: Option<f64>,
    /// Minimum clearance, mm; none if nothing comes near.
    pub clearance_mm: Option<f64>,
    /// Number of findings that prevent the weld.
    pub blocking: u32,
    /// Number of findings by code.
    pub findings: Vec<(String, u32)>,
    /// Fault of an invalid or failed row, in the language of its run.
    pub error: Option<String>,
}

/// A machine with its parts.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct MachineParts {
    /// Its name.
    pub machine: String,
    /// Its parts in order.
    pub parts: Vec<PartTime>,
    /// End of its last part, s.
    pub end_s: f64,
}

/// A part on a machine, from the beginning of its set-up.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct PartTime {
    /// Name of its row.
    pub name: String,
    /// Beginning of the set-up, of the weld, and the end, s.
    pub from_s: f64,
    /// See `from_s`.
    pub weld_s: f64,
    /// See `from_s`.
    pub to_s: f64,
}
