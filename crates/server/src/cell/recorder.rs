//! Entries of welds in the library: their begin, and their end once the cell has written their files.
//!
//! All of it waits for the disk, so threads do it: the desk never waits.

use super::archive::Archive;
use super::event::happening;
use super::hub::Hub;
use super::progress::{self, Left};
use super::stored_message::stored;
use crate::refusal::panel_word;
use seamwright_cell::protocol::RecordStart;
use seamwright_executive::Raised;
use seamwright_executive::realtime::RealtimeRights;
use seamwright_message::Message;
use seamwright_record::journal::Journal;
use seamwright_record::library::{Alarm, AuditEntry, Event, Place as Recorded, WeldRecord};
use seamwright_record::weld_log::Entry;
use seamwright_record::{DataFolder, Error, Moment, Plan};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::sync::mpsc::{Receiver, Sender, channel};
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

/// Maximum time to close records at the end of the program.
const CLOSING: Duration = Duration::from_secs(30);

/// Begins and closes the records of welds, whose files the cell writes.
pub(super) struct Recorder {
    folder: PathBuf,
    hub: Arc<Hub>,
    archive: Archive,
    /// The cell's number of the last start of a weld, and its weld once it is in the library.
    last: Option<(u64, Option<i64>)>,
    /// Welds whose files the cell has not let go of.
    open: BTreeSet<i64>,
    /// Cause of the end of the last weld from outside.
    stopped: Option<Message>,
    /// Number of cells that have died, and why the last one has.
    deaths: u32,
    death: Message,
    tell: Sender<RecorderNews>,
    news: Receiver<RecorderNews>,
    /// Threads that begin and close records.
    threads: Vec<JoinHandle<()>>,
}

/// A weld to be entered into the library.
pub(super) struct Beginning {
    /// The cell's number of its start.
    pub(super) start: u64,
    pub(super) plan: Plan,
    /// Number of passes to be welded.
    pub(super) passes: usize,
    /// Number of process values and of tracked heads.
    pub(super) values: usize,
    pub(super) heads: usize,
}

/// News of the threads.
pub(super) enum RecorderNews {
    /// A weld is in the library.
    Begun(Box<RecordStart>, u32),
    /// The weld with this start is not, and why.
    NotBegun(u64, Error),
    /// A record whose cell has died was closed; the newest weld that was left, if any.
    Left(Option<Left>),
}

/// A record to be closed.
struct Closing {
    folder: PathBuf,
    weld: i64,
    /// Why its cell has gone.
    lost: Option<Message>,
    /// Why it was stopped from outside.
    stopped: Option<Message>,
}

impl Recorder {
    pub(super) fn new(folder: &Path, hub: Arc<Hub>, archive: Archive) -> Self {
        let (tell, news) = channel();
        Self {
            folder: folder.to_owned(),
            hub,
            archive,
            last: None,
            open: BTreeSet::new(),
            stopped: None,
            deaths: 0,
            death: Message::default(),
            tell,
            news,
            threads: Vec::new(),
        }
    }

    pub(super) fn folder(&self) -> &Path {
        &self.folder
    }

    /// Number of the weld that is being recorded.
    pub(super) fn weld(&self) -> Option<i64> {
        self.last?.1.filter(|weld| self.open.contains(weld))
    }

    /// Enters a weld that has begun into the library: news follow. `missing`: real-time rights that the cycle lacks.
    pub(super) fn begin(&mut self, weld: Beginning, missing: &[&str]) {
        self.last = Some((weld.start, None));
        self.stopped = None;
        let mut events = Vec::new();
        if !missing.is_empty() {
            events.push(event(RealtimeRights::event(missing)));
        }
        let (folder, deaths) = (self.folder.clone(), self.deaths);
        self.spawn(move |tell| {
            let Beginning { start, plan, passes, values, heads } = weld;
            let begun = DataFolder::open(&folder).and_then(|mut data| data.begin_elsewhere(&plan, passes, &events));
            // The desk may have ended; the weld is recovered then.
            drop(tell.send(match begun {
                Ok(files) => RecorderNews::Begun(Box::new(RecordStart { start, passes, files, values, heads }), deaths),
                Err(e) => RecorderNews::NotBegun(start, e),
            }));
        });
    }

    /// The next news, if there is any.
    pub(super) fn news(&mut self) -> Option<RecorderNews> {
        loop {
            match self.news.try_recv().ok()? {
                RecorderNews::Begun(start, deaths) if deaths != self.deaths => {
                    let why = self.death.clone();
                    self.close(start.files.weld, Some(why));
                }
                RecorderNews::Begun(start, deaths) => {
                    let weld = start.files.weld;
                    self.open.insert(weld);
                    if let Some(last) = self.last.as_mut().filter(|last| last.0 == start.start) {
                        last.1 = Some(weld);
                    }
                    return Some(RecorderNews::Begun(start, deaths));
                }
                news => return Some(news),
            }
        }
    }

    /// A cell was found running with these records open; the last weld is `recording`.
    pub(super) fn found(&mut self, recording: Option<i64>, open: Vec<i64>) {
        self.last = recording.map(|weld| (0, Some(weld)));
        self.open = open.into_iter().collect();
    }

    /// Archives an alarm at once, with the weld that is recorded, if any.
    pub(super) fn alarm(&mut self, t: f64, raised: &Raised, name: &Message) {
        self.archive.alarm(self.weld(), alarm(t, raised, name));
    }

    /// The weld that runs is ended from outside.
    pub(super) fn stopped_by(&mut self, cause: &Message) {
        self.stopped.get_or_insert_with(|| cause.clone());
    }

    /// The cell has written the files of a weld.
    pub(super) fn ended(&mut self, weld: i64) {
        // One that is not open was closed when its cell died.
        if self.open.remove(&weld) {
            self.close(weld, None);
        }
    }

    /// The cell has died: its welds are interrupted.
    pub(super) fn lost(&mut self, why: &Message) {
        self.deaths += 1;
        self.death = why.clone();
        for weld in std::mem::take(&mut self.open) {
            self.close(weld, Some(why.clone()));
        }
        self.last = None;
    }

    fn close(&mut self, weld: i64, lost: Option<Message>) {
        let is_last = self.last.is_none_or(|last| last.1 == Some(weld));
        let stopped = if is_last { self.stopped.take() } else { None };
        let closing = Closing { folder: self.folder.clone(), weld, lost, stopped };
        let hub = Arc::clone(&self.hub);
        self.spawn(move |tell| closing.run(&hub, tell));
    }

    fn spawn(&mut self, work: impl FnOnce(&Sender<RecorderNews>) + Send + 'static) {
        self.threads.retain(|thread| !thread.is_finished());
        let tell = self.tell.clone();
        self.threads.push(std::thread::spawn(move || work(&tell)));
    }

    /// Waits until all records are on the disk, at most [`CLOSING`]. A weld whose end the cell has not reported counts
    /// as interrupted.
    pub(super) fn close_all(&mut self) {
        let begun = Instant::now();
        let waits = |recorder: &Self| recorder.threads.iter().any(|thread| !thread.is_finished());
        while waits(self) && begun.elapsed() < CLOSING {
            std::thread::sleep(Duration::from_millis(5));
        }
        while self.news().is_some() {}
        self.lost(&Message::new("cell-process-ended-early"));
        while waits(self) && begun.elapsed() < CLOSING {
            std::thread::sleep(Duration::from_millis(5));
        }
    }
}

impl Closing {
    fn run(self, hub: &Hub, tell: &Sender<RecorderNews>) {
        match self.closed() {
            Ok(weld) => {
                hub.count_weld(weld.result);
                tell_recorded(hub, &weld);
                if self.lost.is_some() {
                    let data = DataFolder::open_to_read(&self.folder);
                    let left = data.and_then(|data| progress::newest_left(data.library()));
                    // The desk may have ended; a later one reads it from the library.
                    drop(left.map(|left| tell.send(RecorderNews::Left(left))));
                }
            }
            Err(e) => {
                let message = Message::new("server-event-record-not-whole").number("weld", self.weld as f64, 0);
                hub.event(time(hub), happening(message.message("reason", e.message())));
            }
        }
    }

    fn closed(&self) -> Result<WeldRecord, Error> {
        if let Some(cause) = &self.stopped {
            let text = Message::new("cell-note-stopped").message("cause", cause.clone());
            for entry in [Entry::Event(event(text)), Entry::Stopped(cause.clone())] {
                DataFolder::log(&self.folder, self.weld, &entry)?;
            }
        }
        let mut data = DataFolder::open(&self.folder)?;
        let weld = self.once_free(&mut data)?;
        let position = Journal::look(&self.folder)?.last.filter(|at| i64::try_from(at.weld) == Ok(self.weld));
        if let Some(at) = &position {
            progress::remember(at, data.library())?;
            // The library has the position. A weld that has begun since replaces it.
            progress::clear_journal(&data)?;
        }
        let entry = AuditEntry {
            at: Moment::now(),
            user: weld.welder.clone().unwrap_or_default(),
            station: stored(Message::new("server-audit-panel")),
            command: stored(
                Message::new("server-audit-weld").number("weld", weld.id as f64, 0).text("part", &weld.part),
            ),
            old: String::new(),
            new: String::new(),
            result: stored(panel_word("result", weld.result.name())),
        };
        data.library_mut().audit(&entry)?;
        Ok(weld)
    }

    /// Closes the record once its writer has let go of the files: a process that was killed holds them for a moment.
    fn once_free(&self, data: &mut DataFolder) -> Result<WeldRecord, Error> {
        let begun = Instant::now();
        loop {
            match data.close(self.weld, self.lost.as_ref()) {
                Err(Error::Busy { .. }) if begun.elapsed() < CLOSING => std::thread::sleep(Duration::from_millis(20)),
                closed => return closed,
            }
        }
    }
}

fn time(hub: &Hub) -> f64 {
    hub.latest().map_or(0.0, |status| status.t)
}

fn tell_recorded(hub: &Hub, weld: &WeldRecord) {
    let message = Message::new("server-event-recorded").number("weld", weld.id as f64, 0);
    hub.event(time(hub), happening(message.message("result", panel_word("result", weld.result.name()))));
}

fn event(text: Message) -> Event {
    Event { at: Moment::now(), text, place: Recorded { pass: None, s_mm: None, t_s: None } }
}

fn alarm(t: f64, raised: &Raised, name: &Message) -> Alarm {
    let in_pass = raised.place.pass > 0;
    Alarm {
        name: name.clone(),
        cause: raised.cause(),
        priority: raised.alarm.priority(raised.reaction).name().to_owned(),
        place: Recorded {
            pass: in_pass.then_some(raised.place.pass as u32),
            s_mm: in_pass.then_some(raised.place.s_mm),
            t_s: Some(t),
        },
        raised: Moment::now(),
        first_out: raised.first_out,
        acknowledged: None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_record::journal::Position;
    use seamwright_record::library::{Query, WeldResult};
    use seamwright_record::trace::{Column, Kind};
    use seamwright_record::{WeldFiles, WeldWriter};

    fn plan() -> Plan {
        let text = |name: &str| (name.to_owned(), "schema = 1".to_owned());
        Plan {
            part: "L-1".to_owned(),
            title: "Short".to_owned(),
            simulated: true,
            program: text("a program"),
            machine: text("a machine"),
            columns: vec![Column::new("t_s", "s", Kind::F64)],
            most_rows: 1000,
            rows: 1000,
            ..Plan::default()
        }
    }

    fn recorder(folder: &Path) -> Recorder {
        let hub = Arc::new(Hub::default());
        let archive = Archive::open(folder, Arc::clone(&hub)).unwrap();
        Recorder::new(folder, hub, archive)
    }

    fn begun(recorder: &mut Recorder, start: u64) -> WeldFiles {
        let plan = Plan { welder: Some("ada".to_owned()), ..plan() };
        recorder.begin(Beginning { start, plan, passes: 1, values: 0, heads: 0 }, &["its priority"]);
        loop {
            match recorder.news() {
                Some(RecorderNews::Begun(begun, _)) => return begun.files,
                Some(RecorderNews::NotBegun(_, e)) => panic!("{e}"),
                _ => std::thread::sleep(Duration::from_millis(1)),
            }
        }
    }

    fn welds(folder: &Path) -> Vec<WeldRecord> {
        DataFolder::open_to_read(folder).unwrap().library().find(&Query::default()).unwrap()
    }

    fn written(files: &WeldFiles, entries: &[Entry]) {
        let mut writer = WeldWriter::open(files).unwrap();
        (0..100).for_each(|i| writer.row([f64::from(i)]));
        entries.iter().for_each(|entry| writer.log(entry));
        writer.end(0).unwrap();
    }

    /// The result of a weld is that of its log.
    #[test]
    fn records_are_closed_by_what_was_logged() {
        let folder = tempfile::tempdir().unwrap();
        let mut recorder = recorder(folder.path());
        let alarm = || Entry::Stopped(Message::verbatim("arc lost"));
        let logs = [
            (vec![Entry::PassEnds], WeldResult::Good),
            (vec![alarm(), Entry::PassEnds], WeldResult::Deviating),
            (vec![alarm(), Entry::Left { pass: 1, s_mm: 12.5 }], WeldResult::Stopped),
            (vec![], WeldResult::Stopped),
        ];
        for (start, (entries, _)) in (1..).zip(&logs) {
            let files = begun(&mut recorder, start);
            written(&files, entries);
            recorder.ended(files.weld);
        }
        // One is ended by a signal.
        let files = begun(&mut recorder, 7);
        written(&files, &[]);
        recorder.stopped_by(&Message::verbatim("SIGTERM"));
        recorder.ended(files.weld);
        recorder.close_all();
        let mut welds = welds(folder.path());
        welds.sort_by_key(|weld| weld.id);
        for (weld, (_, result)) in welds.iter().zip(&logs) {
            assert_eq!(weld.result, *result, "{weld:?}");
        }
        assert!(welds[4].result == WeldResult::Stopped && welds[4].note.to_string().contains("SIGTERM"));
        assert!(welds[2].note.to_string().contains("arc lost"), "{}", welds[2].note);
        let data = DataFolder::open(folder.path()).unwrap();
        assert_eq!(data.verify().unwrap().problems, []);
        assert!(data.library().events(1).unwrap()[0].text.to_string().contains("priority"));
    }

    /// A cell that dies leaves an interrupted weld, with the position of its journal and the rows on the disk.
    #[test]
    fn a_weld_whose_cell_has_died_is_interrupted_at_its_place() {
        let folder = tempfile::tempdir().unwrap();
        let mut recorder = recorder(folder.path());
        let files = begun(&mut recorder, 7);
        let mut writer = WeldWriter::open(&files).unwrap();
        (0..100).for_each(|i| writer.row([f64::from(i)]));
        writer.flush();
        let mut journal = Journal::open(folder.path()).unwrap();
        let weld = u64::try_from(files.weld).unwrap();
        let at = Position { time: 1.0, weld, pass: 1, phase: 3, s: 13.0, welded_to: 12.0, corrections: [[0.0; 2]; 2] };
        journal.write(&at).unwrap();
        drop((writer, journal));
        recorder.lost(&Message::verbatim("killed by signal 9"));
        let begun = Instant::now();
        while !matches!(recorder.news(), Some(RecorderNews::Left(Some(_)))) {
            assert!(begun.elapsed() < CLOSING);
        }
        let weld = &welds(folder.path())[0];
        assert!(weld.result == WeldResult::Interrupted && weld.note.to_string().contains("signal 9"), "{weld:?}");
        assert_eq!(Journal::look(folder.path()).unwrap().last, None);
        let data = DataFolder::open(folder.path()).unwrap();
        assert_eq!(data.library().files(weld.id).unwrap()[0].rows, Some(100));
    }

    /// A weld that ended while no panel was there gets its result from the next one.
    #[test]
    fn a_record_that_nobody_closed_is_closed_by_the_next_panel() {
        let folder = tempfile::tempdir().unwrap();
        let mut first = recorder(folder.path());
        let files = begun(&mut first, 1);
        written(&files, &[Entry::PassEnds]);
        drop(first);
        DataFolder::open(folder.path()).unwrap().recover().unwrap();
        assert_eq!(welds(folder.path())[0].result, WeldResult::Good);
    }

    /// A weld that reaches the library after its cell has died is interrupted, and not given to the next cell.
    #[test]
    fn a_weld_that_begins_while_its_cell_dies_is_interrupted() {
        let folder = tempfile::tempdir().unwrap();
        let mut recorder = recorder(folder.path());
        recorder.begin(Beginning { start: 1, plan: plan(), passes: 1, values: 0, heads: 0 }, &[]);
        recorder.lost(&Message::verbatim("killed by signal 9"));
        recorder.close_all();
        assert_eq!(welds(folder.path())[0].result, WeldResult::Interrupted);
    }
}
