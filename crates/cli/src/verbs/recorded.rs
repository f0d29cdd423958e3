//! Where the rows of a weld go: a trace in the output folder, or a recording in the library that is copied there.

use crate::args::records::RecordArgs;
use crate::failure::Failure;
use crate::files::{self, Output};
use crate::load::Loaded;
use seamwright_machine::shipped;
use seamwright_motion::WeldMotion;
use seamwright_program::{Procedure, Program};
use seamwright_record::figures::{Basis, HEAT_INPUT, Judged, Power};
use seamwright_record::journal::Journal;
use seamwright_record::library::{Alarm, AuditEntry, WeldResult};
use seamwright_record::trace::{Column, Kind, TraceWriter};
use seamwright_record::{DataFolder, Moment, Outcome, Plan, Recording};
use seamwright_report::WeldReport;
use std::io::Write;
use tempfile::TempDir;

/// A part of a trace has an hour.
const PART_S: f64 = 3600.0;

/// What a trace says of its rows.
pub(super) struct Header<'a> {
    /// Columns with their units.
    pub(super) columns: &'a [(String, &'static str)],
    /// Pairs of (key, value).
    pub(super) about: &'a [(&'static str, String)],
}

impl Header<'_> {
    fn columns(&self) -> Vec<Column> {
        self.columns.iter().map(|(name, unit)| Column::new(name, *unit, kind(name))).collect()
    }
}

/// A trace for the output folder, in a folder of its own until it is finished.
pub(super) struct TraceFile {
    writer: TraceWriter,
    scratch: TempDir,
}

impl TraceFile {
    pub(super) fn begin(header: &Header<'_>, period_s: f64, output: &Output) -> Result<Self, Failure> {
        let scratch = output.scratch()?;
        let path = scratch.path().join("trace.parquet");
        let writer = TraceWriter::create(&path, &header.columns(), header.about, most_rows(period_s))?;
        Ok(Self { writer, scratch })
    }

    pub(super) fn row(&mut self, values: impl IntoIterator<Item = f64>) -> Result<(), Failure> {
        Ok(self.writer.row(values)?)
    }

    /// Adds the finished trace to `output`.
    pub(super) fn finish(self, output: &mut Output) -> Result<(), Failure> {
        let Self { writer, scratch } = self;
        for part in writer.finish()? {
            let name = part.path.file_name().unwrap_or_default().to_string_lossy().into_owned();
            output.take(&name, &part.path)?;
        }
        // It holds nothing more.
        drop(scratch);
        Ok(())
    }
}

/// Rows of a part of a trace.
fn most_rows(period_s: f64) -> u64 {
    (PART_S / period_s) as u64
}

/// Where the rows of a weld go.
pub(super) enum Rows {
    /// Into a trace.
    Trace(Box<TraceFile>),
    /// Into the library.
    Weld(Box<(Recording, DataFolder)>),
}

/// Begins a trace in `output`, or a recording if one is asked for.
pub(super) fn begin(
    loaded: &Loaded,
    motion: &WeldMotion,
    header: &Header<'_>,
    output: &Output,
    record: &RecordArgs,
) -> Result<Rows, Failure> {
    let period = loaded.machine.servo_period_s;
    let Some(folder) = &record.data else {
        return Ok(Rows::Trace(Box::new(TraceFile::begin(header, period, output)?)));
    };
    let mut data = DataFolder::open(folder)?;
    let rows = motion.count(period, true);
    let (columns, about, most_rows) = (header.columns(), header.about.to_vec(), most_rows(period));
    let plan = Plan { columns, about, most_rows, rows, ..plan(loaded, motion, record)? };
    let recording = data.begin(&plan)?;
    Ok(Rows::Weld(Box::new((recording, data))))
}

/// Time and places in full, states in a byte, the rest to 7 digits.
fn kind(name: &str) -> Kind {
    match name {
        "pass" | "missed" => Kind::U32,
        "arc" | "mode" | "gas" | "process_state" | "burning" | "power" => Kind::U8,
        "t_s" | "s_mm" | "tip_s_mm" | "welded_mm" | "inputs" => Kind::F64,
        axis if ["_set_mm", "_set_deg", "_true_mm", "_true_deg", "_measured_mm", "_measured_deg"]
            .iter()
            .any(|end| axis.ends_with(end)) =>
        {
            Kind::F64
        }
        _ => Kind::F32,
    }
}

/// What is to be recorded, but for the trace.
fn plan(loaded: &Loaded, motion: &WeldMotion, record: &RecordArgs) -> Result<Plan, Failure> {
    let document = &loaded.welding.program;
    let program = &document.value;
    let failed = |e: &dyn std::fmt::Display| Failure::Environment(e.to_string());
    let text = program.to_toml().map_err(|e| failed(&e))?;
    let file = std::path::Path::new(document.file()).file_name().map(|n| n.to_string_lossy().into_owned());
    let machine = match &loaded.machine_file {
        Some(path) => files::read(path)?,
        None => shipped(&program.machine).map_or(String::new(), |s| s.text.to_owned()),
    };
    let procedure = match &program.procedure {
        Some(p) => Some((p.number.clone(), p.to_toml().map_err(|e| failed(&e))?)),
        None => None,
    };
    let is_job = !Program::is_in(document.text());
    Ok(Plan {
        part: record.part.clone(),
        title: program.title.clone(),
        simulated: true,
        job: is_job.then(|| (file.unwrap_or_default(), document.text().to_owned())),
        program: (program.title.clone(), text),
        machine: (loaded.machine.name.clone(), machine),
        procedure,
        welder: record.welder.clone(),
        columns: Vec::new(),
        about: Vec::new(),
        most_rows: 0,
        rows: 0,
        basis: basis(program, motion),
    })
}

/// What is judged: process values, speed and heat input of each pass between run-up and run-down.
fn basis(program: &Program, motion: &WeldMotion) -> Basis {
    let procedure = program.procedure.as_ref();
    let mut judged = Vec::new();
    for (number, (pass, planned)) in (1..).zip(program.passes.iter().zip(&motion.passes)) {
        let run = procedure.and_then(|p| p.run_of(number, pass));
        let legs = planned.law.legs();
        let along: Vec<_> = legs.iter().map(|leg| (leg.run_up_end, leg.run_down_start)).collect();
        let mut judge = |name: &str, allowed: Option<(f64, f64)>| {
            judged.push(Judged { pass: number as u32, name: name.to_owned(), allowed, along: along.clone() });
        };
        let of_run = |window: Option<seamwright_program::Window>| window.map(seamwright_program::Window::ends);
        judge("tip_speed_mm_s", of_run(run.and_then(|r| r.speed_mm_s)));
        if procedure.is_some() {
            judge(HEAT_INPUT, of_run(run.and_then(|r| r.heat_input_kj_mm)));
        }
        let values = pass.spans.iter().flat_map(|s| s.process.keys());
        let names: std::collections::BTreeSet<&String> = values.collect();
        for name in names {
            judge(name, of_run(run.and_then(|r| r.ranges.get(name).copied())));
        }
    }
    Basis { power: procedure.map(power), judged }
}

fn power(procedure: &Procedure) -> Power {
    let factors = procedure.power_factors().map(|(name, by)| (name.to_owned(), by));
    Power { factors: factors.collect(), efficiency: procedure.thermal_efficiency() }
}

impl Rows {
    /// Adds a row.
    pub(super) fn row(&mut self, values: impl IntoIterator<Item = f64>) -> Result<(), Failure> {
        match self {
            Self::Trace(trace) => trace.row(values)?,
            Self::Weld(weld) => weld.0.row(values),
        }
        Ok(())
    }

    /// Ends the simulated weld of `report`, with the other `files` and the alarms that there were; adds its trace to `output`.
    pub(super) fn finish(
        self,
        report: &WeldReport,
        (mut files, alarms): (Vec<(String, String)>, &[Alarm]),
        stopped: bool,
        output: &mut Output,
    ) -> Result<(), Failure> {
        let json = serde_json::to_string_pretty(report).map_err(|e| Failure::Environment(e.to_string()))?;
        files.push(("report.json".to_owned(), json + "\n"));
        let result = if stopped { WeldResult::Stopped } else { result(report) };
        self.keep("simulate", &Outcome { result, note: String::new(), files }, alarms, output)
    }

    /// Ends the weld with this outcome; adds its trace to `output`, and all of it to the library.
    pub(super) fn keep(
        self,
        verb: &str,
        outcome: &Outcome,
        alarms: &[Alarm],
        output: &mut Output,
    ) -> Result<(), Failure> {
        let (recording, mut data) = match self {
            Self::Trace(trace) => return trace.finish(output),
            Self::Weld(weld) => *weld,
        };
        let id = recording.id();
        for alarm in alarms {
            data.library().add_alarm(Some(id), alarm)?;
        }
        let weld = recording.finish(&mut data, outcome)?;
        audit(&mut data, &format!("{verb}: weld {id} of part {:?}", weld.part), weld.result.name())?;
        for file in data.library().files(id)?.iter().filter(|f| f.rows.is_some()) {
            output.take(&file.name, &data.weld_folder(id).join(&file.name))?;
        }
        if !weld.note.is_empty() {
            let _ = writeln!(std::io::stderr(), "note: weld {id}: {}", weld.note);
        }
        let _ = writeln!(std::io::stderr(), "recorded: weld {id}");
        Ok(())
    }

    /// Number of the weld in the library, and why rows of it could not be written, if some could not.
    pub(super) fn weld(&self) -> Option<(i64, Option<&str>)> {
        match self {
            Self::Trace(_) => None,
            Self::Weld(weld) => Some((weld.0.id(), weld.0.trouble())),
        }
    }

    /// The journal for power loss, if the weld is recorded.
    pub(super) fn journal(&self) -> Result<Option<Journal>, Failure> {
        match self {
            Self::Trace(_) => Ok(None),
            Self::Weld(weld) => Ok(Some(weld.1.journal()?)),
        }
    }
}

fn result(report: &WeldReport) -> WeldResult {
    let forbidding = || report.findings.iter().filter(|f| !f.allowed);
    match forbidding().any(|f| f.kind == "stopped") {
        true => WeldResult::Stopped,
        false if forbidding().next().is_some() => WeldResult::Deviating,
        false => WeldResult::Good,
    }
}

/// Notes in the audit log what this command did.
pub(super) fn audit(data: &mut DataFolder, command: &str, result: &str) -> Result<(), Failure> {
    let user = ["USER", "LOGNAME", "USERNAME"].into_iter().find_map(|name| std::env::var(name).ok());
    let entry = AuditEntry {
        at: Moment::now(),
        user: user.unwrap_or_default(),
        station: "command line".to_owned(),
        command: command.to_owned(),
        old: String::new(),
        new: String::new(),
        result: result.to_owned(),
    };
    data.library_mut().audit(&entry)?;
    Ok(())
}
