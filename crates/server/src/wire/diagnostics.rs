use super::message::MessageView;
use super::status::RealtimeView;
use schemars::JsonSchema;
use serde::Serialize;
use ts_rs::TS;

/// `GET /api/diagnostics`: how cell and server are. `GET /metrics` prints the same.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct DiagnosticsView {
    /// Version of the program.
    pub version: String,
    /// Time since the server started, s.
    pub uptime_s: f64,
    /// Reasons for which the cell is not ready, as those of `GET /readyz`; empty: ready.
    pub not_ready: Vec<MessageView>,
    /// Mode of the cell: [`super::Status::mode`]; empty before its first status.
    pub mode: String,
    /// The control cycle.
    pub cycle: CycleView,
    /// Real-time rights of the cycle.
    pub realtime: RealtimeView,
    /// Queues between the cycle and other threads, and those to the disk.
    pub queues: Vec<QueueView>,
    /// Reports of the devices: `drives`, `source`, `inputs`.
    pub reports: Vec<ReportAge>,
    /// Lines to real devices.
    pub lines: Vec<LineView>,
    /// The disk of the data folder.
    pub disk: DiskView,
    /// Memory of the server's process; none if the system does not report it.
    pub memory: Option<MemoryView>,
    /// Memory of the cell's process, where the system reports it.
    pub cell_memory: Option<MemoryView>,
    /// Listed alarms by priority.
    pub alarms: Vec<AlarmCount>,
    /// Recorded welds since the server started, by result.
    pub welds: Vec<CountView>,
    /// Processes that answer questions of pages.
    pub workers: WorkersView,
    /// Clients of the server.
    pub clients: ClientsView,
}

/// `GET /readyz`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ReadyView {
    /// The cell can be used.
    pub ready: bool,
    /// Reasons for which it cannot.
    pub reasons: Vec<MessageView>,
}

/// The control cycle.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct CycleView {
    /// Its period, s.
    pub period_s: f64,
    /// Time since its last status, s; none before the first one.
    pub age_s: Option<f64>,
    /// Missed cycles.
    #[ts(type = "number")]
    pub missed: u64,
    /// Cycles that were lost on a full queue: their rows are not in a record.
    #[ts(type = "number")]
    pub lost: u64,
    /// Longest time without a cycle, ms.
    pub longest_gap_ms: f64,
    /// How late cycles started.
    pub latency: LatencyView,
}

/// Histogram of the lateness of cycles.
#[derive(Debug, Clone, PartialEq, Default, Serialize, TS, JsonSchema)]
pub struct LatencyView {
    /// Upper limits of the classes, microseconds; the last class has none.
    pub limits_us: Vec<f64>,
    /// Number of cycles in each class: one more than limits.
    #[ts(type = "number[]")]
    pub counts: Vec<u64>,
    /// Sum of the lateness of all cycles, s.
    pub sum_s: f64,
    /// Maximum lateness, microseconds.
    pub most_us: f64,
}

/// A queue of fixed size.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, TS, JsonSchema)]
pub struct QueueView {
    /// `cycles`, `notes` and `commands` of the cycle; `audit`: alarms and orders for the disk.
    pub name: String,
    /// Number of waiting items.
    pub waiting: usize,
    /// Maximum number of waiting items so far; none if it is not counted.
    pub most: Option<usize>,
    /// Room.
    pub capacity: usize,
}

/// Age of the last report of a device.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct ReportAge {
    /// `drives`, `source`, `inputs`.
    pub device: String,
    /// Age, s; null: no report yet.
    pub age_s: Option<f64>,
}

/// A line to a real device.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct LineView {
    /// Name of the device in the machine file.
    pub name: String,
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
    /// Of a robot: measured time from a set-point until a report shows it, s.
    pub latency_s: Option<f64>,
    /// Its standard deviation, s.
    pub latency_sigma_s: Option<f64>,
    /// Last error.
    pub trouble: Option<MessageView>,
}

/// The disk of the data folder, looked at every few seconds.
#[derive(Debug, Clone, PartialEq, Default, Serialize, TS, JsonSchema)]
pub struct DiskView {
    /// Bytes free and in total; null if unknown.
    #[ts(type = "number | null")]
    pub free_bytes: Option<u64>,
    /// See `free_bytes`.
    #[ts(type = "number | null")]
    pub total_bytes: Option<u64>,
    /// Duration of the last small write until it was on the disk, s.
    pub write_s: Option<f64>,
    /// Time since the last look, s; it grows while the disk hangs.
    pub age_s: Option<f64>,
}

/// Memory of a process.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, TS, JsonSchema)]
pub struct MemoryView {
    /// In use, bytes.
    #[ts(type = "number")]
    pub resident_bytes: u64,
    /// Locked against paging, bytes.
    #[ts(type = "number")]
    pub locked_bytes: u64,
}

/// Listed alarms of a priority.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, TS, JsonSchema)]
pub struct AlarmCount {
    /// `critical`, `high`, `medium`, `low`: see the alarm catalogue.
    pub priority: String,
    /// Alarms whose cause is present.
    pub active: u32,
    /// Alarms that were not acknowledged.
    pub unacknowledged: u32,
}

/// A number of things of a kind.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, TS, JsonSchema)]
pub struct CountView {
    /// The kind.
    pub name: String,
    /// The number.
    #[ts(type = "number")]
    pub count: u64,
}

/// Processes that answer questions of pages: drafts, plans, reports.
#[derive(Debug, Clone, PartialEq, Default, Serialize, TS, JsonSchema)]
pub struct WorkersView {
    /// Those that run.
    pub running: Vec<WorkerView>,
    /// Ended ones by result: `answered`, `refused`; killed: `superseded`, `late`; failed: `memory`, `failed`.
    pub ended: Vec<CountView>,
}

/// A process that answers a question.
#[derive(Debug, Clone, PartialEq, Serialize, TS, JsonSchema)]
pub struct WorkerView {
    /// Process number.
    pub pid: u32,
    /// Kind of the question, as in [`super::PlanningView::kind`].
    pub question: String,
    /// Time since its start, s.
    pub elapsed_s: f64,
}

/// Clients of the server.
#[derive(Debug, Clone, PartialEq, Default, Serialize, TS, JsonSchema)]
pub struct ClientsView {
    /// Open connections.
    pub connections: usize,
    /// Open pages of the panel.
    pub pages: usize,
    /// Sessions.
    pub sessions: usize,
    /// Ended connections by result: `ended`, `displaced` (for a newcomer), `handshake` (encryption failed).
    pub ended: Vec<CountView>,
    /// Logins by result: `accepted`, `refused`.
    pub logins: Vec<CountView>,
    /// Answers by HTTP status.
    pub answers: Vec<CountView>,
}
