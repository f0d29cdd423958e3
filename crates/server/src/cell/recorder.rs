use super::archive::Archive;
use super::event::happening;
use super::hub::Hub;
use super::names::Names;
use super::stored_message::stored;
use crate::refusal::panel_word;
use seamwright_executive::realtime::{RealtimeRights, Shown};
use seamwright_executive::{Mode, Note, Place, Raised, Reaction};
use seamwright_message::{Message, Unit};
use seamwright_project::power_loss::{self, Places, Watch};
use seamwright_project::run_rows;
use seamwright_project::weld_events;
use seamwright_record::library::{Alarm, AuditEntry, Event, Place as Recorded, WeldResult};
use seamwright_record::{DataFolder, Error, Moment, Outcome, Plan, Recording, joined};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

/// Duration of the record after the end of the program and its gas, s.
const AFTER_S: f64 = 1.0;
/// Maximum time to close records at the end of the program.
const CLOSING: Duration = Duration::from_secs(30);

/// Records welds while they run.
pub(super) struct Recorder {
    folder: PathBuf,
    hub: Arc<Hub>,
    archive: Archive,
    open: Option<Open>,
    /// Journal of positions while a weld is recorded or closed: one for all of them, since it is locked.
    places: Option<Arc<Places>>,
    /// Threads that close records.
    closing: Vec<JoinHandle<()>>,
}

/// A weld that is being recorded.
struct Open {
    recording: Recording,
    places: Arc<Places>,
    watch: Watch,
    tips: run_rows::Tips,
    welder: String,
    passes: usize,
    wanted: usize,
    left: Option<Place>,
    /// Last position of the torch, and events.
    here: Place,
    events: Vec<Event>,
    stopped: Option<Message>,
    /// A cycle of this weld has arrived: earlier ones may still be in the queue when it starts.
    runs: bool,
    /// Time of the end of the program, s.
    ended: Option<f64>,
}

impl Open {
    fn is_whole(&self) -> bool {
        self.left.is_none() && self.passes >= self.wanted
    }
}

impl Recorder {
    pub(super) fn new(folder: &Path, hub: Arc<Hub>, archive: Archive) -> Self {
        Self { folder: folder.to_owned(), hub, archive, open: None, places: None, closing: Vec::new() }
    }

    pub(super) fn folder(&self) -> &Path {
        &self.folder
    }

    /// Number of the weld that is being recorded.
    pub(super) fn weld(&self) -> Option<i64> {
        self.open.as_ref().map(|o| o.recording.id())
    }

    /// Starts the record of a weld with `passes` passes by `welder`; `missing`: real-time rights that the cycle lacks.
    pub(super) fn begin(&mut self, plan: &Plan, passes: usize, welder: &str, missing: &[&str]) -> Result<(), Error> {
        self.end();
        let mut data = DataFolder::open(&self.folder)?;
        let plan = Plan { welder: Some(welder.to_owned()), ..plan.clone() };
        // Opened first, so that a weld without a journal leaves no entry in the library.
        let places = self.journal(&data)?;
        let recording = data.begin(&plan)?;
        let welder = welder.to_owned();
        let mut events = Vec::new();
        if !missing.is_empty() {
            let text = RealtimeRights::event(missing);
            events.push(Event { at: Moment::now(), text, place: Recorded { pass: None, s_mm: None, t_s: None } });
        }
        self.open = Some(Open {
            recording,
            places,
            watch: Watch::default(),
            tips: run_rows::Tips::default(),
            welder,
            passes: 0,
            wanted: passes,
            left: None,
            here: Place::default(),
            events,
            stopped: None,
            runs: false,
            ended: None,
        });
        Ok(())
    }

    /// Returns the journal that a closing record has open, or opens it.
    fn journal(&mut self, data: &DataFolder) -> Result<Arc<Places>, Error> {
        if let Some(places) = &self.places {
            return Ok(Arc::clone(places));
        }
        let places = Arc::new(power_loss::writer(data.journal()?));
        self.places = Some(Arc::clone(&places));
        Ok(places)
    }

    /// Closes the journal once no weld needs it.
    fn free_journal(&mut self) {
        if self.open.is_none() {
            drop(self.places.take_if(|places| Arc::strong_count(places) == 1));
        }
    }

    /// Records a cycle. Returns the trouble that prevents writing rows, if any.
    pub(super) fn row(&mut self, names: &Names, shown: &Shown) -> Option<String> {
        self.free_journal();
        let open = self.open.as_mut()?;
        let welds = matches!(shown.mode, Mode::Weld | Mode::Hold);
        open.runs |= welds;
        if !open.runs {
            return None;
        }
        open.here = shown.place;
        open.recording.row(run_rows::row(&mut open.tips, &names.machine, shown, names.values, names.heads));
        let weld = u64::try_from(open.recording.id()).unwrap_or(0);
        if let Some(position) = open.watch.position(shown, weld) {
            open.places.tell(position);
        }
        let trouble = open.recording.trouble().map(ToString::to_string);
        match open.ended {
            None if !welds && shown.phase.is_none() => open.ended = Some(shown.t),
            Some(t) if shown.t - t > AFTER_S => self.end(),
            _ => {}
        }
        trouble
    }

    /// Adds the event of a note to the open record, if there is one.
    pub(super) fn add_note(&mut self, t: f64, note: &Note) {
        let Some(open) = &mut self.open else { return };
        open.events.extend(weld_events::event(t, note, open.here));
        match note {
            Note::PassEnds(_) => open.passes += 1,
            Note::Left(place) => open.left = Some(*place),
            _ => {}
        }
    }

    /// Archives an alarm at once, with the weld that is recorded, if any.
    pub(super) fn alarm(&mut self, t: f64, raised: &Raised, name: &Message) {
        if let Some(open) = self.open.as_mut().filter(|_| raised.reaction >= Reaction::Hold) {
            open.stopped.get_or_insert_with(|| name.clone());
        }
        self.archive.alarm(self.weld(), alarm(t, raised, name));
    }

    /// Ends the current record in a separate thread: a long trace takes time.
    pub(super) fn end(&mut self) {
        let Some(open) = self.open.take() else { return };
        let (folder, hub) = (self.folder.clone(), Arc::clone(&self.hub));
        let finish = move || {
            let id = open.recording.id();
            let t = hub.latest().map_or(0.0, |s| s.t);
            match finish(open, &folder) {
                Ok(result) => {
                    hub.count_weld(result);
                    hub.event(
                        t,
                        happening(
                            Message::new("server-event-recorded")
                                .number("weld", id as f64, 0)
                                .message("result", panel_word("result", result.name())),
                        ),
                    );
                }
                Err(e) => hub.event(
                    t,
                    happening(
                        Message::new("server-event-record-not-whole")
                            .number("weld", id as f64, 0)
                            .message("reason", e.message()),
                    ),
                ),
            }
        };
        self.closing.retain(|record| !record.is_finished());
        self.closing.push(std::thread::spawn(finish));
    }

    /// Notes that the recorded weld was ended from outside.
    pub(super) fn stopped_by(&mut self, cause: &Message) {
        let Some(open) = &mut self.open else { return };
        let text = Message::new("cell-note-stopped").message("cause", cause.clone());
        open.events.push(Event { at: Moment::now(), text, place: Recorded { pass: None, s_mm: None, t_s: None } });
        open.stopped.get_or_insert_with(|| cause.clone());
    }

    /// Ends the current record and waits until all records are on the disk, at most [`CLOSING`].
    pub(super) fn close(&mut self) {
        self.end();
        let begun = Instant::now();
        while self.closing.iter().any(|record| !record.is_finished()) && begun.elapsed() < CLOSING {
            std::thread::sleep(Duration::from_millis(5));
        }
        self.free_journal();
    }
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

/// Closes a record, and removes its weld from the journal of positions.
fn finish(open: Open, folder: &Path) -> Result<WeldResult, Error> {
    let (places, whole) = (Arc::clone(&open.places), open.is_whole());
    let id = u64::try_from(open.recording.id()).unwrap_or(0);
    let result = settle(open, folder);
    // A regular end needs no journal entry. Otherwise the position stays in the journal, unless the library has it.
    let cleared = if whole || result.is_ok() { places.over(id) } else { Ok(()) };
    result.and_then(|result| cleared.map(|()| result))
}

fn settle(open: Open, folder: &Path) -> Result<WeldResult, Error> {
    let mut data = DataFolder::open(folder)?;
    let id = open.recording.id();
    let whole = open.is_whole();
    let result = match &open.stopped {
        None if whole => WeldResult::Good,
        // It was held by an alarm and then continued to its end.
        Some(_) if whole => WeldResult::Deviating,
        _ => WeldResult::Stopped,
    };
    let mut note = Vec::new();
    if let Some(alarm) = &open.stopped {
        note.push(Message::new("cell-note-stopped").message("cause", alarm.clone()));
    }
    match open.left {
        Some(left) => {
            let left_in = Message::new("cell-note-left").pass("pass", left.pass);
            note.push(left_in.quantity("at", left.s_mm, Unit::Mm, 2));
        }
        None if !whole => note.push(Message::new("cell-note-not-finished")),
        None => {}
    }
    let outcome = Outcome { result, note: joined(note), files: Vec::new() };
    for event in &open.events {
        data.library().add_event(Some(id), event)?;
    }
    let weld = open.recording.finish(&mut data, &outcome)?;
    let entry = AuditEntry {
        at: Moment::now(),
        user: open.welder,
        station: stored(Message::new("server-audit-panel")),
        command: stored(Message::new("server-audit-weld").number("weld", id as f64, 0).text("part", &weld.part)),
        old: String::new(),
        new: String::new(),
        result: stored(panel_word("result", weld.result.name())),
    };
    data.library_mut().audit(&entry)?;
    Ok(result)
}

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_record::library::Query;
    use seamwright_record::trace::{Column, Kind};

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

    fn results(folder: &Path) -> Vec<WeldResult> {
        let welds = DataFolder::open_to_read(folder).unwrap().library().find(&Query::default()).unwrap();
        welds.iter().map(|weld| weld.result).collect()
    }

    /// Welds in quick succession each have a record and a place in the journal.
    #[test]
    fn a_weld_is_recorded_while_the_record_before_is_being_closed() {
        let folder = tempfile::tempdir().unwrap();
        let mut recorder = recorder(folder.path());
        (0..10).for_each(|_| recorder.begin(&plan(), 1, "ada", &[]).unwrap());
        recorder.close();
        assert_eq!(results(folder.path()), [WeldResult::Stopped; 10]);
        // The journal is empty and unlocked.
        assert_eq!(DataFolder::open(folder.path()).unwrap().journal().unwrap().last(), None);
    }

    /// A record that fails to close does not affect later welds.
    #[test]
    fn a_record_that_fails_leaves_the_journal_to_the_next_weld() {
        let folder = tempfile::tempdir().unwrap();
        let mut recorder = recorder(folder.path());
        recorder.begin(&plan(), 1, "ada", &["its priority"]).unwrap();
        let library = rusqlite::Connection::open(folder.path().join("library.sqlite")).unwrap();
        library.execute("DELETE FROM weld", ()).unwrap();
        recorder.close();
        drop(DataFolder::open(folder.path()).unwrap().journal().unwrap());
        recorder.begin(&plan(), 1, "ada", &[]).unwrap();
        recorder.close();
        assert_eq!(results(folder.path()), [WeldResult::Stopped]);
    }

    /// If the journal is locked by another program, no unfinished weld is left in the library.
    #[test]
    fn a_weld_without_a_journal_leaves_nothing() {
        let folder = tempfile::tempdir().unwrap();
        let mut recorder = recorder(folder.path());
        let journal = DataFolder::open(folder.path()).unwrap().journal().unwrap();
        assert!(matches!(recorder.begin(&plan(), 1, "ada", &[]), Err(Error::Busy { .. })));
        assert!(results(folder.path()).is_empty());
        drop(journal);
        recorder.begin(&plan(), 1, "ada", &[]).unwrap();
        recorder.close();
    }
}
