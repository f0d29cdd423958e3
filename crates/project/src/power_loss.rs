//! The position of the weld on the disk, for a power failure.

use crate::failure::Failure;
use seamwright_executive::realtime::Shown;
use seamwright_executive::{Mode, Place};
use seamwright_message::{Message, Unit};
use seamwright_record::Error;
use seamwright_record::journal::{Journal, Position};
use std::path::Path;
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::thread::JoinHandle;
use std::time::{Duration, Instant, SystemTime};

/// Period at which the weld's position is written to the disk, s.
const JOURNAL_S: f64 = 0.05;

/// Decides when the position of the weld is recorded.
#[derive(Debug)]
pub struct Watch {
    /// Time of its last storage, s.
    last: f64,
}

impl Default for Watch {
    fn default() -> Self {
        Self { last: f64::NEG_INFINITY }
    }
}

impl Watch {
    /// Position of `weld`, while it runs or is held, if it is due to be written.
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

/// Refuses to start anew after a power failure until the operator has checked the weld and chosen a position.
///
/// # Errors
/// If a weld was left and `from` gives no position.
pub fn check(data: Option<&Path>, from: Option<Place>) -> Result<(), Failure> {
    let Some(folder) = data.filter(|folder| folder.exists()) else { return Ok(()) };
    let journal = Journal::open(folder)?;
    if from.is_some() {
        return Ok(());
    }
    if journal.is_damaged() {
        let message = Message::new("project-journal-damaged").text("folder", folder.display().to_string());
        return Err(Failure::refused(message, Message::new("project-look-and-choose")));
    }
    let Some(left) = journal.last() else { return Ok(()) };
    let (pass, welded) = (left.pass.max(1), left.welded_to);
    let message = Message::new("project-weld-left").number("weld", left.weld as f64, 0).pass("pass", pass as usize);
    let message = message.quantity("welded", welded, Unit::Mm, 2).quantity("torch", left.s, Unit::Mm, 2);
    let allowed = Message::new("project-grind-and-continue").text("from", format!("{pass},{welded:.2}"));
    Err(Failure::refused(message, allowed))
}

/// Data that wait to be written: only the newest position is written.
#[derive(Debug, Default)]
struct Slot {
    newest: Option<Position>,
    /// Welds that have ended in order.
    over: Vec<u64>,
    /// First error that kept a position from being written.
    failed: Option<Error>,
    ended: bool,
}

/// The slot, with the signal of its changes. Both threads keep it consistent, so a poisoned lock is still usable.
#[derive(Debug, Default)]
struct Waiting(Mutex<Slot>, Condvar);

impl Waiting {
    fn lock(&self) -> MutexGuard<'_, Slot> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn tell(&self, change: impl FnOnce(&mut Slot)) {
        change(&mut self.lock());
        self.1.notify_all();
    }

    /// Waits for a position or for welds that are over; `None` once it has ended and the slot is empty.
    fn next(&self) -> Option<(Option<Position>, Vec<u64>)> {
        let idle = |slot: &mut Slot| slot.newest.is_none() && slot.over.is_empty() && !slot.ended;
        let mut slot = self.1.wait_while(self.lock(), idle).unwrap_or_else(PoisonError::into_inner);
        let work = (slot.newest.take(), slot.over.clone());
        (work.0.is_some() || !work.1.is_empty()).then_some(work)
    }

    /// Reports that these welds were handled, with the first error.
    fn done(&self, welds: &[u64], failed: Option<Error>) {
        self.tell(|slot| {
            slot.over.retain(|weld| !welds.contains(weld));
            slot.failed = slot.failed.take().or(failed);
        });
    }
}

/// A thread that writes the newest position to the disk. Dropped, it frees the journal and leaves the last entry in it.
#[derive(Debug)]
pub struct Places {
    waiting: Arc<Waiting>,
    /// `None` once [`Places::end`] has joined it.
    thread: Option<JoinHandle<Journal>>,
}

/// Starts to write positions to `journal`. The disk lags the weld by at most 50 ms plus the time of one write, however
/// slow the disk is. After a failed write the next position is tried.
pub fn writer(journal: Journal) -> Places {
    let waiting = Arc::new(Waiting::default());
    let from = Arc::clone(&waiting);
    let thread = std::thread::spawn(move || keep(journal, &from));
    Places { waiting, thread: Some(thread) }
}

fn keep(mut journal: Journal, from: &Waiting) -> Journal {
    while let Some((newest, over)) = from.next() {
        let mut result = newest.map_or(Ok(()), |position| journal.write(&position));
        // The entry of a weld that has started since is not cleared.
        if journal.last().is_some_and(|last| over.contains(&last.weld)) {
            result = result.and(journal.clear());
        }
        from.done(&over, result.err());
    }
    journal
}

impl Places {
    /// Period at which the thread is checked to be alive.
    const LOOK: Duration = Duration::from_millis(50);
    /// Maximum wait of a drop for the journal to be free.
    const PATIENCE: Duration = Duration::from_secs(1);

    /// Sets the newest position; it replaces the one before, if that is not being written yet.
    pub fn tell(&self, position: Position) {
        self.waiting.tell(|slot| slot.newest = Some(position));
    }

    /// A weld ended in order: waits until the journal holds no position of it. Positions of another weld stay.
    ///
    /// # Errors
    /// The error of writing the journal, now or since the last call.
    pub fn over(&self, weld: u64) -> Result<(), Error> {
        self.waiting.tell(|slot| slot.over.push(weld));
        let mut slot = self.waiting.lock();
        while slot.over.contains(&weld) && self.thread.as_ref().is_some_and(|thread| !thread.is_finished()) {
            slot = self.waiting.1.wait_timeout(slot, Self::LOOK).unwrap_or_else(PoisonError::into_inner).0;
        }
        slot.failed.take().map_or(Ok(()), Err)
    }

    /// The weld ended in order.
    ///
    /// # Errors
    /// The journal could not be written.
    pub fn end(mut self) -> Result<(), Failure> {
        self.waiting.tell(|slot| slot.ended = true);
        let gone = || Failure::Environment(Message::new("project-journal-thread-failed"));
        let mut journal = self.thread.take().ok_or_else(gone)?.join().map_err(|_| gone())?;
        let cleared = journal.clear();
        let failed = self.waiting.lock().failed.take();
        Ok(failed.map_or(Ok(()), Err).and(cleared)?)
    }
}

impl Drop for Places {
    fn drop(&mut self) {
        self.waiting.tell(|slot| slot.ended = true);
        // Its lock is gone with the thread; a disk that hangs is not waited for.
        let begin = Instant::now();
        while self.thread.as_ref().is_some_and(|thread| !thread.is_finished()) && begin.elapsed() < Self::PATIENCE {
            std::thread::sleep(Duration::from_millis(1));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn position(weld: u64) -> Position {
        Position { time: 1.0, weld, pass: 1, phase: 0, s: 2.0, welded_to: 1.0, corrections: [[0.0; 2]; 2] }
    }

    /// A weld that does not end in order leaves its position, and the journal to the next one.
    #[test]
    fn dropped_places_free_the_journal_and_stay_in_it() {
        let folder = tempfile::tempdir().unwrap();
        let places = writer(Journal::open(folder.path()).unwrap());
        places.tell(position(7));
        drop(places);
        assert_eq!(Journal::open(folder.path()).unwrap().last(), Some(position(7)));
    }

    #[test]
    fn the_end_of_a_weld_clears_its_own_place_only() {
        let folder = tempfile::tempdir().unwrap();
        let places = writer(Journal::open(folder.path()).unwrap());
        places.tell(position(7));
        places.over(7).unwrap();
        places.tell(position(8));
        places.over(7).unwrap();
        drop(places);
        assert_eq!(Journal::open(folder.path()).unwrap().last(), Some(position(8)));
        let places = writer(Journal::open(folder.path()).unwrap());
        places.tell(position(9));
        places.over(9).unwrap();
        drop(places);
        assert_eq!(Journal::open(folder.path()).unwrap().last(), None);
    }
}
