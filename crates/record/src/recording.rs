use crate::data_folder::DataFolder;
use crate::error::{Doing, Error};
use crate::event::Event;
use crate::figures::{Basis, Figures, HEAT_INPUT};
use crate::hash::{sha256, sha256_of_file};
use crate::library::{WeldEnd, WeldFile, WeldRecord, WeldResult};
use crate::moment::Moment;
use crate::stored_message::joined;
use crate::trace::{self, Column, Trace};
use crate::weld_log::{self, Entry};
use crate::weld_writer::{WeldFiles, WeldWriter};
use crate::whole_file;
use seamwright_message::{Message, Unit};
use std::fs;
use std::io::Write;
use std::path::Path;

/// A weld that is to be recorded. Texts with the name under which the library keeps them.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Plan {
    /// Number of the part, as the shop has it.
    pub part: String,
    /// The job's title.
    pub title: String,
    /// No metal will be welded.
    pub simulated: bool,
    /// Name and text of the job file, if it is no program.
    pub job: Option<(String, String)>,
    /// Name and text of the program.
    pub program: (String, String),
    /// Name and text of the machine file.
    pub machine: (String, String),
    /// Number and text of the welding procedure.
    pub procedure: Option<(String, String)>,
    /// Name of the welder.
    pub welder: Option<String>,
    /// Columns of the trace.
    pub columns: Vec<Column>,
    /// (key, value) pairs for the trace's metadata.
    pub about: Vec<(&'static str, String)>,
    /// Rows of a part of the trace at most.
    pub most_rows: u64,
    /// Expected number of rows: the weld is refused without room for them.
    pub rows: u64,
    /// Inputs of the figures.
    pub basis: Basis,
    /// Note made at the start of the weld; may be empty.
    pub note: Message,
}

/// End of a weld.
#[derive(Debug, Clone, PartialEq)]
pub struct Outcome {
    /// Result of the weld.
    pub result: WeldResult,
    /// Further remarks; may be empty.
    pub note: Message,
    /// Files to keep with it: name and text.
    pub files: Vec<(String, String)>,
}

/// A weld that is recorded by the program that has its library open.
///
/// Rows never stop the weld: see [`WeldWriter`]. The weld's note reports lost rows in the end.
#[derive(Debug)]
pub struct Recording {
    files: WeldFiles,
    begun: Moment,
    note: Message,
    writer: WeldWriter,
}

impl Recording {
    pub(crate) fn new(files: WeldFiles, begun: Moment, note: Message) -> Result<Self, Error> {
        let writer = WeldWriter::open(&files)?;
        Ok(Self { files, begun, note, writer })
    }

    /// Number of the weld in the library.
    pub fn id(&self) -> i64 {
        self.files.weld
    }

    /// Adds a row to the trace.
    pub fn row(&mut self, values: impl IntoIterator<Item = f64>) {
        self.writer.row(values);
    }

    /// Puts all rows so far on the disk.
    pub fn flush(&mut self) {
        self.writer.flush();
    }

    /// Reason why rows could not be written, if any: an alarm should report it.
    pub fn trouble(&self) -> Option<&Message> {
        self.writer.trouble()
    }

    /// Ends the weld: converts the trace to Parquet, computes the figures and puts all of it into the library.
    ///
    /// # Errors
    /// If the library cannot be written: the trace stays, and [`DataFolder::recover`] puts it into the library later.
    /// An unfinished trace is no error; the weld's note reports it.
    pub fn finish(self, data: &mut DataFolder, outcome: &Outcome) -> Result<WeldRecord, Error> {
        let Self { files, begun, note, writer } = self;
        let folder = &files.folder();
        let ended = writer.end(0);
        let log = weld_log::read(folder)?;
        let mut notes = vec![note, outcome.note.clone()];
        notes.extend(missing(&log));
        let kept = ended
            .and_then(|()| trace::recover(folder))
            .and_then(|_| outcome.files.iter().try_for_each(|(name, text)| write(&folder.join(name), text.as_bytes())));
        notes.extend(kept.err().map(|why| Message::new("record-incomplete").message("why", why.message())));
        let end = Settled {
            result: outcome.result,
            ended: lasted(&log).map_or_else(Moment::now, |ms| begun.after_ms(ms)),
            note: joined(notes),
            events: Vec::new(),
        };
        settle(data, files.weld, folder, end)
    }
}

/// The time that a weld took by its log, ms; `None` if its end is not in it.
pub(crate) fn lasted(log: &[Entry]) -> Option<u64> {
    log.iter().rev().find_map(|entry| if let Entry::Ended { lasted_ms } = entry { Some(*lasted_ms) } else { None })
}

/// The note on what is missing in the record of a weld, by its log.
pub(crate) fn missing(log: &[Entry]) -> Option<Message> {
    log.iter().rev().find_map(|entry| match entry {
        Entry::RowsLost { rows, why } => {
            let rows = usize::try_from(*rows).unwrap_or(usize::MAX);
            Some(Message::new("record-rows-lost").count("n", rows).message("why", why.clone()))
        }
        Entry::Incomplete(why) => Some(Message::new("record-incomplete").message("why", why.clone())),
        _ => None,
    })
}

/// Data of a weld for the library beside the contents of its folder.
pub(crate) struct Settled {
    pub(crate) result: WeldResult,
    pub(crate) ended: Moment,
    pub(crate) note: Message,
    pub(crate) events: Vec<Event>,
}

fn write(path: &Path, bytes: &[u8]) -> Result<(), Error> {
    let mut file = whole_file::create(path)?;
    file.write_all(bytes).map_err(|e| Error::io(path, Doing::Write, e))?;
    whole_file::finish(file, path)
}

/// Puts the contents of a weld's folder into the library, with the weld's end.
pub(crate) fn settle(data: &mut DataFolder, id: i64, folder: &Path, end: Settled) -> Result<WeldRecord, Error> {
    let Settled { result, ended, mut note, events } = end;
    let files = files_in(folder)?;
    let traces = files.iter().filter(|f| f.rows.is_some()).map(|f| Trace::open(&folder.join(&f.name)));
    let figures = traces.collect::<Result<Vec<_>, _>>().and_then(|traces| {
        let basis = data.library().basis(id)?;
        Figures::of(&traces, &basis)
    });
    let figures = figures.unwrap_or_else(|why| {
        let why = Message::new("record-no-figures").message("why", why.message());
        note = joined([std::mem::take(&mut note), why]);
        Figures::default()
    });
    let beyond: f64 = figures.values.iter().filter(|v| v.name == HEAT_INPUT).map(|v| v.outside_mm).sum();
    let result = match result {
        // Energy over a way, which averages out the noise of the arc: the qualified range of the procedure was left.
        WeldResult::Good if beyond > 0.0 => {
            let why = Message::new("record-heat-input-outside").quantity("length", beyond, Unit::Mm, 0);
            note = joined([note, why]);
            WeldResult::Deviating
        }
        other => other,
    };
    let end = WeldEnd {
        ended,
        result,
        note,
        heat_input_kj_mm: figures.heat_input_kj_mm,
        worst_deviation_mm: figures.worst_deviation_mm,
        values: figures.values,
        files,
        events,
    };
    data.library_mut().end_weld(id, &end)?;
    // The library has all of it.
    drop(fs::remove_file(folder.join(weld_log::NAME)));
    data.library().weld(id)
}

/// The files in a weld's folder, with their hashes; traces with their rows.
fn files_in(folder: &Path) -> Result<Vec<WeldFile>, Error> {
    let mut files = Vec::new();
    if !folder.exists() {
        return Ok(files);
    }
    let unreadable = |e| Error::io(folder, Doing::Read, e);
    for entry in fs::read_dir(folder).map_err(unreadable)? {
        let path = entry.map_err(unreadable)?.path();
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        if name.starts_with('.') || name.ends_with(".raw") || name == weld_log::NAME {
            continue;
        }
        let (sha256, bytes) = sha256_of_file(&path)?;
        let rows = if name.ends_with(".parquet") { Some(Trace::open(&path)?.rows()) } else { None };
        files.push(WeldFile { name, sha256, bytes, rows });
    }
    // Parts of the trace in their order.
    files.sort_by_key(|f| (f.rows.is_none(), f.name.len(), f.name.clone()));
    Ok(files)
}

pub(crate) fn hash_of(text: &str) -> String {
    sha256(text.as_bytes())
}
