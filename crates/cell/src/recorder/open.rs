//! Files of a weld that are open.

use super::RecordStart;
use seamwright_executive::realtime::Shown;
use seamwright_executive::{Note, Place, Raised, Reaction};
use seamwright_machine::Machine;
use seamwright_message::Message;
use seamwright_project::power_loss::{self, Places, Watch};
use seamwright_project::{run_rows, weld_events};
use seamwright_record::journal::Journal;
use seamwright_record::weld_log::Entry;
use seamwright_record::{Error, WeldWriter};
use std::time::{Duration, Instant};

/// Period of attempts to open the journal, which the panel may hold for a moment.
pub(super) const JOURNAL_AGAIN: Duration = Duration::from_millis(200);
/// Time after which a journal that does not open is reported.
const JOURNAL_BUSY: Duration = Duration::from_secs(5);

/// Files of a weld that are being written.
pub(super) struct Open {
    pub(super) weld: i64,
    pub(super) writer: WeldWriter,
    pub(super) start: Box<RecordStart>,
    /// The journal, once it is free, and the time of the last and the first attempt.
    pub(super) places: Option<Places>,
    journal_tried: Option<Instant>,
    begun: Instant,
    watch: Watch,
    tips: run_rows::Tips,
    pub(super) passes: usize,
    pub(super) is_left: bool,
}

impl Open {
    pub(super) fn new(start: Box<RecordStart>) -> Result<Self, (i64, Error)> {
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

    pub(super) fn row(&mut self, machine: &Machine, shown: &Shown) {
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

    pub(super) fn log(&mut self, machine: &Machine, t: f64, note: &Note, here: Place) {
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

    pub(super) fn trouble(&self) -> Option<Message> {
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
