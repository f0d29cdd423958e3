use super::happening::happening;
use super::hub::Hub;
use seamwright_record::library::{Alarm, AuditEntry};
use seamwright_record::{DataFolder, Error, Moment};
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::mpsc::{Sender, SyncSender, channel, sync_channel};
use std::time::Duration;

/// Entries that wait for the disk at most; past that they are counted only: nobody who stops a machine waits for a disk.
const WAITING: usize = 4096;
/// At the end this long is waited for the disk.
const PATIENCE: Duration = Duration::from_secs(10);
/// Most characters of a field of the audit log.
const MOST: usize = 500;

/// What is kept of commands and of alarms, written by a thread of its own.
#[derive(Clone)]
pub(crate) struct Archive {
    to: SyncSender<Entry>,
    left_out: Arc<AtomicU64>,
}

enum Entry {
    Audit(AuditEntry),
    Alarm(Option<i64>, Box<Alarm>),
    /// By whom; the alarm of this name, or all.
    Acknowledge(String, Moment, Option<String>),
    /// Everything before it has been written.
    Written(Sender<()>),
    /// Everything before it has been written, and the library is closed.
    Closed(Sender<()>),
}

/// True for what changes a text's look, or is not seen: controls, and marks that turn its direction.
pub(crate) fn hides(c: char) -> bool {
    c.is_control()
        || matches!(c, '\u{200b}'..='\u{200f}' | '\u{2028}'..='\u{202e}' | '\u{2060}'..='\u{206f}' | '\u{feff}')
}

/// A text of others as one line that looks like what it is.
fn plain(text: &str) -> String {
    let mut out = String::new();
    for (i, c) in text.chars().enumerate() {
        match c {
            _ if i == MOST => {
                out.push('…');
                break;
            }
            c if hides(c) => out.extend(c.escape_default()),
            c => out.push(c),
        }
    }
    out
}

fn entry(user: &str, station: &str, command: &str, (old, new): (&str, &str), result: &str) -> AuditEntry {
    AuditEntry {
        at: Moment::now(),
        user: plain(user),
        station: plain(station),
        command: plain(command),
        old: plain(old),
        new: plain(new),
        result: plain(result),
    }
}

fn write(data: &mut DataFolder, item: Entry) -> Result<(), Error> {
    match item {
        Entry::Audit(entry) => data.library_mut().audit(&entry).map(drop),
        Entry::Alarm(weld, alarm) => {
            let id = data.library().add_alarm(weld, &alarm)?;
            data.library().list_alarm(id)
        }
        Entry::Acknowledge(by, at, None) => data.library().acknowledge_listed(&by, at).map(drop),
        Entry::Acknowledge(by, at, Some(name)) => data.library().acknowledge_named(&name, &by, at).map(drop),
        Entry::Written(to) | Entry::Closed(to) => {
            // Who asked may have gone.
            let _ = to.send(());
            Ok(())
        }
    }
}

impl Archive {
    /// # Errors
    /// If the library cannot be written.
    pub(crate) fn open(folder: &Path, hub: Arc<Hub>) -> Result<Self, Error> {
        Self::with_room(folder, hub, WAITING)
    }

    fn with_room(folder: &Path, hub: Arc<Hub>, waiting: usize) -> Result<Self, Error> {
        let mut data = DataFolder::open(folder)?;
        let (to, from) = sync_channel(waiting);
        let left_out = Arc::new(AtomicU64::new(0));
        let lost = Arc::clone(&left_out);
        std::thread::spawn(move || {
            let mut failed = false;
            for item in from {
                if let Entry::Closed(to) = item {
                    drop(data);
                    // Who asked may have gone.
                    let _ = to.send(());
                    return;
                }
                let n = lost.swap(0, Ordering::Relaxed);
                let gap = (n > 0).then(|| {
                    Entry::Audit(entry("", "panel", "audit", ("", ""), &format!("{n} entries were left out")))
                });
                let written = gap.into_iter().chain([item]).try_for_each(|item| write(&mut data, item));
                if let Err(e) = written {
                    lost.fetch_add(1, Ordering::Relaxed);
                    if !failed {
                        let t = hub.latest().map_or(0.0, |s| s.t);
                        hub.event(t, happening("audit_fails", [e.to_string()]));
                        eprintln!("warning: the audit log cannot be written: {e}");
                    }
                    failed = true;
                } else {
                    failed = false;
                }
            }
        });
        Ok(Self { to, left_out })
    }

    fn send(&self, item: Entry) {
        if self.to.try_send(item).is_err() {
            self.left_out.fetch_add(1, Ordering::Relaxed);
        }
    }

    /// Waits until all is on the disk, for a while: at the end of the program.
    pub(crate) fn flush(&self) {
        let (to, written) = channel();
        if self.to.send(Entry::Written(to)).is_ok() {
            let _ = written.recv_timeout(PATIENCE);
        }
    }

    /// Writes what there is and closes the library for good; true once that is done.
    pub(crate) fn close(&self) -> bool {
        let (to, closed) = channel();
        self.to.send(Entry::Closed(to)).is_ok() && closed.recv_timeout(PATIENCE).is_ok()
    }

    /// Who did what, from where, and what came of it.
    pub(crate) fn audit(&self, user: &str, station: &str, command: &str, change: (&str, &str), result: &str) {
        self.send(Entry::Audit(entry(user, station, command, change, result)));
    }

    /// An alarm, of a weld or beside: on the list until somebody acknowledges it.
    pub(crate) fn alarm(&self, weld: Option<i64>, alarm: Alarm) {
        self.send(Entry::Alarm(weld, Box::new(alarm)));
    }

    /// Somebody knows the alarm of this name on the list, or all.
    pub(crate) fn acknowledge(&self, user: &str, name: Option<String>) {
        self.send(Entry::Acknowledge(plain(user), Moment::now(), name));
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn foreign_texts_are_one_line_that_looks_like_what_it_is() {
        assert_eq!(plain("load Зварка 1.toml"), "load Зварка 1.toml");
        assert_eq!(plain("a\nada  arm  taken"), "a\\nada  arm  taken");
        assert_eq!(plain("\u{202e}nimda\u{0}\u{1b}[2J"), "\\u{202e}nimda\\u{0}\\u{1b}[2J");
        assert!(plain(&"x".repeat(1 << 20)).len() < MOST + 8);
    }

    /// A disk that is too slow costs entries, which are counted, and never time.
    #[test]
    fn nobody_waits_for_the_disk() {
        let folder = tempfile::tempdir().unwrap();
        let archive = Archive::with_room(folder.path(), Arc::new(Hub::new()), 8).unwrap();
        let busy = rusqlite::Connection::open(folder.path().join("library.sqlite")).unwrap();
        busy.execute_batch("BEGIN IMMEDIATE").unwrap();
        for i in 0..100 {
            archive.audit("ada", "panel 1", &format!("stop {i}"), ("", ""), "taken");
        }
        let left_out = archive.left_out.load(Ordering::Relaxed);
        assert!((85..100).contains(&left_out), "{left_out}");
        busy.execute_batch("COMMIT").unwrap();
        let told = format!("{left_out} entries were left out");
        let data = DataFolder::open_to_read(folder.path()).unwrap();
        loop {
            let entries = data.library().audit_entries(200).unwrap();
            if entries.iter().any(|e| e.result == told) {
                break;
            }
            std::thread::sleep(Duration::from_millis(20));
        }
        assert!(data.library().verify_audit().unwrap().broken.is_none());
    }
}
