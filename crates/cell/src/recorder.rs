//! The files of a weld, written while it runs: trace, log, and the journal for power loss.
//!
//! The link passes cycles and notes to a thread of its own through a bounded queue. A disk that hangs fills the queue:
//! then rows are lost and counted, which is an alarm, and neither cycle nor link wait. The panel closes the record once
//! the thread has let go of its files; if the panel has gone, the next one does.

use seamwright_executive::realtime::Shown;
use seamwright_executive::{Mode, Note, Place, Raised, Reaction};
use seamwright_machine::Machine;
use seamwright_message::Message;
use seamwright_project::power_loss::{self, Places, Watch};
use seamwright_project::{run_rows, weld_events};
use seamwright_record::journal::Journal;
use seamwright_record::weld_log::Entry;
use seamwright_record::{Error, WeldFiles, WeldWriter};
use serde::{Deserialize, Serialize};
use std::collections::VecDeque;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, SyncSender, channel, sync_channel};
use std::time::{Duration, Instant};

/// Cycles and notes that wait for the disk: at 1 kHz 16 s of them, in 23 MB while it hangs.
const WAITING: usize = 1 << 14;
/// Cycles and notes of a weld that are kept until its record begins: the panel makes its entry in the library meanwhile.
const MAX_EARLY: usize = WAITING;
/// Rows reach the disk no later than this after the last one.
const FLUSH: Duration = Duration::from_millis(500);
/// Duration of the record after the end of the program and its gas, s.
const AFTER_S: f64 = 1.0;

/// A weld that is to be recorded.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct RecordStart {
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
    /// Rows of this weld are lost, or none can be written, with the reason.
    Fails(i64, Message),
}

enum Work {
    Begin(Box<RecordStart>),
    Machine(Arc<Machine>),
    Cycle(Box<Shown>),
    Note(f64, Note),
    End,
    /// Ends the thread.
    Close,
}

/// The link's end of the queue.
pub(crate) struct Recorder {
    to: SyncSender<Work>,
    news: Receiver<RecordNews>,
    /// Weld whose files are open.
    weld: Option<i64>,
    /// Rows that the queue did not take, until the thread counts them.
    lost: Arc<AtomicU64>,
}

impl Recorder {
    /// Starts the thread. `machine`: of the first program.
    pub(crate) fn start(machine: Arc<Machine>) -> std::io::Result<Self> {
        let (to, work) = sync_channel(WAITING);
        let (tell, news) = channel();
        let lost = Arc::new(AtomicU64::new(0));
        let writer = Writer { machine, tell, lost: Arc::clone(&lost), open: None, early: None };
        std::thread::Builder::new().name("record".into()).spawn(move || writer.run(&work))?;
        Ok(Self { to, news, weld: None, lost })
    }

    /// Number of the weld whose files are open.
    pub(crate) fn weld(&self) -> Option<i64> {
        self.weld
    }

    /// Begins the record of a weld; one that is open ends. Returns false if the thread does not take it.
    pub(crate) fn begin(&mut self, start: Box<RecordStart>) -> bool {
        let weld = start.files.weld;
        let taken = self.to.try_send(Work::Begin(start)).is_ok();
        if taken {
            self.weld = Some(weld);
        }
        taken
    }

    /// Passes a cycle on. Returns false if it is missing in an open record.
    pub(crate) fn cycle(&mut self, shown: &Shown) -> bool {
        if self.weld.is_none() && !matches!(shown.mode, Mode::Weld | Mode::Hold) {
            return true;
        }
        let taken = self.to.try_send(Work::Cycle(Box::new(*shown))).is_ok();
        if !taken {
            self.lost.fetch_add(1, Ordering::Relaxed);
        }
        taken
    }

    /// Passes a note on. Returns false if the thread does not take it.
    pub(crate) fn note(&mut self, t: f64, note: &Note) -> bool {
        self.to.try_send(Work::Note(t, *note)).is_ok()
    }

    /// The cycle has taken a program, with this machine: what follows belongs to it.
    pub(crate) fn program(&mut self, machine: Arc<Machine>) {
        // A thread that waits for the disk keeps the machine of its weld.
        drop(self.to.try_send(Work::End));
        drop(self.to.try_send(Work::Machine(machine)));
    }

    /// The next news, if there is any.
    pub(crate) fn news(&mut self) -> Option<RecordNews> {
        let news = self.news.try_recv().ok()?;
        if let RecordNews::Ended(weld) = &news {
            self.weld = self.weld.filter(|open| open != weld);
        }
        Some(news)
    }

    /// Ends the open record, and returns the news until its files are free, at most until `patience` is over.
    pub(crate) fn close(&mut self, patience: Duration) -> Vec<RecordNews> {
        let begin = Instant::now();
        while self.to.try_send(Work::Close).is_err() && begin.elapsed() < patience {
            std::thread::sleep(Duration::from_millis(1));
        }
        let left = || patience.saturating_sub(begin.elapsed());
        std::iter::from_fn(|| self.news.recv_timeout(left()).ok()).collect()
    }
}

/// A record that is being written.
struct Open {
    weld: i64,
    writer: WeldWriter,
    places: Places,
    watch: Watch,
    tips: run_rows::Tips,
    values: usize,
    heads: usize,
    here: Place,
    /// Its trouble was reported.
    is_told: bool,
    /// A cycle of this weld has arrived.
    runs: bool,
    /// Time of the end of the program, s.
    ended: Option<f64>,
}

/// The thread.
struct Writer {
    machine: Arc<Machine>,
    tell: Sender<RecordNews>,
    lost: Arc<AtomicU64>,
    open: Option<Open>,
    /// Cycles and notes of a weld that has begun before its record.
    early: Option<VecDeque<Work>>,
}

impl Writer {
    fn run(mut self, work: &Receiver<Work>) {
        let mut flushed = Instant::now();
        loop {
            match work.recv_timeout(FLUSH) {
                Ok(Work::Close) | Err(RecvTimeoutError::Disconnected) => break,
                Ok(work) => self.handle(work),
                Err(RecvTimeoutError::Timeout) => {}
            }
            // Rows flush themselves as they come.
            if let Some(open) = self.open.as_mut().filter(|_| flushed.elapsed() >= FLUSH) {
                open.writer.flush();
                flushed = Instant::now();
            }
        }
        self.end();
    }

    fn handle(&mut self, work: Work) {
        match work {
            Work::Begin(start) => self.begin(&start),
            Work::Machine(machine) => {
                self.machine = machine;
                self.early = None;
            }
            Work::Cycle(shown) if self.open.is_some() => self.cycle(&shown),
            Work::Note(t, note) if self.open.is_some() => self.note(t, &note),
            Work::Cycle(_) | Work::Note(..) => self.keep_early(work),
            Work::End => self.end(),
            Work::Close => {}
        }
    }

    /// Keeps what comes before the record begins, from the start of the weld.
    fn keep_early(&mut self, work: Work) {
        if let Work::Note(_, Note::Mode(from, Mode::Weld)) = &work
            && *from != Mode::Hold
        {
            self.early = Some(VecDeque::new());
            self.lost.store(0, Ordering::Relaxed);
        }
        let Some(early) = &mut self.early else { return };
        if early.len() >= MAX_EARLY && matches!(early.pop_front(), Some(Work::Cycle(_))) {
            self.lost.fetch_add(1, Ordering::Relaxed);
        }
        early.push_back(work);
    }

    fn begin(&mut self, start: &RecordStart) {
        self.end();
        match self.opened(start) {
            Ok(open) => {
                self.open = Some(open);
                for work in self.early.take().into_iter().flatten() {
                    self.handle(work);
                }
            }
            Err(e) => {
                let weld = start.files.weld;
                // The link outlives this thread.
                drop(self.tell.send(RecordNews::Fails(weld, e.message())));
                drop(self.tell.send(RecordNews::Ended(weld)));
            }
        }
    }

    fn opened(&self, start: &RecordStart) -> Result<Open, Error> {
        let files = &start.files;
        let places = power_loss::writer(Journal::open(&files.data)?);
        Ok(Open {
            weld: files.weld,
            writer: WeldWriter::open(files)?,
            places,
            watch: Watch::default(),
            tips: run_rows::Tips::default(),
            values: start.values,
            heads: start.heads,
            here: Place::default(),
            is_told: false,
            runs: false,
            ended: None,
        })
    }

    fn cycle(&mut self, shown: &Shown) {
        let Some(open) = &mut self.open else { return };
        let welds = matches!(shown.mode, Mode::Weld | Mode::Hold);
        open.runs |= welds;
        if !open.runs {
            return;
        }
        open.here = shown.place;
        open.writer.row(run_rows::row(&mut open.tips, &self.machine, shown, open.values, open.heads));
        if let Some(position) = open.watch.position(shown, u64::try_from(open.weld).unwrap_or(0)) {
            open.places.tell(position);
        }
        if let Some(why) = open.writer.trouble().filter(|_| !open.is_told) {
            open.is_told = true;
            drop(self.tell.send(RecordNews::Fails(open.weld, why.clone())));
        }
        match open.ended {
            None if !welds && shown.phase.is_none() => open.ended = Some(shown.t),
            Some(t) if shown.t - t > AFTER_S => self.end(),
            _ => {}
        }
    }

    fn note(&mut self, t: f64, note: &Note) {
        let Some(open) = &mut self.open else { return };
        if let Some(event) = weld_events::event(t, note, open.here) {
            open.writer.log(&Entry::Event(event));
        }
        match note {
            Note::PassEnds(_) => open.writer.log(&Entry::PassEnds),
            Note::Left(place) => open.writer.log(&Entry::Left { pass: place.pass, s_mm: place.s_mm }),
            Note::Alarm(raised) if raised.reaction >= Reaction::Hold => {
                open.writer.log(&Entry::Stopped(title(&self.machine, raised)));
            }
            _ => {}
        }
    }

    /// Ends the open record and lets go of its files.
    fn end(&mut self) {
        let Some(open) = self.open.take() else { return };
        let Open { weld, writer, places, .. } = open;
        let missing = self.lost.swap(0, Ordering::Relaxed);
        // The panel takes the position out of the journal once the library has the end of the weld.
        drop(places);
        if let Err(e) = writer.end(missing) {
            drop(self.tell.send(RecordNews::Fails(weld, e.message())));
        }
        drop(self.tell.send(RecordNews::Ended(weld)));
    }
}

/// The title of an alarm, with what it is about.
fn title(machine: &Machine, raised: &Raised) -> Message {
    let axes: Vec<&str> = machine.axes.iter().map(|axis| axis.name.as_str()).collect();
    let conditions: Vec<&str> = machine.interlocks.iter().map(|interlock| interlock.name.as_str()).collect();
    raised.alarm.title_of(raised.alarm.about(raised.detail, &axes, &conditions))
}
