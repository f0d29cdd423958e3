use super::open::JOURNAL_AGAIN;
use super::writer::{MAX_WELDS, Writer};
use super::*;
use seamwright_executive::{Alarm, AlarmState, Orders, Place, ProcessState, Raised, Reaction, Reports, Status};
use seamwright_machine::shipped;
use seamwright_project::run_rows;
use seamwright_record::journal::Journal;
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
            ..Plan::default()
        };
        let mut data = DataFolder::open(self.folder.path()).unwrap();
        let files = data.begin_elsewhere(&plan, 1, &[]).unwrap();
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
