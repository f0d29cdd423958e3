//! Audit log and alarm archive, written by a separate thread.

use super::audit_entry::{Change, entry, plain};
use super::event::happening;
use super::hub::Hub;
use super::refusals::Refusals;
use super::stored_message::stored;
use crate::refusal::action_word;
use crate::wire::QueueView;
use seamwright_message::Message;
use seamwright_record::library::{Alarm, AuditEntry};
use seamwright_record::{DataFolder, Error, Moment};
use std::collections::VecDeque;
use std::path::Path;
use std::sync::mpsc::{Sender, channel};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// Maximum number of alarms, and of orders, that wait for the disk. Further ones are only counted: a stop never waits
/// for a disk.
const MAX_WAITING: usize = 4096;
/// Maximum wait for the disk at the end.
const PATIENCE: Duration = Duration::from_secs(10);
/// Audit log and alarm archive. Alarms, orders and refusals have separate queues, so that none displaces another.
#[derive(Clone)]
pub(crate) struct Archive(Arc<Owner>);

/// Lets the writer end when the last [`Archive`] is dropped.
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

#[derive(Default)]
struct Waiting {
    alarms: VecDeque<Entry>,
    orders: VecDeque<AuditEntry>,
    refusals: Refusals,
    /// Number of alarms and orders dropped for lack of room.
    left_out: u64,
    /// Clients that wait until all earlier entries are written.
    flushes: Vec<Sender<()>>,
    /// Close the library once everything is written.
    closes: bool,
}

enum Entry {
    Audit(AuditEntry),
    Alarm(Option<i64>, Box<Alarm>),
    /// The user, the time, and the name of the alarm; `None`: all alarms.
    Acknowledge(String, Moment, Option<Message>),
}

enum Next {
    Write(Vec<Entry>),
    /// Everything is written: notify these clients, and close the library if true.
    Tell(Vec<Sender<()>>, bool),
    Wait(Option<Duration>),
}

impl Waiting {
    /// Returns true if a client waits until everything is written.
    fn ends(&self) -> bool {
        self.closes || !self.flushes.is_empty()
    }

    /// Returns alarms first, then orders, then due refusals.
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
            let left_out =
                Message::new("server-audit-left-out").count("n", std::mem::take(&mut self.left_out) as usize);
            let [station, command, result] =
                [Message::new("server-audit-panel"), action_word("audit"), left_out].map(stored);
            entries.insert(0, Entry::Audit(entry("", &station, &command, Change::default(), &result)));
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

    /// Waits until there is something to write, or everything is written and clients must be notified.
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

/// Delay between attempts while disk or library cannot be written.
const AGAIN: Duration = Duration::from_millis(200);

struct Writer {
    shared: Arc<Shared>,
    data: DataFolder,
    hub: Arc<Hub>,
    fails: bool,
}

impl Writer {
    /// Writes entries until the library is to be closed.
    fn run(mut self) {
        loop {
            match self.shared.take() {
                Next::Write(entries) => entries.iter().for_each(|item| self.write(item)),
                Next::Tell(flushes, closes) => {
                    // The client may have gone.
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

    /// Writes an entry. Retries if the disk may recover; at the end it tries once.
    fn write(&mut self, item: &Entry) {
        while let Err(e) = write(&mut self.data, item) {
            if !self.fails {
                let t = self.hub.latest().map_or(0.0, |s| s.t);
                self.hub.event(t, happening(Message::new("server-event-audit-fails").message("reason", e.message())));
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

    /// Changes the queues and wakes the writer.
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

    /// Alarms and orders that wait for the disk.
    pub(crate) fn queue(&self) -> QueueView {
        let (waiting, capacity) = (self.0.0.waiting(), 2 * self.0.0.room);
        let waiting = waiting.alarms.len() + waiting.orders.len();
        QueueView { name: "audit".to_owned(), waiting, most: None, capacity }
    }

    /// Waits until everything is on the disk, at most [`PATIENCE`]: at the end of the program.
    pub(crate) fn flush(&self) {
        self.wait(false);
    }

    /// Writes all entries and closes the library for good. Returns true once that is done.
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

    /// Adds an entry to the audit log: user, station, command, change and result.
    pub(crate) fn audit(
        &self,
        user: &str,
        station: impl Into<Message>,
        command: impl Into<Message>,
        change: Change<'_>,
        result: impl Into<Message>,
    ) {
        let [station, command, result] = [station.into(), command.into(), result.into()].map(stored);
        let (item, room) = (entry(user, &station, &command, change, &result), self.0.0.room);
        self.add(|waiting| match waiting.orders.len() < room {
            true => waiting.orders.push_back(item),
            false => waiting.left_out += 1,
        });
    }

    /// Adds an entry that may be repeated without limit (a refusal, an acknowledgement, a change of control): repeats are
    /// counted.
    pub(crate) fn repeatable(
        &self,
        user: &str,
        station: impl Into<Message>,
        command: impl Into<Message>,
        result: impl Into<Message>,
    ) {
        let [station, command] = [station.into(), command.into()].map(stored);
        let (user, result) = (plain(user), result.into());
        self.add(|waiting| waiting.refusals.add(&user, &station, &command, &result, Instant::now()));
    }

    /// Adds an alarm, of a weld or of none. It stays listed until acknowledged.
    pub(crate) fn alarm(&self, weld: Option<i64>, alarm: Alarm) {
        self.add_alarm(Entry::Alarm(weld, Box::new(alarm)));
    }

    /// Acknowledges the listed alarm of this name, or all. Skipped if it repeats one since the last alarm.
    pub(crate) fn acknowledge(&self, user: &str, name: Option<Message>) {
        let covers =
            |entry: &Entry| matches!(entry, Entry::Acknowledge(.., known) if known.is_none() || *known == name);
        let waiting = self.0.0.waiting();
        let repeats = waiting.alarms.iter().rev().take_while(|entry| !matches!(entry, Entry::Alarm(..))).any(covers);
        drop(waiting);
        if !repeats {
            self.add_alarm(Entry::Acknowledge(plain(user), Moment::now(), name));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cell::audit_entry::MAX_FIELD_CHARS;
    use crate::cell::stored_message::from_stored;

    fn words(entry: &AuditEntry) -> String {
        from_stored(entry.result.clone()).to_string()
    }

    #[test]
    fn foreign_texts_are_one_line_that_looks_like_what_it_is() {
        assert_eq!(plain("load Зварка 1.toml"), "load Зварка 1.toml");
        assert_eq!(plain("a\nada  arm  taken"), "a\\nada  arm  taken");
        assert_eq!(plain("\u{202e}nimda\u{0}\u{1b}[2J"), "\\u{202e}nimda\\u{0}\\u{1b}[2J");
        assert!(plain(&"x".repeat(1 << 20)).len() < MAX_FIELD_CHARS + 8);
    }

    fn alarm(name: &str) -> Alarm {
        let place = seamwright_record::library::Place::default();
        let (name, cause, raised) = (Message::verbatim(name), Message::default(), Moment::now());
        Alarm { name, cause, place, raised, first_out: false, acknowledged: None }
    }

    /// Locks the library, as a slow disk would, until the connection is dropped.
    fn hold(folder: &Path) -> rusqlite::Connection {
        let busy = rusqlite::Connection::open(folder.join("library.sqlite")).unwrap();
        busy.execute_batch("BEGIN IMMEDIATE").unwrap();
        busy
    }

    /// A slow disk costs entries, which are counted, but no time.
    #[test]
    fn nobody_waits_for_the_disk() {
        let folder = tempfile::tempdir().unwrap();
        let archive = Archive::with_room(folder.path(), Arc::new(Hub::default()), 8).unwrap();
        let busy = hold(folder.path());
        for i in 0..100 {
            archive.audit("ada", "panel 1", format!("stop {i}"), Change::default(), "taken");
        }
        busy.execute_batch("COMMIT").unwrap();
        assert!(archive.close());
        let data = DataFolder::open_to_read(folder.path()).unwrap();
        let entries = data.library().audit_entries(200).unwrap();
        // The writer may have begun with some before the rest came: then they are counted in two entries.
        let counted = entries.iter().filter_map(|e| words(e).strip_suffix(" entries were left out").map(str::to_owned));
        let left_out: usize = counted.map(|count| count.parse::<usize>().unwrap()).sum();
        let orders = entries.iter().filter(|e| e.command.starts_with("stop ")).count();
        assert!((85..100).contains(&left_out) && left_out + orders == 100, "{left_out}, {orders}: {entries:?}");
        assert!(data.library().verify_audit().unwrap().broken.is_none());
    }

    /// Endless acknowledgements and control requests on a stalled disk displace no alarm and no order.
    #[test]
    fn what_is_repeated_takes_no_room_of_alarms_and_orders() {
        let folder = tempfile::tempdir().unwrap();
        let archive = Archive::with_room(folder.path(), Arc::new(Hub::default()), 16).unwrap();
        let busy = hold(folder.path());
        for i in 0..1000 {
            if i % 200 == 0 {
                archive.alarm(None, alarm(&format!("alarm {i}")));
                archive.audit("ada", "panel 1", format!("order {i}"), Change::default(), "taken");
            }
            archive.acknowledge("eve", Some(Message::verbatim("alarm 0")));
            archive.acknowledge("eve", None);
            archive.repeatable("eve", "panel 2", "take control", "control taken");
        }
        archive.alarm(None, alarm("last"));
        busy.execute_batch("COMMIT").unwrap();
        assert!(archive.close());
        let data = DataFolder::open_to_read(folder.path()).unwrap();
        let entries = data.library().audit_entries(1000).unwrap();
        assert_eq!(entries.iter().filter(|e| e.command.starts_with("order ")).count(), 5, "{entries:?}");
        assert!(!entries.iter().any(|e| words(e).contains("left out")), "{entries:?}");
        // All but the last were acknowledged after they were raised.
        let listed = data.library().listed_alarms().unwrap();
        assert_eq!(listed.iter().map(|alarm| alarm.name.to_string()).collect::<Vec<_>>(), ["last"]);
        assert!(entries.iter().any(|e| words(e).contains("control taken: 999 more")), "{entries:?}");
    }

    /// Endless refusals on a stalled disk displace no alarm and no order; they are counted.
    #[test]
    fn refusals_take_no_room_of_alarms_and_orders() {
        let folder = tempfile::tempdir().unwrap();
        let archive = Archive::with_room(folder.path(), Arc::new(Hub::default()), 64).unwrap();
        let busy = hold(folder.path());
        for i in 0..20_000 {
            archive.repeatable("eve", "panel", "users.read", "refused: role");
            if i % 500 == 0 {
                archive.audit("ada", "panel 1", format!("order {i}"), Change::default(), "taken");
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
        assert!(refused.len() == 2 && refused[0].result.contains("19999"), "{refused:?}");
    }
}
