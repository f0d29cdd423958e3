use seamwright_record::library::{Alarm, AuditEntry};
use seamwright_record::{DataFolder, Error, Moment};
use std::path::Path;
use std::sync::mpsc::{SyncSender, sync_channel};

/// Entries that wait for the disk at most; past that whoever adds one waits too.
const WAITING: usize = 4096;

/// What is kept of commands and of alarms beside welds, written by a thread of its own.
#[derive(Clone)]
pub(crate) struct Archive(SyncSender<Entry>);

enum Entry {
    Audit(AuditEntry),
    Alarm(Box<Alarm>),
}

impl Archive {
    /// # Errors
    /// If the library cannot be written.
    pub(crate) fn open(folder: &Path) -> Result<Self, Error> {
        let mut data = DataFolder::open(folder)?;
        let (to, from) = sync_channel(WAITING);
        std::thread::spawn(move || {
            for entry in from {
                let written = match entry {
                    Entry::Audit(entry) => data.library_mut().audit(&entry).map(drop),
                    Entry::Alarm(alarm) => data.library().add_alarm(None, &alarm).map(drop),
                };
                if let Err(e) = written {
                    eprintln!("warning: the audit log cannot be written: {e}");
                }
            }
        });
        Ok(Self(to))
    }

    /// Who did what, from where, and what came of it.
    pub(crate) fn audit(&self, user: &str, station: &str, command: &str, (old, new): (&str, &str), result: &str) {
        let owned = str::to_owned;
        let entry = AuditEntry {
            at: Moment::now(),
            user: owned(user),
            station: owned(station),
            command: owned(command),
            old: owned(old),
            new: owned(new),
            result: owned(result),
        };
        // The thread lives as long as anybody can ask.
        drop(self.0.send(Entry::Audit(entry)));
    }

    /// An alarm beside welds.
    pub(crate) fn alarm(&self, alarm: Alarm) {
        drop(self.0.send(Entry::Alarm(Box::new(alarm))));
    }
}
