//! The log of a weld: what happens beside its rows, in its folder until the library has it.
//!
//! One JSON object a line in `log.jsonl`. Each line is one write to the end of the file, so that two processes may write:
//! the cell that welds, and its panel. A torn last line is left out; any other damaged line makes the log incomplete.

use crate::error::{Doing, Error};
use crate::event::{Event, Place};
#[cfg(feature = "library")]
use crate::library::WeldResult;
use crate::moment::Moment;
use crate::private_files;
#[cfg(feature = "library")]
use crate::stored_message::joined;
use seamwright_message::Message;
use serde::{Deserialize, Serialize};
use std::fs::File;
use std::io::{Read, Write};
use std::path::{Path, PathBuf};

/// Name of the file in the folder of a weld.
pub(crate) const NAME: &str = "log.jsonl";
/// Bytes of a log beyond which events are left out of it, and beyond which it is not read.
const MAX_BYTES: u64 = 16 << 20;
/// Bytes of some thousand events.
const USUAL_BYTES: u64 = 1 << 20;

/// A line of the log.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Entry {
    /// The record begins.
    Begun {
        /// Number of passes to be welded.
        passes: usize,
    },
    /// An event.
    Event(#[serde(with = "LoggedEvent")] Event),
    /// A pass has ended.
    PassEnds,
    /// A pass was left.
    Left {
        /// The pass, from 1.
        pass: usize,
        /// Path length up to which it is welded, mm.
        s_mm: f64,
    },
    /// Reason for which the weld was held or stopped.
    Stopped(Message),
    /// Rows are missing in the trace.
    RowsLost {
        /// Their number.
        rows: u64,
        /// Why.
        why: Message,
    },
    /// Lines are missing in this log.
    Incomplete(Message),
    /// The program has ended; all rows are in the trace.
    Ended {
        /// Time since the start of the record, ms.
        lasted_ms: u64,
    },
}

#[derive(Serialize, Deserialize)]
#[serde(remote = "Event")]
struct LoggedEvent {
    #[serde(with = "LoggedMoment")]
    at: Moment,
    text: Message,
    place: Place,
}

#[derive(Serialize, Deserialize)]
#[serde(remote = "Moment")]
struct LoggedMoment(i64);

/// Appends to the log of a weld.
#[derive(Debug)]
pub struct WeldLog {
    file: File,
    path: PathBuf,
    /// The last line may be torn.
    is_torn: bool,
}

impl WeldLog {
    /// Opens the log in the folder of a weld, made if missing.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn open(folder: &Path) -> Result<Self, Error> {
        let path = folder.join(NAME);
        let file = private_files::options().append(true).create(true).open(&path);
        let file = file.map_err(|e| Error::io(&path, Doing::Write, e))?;
        Ok(Self { file, path, is_torn: false })
    }

    /// Reserves room on the disk for the lines of a usual weld.
    ///
    /// # Errors
    /// If the disk has not so much room.
    pub fn reserve(&self) -> Result<(), Error> {
        let failed = |e| Error::io(&self.path, Doing::Write, e);
        let length = self.file.metadata().map_err(failed)?.len();
        private_files::reserve(&self.file, length, USUAL_BYTES).map_err(failed)
    }

    /// Appends a line; it is with the system when the call returns, and on the disk after [`WeldLog::sync`].
    ///
    /// # Errors
    /// If it cannot be written. Events of a log that has become too long are left out.
    pub fn write(&mut self, entry: &Entry) -> Result<(), Error> {
        let failed = |e| Error::io(&self.path, Doing::Write, e);
        if matches!(entry, Entry::Event(_)) && self.file.metadata().map_err(failed)?.len() > MAX_BYTES / 2 {
            return Ok(());
        }
        let mut line = if self.is_torn { vec![b'\n'] } else { Vec::new() };
        serde_json::to_writer(&mut line, entry).map_err(|e| failed(e.into()))?;
        line.push(b'\n');
        let written = self.file.write_all(&line);
        self.is_torn = written.is_err();
        written.map_err(|e| Error::io(&self.path, Doing::Write, e))
    }

    /// Waits until all lines are on the disk.
    ///
    /// # Errors
    /// If they cannot be written.
    pub fn sync(&self) -> Result<(), Error> {
        self.file.sync_data().map_err(|e| Error::io(&self.path, Doing::Write, e))
    }
}

/// Reads the log in the folder of a weld; a weld without a log has no entries. A damaged line becomes
/// [`Entry::Incomplete`], but a torn last line is left out.
///
/// # Errors
/// If it cannot be read.
pub fn read(folder: &Path) -> Result<Vec<Entry>, Error> {
    let path = folder.join(NAME);
    let mut bytes = Vec::new();
    match File::open(&path) {
        Ok(file) => file.take(MAX_BYTES).read_to_end(&mut bytes).map_err(|e| Error::io(&path, Doing::Read, e))?,
        Err(e) if e.kind() == std::io::ErrorKind::NotFound => return Ok(Vec::new()),
        Err(e) => return Err(Error::io(&path, Doing::Read, e)),
    };
    let lines = bytes.split_inclusive(|byte| *byte == b'\n').filter_map(|line| line.strip_suffix(b"\n"));
    let damaged = || Entry::Incomplete(Message::new("record-log-damaged"));
    let lines = lines.filter(|line| !line.is_empty());
    Ok(lines.map(|line| serde_json::from_slice(line).unwrap_or_else(|_| damaged())).collect())
}

/// Summary of the log of a weld.
#[cfg(feature = "library")]
#[derive(Debug, Default)]
pub(crate) struct LogSummary {
    pub(crate) events: Vec<Event>,
    /// Number of passes to be welded; `None`: somebody else decides the result.
    wanted: Option<usize>,
    passes: usize,
    left: Option<Message>,
    stopped: Option<Message>,
    /// Lines are missing.
    is_incomplete: bool,
}

#[cfg(feature = "library")]
impl LogSummary {
    pub(crate) fn of(log: &[Entry]) -> Self {
        let mut summary = Self::default();
        for entry in log {
            match entry {
                Entry::Begun { passes } => summary.wanted = Some(*passes),
                Entry::Event(event) => summary.events.push(event.clone()),
                Entry::PassEnds => summary.passes += 1,
                Entry::Left { pass, s_mm } => {
                    let left = Message::new("cell-note-left").pass("pass", *pass);
                    summary.left = Some(left.quantity("at", *s_mm, seamwright_message::Unit::Mm, 2));
                }
                Entry::Stopped(cause) => {
                    summary.stopped.get_or_insert_with(|| cause.clone());
                }
                Entry::Incomplete(_) => summary.is_incomplete = true,
                Entry::RowsLost { .. } | Entry::Ended { .. } => {}
            }
        }
        summary
    }

    fn is_whole(&self) -> bool {
        self.left.is_none() && self.wanted.is_none_or(|wanted| self.passes >= wanted)
    }

    /// Result of a weld that has ended. Without the number of its passes it is not known to be good.
    pub(crate) fn result(&self) -> WeldResult {
        match &self.stopped {
            _ if self.wanted.is_none() => WeldResult::Interrupted,
            // It was held by an alarm and then continued to its end; or an alarm may be missing.
            _ if self.is_whole() && (self.stopped.is_some() || self.is_incomplete) => WeldResult::Deviating,
            None if self.is_whole() => WeldResult::Good,
            _ => WeldResult::Stopped,
        }
    }

    /// Why it was stopped, and where it was left; empty for a weld that ended well or was never begun.
    pub(crate) fn note(&self) -> Message {
        let stopped = self.stopped.as_ref();
        let stopped = stopped.map(|cause| Message::new("cell-note-stopped").message("cause", cause.clone()));
        let left = self.left.clone();
        let unfinished = (left.is_none() && !self.is_whole()).then(|| Message::new("cell-note-not-finished"));
        joined(stopped.into_iter().chain(left).chain(unfinished))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn entries() -> Vec<Entry> {
        let text = Message::new("cell-event-pass-left").pass("pass", 2);
        let place = Place { pass: Some(2), s_mm: Some(12.5), t_s: Some(3.25) };
        vec![
            Entry::Begun { passes: 3 },
            Entry::Event(Event { at: Moment(1_700_000_000_123), text: text.clone(), place }),
            Entry::PassEnds,
            Entry::Left { pass: 2, s_mm: 0.1 },
            Entry::Stopped(text.clone()),
            Entry::RowsLost { rows: 7, why: text },
            Entry::Ended { lasted_ms: 12 },
        ]
    }

    #[test]
    fn lines_of_two_writers_are_read_and_a_torn_one_is_left_out() {
        let folder = tempfile::tempdir().unwrap();
        assert_eq!(read(folder.path()).unwrap(), []);
        let mut writers = [WeldLog::open(folder.path()).unwrap(), WeldLog::open(folder.path()).unwrap()];
        let entries = entries();
        for (i, entry) in entries.iter().enumerate() {
            writers[i % 2].write(entry).unwrap();
        }
        writers[0].sync().unwrap();
        assert_eq!(read(folder.path()).unwrap(), entries);
        let path = folder.path().join(NAME);
        let whole = std::fs::read(&path).unwrap();
        // A damaged line in the middle does not hide those after it.
        let second = whole.iter().position(|byte| *byte == b'\n').unwrap() + 1;
        let mut damaged = whole.clone();
        damaged[second] = b'x';
        std::fs::write(&path, damaged).unwrap();
        let lines = read(folder.path()).unwrap();
        assert!(matches!(lines[1], Entry::Incomplete(_)) && lines[2..] == entries[2..]);
        for cut in 0..whole.len() {
            std::fs::write(&path, &whole[..cut]).unwrap();
            let read = read(folder.path()).unwrap();
            let lines = whole[..cut].iter().filter(|byte| **byte == b'\n').count();
            assert_eq!(read, entries[..lines]);
        }
    }

    /// Events cannot fill the disk, and what decides the result of the weld is still taken.
    #[test]
    fn a_long_log_takes_no_more_events() {
        let folder = tempfile::tempdir().unwrap();
        let mut log = WeldLog::open(folder.path()).unwrap();
        let text = Message::verbatim("x".repeat(1 << 16));
        let event = Entry::Event(Event { at: Moment(1), text, place: Place::default() });
        (0..1000).for_each(|_| log.write(&event).unwrap());
        log.write(&Entry::Ended { lasted_ms: 1 }).unwrap();
        assert!(std::fs::metadata(folder.path().join(NAME)).unwrap().len() < MAX_BYTES);
        assert_eq!(read(folder.path()).unwrap().last(), Some(&Entry::Ended { lasted_ms: 1 }));
    }
}
