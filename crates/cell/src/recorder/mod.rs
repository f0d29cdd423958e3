//! The files of a weld, written while it runs: trace, log, and the journal for power loss.
//!
//! The link passes cycles and notes to a thread of its own. A disk that hangs fills the queue: then rows are lost and
//! counted, which is an alarm, and neither cycle nor link wait. The cell numbers the starts of its welds; the panel enters
//! each into the library and asks for its record by that number. Rows from the start of the weld on wait for that.
//!
//! The panel closes the record once the thread has let go of the files; if the panel has gone, the next one does.

mod open;
#[cfg(test)]
mod tests;
mod writer;

use seamwright_executive::realtime::Shown;
use seamwright_executive::{Mode, Note};
use seamwright_machine::Machine;
use seamwright_message::Message;
use seamwright_record::WeldFiles;
use serde::{Deserialize, Serialize};
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, Sender, channel};
use std::time::{Duration, Instant};
use writer::Writer;

/// Cycles that wait for the disk, or for the start of a record: at 1 kHz 16 s of them, in 23 MB while it hangs.
const WAITING: usize = 1 << 14;
/// Duration of the record after the end of the program and its gas, s.
const AFTER_S: f64 = 1.0;

/// A weld that is to be recorded.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct RecordStart {
    /// The cell's number of the start of the weld.
    pub start: u64,
    /// Number of passes to be welded.
    pub passes: usize,
    /// Its folder and columns.
    pub files: WeldFiles,
    /// Number of process values, and of tracked heads, that the columns have.
    pub values: usize,
    /// See `values`.
    pub heads: usize,
}

/// News of the thread.
pub(crate) enum RecordNews {
    /// The files of this weld are written and free.
    Ended(i64),
    /// Rows of the weld with this start are lost, or none can be written, with the reason.
    Fails(u64, Message),
}

enum Work {
    Begin(Box<RecordStart>),
    Machine(Arc<Machine>),
    Cycle(Box<Shown>),
    Note(f64, Note),
    /// Ends the thread.
    Close,
}

/// True for the note of the start of a weld.
fn begins(note: &Note) -> bool {
    matches!(note, Note::Mode(from, Mode::Weld) if *from != Mode::Hold)
}

/// Numbers that both ends count.
#[derive(Default)]
struct Counts {
    /// Cycles on their way to the thread.
    waiting: AtomicUsize,
    /// Cycles that were not sent, until the thread counts them.
    lost: AtomicU64,
}

/// The link's end of the queue.
pub(crate) struct Recorder {
    to: Sender<Work>,
    news: Receiver<RecordNews>,
    counts: Arc<Counts>,
    /// Number of the last start of a weld.
    starts: u64,
    /// Its weld, once its record was asked for.
    weld: Option<i64>,
    /// Welds whose files are open, or about to be.
    open: Vec<i64>,
    /// Cycles belong to the weld until then, s.
    until: f64,
}

impl Recorder {
    /// Starts the thread. `machine`: of the first program.
    pub(crate) fn start(machine: Arc<Machine>) -> std::io::Result<Self> {
        let (to, work) = channel();
        let (tell, news) = channel();
        let counts = Arc::new(Counts::default());
        let writer = Writer::new(machine, tell, Arc::clone(&counts));
        std::thread::Builder::new().name("record".into()).spawn(move || writer.run(&work))?;
        Ok(Self { to, news, counts, starts: 0, weld: None, open: Vec::new(), until: f64::NEG_INFINITY })
    }

    /// Number of the last start of a weld, and its weld in the library.
    pub(crate) fn last(&self) -> (u64, Option<i64>) {
        (self.starts, self.weld)
    }

    /// Welds whose files are open, or about to be.
    pub(crate) fn open(&self) -> &[i64] {
        &self.open
    }

    /// Begins the record of a weld.
    pub(crate) fn begin(&mut self, start: Box<RecordStart>) {
        if start.start == self.starts {
            self.weld = Some(start.files.weld);
        }
        self.open.push(start.files.weld);
        self.send(Work::Begin(start));
    }

    /// Notes are few, and none may be lost: only cycles are counted against the room of the queue.
    fn send(&self, work: Work) {
        // The thread ends with this recorder.
        drop(self.to.send(work));
    }

    /// Passes a cycle on, if it may belong to a weld. Returns false if there is no room for it.
    pub(crate) fn cycle(&mut self, shown: &Shown) -> bool {
        if matches!(shown.mode, Mode::Weld | Mode::Hold) || shown.phase.is_some() {
            self.until = shown.t + AFTER_S + 0.5;
        }
        if shown.t > self.until {
            return true;
        }
        if self.counts.waiting.load(Ordering::Relaxed) >= WAITING {
            self.counts.lost.fetch_add(1, Ordering::Relaxed);
            return false;
        }
        self.counts.waiting.fetch_add(1, Ordering::Relaxed);
        self.send(Work::Cycle(Box::new(*shown)));
        true
    }

    /// Passes a note on. Returns the number of the start if a weld starts.
    pub(crate) fn note(&mut self, t: f64, note: &Note) -> Option<u64> {
        self.send(Work::Note(t, *note));
        begins(note).then(|| {
            (self.starts, self.weld) = (self.starts + 1, None);
            self.starts
        })
    }

    /// The cycle has taken a program, with this machine: what follows belongs to it.
    pub(crate) fn program(&mut self, machine: Arc<Machine>) {
        self.send(Work::Machine(machine));
    }

    /// The next news, if there is any.
    pub(crate) fn news(&mut self) -> Option<RecordNews> {
        let news = self.news.try_recv().ok()?;
        self.heard(&news);
        Some(news)
    }

    fn heard(&mut self, news: &RecordNews) {
        if let RecordNews::Ended(weld) = news {
            self.open.retain(|open| open != weld);
            self.weld = self.weld.filter(|open| open != weld);
        }
    }

    /// Ends all records, and returns the news until their files are free, at most until `patience` is over.
    pub(crate) fn close(&mut self, patience: Duration) -> Vec<RecordNews> {
        let begin = Instant::now();
        self.send(Work::Close);
        let mut all = Vec::new();
        while let Ok(news) = self.news.recv_timeout(patience.saturating_sub(begin.elapsed())) {
            self.heard(&news);
            all.push(news);
        }
        all
    }
}
