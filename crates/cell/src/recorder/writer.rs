//! The thread that writes: it sorts cycles and notes by weld, and keeps those whose record has not begun.

use super::open::Open;
use super::{AFTER_S, Counts, RecordNews, RecordStart, WAITING, Work, begins};
use seamwright_executive::realtime::Shown;
use seamwright_executive::{Mode, Note, Place};
use seamwright_machine::Machine;
use seamwright_message::Message;
use std::collections::VecDeque;
use std::sync::Arc;
use std::sync::atomic::Ordering;
use std::sync::mpsc::{Receiver, RecvTimeoutError, Sender};
use std::time::{Duration, Instant};

/// Welds that wait for the start of their record; beyond that the oldest has none.
pub(super) const MAX_WELDS: usize = 8;
/// Rows reach the disk no later than this after the last one.
const FLUSH: Duration = Duration::from_millis(500);

/// A weld from its start on.
pub(super) struct Weld {
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
pub(super) struct Writer {
    pub(super) machine: Arc<Machine>,
    tell: Sender<RecordNews>,
    pub(super) counts: Arc<Counts>,
    /// Welds whose record is open or has not begun; the last one may run.
    pub(super) welds: VecDeque<Weld>,
    /// Cycles kept for welds whose record has not begun.
    pub(super) kept: usize,
    /// Number of the last start.
    starts: u64,
}

impl Writer {
    pub(super) fn new(machine: Arc<Machine>, tell: Sender<RecordNews>, counts: Arc<Counts>) -> Self {
        Self { machine, tell, counts, welds: VecDeque::new(), kept: 0, starts: 0 }
    }

    pub(super) fn run(mut self, work: &Receiver<Work>) {
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

    pub(super) fn handle(&mut self, work: Work) {
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
    pub(super) fn end(&self, mut weld: Weld) {
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
