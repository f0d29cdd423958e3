//! The place of the weld on the disk, for the day the power fails.

use crate::Failure;
use seamwright_cell::executive::{Mode, Place};
use seamwright_cell::realtime::Shown;
use seamwright_record::DataFolder;
use seamwright_record::journal::{Journal, Position};
use std::path::Path;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread::JoinHandle;
use std::time::SystemTime;

/// How often the place of the weld goes to the disk, s.
const JOURNAL_S: f64 = 0.05;

/// When the place of a weld is to be kept.
#[derive(Debug)]
pub struct Watch {
    /// When it was kept last, s.
    last: f64,
}

impl Default for Watch {
    fn default() -> Self {
        Self { last: f64::NEG_INFINITY }
    }
}

impl Watch {
    /// Where `weld` is, while it runs or is held, if that is to be kept now.
    pub fn position(&mut self, now: &Shown, weld: u64) -> Option<Position> {
        let welds = matches!(now.mode, Mode::Weld | Mode::Hold) && now.place.pass > 0;
        if !welds || now.t - self.last < JOURNAL_S {
            return None;
        }
        self.last = now.t;
        let time = SystemTime::now().duration_since(SystemTime::UNIX_EPOCH).map_or(0.0, |d| d.as_secs_f64());
        Some(Position {
            time,
            weld,
            pass: now.place.pass as u32,
            phase: now.phase.map_or(0, |phase| phase as u8),
            s: now.place.s_mm,
            welded_to: now.welded_mm,
            corrections: now.tracked.map(|head| head.map_or([0.0; 2], |head| head.correction_mm)),
        })
    }
}

/// Refuses to begin anew what a power failure has left: somebody has to look at it and say.
///
/// # Errors
/// If something was left and `from` does not say where to go on.
pub fn check(data: Option<&Path>, from: Option<Place>) -> Result<(), Failure> {
    let Some(folder) = data.filter(|folder| folder.exists()) else { return Ok(()) };
    let journal = DataFolder::open(folder)?.journal()?;
    if from.is_some() {
        return Ok(());
    }
    if journal.is_damaged() {
        return Err(Failure::Input(format!(
            "{}: both files of the journal of positions are damaged: a weld may have been left by a failure, and where is not known\n   \
             allowed: look at the part, then --from PASS,MM to go on there, or --from 1,0 to weld anew",
            folder.display()
        )));
    }
    let Some(left) = journal.last() else { return Ok(()) };
    let (pass, welded) = (left.pass.max(1), left.welded_to);
    Err(Failure::Input(format!(
        "weld {} was left by a failure of power or program: pass {pass}, welded up to {welded:.2} mm, the torch at {:.2} mm\n   \
         allowed: look at the end of the bead, grind it, then --from {pass},{welded:.2}; or --from 1,0 to weld anew",
        left.weld, left.s
    )))
}

/// What waits to be written: only the newest place matters.
#[derive(Debug, Default)]
struct Slot {
    newest: Option<Position>,
    ended: bool,
}

/// The slot, and who waits for it. Neither side can leave it half-changed, so a poisoned lock is still in order.
#[derive(Debug, Default)]
struct Waiting(Mutex<Slot>, Condvar);

impl Waiting {
    fn lock(&self) -> MutexGuard<'_, Slot> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn tell(&self, change: impl FnOnce(&mut Slot)) {
        change(&mut self.lock());
        self.1.notify_one();
    }

    /// The newest place, once there is one; none after the end.
    fn next(&self) -> Option<Position> {
        let idle = |slot: &mut Slot| slot.newest.is_none() && !slot.ended;
        self.1.wait_while(self.lock(), idle).unwrap_or_else(PoisonError::into_inner).newest.take()
    }
}

/// A thread that keeps the newest place on the disk.
#[derive(Debug)]
pub struct Places {
    waiting: Arc<Waiting>,
    thread: JoinHandle<Result<Journal, seamwright_record::Error>>,
}

/// Begins to keep places in `journal`. What is on the disk is older than the weld by 50 ms and the time of one write at
/// most, however slow the disk is.
pub fn writer(mut journal: Journal) -> Places {
    let waiting = Arc::new(Waiting::default());
    let from = Arc::clone(&waiting);
    let thread = std::thread::spawn(move || {
        while let Some(position) = from.next() {
            journal.write(&position)?;
        }
        Ok(journal)
    });
    Places { waiting, thread }
}

impl Places {
    /// The newest place; in the stead of the one before, if that is not being written yet.
    pub fn tell(&self, position: Position) {
        // If whoever writes has ended with an error, the end of the run tells it.
        self.waiting.tell(|slot| slot.newest = Some(position));
    }

    /// The weld ended in order.
    ///
    /// # Errors
    /// What kept the journal from being written.
    pub fn end(self) -> Result<(), Failure> {
        self.waiting.tell(|slot| slot.ended = true);
        let journal = self.thread.join().map_err(|_| Failure::Environment("the journal's thread failed".to_owned()))?;
        Ok(journal?.clear()?)
    }
}
