use super::archive::Archive;
use super::happening::happening;
use super::hub::Hub;
use super::names::Names;
use seamwright_cell::executive::{Mode, Note, Place, Raised, Reaction};
use seamwright_cell::realtime::Shown;
use seamwright_project::power_loss::{self, Places, Watch};
use seamwright_project::run_rows;
use seamwright_project::weld_events;
use seamwright_record::library::{Alarm, AuditEntry, Event, Place as Recorded, WeldResult};
use seamwright_record::{DataFolder, Error, Moment, Outcome, Plan, Recording};
use std::path::{Path, PathBuf};
use std::sync::Arc;
use std::thread::JoinHandle;
use std::time::{Duration, Instant};

/// After the program has ended, its gas too, the record goes on for this long, s.
const AFTER_S: f64 = 1.0;
/// At the end of the program records that are being closed have this long.
const CLOSING: Duration = Duration::from_secs(30);

/// Records welds as they come.
pub(super) struct Recorder {
    folder: PathBuf,
    hub: Arc<Hub>,
    archive: Archive,
    open: Option<Open>,
    /// The journal of positions while a weld is recorded or its record is being closed: one for all of them, since it is locked.
    places: Option<Arc<Places>>,
    /// Records that are being closed.
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
    /// Where the torch was last, and what happened.
    here: Place,
    events: Vec<Event>,
    stopped: Option<String>,
    /// A cycle of the weld itself has come: those before it may wait in the queue when it is begun.
    runs: bool,
    /// When the program ended, s.
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

    /// Where welds are recorded.
    pub(super) fn folder(&self) -> &Path {
        &self.folder
    }

    /// Number of the weld that is recorded.
    pub(super) fn weld(&self) -> Option<i64> {
        self.open.as_ref().map(|o| o.recording.id())
    }

    /// A weld begins: `passes` of it are to come, by `welder`; `missing` is what the cycle lacks of real-time rights.
    ///
    /// # Errors
    /// If it cannot be recorded.
    pub(super) fn begin(&mut self, plan: &Plan, passes: usize, welder: &str, missing: &[&str]) -> Result<(), Error> {
        self.end();
        let mut data = DataFolder::open(&self.folder)?;
        let plan = Plan { welder: Some(welder.to_owned()), ..plan.clone() };
        // First, so that a weld without a journal leaves nothing in the library.
        let places = self.journal(&data)?;
        let recording = data.begin(&plan)?;
        let welder = welder.to_owned();
        let mut events = Vec::new();
        if !missing.is_empty() {
            let text = format!("without real-time rights: {}", missing.join(", "));
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

    /// The journal that is open already, for a weld that is still being closed, or opens it.
    fn journal(&mut self, data: &DataFolder) -> Result<Arc<Places>, Error> {
        if let Some(places) = &self.places {
            return Ok(Arc::clone(places));
        }
        let places = Arc::new(power_loss::writer(data.journal()?));
        self.places = Some(Arc::clone(&places));
        Ok(places)
    }

    /// Lets other programs have the journal once no weld needs it.
    fn free_journal(&mut self) {
        if self.open.is_none() {
            drop(self.places.take_if(|places| Arc::strong_count(places) == 1));
        }
    }

    /// A cycle; the trouble that keeps rows from being written, if there is some.
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
        let trouble = open.recording.trouble().map(str::to_owned);
        match open.ended {
            None if !welds && shown.phase.is_none() => open.ended = Some(shown.t),
            Some(t) if shown.t - t > AFTER_S => self.end(),
            _ => {}
        }
        trouble
    }

    pub(super) fn noted(&mut self, t: f64, note: &Note) {
        let Some(open) = &mut self.open else { return };
        open.events.extend(weld_events::event(t, note, open.here));
        match note {
            Note::PassEnds(_) => open.passes += 1,
            Note::Left(place) => open.left = Some(*place),
            _ => {}
        }
    }

    /// An alarm is kept at once, of the weld that is recorded or of none.
    pub(super) fn alarm(&mut self, t: f64, raised: &Raised, name: &str) {
        if let Some(open) = self.open.as_mut().filter(|_| raised.reaction >= Reaction::Hold) {
            open.stopped.get_or_insert_with(|| name.to_owned());
        }
        self.archive.alarm(self.weld(), alarm(t, raised, name));
    }

    /// Ends what is being recorded, in a thread of its own: a long trace takes a while.
    pub(super) fn end(&mut self) {
        let Some(open) = self.open.take() else { return };
        let (folder, hub) = (self.folder.clone(), Arc::clone(&self.hub));
        let finish = move || {
            let id = open.recording.id();
            let t = hub.latest().map_or(0.0, |s| s.t);
            match finish(open, &folder) {
                Ok(result) => {
                    hub.event(t, happening("recorded", [id.to_string(), result.name().to_owned()]));
                }
                Err(e) => hub.event(t, happening("record_not_whole", [id.to_string(), e.to_string()])),
            }
        };
        self.closing.retain(|record| !record.is_finished());
        self.closing.push(std::thread::spawn(finish));
    }

    /// What is recorded was ended from outside.
    pub(super) fn stopped_by(&mut self, cause: &str) {
        let Some(open) = &mut self.open else { return };
        let text = format!("stopped by: {cause}");
        open.events.push(Event { at: Moment::now(), text, place: Recorded { pass: None, s_mm: None, t_s: None } });
        open.stopped.get_or_insert_with(|| cause.to_owned());
    }

    /// Ends what is being recorded, and waits until all records are on the disk, for a while.
    pub(super) fn close(&mut self) {
        self.end();
        let begun = Instant::now();
        while self.closing.iter().any(|record| !record.is_finished()) && begun.elapsed() < CLOSING {
            std::thread::sleep(Duration::from_millis(5));
        }
        self.free_journal();
    }
}

/// An alarm as the library keeps it.
fn alarm(t: f64, raised: &Raised, name: &str) -> Alarm {
    let in_pass = raised.place.pass > 0;
    Alarm {
        name: name.to_owned(),
        cause: raised.alarm.entry().cause.to_owned(),
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

/// Closes a record, and takes its weld out of the journal of positions.
fn finish(open: Open, folder: &Path) -> Result<WeldResult, Error> {
    let (places, whole) = (Arc::clone(&open.places), open.is_whole());
    let id = u64::try_from(open.recording.id()).unwrap_or(0);
    let result = settle(open, folder);
    // It ended in order: nothing is left to power failures. Where it was left stays in the journal if the library does not have it.
    let cleared = if whole || result.is_ok() { places.over(id) } else { Ok(()) };
    result.and_then(|result| cleared.map(|()| result))
}

fn settle(open: Open, folder: &Path) -> Result<WeldResult, Error> {
    let mut data = DataFolder::open(folder)?;
    let id = open.recording.id();
    let whole = open.is_whole();
    let result = match &open.stopped {
        None if whole => WeldResult::Good,
        // It was held by an alarm, and went on to its end.
        Some(_) if whole => WeldResult::Deviating,
        _ => WeldResult::Stopped,
    };
    let mut note = Vec::new();
    if let Some(alarm) = &open.stopped {
        note.push(format!("stopped by: {alarm}"));
    }
    match open.left {
        Some(left) => note.push(format!("left in pass {}, welded up to {:.2} mm", left.pass, left.s_mm)),
        None if !whole => note.push("not welded to its end".to_owned()),
        None => {}
    }
    let outcome = Outcome { result, note: note.join("; "), files: Vec::new() };
    for event in &open.events {
        data.library().add_event(Some(id), event)?;
    }
    let weld = open.recording.finish(&mut data, &outcome)?;
    let entry = AuditEntry {
        at: Moment::now(),
        user: open.welder,
        station: "panel".to_owned(),
        command: format!("weld {id} of part {:?}", weld.part),
        old: String::new(),
        new: String::new(),
        result: weld.result.name().to_owned(),
    };
    data.library_mut().audit(&entry)?;
    Ok(result)
}

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_record::figures::Basis;
    use seamwright_record::library::Query;
    use seamwright_record::trace::{Column, Kind};

    fn plan() -> Plan {
        let text = |name: &str| (name.to_owned(), "schema = 1".to_owned());
        Plan {
            part: "L-1".to_owned(),
            title: "Short".to_owned(),
            simulated: true,
            job: None,
            program: text("a program"),
            machine: text("a machine"),
            procedure: None,
            welder: None,
            columns: vec![Column::new("t_s", "s", Kind::F64)],
            about: Vec::new(),
            most_rows: 1000,
            rows: 1000,
            basis: Basis::default(),
            note: String::new(),
        }
    }

    fn recorder(folder: &Path) -> Recorder {
        let hub = Arc::new(Hub::new());
        let archive = Archive::open(folder, Arc::clone(&hub)).unwrap();
        Recorder::new(folder, hub, archive)
    }

    fn results(folder: &Path) -> Vec<WeldResult> {
        let welds = DataFolder::open_to_read(folder).unwrap().library().find(&Query::default()).unwrap();
        welds.iter().map(|weld| weld.result).collect()
    }

    /// A weld that begins at once after another one has its record, and its place in the journal.
    #[test]
    fn a_weld_is_recorded_while_the_record_before_is_being_closed() {
        let folder = tempfile::tempdir().unwrap();
        let mut recorder = recorder(folder.path());
        (0..10).for_each(|_| recorder.begin(&plan(), 1, "ada", &[]).unwrap());
        recorder.close();
        assert_eq!(results(folder.path()), [WeldResult::Stopped; 10]);
        // Nothing is left in the journal, which others may have now.
        assert_eq!(DataFolder::open(folder.path()).unwrap().journal().unwrap().last(), None);
    }

    /// A record that cannot be closed takes nothing from the welds to come.
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

    /// Where the journal is somebody else's, no weld is left that runs for ever.
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
