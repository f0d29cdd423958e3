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
    /// Records that are being closed.
    closing: Vec<JoinHandle<()>>,
}

/// A weld that is being recorded.
struct Open {
    recording: Recording,
    places: Option<Places>,
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
        Self { folder: folder.to_owned(), hub, archive, open: None, closing: Vec::new() }
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
        let recording = data.begin(&plan)?;
        let places = Some(power_loss::writer(data.journal()?));
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

    /// A cycle; the trouble that keeps rows from being written, if there is some.
    pub(super) fn row(&mut self, names: &Names, shown: &Shown) -> Option<String> {
        let open = self.open.as_mut()?;
        let welds = matches!(shown.mode, Mode::Weld | Mode::Hold);
        open.runs |= welds;
        if !open.runs {
            return None;
        }
        open.here = shown.place;
        open.recording.row(run_rows::row(&mut open.tips, &names.machine, shown, names.values, names.heads));
        let weld = u64::try_from(open.recording.id()).unwrap_or(0);
        if let (Some(places), Some(position)) = (&open.places, open.watch.position(shown, weld)) {
            places.tell(position);
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

fn finish(open: Open, folder: &Path) -> Result<WeldResult, Error> {
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
    if let Some(places) = open.places {
        // It ended in order: nothing is left to power failures. A journal that failed has said so in the trace's trouble.
        drop(places.end());
    }
    Ok(result)
}
