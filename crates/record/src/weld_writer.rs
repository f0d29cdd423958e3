use crate::error::Error;
use crate::trace::{Column, TraceWriter};
use crate::weld_log::{Entry, WeldLog};
use seamwright_message::Message;
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};
use std::time::Instant;

/// A weld whose files are to be written.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct WeldFiles {
    /// Number of the weld in the library.
    pub weld: i64,
    /// The data folder.
    pub data: PathBuf,
    /// Columns of the trace.
    pub columns: Vec<Column>,
    /// (key, value) pairs for the trace's metadata.
    pub about: Vec<(String, String)>,
    /// Rows of a part of the trace at most.
    pub most_rows: u64,
    /// Expected number of rows.
    pub rows: u64,
}

impl WeldFiles {
    /// Folder of the weld's files.
    pub fn folder(&self) -> PathBuf {
        weld_folder(&self.data, self.weld)
    }
}

/// Folder of the files of a weld in a data folder.
pub(crate) fn weld_folder(data: &Path, weld: i64) -> PathBuf {
    data.join("welds").join(format!("{weld:06}"))
}

/// Writes the files of a weld while it runs: trace and log.
///
/// Rows never stop the weld: rows that fail to be written are counted, and reported by [`WeldWriter::trouble`].
#[derive(Debug)]
pub struct WeldWriter {
    begun: Instant,
    trace: TraceWriter,
    log: WeldLog,
    trouble: Option<Message>,
}

impl WeldWriter {
    /// Creates the trace, with room on the disk for its rows, and opens the log.
    ///
    /// # Errors
    /// If they cannot be written, or the disk has no room.
    pub fn open(files: &WeldFiles) -> Result<Self, Error> {
        let about: Vec<_> = files.about.iter().map(|(key, value)| (key.as_str(), value.clone())).collect();
        let folder = files.folder();
        let trace = TraceWriter::create(&folder.join("trace.parquet"), &files.columns, &about, files.most_rows)?;
        trace.reserve(files.rows)?;
        let log = WeldLog::open(&folder)?;
        log.reserve()?;
        Ok(Self { begun: Instant::now(), trace, log, trouble: None })
    }

    /// Adds a row to the trace.
    pub fn row(&mut self, values: impl IntoIterator<Item = f64>) {
        let result = self.trace.row(values);
        self.keep(result);
    }

    /// Adds a line to the log.
    pub fn log(&mut self, entry: &Entry) {
        let result = self.log.write(entry);
        self.keep(result);
    }

    /// Puts all rows and lines so far on the disk.
    pub fn flush(&mut self) {
        let result = self.trace.flush().and_then(|()| self.log.sync());
        self.keep(result);
    }

    fn keep(&mut self, result: Result<(), Error>) {
        if let Err(error) = result {
            self.trouble.get_or_insert_with(|| error.message());
        }
    }

    /// Reason why rows or lines could not be written, if any: an alarm should report it.
    pub fn trouble(&self) -> Option<&Message> {
        self.trouble.as_ref()
    }

    /// Ends trace and log; `missing`: rows that did not come here. The record can be closed then.
    ///
    /// # Errors
    /// If the last rows or lines cannot be written.
    pub fn end(mut self, missing: u64) -> Result<(), Error> {
        self.flush();
        let late = || Message::new("record-rows-late");
        match (self.trace.lost() + missing, self.trouble.take()) {
            (0, None) => {}
            (0, Some(why)) => self.log(&Entry::Incomplete(why)),
            (rows, why) => self.log(&Entry::RowsLost { rows, why: why.unwrap_or_else(late) }),
        }
        let lasted_ms = u64::try_from(self.begun.elapsed().as_millis()).unwrap_or(u64::MAX);
        let closed = self.trace.close();
        let logged = self.log.write(&Entry::Ended { lasted_ms }).and_then(|()| self.log.sync());
        closed.and(logged)
    }
}
