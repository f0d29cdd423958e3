//! Destination of a weld's rows: a trace in the output folder, or a recording in the library that is copied there.

use crate::args::records::RecordArgs;
use crate::rows::json_text;
use seamwright_message::Message;
use seamwright_motion::WeldMotion;
use seamwright_project::failure::Failure;
use seamwright_project::files::Output;
use seamwright_project::load::Loaded;
use seamwright_project::recording::{Header, Who, most_rows, record_plan};
use seamwright_record::journal::Journal;
use seamwright_record::library::{Alarm, AuditEntry, Event, WeldResult};
use seamwright_record::trace::TraceWriter;
use seamwright_record::{DataFolder, Moment, Outcome, Recording};
use seamwright_report::WeldReport;
use std::io::Write;
use tempfile::TempDir;

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

    pub(super) fn finish(self, output: &mut Output) -> Result<(), Failure> {
        let Self { writer, scratch } = self;
        for part in writer.finish()? {
            let name = part.path.file_name().unwrap_or_default().to_string_lossy().into_owned();
            output.take(&name, &part.path)?;
        }
        // All its files have been copied.
        drop(scratch);
        Ok(())
    }
}

/// Alarms and events of a weld.
#[derive(Clone, Copy)]
pub(super) struct Happened<'a> {
    pub(super) alarms: &'a [Alarm],
    pub(super) events: &'a [Event],
}

/// Destination of a weld's rows.
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
    simulated: bool,
) -> Result<Rows, Failure> {
    let period = loaded.machine.servo_period_s;
    let Some(folder) = &record.data else {
        return Ok(Rows::Trace(Box::new(TraceFile::begin(header, period, output)?)));
    };
    let mut data = DataFolder::open(folder)?;
    let who = Who { part: record.part.clone(), simulated, welder: record.welder.clone() };
    let plan = record_plan(loaded, motion, header, who)?;
    let recording = data.begin(&plan)?;
    Ok(Rows::Weld(Box::new((recording, data))))
}

impl Rows {
    pub(super) fn row(&mut self, values: impl IntoIterator<Item = f64>) -> Result<(), Failure> {
        match self {
            Self::Trace(trace) => trace.row(values)?,
            Self::Weld(weld) => weld.0.row(values),
        }
        Ok(())
    }

    /// Ends the simulated weld of `report`, with the other `files` and the events; adds its trace to `output`.
    pub(super) fn finish(
        self,
        report: &WeldReport,
        mut files: Vec<(String, String)>,
        happened: Happened<'_>,
        stopped: bool,
        output: &mut Output,
    ) -> Result<(), Failure> {
        files.push(("report.json".to_owned(), json_text(report)?));
        let result = if stopped { WeldResult::Stopped } else { result(report) };
        self.keep("simulate", &Outcome { result, note: Message::default(), files }, happened, output)
    }

    /// Ends the weld with this outcome; adds its trace to `output`, and all of it to the library.
    pub(super) fn keep(
        self,
        verb: &str,
        outcome: &Outcome,
        happened: Happened<'_>,
        output: &mut Output,
    ) -> Result<(), Failure> {
        let (recording, mut data) = match self {
            Self::Trace(trace) => return trace.finish(output),
            Self::Weld(weld) => *weld,
        };
        let id = recording.id();
        for alarm in happened.alarms {
            data.library().add_alarm(Some(id), alarm)?;
        }
        for event in happened.events {
            data.library().add_event(Some(id), event)?;
        }
        let weld = recording.finish(&mut data, outcome)?;
        audit(&mut data, &format!("{verb}: weld {id} of part {:?}", weld.part), weld.result.name())?;
        for file in data.library().files(id)?.iter().filter(|f| f.rows.is_some()) {
            output.take(&file.name, &data.weld_folder(id).join(&file.name))?;
        }
        if !weld.note.is_empty() {
            let note = Message::new("cli-record-weld-note").text("weld", id.to_string());
            let _ = writeln!(std::io::stderr(), "{}", note.message("note", weld.note.clone()));
        }
        let _ = writeln!(std::io::stderr(), "{}", Message::new("cli-recorded").text("weld", id.to_string()));
        Ok(())
    }

    /// Number of the weld in the library, and why rows of it could not be written, if some could not.
    pub(super) fn weld(&self) -> Option<(i64, Option<&Message>)> {
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
