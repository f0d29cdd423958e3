//! The place of the weld on the disk, for the day the power fails.

use crate::args::records::RecordArgs;
use crate::failure::Failure;
use seamwright_cell::executive::Place;
use seamwright_record::DataFolder;
use seamwright_record::journal::{Journal, Position};
use std::sync::mpsc::{SyncSender, TrySendError, sync_channel};
use std::thread::JoinHandle;

/// Refuses to begin anew what a power failure has left: somebody has to look at it and say.
pub(super) fn check(record: &RecordArgs, from: Option<Place>) -> Result<(), Failure> {
    let Some(folder) = record.data.as_ref().filter(|folder| folder.exists()) else { return Ok(()) };
    let Some(left) = DataFolder::open(folder)?.journal()?.last() else { return Ok(()) };
    if from.is_some() {
        return Ok(());
    }
    let (pass, welded) = (left.pass.max(1), left.welded_to);
    Err(Failure::Input(format!(
        "weld {} was left by a failure of power or program: pass {pass}, welded up to {welded:.2} mm, the torch at {:.2} mm\n   \
         allowed: look at the end of the bead, grind it, then --from {pass},{welded:.2}; or --from 1,0 to weld anew",
        left.weld, left.s
    )))
}

/// A thread that keeps the newest place on the disk.
pub(super) struct Places {
    to: SyncSender<Position>,
    thread: JoinHandle<Result<Journal, seamwright_record::Error>>,
}

pub(super) fn writer(mut journal: Journal) -> Places {
    let (to, from) = sync_channel::<Position>(1);
    let thread = std::thread::spawn(move || {
        for position in from {
            journal.write(&position)?;
        }
        Ok(journal)
    });
    Places { to, thread }
}

impl Places {
    /// The newest place; left out while the one before is still being written.
    pub(super) fn tell(&self, position: Position) {
        match self.to.try_send(position) {
            // Whoever writes has ended with an error, which the end of the run tells.
            Ok(()) | Err(TrySendError::Full(_) | TrySendError::Disconnected(_)) => {}
        }
    }

    /// The weld ended in order.
    pub(super) fn end(self) -> Result<(), Failure> {
        drop(self.to);
        let journal = self.thread.join().map_err(|_| Failure::Environment("the journal's thread failed".to_owned()))?;
        Ok(journal?.clear()?)
    }
}
