//! The files of a weld, written while it runs: trace, log, and the journal for power loss.
//!
//! The link passes cycles and notes to a thread of its own. A disk that hangs fills the queue: then rows are lost and
//! counted, which is an alarm, and neither cycle nor link wait. The cell numbers the starts of its welds; the panel enters
//! each into the library and asks for its record by that number. Rows from the start of the weld on wait for that.
//!
//! The panel closes the record once the thread has let go of the files; if the panel has gone, the next one does.

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
use std::sync::atomic::{AtomicU64, AtomicUsize, Ordering};
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender, channel};
use std::time::{Duration, Instant};

/// Cycles that wait for the disk, or for the start of a record: at 1 kHz 16 s of them, in 23 MB while it hangs.
const WAITING: usize = 1 << 14;
/// Welds that wait for the start of their record; beyond that the oldest has none.
const MAX_WELDS: usize = 8;
/// Rows reach the disk no later than this after the last one.
const FLUSH: Duration = Duration::from_millis(500);
/// Duration of the record after the end of the program and its gas, s.
const AFTER_S: f64 = 1.0;
/// Period of attempts to open the journal, which the panel may hold for a moment.
const JOURNAL_AGAIN: Duration = Duration::from_millis(200);
/// A journal that cannot be opened for this long is reported.
const JOURNAL_BUSY: Duration = Duration::from_secs(5);

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

/// Files of a weld that are being written.
struct Open {
    weld: i64,
    writer: WeldWriter,
    start: Box<RecordStart>,
    /// The journal, once it is free, and the time of the last and the first attempt.
    places: Option<Places>,
    journal_tried: Option<Instant>,
    begun: Instant,
    watch: Watch,
    tips: run_rows::Tips,
    passes: usize,
    is_left: bool,
}

/// A weld from its start on.
struct Weld {
    start: u64,
    machine: Arc<Machine>,
    /// Cycles and notes before its record begins.
    kept: Vec<Work>,
    /// Cycles that are missing among them.
    missing: u64,
    open: Option<Open>,
    /// Its record could not be opened.
    is_refused: bool,
    is_told: bool,
    here: Place,
    /// A cycle of this weld has arrived.
    runs: bool,
    /// Time of the end of the program, s.
    ended: Option<f64>,
    is_over: bool,
}

/// The thread.
struct Writer {
    machine: Arc<Machine>,
    tell: Sender<RecordNews>,
    counts: Arc<Counts>,
    /// Welds whose record is open or has not begun; the last one may run.
    welds: VecDeque<Weld>,
    /// Cycles kept for welds whose record has not begun.
    kept: usize,
    /// Number of the last start.
    starts: u64,
}

impl Writer {
    fn new(machine: Arc<Machine>, tell: Sender<RecordNews>, counts: Arc<Counts>) -> Self {
        Self { machine, tell, counts, welds: VecDeque::new(), kept: 0, starts: 0 }
    }

    fn run(mut self, work: &Receiver<Work>) {
        let mut flushed = Instant::now();
        loop {
            match work.recv_timeout(FLUSH) {
                Ok(Work::Close) | Err(RecvTimeoutError::Disconnected) => break,
                Ok(work) => self.handle(work),
                Err(RecvTimeoutError::Timeout) => {}
            }
            if flushed.elapsed() >= FLUSH {
                flushed = Instant::now();
                let open = self.welds.iter_mut().filter_map(|weld| weld.open.as_mut());
                open.for_each(|open| open.writer.flush());
            }
        }
        while let Some(weld) = self.welds.pop_front() {
            self.end(weld);
        }
    }

    fn handle(&mut self, work: Work) {
        match work {
            Work::Begin(start) => self.begin(start),
            Work::Machine(machine) => {
                self.machine = machine;
                self.last_is_over();
            }
            Work::Note(t, note) => {
                if begins(&note) {
                    self.last_is_over();
                    self.next_weld();
                }
                self.note(t, note);
            }
            Work::Cycle(shown) => {
                self.counts.waiting.fetch_sub(1, Ordering::Relaxed);
                self.cycle(shown);
            }
            Work::Close => {}
        }
    }

    fn next_weld(&mut self) {
        // Cycles that were lost before this weld belong to none.
        self.counts.lost.store(0, Ordering::Relaxed);
        self.starts += 1;
        if self.welds.len() >= MAX_WELDS
            && let Some(oldest) = self.welds.pop_front()
        {
            self.kept -= oldest.cycles_kept();
            self.end(oldest);
        }
        self.welds.push_back(Weld::new(self.starts, Arc::clone(&self.machine)));
    }

    fn cycle(&mut self, shown: Box<Shown>) {
        let lost = self.counts.lost.swap(0, Ordering::Relaxed);
        let room = self.kept < WAITING;
        let Some(weld) = self.welds.back_mut().filter(|weld| !weld.is_over) else { return };
        weld.missing += lost;
        let welds = matches!(shown.mode, Mode::Weld | Mode::Hold);
        weld.runs |= welds;
        if !weld.runs {
            return;
        }
        let (t, rests) = (shown.t, !welds && shown.phase.is_none());
        if weld.open.is_some() {
            weld.row(&shown);
        } else if room && !weld.is_refused {
            weld.kept.push(Work::Cycle(shown));
            self.kept += 1;
        } else {
            weld.missing += 1;
        }
        if weld.missing > 0 {
            weld.fails(&self.tell, Message::new("record-rows-late"));
        }
        weld.report(&self.tell);
        match weld.ended {
            None if rests => weld.ended = Some(t),
            Some(end) if t - end > AFTER_S => self.last_is_over(),
            _ => {}
        }
    }

    fn note(&mut self, t: f64, note: Note) {
        let Some(weld) = self.welds.back_mut().filter(|weld| !weld.is_over) else { return };
        if weld.open.is_some() {
            weld.log(t, &note);
        } else {
            weld.kept.push(Work::Note(t, note));
        }
        weld.report(&self.tell);
    }

    fn begin(&mut self, start: Box<RecordStart>) {
        let number = start.start;
        let Some(at) = self.welds.iter().position(|weld| weld.start == number && weld.open.is_none()) else {
            drop(self.tell.send(RecordNews::Fails(number, Message::new("record-rows-late"))));
            drop(self.tell.send(RecordNews::Ended(start.files.weld)));
            return;
        };
        let weld = &mut self.welds[at];
        self.kept -= weld.cycles_kept();
        weld.open(start, &self.tell);
        weld.report(&self.tell);
        if weld.is_over
            && let Some(weld) = self.welds.remove(at)
        {
            self.end(weld);
        }
    }

    /// Whatever follows does not belong to the last weld.
    fn last_is_over(&mut self) {
        let Some(weld) = self.welds.back_mut().filter(|weld| !weld.is_over) else { return };
        weld.is_over = true;
        if (weld.open.is_some() || weld.is_refused)
            && let Some(weld) = self.welds.pop_back()
        {
            self.end(weld);
        }
    }

    /// Ends the record of a weld, if it has one, and lets go of its files.
    fn end(&self, mut weld: Weld) {
        weld.missing += self.counts.lost.swap(0, Ordering::Relaxed);
        let Some(open) = weld.open.take() else { return };
        let Open { weld: id, writer, places, passes, is_left, start, .. } = open;
        if let Some(places) = places {
            // A weld that ended well is not one to be continued. Otherwise its position stays until the library has it.
            let is_whole = passes >= start.passes && !is_left;
            let cleared = if is_whole { places.over(u64::try_from(id).unwrap_or(0)) } else { Ok(()) };
            if let Err(e) = cleared {
                drop(self.tell.send(RecordNews::Fails(weld.start, e.message())));
            }
        }
        if let Err(e) = writer.end(weld.missing) {
            drop(self.tell.send(RecordNews::Fails(weld.start, e.message())));
        }
        drop(self.tell.send(RecordNews::Ended(id)));
    }
}

impl Weld {
    fn new(start: u64, machine: Arc<Machine>) -> Self {
        Self {
            start,
            machine,
            kept: Vec::new(),
            missing: 0,
            open: None,
            is_refused: false,
            is_told: false,
            here: Place::default(),
            runs: false,
            ended: None,
            is_over: false,
        }
    }

    fn cycles_kept(&self) -> usize {
        self.kept.iter().filter(|work| matches!(work, Work::Cycle(_))).count()
    }

    /// Opens its files and writes what was kept for them.
    fn open(&mut self, start: Box<RecordStart>, tell: &Sender<RecordNews>) {
        let kept = std::mem::take(&mut self.kept);
        match Open::new(start) {
            Ok(open) => self.open = Some(open),
            Err((weld, e)) => {
                self.is_refused = true;
                self.fails(tell, e.message());
                drop(tell.send(RecordNews::Ended(weld)));
                return;
            }
        }
        for work in kept {
            match work {
                Work::Cycle(shown) => self.row(&shown),
                Work::Note(t, note) => self.log(t, &note),
                Work::Begin(_) | Work::Machine(_) | Work::Close => {}
            }
        }
    }

    fn row(&mut self, shown: &Shown) {
        self.here = shown.place;
        if let Some(open) = &mut self.open {
            open.row(&self.machine, shown);
        }
    }

    fn log(&mut self, t: f64, note: &Note) {
        if let Some(open) = &mut self.open {
            open.log(&self.machine, t, note, self.here);
        }
    }

    /// Reports trouble of its files.
    fn report(&mut self, tell: &Sender<RecordNews>) {
        if let Some(why) = self.open.as_ref().and_then(Open::trouble) {
            self.fails(tell, why);
        }
    }

    /// Reports trouble once.
    fn fails(&mut self, tell: &Sender<RecordNews>, why: Message) {
        if !std::mem::replace(&mut self.is_told, true) {
            // The link outlives this thread.
            drop(tell.send(RecordNews::Fails(self.start, why)));
        }
    }
}

impl Open {
    fn new(start: Box<RecordStart>) -> Result<Self, (i64, Error)> {
        let weld = start.files.weld;
        Ok(Self {
            weld,
            writer: WeldWriter::open(&start.files).map_err(|e| (weld, e))?,
            start,
            places: None,
            journal_tried: None,
            begun: Instant::now(),
            watch: Watch::default(),
            tips: run_rows::Tips::default(),
            passes: 0,
            is_left: false,
        })
    }

    fn row(&mut self, machine: &Machine, shown: &Shown) {
        let (values, heads) = (self.start.values, self.start.heads);
        self.writer.row(run_rows::row(&mut self.tips, machine, shown, values, heads));
        if self.places.is_none() && self.journal_tried.is_none_or(|at| at.elapsed() >= JOURNAL_AGAIN) {
            self.journal_tried = Some(Instant::now());
            // The last weld's journal may be in use for a moment.
            self.places = Journal::open(&self.start.files.data).ok().map(power_loss::writer);
        }
        if let Some(places) = &self.places
            && let Some(position) = self.watch.position(shown, u64::try_from(self.weld).unwrap_or(0))
        {
            places.tell(position);
        }
    }

    fn log(&mut self, machine: &Machine, t: f64, note: &Note, here: Place) {
        if let Some(event) = weld_events::event(t, note, here) {
            self.writer.log(&Entry::Event(event));
        }
        match note {
            Note::PassEnds(_) => {
                self.passes += 1;
                self.writer.log(&Entry::PassEnds);
            }
            Note::Left(place) => {
                self.is_left = true;
                self.writer.log(&Entry::Left { pass: place.pass, s_mm: place.s_mm });
            }
            Note::Alarm(raised) if raised.reaction >= Reaction::Hold => {
                self.writer.log(&Entry::Stopped(title(machine, raised)));
            }
            _ => {}
        }
    }

    fn trouble(&self) -> Option<Message> {
        let busy = self.places.is_none() && self.journal_tried.is_some() && self.begun.elapsed() > JOURNAL_BUSY;
        let no_journal = || {
            let path = self.start.files.data.join("position.a");
            busy.then(|| Error::Busy { path }.message())
        };
        self.writer.trouble().cloned().or_else(no_journal)
    }
}

/// The title of an alarm, with what it is about.
fn title(machine: &Machine, raised: &Raised) -> Message {
    let axes: Vec<&str> = machine.axes.iter().map(|axis| axis.name.as_str()).collect();
    let conditions: Vec<&str> = machine.interlocks.iter().map(|interlock| interlock.name.as_str()).collect();
    raised.alarm.title_of(raised.alarm.about(raised.detail, &axes, &conditions))
}

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_executive::{Alarm, AlarmState, Orders, ProcessState, Reports, Status};
    use seamwright_machine::shipped;
    use seamwright_record::library::WeldResult;
    use seamwright_record::trace::{Column, Kind, Trace};
    use seamwright_record::{DataFolder, Plan};
    use tempfile::TempDir;

    /// A thread's work, done here, on a data folder.
    struct Bench {
        writer: Writer,
        news: Receiver<RecordNews>,
        folder: TempDir,
        t: f64,
    }

    impl Bench {
        fn new() -> Self {
            let (tell, news) = channel();
            let text = shipped("ellipse-xy").unwrap().text;
            let machine = Arc::new(Machine::read("ellipse-xy", text).unwrap());
            let folder = tempfile::tempdir().unwrap();
            DataFolder::open(folder.path()).unwrap();
            Self { writer: Writer::new(machine, tell, Arc::default()), news, folder, t: 0.0 }
        }

        /// Enters a weld into the library, as the panel does.
        fn entered(&self, start: u64) -> Work {
            let columns = run_rows::columns(&self.writer.machine, &[], &[]);
            let text = |name: &str| (name.to_owned(), "schema = 1".to_owned());
            let plan = Plan {
                program: text("a program"),
                machine: text("a machine"),
                columns: columns.into_iter().map(|(name, unit)| Column::new(name, unit, Kind::F64)).collect(),
                most_rows: 1 << 20,
                rows: 1000,
                passes: 1,
                ..Plan::default()
            };
            let mut data = DataFolder::open(self.folder.path()).unwrap();
            let files = data.begin_elsewhere(&plan, &[]).unwrap();
            Work::Begin(Box::new(RecordStart { start, passes: 1, files, values: 0, heads: 0 }))
        }

        fn cycles(&mut self, count: usize, mode: Mode) {
            for _ in 0..count {
                self.t += 1e-3;
                self.writer.counts.waiting.fetch_add(1, Ordering::Relaxed);
                self.writer.handle(Work::Cycle(Box::new(shown(self.t, mode))));
            }
        }

        fn note(&mut self, note: Note) {
            self.writer.handle(Work::Note(self.t, note));
        }

        /// Welds so many cycles after the note of the start.
        fn weld(&mut self, cycles: usize) {
            self.note(Note::Mode(Mode::Ready, Mode::Weld));
            self.cycles(cycles, Mode::Weld);
        }

        fn end(&mut self) {
            while let Some(weld) = self.writer.welds.pop_front() {
                self.writer.end(weld);
            }
        }

        /// Result and rows of a weld, once its record is closed.
        fn closed(&self, weld: i64) -> (WeldResult, u64, String) {
            let mut data = DataFolder::open(self.folder.path()).unwrap();
            let record = data.close(weld, None).unwrap();
            let path = data.weld_folder(weld).join("trace.parquet");
            (record.result, if path.exists() { Trace::open(&path).unwrap().rows() } else { 0 }, record.note.to_string())
        }

        fn fails(&self) -> Vec<u64> {
            let fails = |news| if let RecordNews::Fails(start, _) = news { Some(start) } else { None };
            self.news.try_iter().filter_map(fails).collect()
        }
    }

    fn shown(t: f64, mode: Mode) -> Shown {
        let status = Status {
            t,
            mode,
            place: Place { pass: 1, s_mm: 1000.0 * t },
            phase: None,
            speed: 1.0,
            steady: true,
            welded_mm: 1000.0 * t,
            process: ProcessState::Off,
            armed: false,
            feed_override: 1.0,
            tracked: [None; 2],
        };
        Shown { status, orders: Orders::default(), reports: Reports::default(), cycle: 1, lost: 0 }
    }

    const PASS_ENDS: Note = Note::PassEnds(Place { pass: 1, s_mm: 10.0 });
    const LEFT: Note = Note::Left(Place { pass: 1, s_mm: 5.0 });

    fn alarm() -> Note {
        Note::Alarm(Raised {
            alarm: Alarm::ALL[0],
            state: AlarmState::Unacknowledged,
            reaction: Reaction::Hold,
            first_out: true,
            detail: 0,
            gap_s: None,
            place: Place::default(),
            t: 0.0,
        })
    }

    /// A weld that starts within the second after the one before has a record of its own, whenever that begins.
    #[test]
    fn welds_in_quick_succession_keep_their_rows_and_alarms_apart() {
        for order in [[1, 2], [2, 1]] {
            let mut bench = Bench::new();
            bench.weld(300);
            bench.note(PASS_ENDS);
            bench.cycles(50, Mode::Ready);
            bench.weld(200);
            bench.note(alarm());
            bench.note(LEFT);
            bench.cycles(1500, Mode::Ready);
            let mut entered: Vec<Option<Work>> = [1, 2].map(|start| Some(bench.entered(start))).into();
            for start in order {
                let begin = entered[start - 1].take().unwrap();
                bench.writer.handle(begin);
            }
            let (first, second) = (bench.closed(1), bench.closed(2));
            assert_eq!((first.0, first.1), (WeldResult::Good, 350), "{first:?}");
            // The second after the end is counted in binary fractions.
            assert!(second.0 == WeldResult::Stopped && (1200..=1202).contains(&second.1), "{second:?}");
            assert!(bench.fails().is_empty() && bench.writer.welds.is_empty() && bench.writer.kept == 0);
        }
    }

    #[test]
    fn rows_and_notes_before_and_after_the_begin_of_a_record_are_in_it() {
        let mut bench = Bench::new();
        bench.weld(100);
        bench.note(alarm());
        let begin = bench.entered(1);
        bench.writer.handle(begin);
        bench.cycles(100, Mode::Hold);
        bench.note(Note::Mode(Mode::Hold, Mode::Weld));
        bench.cycles(100, Mode::Weld);
        bench.note(PASS_ENDS);
        bench.end();
        let closed = bench.closed(1);
        assert_eq!((closed.0, closed.1), (WeldResult::Deviating, 300), "{closed:?}");
    }

    /// Rows beyond the room are counted and reported once; notes are never lost.
    #[test]
    fn a_record_that_begins_too_late_tells_its_lost_rows() {
        let mut bench = Bench::new();
        bench.weld(WAITING + 500);
        bench.note(LEFT);
        assert_eq!(bench.fails(), [1]);
        let begin = bench.entered(1);
        bench.writer.handle(begin);
        bench.end();
        let closed = bench.closed(1);
        assert_eq!((closed.0, closed.1), (WeldResult::Stopped, WAITING as u64), "{closed:?}");
        assert!(closed.2.contains("500 rows"), "{}", closed.2);
    }

    /// A weld that is forgotten, or unknown, is interrupted: nothing says that it was good.
    #[test]
    fn a_record_without_its_weld_is_interrupted() {
        let mut bench = Bench::new();
        (0..=MAX_WELDS).for_each(|_| bench.weld(10));
        let begin = bench.entered(1);
        bench.writer.handle(begin);
        assert_eq!(bench.fails(), [1]);
        assert_eq!(bench.closed(1).0, WeldResult::Interrupted);
        let begin = bench.entered(77);
        bench.writer.handle(begin);
        assert_eq!(bench.closed(2).0, WeldResult::Interrupted);
        assert!(bench.writer.kept <= 10 * MAX_WELDS);
    }

    /// A journal that is in use costs no rows, and is used once it is free; a weld that ended well leaves nothing in it.
    #[test]
    fn the_journal_is_opened_when_it_is_free() {
        let mut bench = Bench::new();
        let held = Journal::open(bench.folder.path()).unwrap();
        bench.weld(10);
        let begin = bench.entered(1);
        bench.writer.handle(begin);
        bench.cycles(100, Mode::Weld);
        drop(held);
        std::thread::sleep(JOURNAL_AGAIN);
        bench.cycles(100, Mode::Weld);
        bench.end();
        let left = Journal::look(bench.folder.path()).unwrap().last.unwrap();
        assert_eq!((left.weld, left.pass), (1, 1));
        assert_eq!(bench.closed(1).1, 210);
        bench.weld(100);
        let begin = bench.entered(2);
        bench.writer.handle(begin);
        bench.note(PASS_ENDS);
        bench.end();
        assert_eq!(Journal::look(bench.folder.path()).unwrap().last, None);
        assert_eq!(bench.closed(2).0, WeldResult::Good);
    }

    /// The link counts what the thread has not taken, and leaves out cycles of no weld.
    #[test]
    fn the_queue_is_bounded_and_rest_is_left_out() {
        let (to, work) = channel();
        let (_, news) = channel();
        let counts = Arc::new(Counts::default());
        let (starts, until) = (0, f64::NEG_INFINITY);
        let mut recorder = Recorder { to, news, counts, starts, weld: None, open: Vec::new(), until };
        assert!(recorder.cycle(&shown(0.0, Mode::Ready)) && work.try_iter().count() == 0);
        let taken = (0..WAITING + 10).filter(|i| recorder.cycle(&shown(*i as f64 * 1e-3, Mode::Weld))).count();
        assert_eq!((taken, recorder.counts.lost.load(Ordering::Relaxed)), (WAITING, 10));
        assert_eq!(recorder.note(0.0, &Note::Mode(Mode::Ready, Mode::Weld)), Some(1));
        assert_eq!(recorder.note(0.0, &Note::Mode(Mode::Hold, Mode::Weld)), None);
    }
}
