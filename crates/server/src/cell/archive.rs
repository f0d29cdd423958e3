//! What is kept of commands and of alarms, written by a thread of its own.

use super::happening::happening;
use super::hub::Hub;
use super::refusals::Refusals;
use crate::log;
use seamwright_record::library::{Alarm, AuditEntry};
use seamwright_record::{DataFolder, Error, Moment};
use std::collections::VecDeque;
use std::path::Path;
use std::sync::mpsc::{Sender, channel};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// Maximum number of alarms, and of orders, that wait for the disk; past that they are counted only: nobody who stops a machine waits
/// for a disk.
const MAX_WAITING: usize = 4096;
/// At the end the disk is waited for this long.
const PATIENCE: Duration = Duration::from_secs(10);
/// Maximum number of characters of a field of the audit log.
const MOST: usize = 500;

/// What is kept of commands and of alarms. Alarms, orders and refusals wait apart: none of them takes the room of another.
#[derive(Clone)]
pub(crate) struct Archive(Arc<Owner>);

/// Lets the writer end when nobody is left who could add something.
struct Owner(Arc<Shared>);

impl Drop for Owner {
    fn drop(&mut self) {
        self.0.waiting().closes = true;
        self.0.came.notify_one();
    }
}

struct Shared {
    waiting: Mutex<Waiting>,
    came: Condvar,
    room: usize,
}

/// What waits for the disk.
#[derive(Default)]
struct Waiting {
    alarms: VecDeque<Entry>,
    orders: VecDeque<AuditEntry>,
    refusals: Refusals,
    /// Alarms and orders for which there was no room.
    left_out: u64,
    /// Who waits until everything before has been written.
    flushes: Vec<Sender<()>>,
    /// The library is to be closed once everything has been written.
    closes: bool,
}

/// Something to be written.
enum Entry {
    Audit(AuditEntry),
    Alarm(Option<i64>, Box<Alarm>),
    /// By whom; the alarm of this name, or all.
    Acknowledge(String, Moment, Option<String>),
}

/// What the writer does next.
enum Next {
    Write(Vec<Entry>),
    /// Everything has been written: these are told, and the library is closed if so asked.
    Tell(Vec<Sender<()>>, bool),
    Wait(Option<Duration>),
}

impl Waiting {
    /// Somebody waits until all is written.
    fn ends(&self) -> bool {
        self.closes || !self.flushes.is_empty()
    }

    /// Alarms first, then orders, then what is due of refusals.
    fn next(&mut self, now: Instant) -> Next {
        let ends = self.ends();
        let mut entries: Vec<Entry> = self.alarms.pop_front().into_iter().collect();
        if entries.is_empty() {
            entries.extend(self.orders.pop_front().map(Entry::Audit));
        }
        if entries.is_empty() {
            entries.extend(self.refusals.due(now, ends).into_iter().map(Entry::Audit));
        }
        if self.left_out > 0 && !entries.is_empty() {
            let text = format!("{} entries were left out", std::mem::take(&mut self.left_out));
            entries.insert(0, Entry::Audit(entry("", "panel", "audit", ("", ""), &text)));
        }
        match entries.is_empty() {
            false => Next::Write(entries),
            true if ends => Next::Tell(std::mem::take(&mut self.flushes), self.closes),
            true => Next::Wait(self.refusals.next(now)),
        }
    }
}

impl Shared {
    fn waiting(&self) -> MutexGuard<'_, Waiting> {
        self.waiting.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Waits until there is something to write, or everything has been written and somebody is to be told.
    fn take(&self) -> Next {
        let mut waiting = self.waiting();
        loop {
            let patience = match waiting.next(Instant::now()) {
                Next::Wait(patience) => patience.unwrap_or(PATIENCE),
                next => return next,
            };
            let waited = self.came.wait_timeout(waiting, patience);
            waiting = waited.unwrap_or_else(PoisonError::into_inner).0;
        }
    }
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

pub(super) fn entry(user: &str, station: &str, command: &str, (old, new): (&str, &str), result: &str) -> AuditEntry {
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

fn write(data: &mut DataFolder, item: &Entry) -> Result<(), Error> {
    match item {
        Entry::Audit(entry) => data.library_mut().audit(entry).map(drop),
        Entry::Alarm(weld, alarm) => {
            let id = data.library().add_alarm(*weld, alarm)?;
            data.library().list_alarm(id)
        }
        Entry::Acknowledge(by, at, None) => data.library().acknowledge_listed(by, *at).map(drop),
        Entry::Acknowledge(by, at, Some(name)) => data.library().acknowledge_named(name, by, *at).map(drop),
    }
}

/// Between tries where the disk or the library cannot be written for now.
const AGAIN: Duration = Duration::from_millis(200);

/// The thread that writes.
struct Writer {
    shared: Arc<Shared>,
    data: DataFolder,
    hub: Arc<Hub>,
    fails: bool,
}

impl Writer {
    /// Writes what comes until the library is to be closed.
    fn run(mut self) {
        loop {
            match self.shared.take() {
                Next::Write(entries) => entries.iter().for_each(|item| self.write(item)),
                Next::Tell(flushes, closes) => {
                    // Who asked may have gone.
                    let tell = || {
                        for to in flushes {
                            let _ = to.send(());
                        }
                    };
                    if closes {
                        drop(self.data);
                        return tell();
                    }
                    tell();
                }
                Next::Wait(_) => {}
            }
        }
    }

    /// Writes an entry, again and again where the disk may come back; at the end once.
    fn write(&mut self, item: &Entry) {
        while let Err(e) = write(&mut self.data, item) {
            if !self.fails {
                let t = self.hub.latest().map_or(0.0, |s| s.t);
                self.hub.event(t, happening("audit_fails", [e.to_string()]));
                log::warning(&format!("the audit log cannot be written: {e}"));
            }
            self.fails = true;
            let passes =
                matches!(e, Error::Busy { .. } | Error::Full { .. } | Error::ReadOnly { .. } | Error::Io { .. });
            if !passes || self.shared.waiting().ends() {
                self.shared.waiting().left_out += 1;
                return;
            }
            std::thread::sleep(AGAIN);
        }
        self.fails = false;
    }
}

impl Archive {
    /// # Errors
    /// If the library cannot be written.
    pub(crate) fn open(folder: &Path, hub: Arc<Hub>) -> Result<Self, Error> {
        Self::with_room(folder, hub, MAX_WAITING)
    }

    fn with_room(folder: &Path, hub: Arc<Hub>, room: usize) -> Result<Self, Error> {
        let data = DataFolder::open(folder)?;
        let shared = Arc::new(Shared { waiting: Mutex::default(), came: Condvar::new(), room });
        let writer = Writer { shared: Arc::clone(&shared), data, hub, fails: false };
        std::thread::spawn(move || writer.run());
        Ok(Self(Arc::new(Owner(shared))))
    }

    /// Changes what waits, and wakes the writer.
    fn add(&self, change: impl FnOnce(&mut Waiting)) {
        let shared = &self.0.0;
        change(&mut shared.waiting());
        shared.came.notify_one();
    }

    fn add_alarm(&self, item: Entry) {
        let room = self.0.0.room;
        self.add(|waiting| match waiting.alarms.len() < room {
            true => waiting.alarms.push_back(item),
            false => waiting.left_out += 1,
        });
    }

    /// Waits until all is on the disk, for a while: at the end of the program.
    pub(crate) fn flush(&self) {
        self.wait(false);
    }

    /// Writes what there is and closes the library for good; true once that is done.
    pub(crate) fn close(&self) -> bool {
        self.wait(true)
    }

    fn wait(&self, closes: bool) -> bool {
        let (to, written) = channel();
        self.add(|waiting| {
            waiting.flushes.push(to);
            waiting.closes |= closes;
        });
        written.recv_timeout(PATIENCE).is_ok()
    }

    /// Who did what, from where, and what came of it.
    pub(crate) fn audit(&self, user: &str, station: &str, command: &str, change: (&str, &str), result: &str) {
        let (item, room) = (entry(user, station, command, change, result), self.0.0.room);
        self.add(|waiting| match waiting.orders.len() < room {
            true => waiting.orders.push_back(item),
            false => waiting.left_out += 1,
        });
    }

    /// Something was refused to somebody: counted where it is repeated.
    pub(crate) fn refused(&self, user: &str, station: &str, command: &str, result: &str) {
        let [user, station, command, result] = [user, station, command, result].map(plain);
        self.add(|waiting| waiting.refusals.add(&user, &station, &command, &result, Instant::now()));
    }

    /// Something that may be asked for without end, and does not change what is: counted where it is repeated.
    pub(crate) fn repeatable(&self, user: &str, station: &str, command: &str, result: &str) {
        self.refused(user, station, command, result);
    }

    /// An alarm, of a weld or beside: on the list until somebody acknowledges it.
    pub(crate) fn alarm(&self, weld: Option<i64>, alarm: Alarm) {
        log::warning(&format!("alarm: {}", plain(&alarm.name)));
        self.add_alarm(Entry::Alarm(weld, Box::new(alarm)));
    }

    /// Somebody knows the alarm of this name on the list, or all. Where no alarm has come since, once more says nothing new.
    pub(crate) fn acknowledge(&self, user: &str, name: Option<String>) {
        let item = Entry::Acknowledge(plain(user), Moment::now(), name);
        let Entry::Acknowledge(.., name) = &item else { return };
        let is_known =
            |waits: &Entry| matches!(waits, Entry::Acknowledge(.., known) if known.is_none() || known == name);
        let waiting = self.0.0.waiting();
        let since = waiting.alarms.iter().rev().take_while(|waits| !matches!(waits, Entry::Alarm(..)));
        let repeats = since.into_iter().any(is_known);
        drop(waiting);
        if !repeats {
            self.add_alarm(item);
        }
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

    fn alarm(name: &str) -> Alarm {
        let place = seamwright_record::library::Place::default();
        let (name, cause, raised) = (name.to_owned(), String::new(), Moment::now());
        Alarm { name, cause, place, raised, first_out: false, acknowledged: None }
    }

    /// A library that somebody else holds, as a slow disk would, until it is let go.
    fn hold(folder: &Path) -> rusqlite::Connection {
        let busy = rusqlite::Connection::open(folder.join("library.sqlite")).unwrap();
        busy.execute_batch("BEGIN IMMEDIATE").unwrap();
        busy
    }

    /// A disk that is too slow costs entries, which are counted, and never time.
    #[test]
    fn nobody_waits_for_the_disk() {
        let folder = tempfile::tempdir().unwrap();
        let archive = Archive::with_room(folder.path(), Arc::new(Hub::new()), 8).unwrap();
        let busy = hold(folder.path());
        for i in 0..100 {
            archive.audit("ada", "panel 1", &format!("stop {i}"), ("", ""), "taken");
        }
        let left_out = archive.0.0.waiting().left_out;
        assert!((85..100).contains(&left_out), "{left_out}");
        busy.execute_batch("COMMIT").unwrap();
        assert!(archive.close());
        let data = DataFolder::open_to_read(folder.path()).unwrap();
        let entries = data.library().audit_entries(200).unwrap();
        let reported = format!("{left_out} entries were left out");
        assert!(entries.iter().any(|e| e.result == reported), "{entries:?}");
        assert!(data.library().verify_audit().unwrap().broken.is_none());
    }

    /// Whoever acknowledges or takes control without end, on a disk that stands meanwhile, costs no alarm and no order.
    #[test]
    fn what_is_repeated_takes_no_room_of_alarms_and_orders() {
        let folder = tempfile::tempdir().unwrap();
        let archive = Archive::with_room(folder.path(), Arc::new(Hub::new()), 16).unwrap();
        let busy = hold(folder.path());
        for i in 0..1000 {
            if i % 200 == 0 {
                archive.alarm(None, alarm(&format!("alarm {i}")));
                archive.audit("ada", "panel 1", &format!("order {i}"), ("", ""), "taken");
            }
            archive.acknowledge("eve", Some("alarm 0".to_owned()));
            archive.acknowledge("eve", None);
            archive.repeatable("eve", "panel 2", "take control", "control taken");
        }
        archive.alarm(None, alarm("last"));
        busy.execute_batch("COMMIT").unwrap();
        assert!(archive.close());
        let data = DataFolder::open_to_read(folder.path()).unwrap();
        let entries = data.library().audit_entries(1000).unwrap();
        assert_eq!(entries.iter().filter(|e| e.command.starts_with("order ")).count(), 5, "{entries:?}");
        assert!(!entries.iter().any(|e| e.result.contains("left out")), "{entries:?}");
        // All but the last were acknowledged after they came.
        let listed = data.library().listed_alarms().unwrap();
        assert_eq!(listed.iter().map(|alarm| alarm.name.as_str()).collect::<Vec<_>>(), ["last"]);
        assert!(entries.iter().any(|e| e.result.contains("control taken: 999 more")), "{entries:?}");
    }

    /// Refusals without end, on a disk that stands meanwhile, cost no alarm and no order; they are counted.
    #[test]
    fn refusals_take_no_room_of_alarms_and_orders() {
        let folder = tempfile::tempdir().unwrap();
        let archive = Archive::with_room(folder.path(), Arc::new(Hub::new()), 64).unwrap();
        let busy = hold(folder.path());
        for i in 0..20_000 {
            archive.refused("eve", "panel", "users.read", "refused: role");
            if i % 500 == 0 {
                archive.audit("ada", "panel 1", &format!("order {i}"), ("", ""), "taken");
            }
            if i % 4000 == 0 {
                archive.alarm(None, alarm(&format!("alarm {i}")));
            }
        }
        busy.execute_batch("COMMIT").unwrap();
        assert!(archive.close());
        let data = DataFolder::open_to_read(folder.path()).unwrap();
        let entries = data.library().audit_entries(1000).unwrap();
        assert_eq!(entries.iter().filter(|e| e.command.starts_with("order ")).count(), 40);
        assert_eq!(data.library().listed_alarms().unwrap().len(), 5);
        let refused: Vec<_> = entries.iter().filter(|e| e.user == "eve").collect();
        assert!(refused.len() == 2 && refused[0].result.contains("19999 more"), "{refused:?}");
    }
}
