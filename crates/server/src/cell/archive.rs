//! Audit log and alarm archive, written by a separate thread, so that the cell never waits for a disk.
//!
//! | what comes | room | if the room is full |
//! |---|---|---|
//! | alarms and acknowledgements | 65,536 entries, 16 MiB; of one alarm 10 a minute | counted as left out |
//! | orders | 65,536 entries, 16 MiB | counted as left out |
//! | refusals and other repeatable requests | counted by source and kind: [`Refusals`] | never full |
//!
//! Alarms go to the library first, then orders, then sums of refusals. An entry stays in its queue until the library
//! has it. While the library does not take it (disk full, database locked, disk gone), it also goes into a
//! [`WaitingFile`] of 4 MiB, from which the next start stores it if this program ends before. An event informs the
//! operator when that begins, every minute, and when it is over.

use super::archive_queue::{Class, Lost, MAX_ENTRIES, Queues, Work};
use super::audit_entry::{Change, entry, plain};
use super::chattering::Occurrences;
use super::event::happening;
use super::hub::Hub;
use super::refusals::{Refusals, Repeatable};
use super::stored_message::stored;
use crate::refusal::action_word;
use crate::syslog::Syslog;
use crate::wire::QueueView;
use seamwright_log as log;
use seamwright_message::Message;
use seamwright_record::library::{Alarm, AuditEntry, PendingEntry};
use seamwright_record::{DataFolder, Error, Moment, WaitingFile};
use std::path::Path;
use std::sync::mpsc::{Sender, channel};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, OnceLock, PoisonError, Weak};
use std::time::{Duration, Instant};

/// Maximum wait for the disk at the end.
const PATIENCE: Duration = Duration::from_secs(10);
/// Delay between attempts while disk or library cannot be written.
const AGAIN: Duration = Duration::from_millis(200);
/// Interval of the events about a failing audit log.
const REMIND: Duration = Duration::from_secs(60);
/// Time of a write to the library after which its disk counts as hanging: more than SQLite's wait for a lock.
const HANGS: Duration = Duration::from_secs(8);
/// Interval in which a hanging disk and lost entries are looked for.
const WATCH: Duration = Duration::from_millis(500);

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

/// Next action of the writer.
enum Next {
    Write(Work),
    /// Everything is written: notify these clients, and close the library if true.
    Tell(Vec<Sender<()>>, bool),
}

struct Shared {
    waiting: Mutex<Waiting>,
    came: Condvar,
    /// Sends orders and alarms to a receiver elsewhere as they come, whether the disk works or not.
    syslog: OnceLock<Syslog>,
}

struct Waiting {
    queues: Queues,
    refusals: Refusals,
    /// A chattering alarm fills neither queue nor disk.
    occurrences: Occurrences,
    /// Clients that wait until all earlier entries are written.
    flushes: Vec<Sender<()>>,
    /// Close the library once everything is written.
    closes: bool,
    /// Begin of the write to the library that is going on.
    writes_since: Option<Instant>,
    /// Number of entries lost, that events have reported.
    told_lost: u64,
}

impl Waiting {
    /// Returns true if a client waits until everything is written.
    fn ends(&self) -> bool {
        self.closes || !self.flushes.is_empty()
    }

    /// Returns alarms first, then orders, then due refusals.
    fn next(&mut self, now: Instant) -> Work {
        // Refusals are counted until the sums of before are in the library, so that they never fill a queue.
        if self.queues.has_room_for_sums() {
            let sums = self.refusals.due(now, self.ends());
            self.queues.add_sums(sums);
        }
        self.queues.next()
    }
}

impl Shared {
    fn waiting(&self) -> MutexGuard<'_, Waiting> {
        self.waiting.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn send(&self, entry: &PendingEntry) {
        if let Some(syslog) = self.syslog.get() {
            syslog.send(entry);
        }
    }

    /// Waits until there is something to write, or everything is written and clients must be notified.
    fn take(&self) -> Next {
        let mut waiting = self.waiting();
        loop {
            let now = Instant::now();
            let work = waiting.next(now);
            if !work.entries.is_empty() {
                return Next::Write(work);
            }
            if waiting.ends() {
                return Next::Tell(std::mem::take(&mut waiting.flushes), waiting.closes);
            }
            let patience = waiting.refusals.next(now).unwrap_or(PATIENCE);
            let waited = self.came.wait_timeout(waiting, patience);
            waiting = waited.unwrap_or_else(PoisonError::into_inner).0;
        }
    }
}

struct Writer {
    shared: Arc<Shared>,
    data: DataFolder,
    hub: Arc<Hub>,
    /// `None`: another program has it open, or the disk does not allow it.
    file: Option<WaitingFile>,
    /// Time of the last event about a failure, while the library takes no entries.
    failing: Option<Instant>,
    /// Maximum number of entries that waited since it fails.
    waited: usize,
    /// Sums of refusals sent by syslog, which stay in their queue while the library fails.
    sums_sent: u64,
}

/// Returns true if the library refuses the entry itself, and not because of its disk.
fn is_of_entry(e: &Error) -> bool {
    matches!(e, Error::Wrong { .. }) || e.is_constraint()
}

impl Writer {
    /// Writes entries until the library is to be closed.
    fn run(mut self) {
        loop {
            match self.shared.take() {
                Next::Write(work) => {
                    if !self.write(&work) {
                        match self.gives_up() {
                            (flushes, true) => return self.close(flushes),
                            (flushes, false) => tell(flushes),
                        }
                    }
                }
                Next::Tell(flushes, closes) => {
                    self.clear();
                    if closes {
                        return self.close(flushes);
                    }
                    tell(flushes);
                }
            }
        }
    }

    /// Writes entries in one transaction. Returns false if the disk fails: they stay in their queue.
    fn write(&mut self, work: &Work) -> bool {
        self.send_sums(work);
        self.shared.waiting().writes_since = Some(Instant::now());
        let library = self.data.library_mut();
        let stored = match work.is_again {
            true => library.store_missing(&work.entries).map(drop),
            false => library.store(&work.entries),
        };
        self.shared.waiting().writes_since = None;
        match stored {
            Ok(()) => {
                self.shared.waiting().queues.remove(work.class, work.entries.len());
                self.works();
                if self.shared.waiting().queues.len() == 0 {
                    self.clear();
                }
                true
            }
            Err(e) if is_of_entry(&e) && work.entries.len() > 1 => {
                let single = |entry: &PendingEntry| Work { entries: vec![entry.clone()], ..*work };
                work.entries.iter().all(|entry| self.write(&single(entry)))
            }
            Err(e) if is_of_entry(&e) => {
                let refused = Message::new("server-log-entry-refused").message("reason", e.message());
                log::warn(&refused.text("entry", format!("{:?}", work.entries)));
                self.shared.waiting().queues.lose_first(work.class);
                true
            }
            Err(e) => {
                self.fails(&e);
                false
            }
        }
    }

    /// Sends sums of refusals once: they are made by this thread.
    fn send_sums(&mut self, work: &Work) {
        if work.class == Class::Sums {
            let new = self.shared.waiting().queues.new_sums(&mut self.sums_sent);
            new.iter().for_each(|sum| self.shared.send(sum));
        }
    }

    /// Reports to the operator that the library takes no entries, and puts them into the file.
    fn fails(&mut self, e: &Error) {
        let count = self.shared.waiting().queues.len();
        self.waited = self.waited.max(count);
        if self.failing.is_none_or(|told| told.elapsed() >= REMIND) {
            let message = Message::new("server-event-audit-fails").message("reason", e.message());
            event(&self.hub, message.count("n", count));
            self.failing = Some(Instant::now());
        }
        self.keep();
    }

    /// Writes waiting entries into the file as far as it has room.
    fn keep(&mut self) {
        let Some(file) = &mut self.file else { return };
        loop {
            let (class, entries) = self.shared.waiting().queues.not_kept();
            let Ok(count) = file.append(&entries) else { return };
            if count == 0 {
                return;
            }
            self.shared.waiting().queues.mark_kept(class, count);
        }
    }

    /// Reports to the operator that the library takes entries again.
    fn works(&mut self) {
        if self.failing.take().is_some() {
            let waited = std::mem::take(&mut self.waited);
            event(&self.hub, Message::new("server-event-audit-stored").count("n", waited));
        }
        let mut waiting = self.shared.waiting();
        let lost = waiting.queues.take_lost().map(left_out);
        waiting.queues.add_sums(lost.into_iter().collect());
    }

    /// Empties the file once the library has all entries.
    fn clear(&mut self) {
        let Some(file) = self.file.as_mut().filter(|file| !file.is_empty()) else { return };
        if let Err(e) = file.clear() {
            // The next start finds that the library has them.
            log::warn(&Message::new("server-log-waiting-file").message("reason", e.message()));
        }
    }

    /// Waits until the next attempt. At the end of the program it gives up: the next start stores the entries of the file.
    /// Returns the clients to be informed, and whether the library is to be closed.
    fn gives_up(&mut self) -> (Vec<Sender<()>>, bool) {
        let waiting = self.shared.waiting();
        let waited = self.shared.came.wait_timeout_while(waiting, AGAIN, |waiting| !waiting.ends());
        let mut waiting = waited.unwrap_or_else(PoisonError::into_inner).0;
        if !waiting.ends() {
            return (Vec::new(), false);
        }
        let mut sums = waiting.refusals.due(Instant::now(), true);
        sums.extend(waiting.queues.take_lost().map(left_out));
        waiting.queues.add_sums(sums);
        let (flushes, closes) = (std::mem::take(&mut waiting.flushes), waiting.closes);
        drop(waiting);
        self.keep();
        let lost = self.shared.waiting().queues.not_kept_len();
        if closes && lost > 0 {
            log::warn(&Message::new("server-event-audit-left-out").count("n", lost));
        }
        (flushes, closes)
    }

    /// Closes library and file, before anybody hears of it.
    fn close(self, flushes: Vec<Sender<()>>) {
        let Self { data, file, .. } = self;
        drop((data, file));
        tell(flushes);
    }
}

/// Returns the entry about lost ones.
fn left_out(lost: Lost) -> AuditEntry {
    let result = Message::new("server-audit-left-out").count("n", lost.count as usize);
    let result = result.text("first", lost.first.to_string()).text("last", lost.last.to_string());
    let [station, command, result] = [Message::new("server-audit-panel"), action_word("audit"), result].map(stored);
    entry("", &station, &command, Change::default(), &result)
}

fn tell(flushes: Vec<Sender<()>>) {
    for to in flushes {
        // The client may have gone.
        let _ = to.send(());
    }
}

fn event(hub: &Hub, message: Message) {
    hub.event(hub.latest().map_or(0.0, |status| status.t), happening(message));
}

/// Reports a write that does not return, and lost entries, to the operator until the archive ends.
fn watch(shared: &Weak<Shared>, hub: &Weak<Hub>) {
    let mut told: Option<Instant> = None;
    while let (Some(shared), Some(hub)) = (shared.upgrade(), hub.upgrade()) {
        let mut waiting = shared.waiting();
        let (count, lost) = (waiting.queues.len(), waiting.queues.lost_ever() - waiting.told_lost);
        waiting.told_lost += lost;
        let hangs = waiting.writes_since.is_some_and(|since| since.elapsed() > HANGS);
        drop(waiting);
        if hangs && told.is_none_or(|told| told.elapsed() >= REMIND) {
            told = Some(Instant::now());
            event(&hub, Message::new("server-event-audit-hangs").count("n", count));
        }
        if !hangs {
            told = None;
        }
        if lost > 0 {
            event(&hub, Message::new("server-event-audit-left-out").count("n", lost as usize));
        }
        drop((shared, hub));
        std::thread::sleep(WATCH);
    }
}

impl Archive {
    pub(crate) fn open(folder: &Path, hub: Arc<Hub>) -> Result<Self, Error> {
        Ok(Self::start(DataFolder::open(folder)?, hub, Queues::default()))
    }

    /// Starts the writer, which stores entries in `data`.
    fn start(data: DataFolder, hub: Arc<Hub>, mut queues: Queues) -> Self {
        // Another program that serves the same folder has it; without it entries wait in memory only.
        let file = WaitingFile::open(data.path());
        let (file, before) = file.map_or((None, Vec::new()), |(file, all)| (Some(file), all));
        queues.add_again(before);
        let waiting = Waiting {
            queues,
            refusals: Refusals::default(),
            occurrences: Occurrences::default(),
            flushes: Vec::new(),
            closes: false,
            writes_since: None,
            told_lost: 0,
        };
        let shared = Arc::new(Shared { waiting: Mutex::new(waiting), came: Condvar::new(), syslog: OnceLock::new() });
        let watched = (Arc::downgrade(&shared), Arc::downgrade(&hub));
        let writer = Writer { shared: Arc::clone(&shared), data, hub, file, failing: None, waited: 0, sums_sent: 0 };
        std::thread::spawn(move || writer.run());
        std::thread::spawn(move || watch(&watched.0, &watched.1));
        Self(Arc::new(Owner(shared)))
    }

    /// Sends all later entries to a syslog receiver too.
    pub(crate) fn send_to(&self, syslog: Syslog) {
        // It is set up once.
        drop(self.0.0.syslog.set(syslog));
    }

    /// Changes the queues and wakes the writer.
    fn change(&self, change: impl FnOnce(&mut Waiting)) {
        let shared = &self.0.0;
        change(&mut shared.waiting());
        shared.came.notify_one();
    }

    fn add(&self, class: Class, item: PendingEntry) {
        self.0.0.send(&item);
        self.change(|waiting| waiting.queues.add(class, item));
    }

    /// Alarms and orders that wait for the disk.
    pub(crate) fn queue(&self) -> QueueView {
        let waiting = self.0.0.waiting().queues.len();
        QueueView { name: "audit".to_owned(), waiting, most: None, capacity: 2 * MAX_ENTRIES }
    }

    /// Waits until everything is on the disk, at most [`PATIENCE`]: at the end of the program.
    pub(crate) fn flush(&self) {
        self.wait(false);
        if let Some(syslog) = self.0.0.syslog.get() {
            syslog.flush();
        }
    }

    /// Writes all entries and closes the library for good. Returns true once that is done.
    pub(crate) fn close(&self) -> bool {
        self.wait(true)
    }

    fn wait(&self, closes: bool) -> bool {
        let (to, written) = channel();
        self.change(|waiting| {
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
        self.add(Class::Orders, PendingEntry::Audit(entry(user, &station, &command, change, &result)));
    }

    /// Adds a refusal: refusals of a source are counted and summed up.
    pub(crate) fn refused(
        &self,
        user: &str,
        station: impl Into<Message>,
        command: impl Into<Message>,
        result: impl Into<Message>,
    ) {
        self.count(user, station.into(), command.into(), result.into(), true);
    }

    /// Adds an entry that may be repeated without limit (an acknowledgement, a change of control): repeats are counted
    /// as refusals are.
    pub(crate) fn repeatable(
        &self,
        user: &str,
        station: impl Into<Message>,
        command: impl Into<Message>,
        result: impl Into<Message>,
    ) {
        self.count(user, station.into(), command.into(), result.into(), false);
    }

    fn count(&self, user: &str, station: Message, command: Message, result: Message, is_refused: bool) {
        let request = Repeatable { user: plain(user), station: stored(station), command, result, is_refused };
        self.change(|waiting| waiting.refusals.add(&request, Instant::now()));
    }

    /// Adds an alarm, of a weld or of none. It stays listed until acknowledged. Occurrences of a chattering alarm are
    /// counted in the audit log.
    pub(crate) fn alarm(&self, weld: Option<i64>, alarm: Alarm) {
        if self.0.0.waiting().occurrences.is_flood(&alarm.name, Instant::now()) {
            let again = Message::new("server-audit-raised-again");
            return self.repeatable("", Message::new("server-audit-panel"), alarm.name, again);
        }
        self.add(Class::Alarms, PendingEntry::Alarm { weld, alarm: Box::new(alarm) });
    }

    /// Acknowledges the listed alarm of this name, or all. Skipped if it repeats one since the last alarm.
    pub(crate) fn acknowledge(&self, user: &str, name: Option<Message>) {
        let mut waiting = self.0.0.waiting();
        waiting.occurrences.forget();
        let repeats = waiting.queues.acknowledges(name.as_ref());
        drop(waiting);
        if !repeats {
            let by = plain(user);
            self.add(Class::Alarms, PendingEntry::Acknowledge { name, by, at: Moment::now() });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cell::audit_entry::MAX_FIELD_CHARS;
    use crate::cell::refusals::requests_of;
    use crate::cell::stored_message::from_stored;
    use seamwright_record::library::DocumentKind;
    use std::sync::atomic::{AtomicUsize, Ordering};

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
        let priority = "low".to_owned();
        Alarm { name, cause, priority, place, raised, first_out: false, acknowledged: None }
    }

    /// Archive whose queues have room for so many entries each.
    fn with_room(folder: &Path, room: usize) -> Archive {
        Archive::start(DataFolder::open(folder).unwrap(), Arc::new(Hub::default()), Queues::with_room(room))
    }

    fn order(archive: &Archive, name: impl std::fmt::Display) {
        archive.audit("ada", "panel 1", format!("order {name}"), Change::default(), "taken");
    }

    /// Locks the library, as a slow disk would, until the connection is dropped.
    fn hold(folder: &Path) -> rusqlite::Connection {
        let busy = rusqlite::Connection::open(folder.join("library.sqlite")).unwrap();
        busy.busy_timeout(Duration::from_secs(60)).unwrap();
        busy.execute_batch("BEGIN EXCLUSIVE").unwrap();
        busy
    }

    /// Contents of the library.
    struct Found {
        entries: Vec<AuditEntry>,
        listed: Vec<String>,
    }

    impl Found {
        fn in_folder(folder: &Path) -> Self {
            let data = DataFolder::open_to_read(folder).unwrap();
            assert!(data.library().verify_audit().unwrap().broken.is_none());
            let listed = data.library().listed_alarms().unwrap().iter().map(|alarm| alarm.name.to_string()).collect();
            Self { entries: data.library().audit_entries(u32::MAX).unwrap(), listed }
        }

        fn orders(&self) -> usize {
            self.entries.iter().filter(|e| e.command.starts_with("order ")).count()
        }

        fn left_out(&self) -> usize {
            let counts = self.entries.iter().filter_map(|e| {
                let words = words(e);
                words.split_once(" entries were left out").and_then(|(n, _)| n.parse::<usize>().ok())
            });
            counts.sum()
        }
    }

    /// Codes of the events that the operator saw.
    fn messages(hub: &Hub) -> Vec<String> {
        let (station, mut from, _) = hub.connect("ada", crate::wire::Role::Operator).unwrap();
        let mut codes = Vec::new();
        while let Ok(text) = from.try_recv() {
            let message: serde_json::Value = serde_json::from_str(&text).unwrap();
            codes.extend(message["key"].as_str().map(str::to_owned));
        }
        hub.disconnect(station);
        codes
    }

    /// A slow disk costs no time. Entries beyond the room are counted.
    #[test]
    fn nobody_waits_for_the_disk() {
        let folder = tempfile::tempdir().unwrap();
        let archive = with_room(folder.path(), 8);
        let busy = hold(folder.path());
        let begun = Instant::now();
        (0..100).for_each(|i| order(&archive, i));
        // SQLite waits for 5 s.
        assert!(begun.elapsed() < Duration::from_secs(4));
        busy.execute_batch("COMMIT").unwrap();
        assert!(archive.close());
        let found = Found::in_folder(folder.path());
        assert_eq!((found.orders(), found.left_out()), (8, 92));
    }

    /// Endless acknowledgements and control requests on a stalled disk displace no alarm and no order.
    #[test]
    fn what_is_repeated_takes_no_room_of_alarms_and_orders() {
        let folder = tempfile::tempdir().unwrap();
        let archive = with_room(folder.path(), 16);
        let busy = hold(folder.path());
        for i in 0..1000 {
            if i % 200 == 0 {
                archive.alarm(None, alarm(&format!("alarm {i}")));
                order(&archive, i);
            }
            archive.acknowledge("eve", Some(Message::verbatim("alarm 0")));
            archive.acknowledge("eve", None);
            archive.repeatable("eve", "panel 2", "take control", "control taken");
        }
        archive.alarm(None, alarm("last"));
        busy.execute_batch("COMMIT").unwrap();
        assert!(archive.close());
        let found = Found::in_folder(folder.path());
        assert_eq!((found.orders(), found.left_out()), (5, 0));
        // All but the last were acknowledged after they were raised.
        assert_eq!(found.listed, ["last"]);
        assert_eq!(found.entries.iter().filter(|e| e.user == "eve").map(requests_of).sum::<u64>(), 1000);
    }

    /// 200,000 refusals of several users, pages and addresses, while orders and alarms go on: all orders and alarms are
    /// in the library, and every refusal is counted.
    #[test]
    fn a_flood_of_refusals_displaces_nothing_and_is_summed_exactly() {
        const REFUSALS: usize = 200_000;
        const THREADS: usize = 8;
        let folder = tempfile::tempdir().unwrap();
        let archive = with_room(folder.path(), 4096);
        let (running, begun) = (AtomicUsize::new(THREADS), Instant::now());
        let (mut orders, mut alarms) = (0, 0);
        std::thread::scope(|scope| {
            for thread in 0..THREADS {
                let (archive, running) = (&archive, &running);
                scope.spawn(move || {
                    for i in 0..REFUSALS / THREADS {
                        let (user, place) =
                            (format!("user {}", thread % 5), format!("panel at 10.0.{thread}.{}", i % 3));
                        let commands = ["users.read", "job.write", "arm"];
                        archive.refused(&user, place, commands[i / 3 % 3], Message::new("server-audit-refused-role"));
                    }
                    running.fetch_sub(1, Ordering::Relaxed);
                });
            }
            while running.load(Ordering::Relaxed) > 0 || orders < 200 {
                order(&archive, orders);
                if orders % 10 == 0 {
                    archive.alarm(None, alarm(&format!("alarm {orders}")));
                    alarms += 1;
                }
                orders += 1;
                std::thread::sleep(Duration::from_millis(1));
            }
        });
        assert!(archive.close());
        let found = Found::in_folder(folder.path());
        assert_eq!((found.orders(), found.listed.len(), found.left_out()), (orders, alarms, 0));
        let refused: Vec<&AuditEntry> = found.entries.iter().filter(|e| !e.command.starts_with("order ")).collect();
        assert_eq!(refused.iter().map(|e| requests_of(e)).sum::<u64>(), REFUSALS as u64);
        // 24 places with 3 kinds, and a sum of each place a minute.
        let minutes = begun.elapsed().as_secs() as usize / 60 + 1;
        assert!(refused.len() <= 24 * (3 + minutes), "{}", refused.len());
        assert!(refused.iter().any(|e| words(e).contains("refused requests, first 20")), "{refused:?}");
    }

    /// Another program locks the library for longer than SQLite waits: an event reports it, and nothing is lost. Killed
    /// meanwhile, the next start finds everything.
    #[test]
    fn a_locked_library_loses_nothing() {
        let folder = tempfile::tempdir().unwrap();
        let hub = Arc::new(Hub::default());
        let archive = Archive::open(folder.path(), Arc::clone(&hub)).unwrap();
        let busy = hold(folder.path());
        for i in 0..300 {
            order(&archive, i);
            archive.alarm(None, alarm(&format!("alarm {i}")));
        }
        let begun = Instant::now();
        while !messages(&hub).contains(&"audit_fails".to_owned()) {
            assert!(begun.elapsed() < Duration::from_secs(60));
            std::thread::sleep(Duration::from_millis(50));
        }
        order(&archive, "later");
        // As if it was killed now: the copy has a library without the entries, and the file.
        let copy = tempfile::tempdir().unwrap();
        let begun = Instant::now();
        loop {
            std::fs::copy(folder.path().join("audit.waiting"), copy.path().join("audit.waiting")).unwrap();
            if WaitingFile::open(copy.path()).unwrap().1.len() >= 600 {
                break;
            }
            assert!(begun.elapsed() < Duration::from_secs(60));
            std::thread::sleep(Duration::from_millis(50));
        }
        busy.execute_batch("COMMIT").unwrap();
        archive.flush();
        assert!(archive.close());
        let found = Found::in_folder(folder.path());
        assert_eq!((found.orders(), found.listed.len(), found.left_out()), (301, 300, 0));
        assert!(messages(&hub).contains(&"audit_stored".to_owned()));
        assert!(DataFolder::open(copy.path()).unwrap().recover().unwrap().is_empty());
        let found = Found::in_folder(copy.path());
        assert!(found.orders() >= 300 && found.listed.len() == 300, "{} {}", found.orders(), found.listed.len());
        // A second start stores nothing twice.
        let before = found.entries.len();
        assert!(Archive::open(copy.path(), Arc::default()).unwrap().close());
        assert_eq!(Found::in_folder(copy.path()).entries.len(), before);
    }

    /// Data folder whose library cannot grow: its pages are those of a document, which is returned to be deleted.
    fn full(folder: &Path) -> DataFolder {
        let data = DataFolder::open(folder).unwrap();
        data.library().add_document(DocumentKind::Job, "big", &"x".repeat(4 << 20)).unwrap();
        data.library().limit_pages(1).unwrap();
        data
    }

    /// With a full disk orders and alarms wait, refusals are counted, and all are stored once there is room.
    #[test]
    fn a_full_disk_loses_nothing() {
        let folder = tempfile::tempdir().unwrap();
        let hub = Arc::new(Hub::default());
        let archive = Archive::start(full(folder.path()), Arc::clone(&hub), Queues::default());
        for i in 0..2000 {
            order(&archive, i);
            archive.refused("eve", "panel at ::1", "arm", Message::new("server-audit-refused-role"));
            if i % 10 == 0 {
                archive.alarm(None, alarm(&format!("alarm {i}")));
            }
        }
        let begun = Instant::now();
        while !messages(&hub).contains(&"audit_fails".to_owned()) {
            assert!(begun.elapsed() < Duration::from_secs(60));
            std::thread::sleep(Duration::from_millis(10));
        }
        let room = rusqlite::Connection::open(folder.path().join("library.sqlite")).unwrap();
        room.busy_timeout(Duration::from_secs(60)).unwrap();
        room.execute("DELETE FROM document", ()).unwrap();
        let begun = Instant::now();
        while !messages(&hub).contains(&"audit_stored".to_owned()) {
            assert!(begun.elapsed() < Duration::from_secs(60));
            std::thread::sleep(Duration::from_millis(10));
        }
        assert!(archive.close());
        let found = Found::in_folder(folder.path());
        assert_eq!((found.orders(), found.listed.len(), found.left_out()), (2000, 200, 0));
        assert_eq!(found.entries.iter().filter(|e| e.user == "eve").map(requests_of).sum::<u64>(), 2000);
    }

    /// A disk that is full until the program ends: the next start stores everything, sums of refusals too.
    #[test]
    fn a_disk_that_stays_full_loses_nothing() {
        let folder = tempfile::tempdir().unwrap();
        let archive = Archive::start(full(folder.path()), Arc::default(), Queues::default());
        for i in 0..1000 {
            order(&archive, i);
            archive.refused("eve", "panel at ::1", "arm", Message::new("server-audit-refused-role"));
        }
        archive.alarm(None, alarm("last"));
        assert!(archive.close());
        let early = Found::in_folder(folder.path());
        let mut data = DataFolder::open(folder.path()).unwrap();
        data.recover().unwrap();
        drop(data);
        let found = Found::in_folder(folder.path());
        assert!(early.orders() < 1000, "{}", early.orders());
        assert_eq!((found.orders(), found.listed.len(), found.left_out()), (1000, 1, 0));
        assert_eq!(found.entries.iter().filter(|e| e.user == "eve").map(requests_of).sum::<u64>(), 1000);
    }

    /// A chattering alarm is stored some times and then counted; after an acknowledgement it is stored again.
    #[test]
    fn a_chattering_alarm_is_counted() {
        let folder = tempfile::tempdir().unwrap();
        let archive = Archive::open(folder.path(), Arc::default()).unwrap();
        (0..500).for_each(|_| archive.alarm(None, alarm("following error")));
        archive.acknowledge("ada", None);
        archive.alarm(None, alarm("following error"));
        assert!(archive.close());
        let found = Found::in_folder(folder.path());
        assert_eq!(found.listed, ["following error"]);
        let again: Vec<&AuditEntry> = found.entries.iter().filter(|e| e.command == "following error").collect();
        assert_eq!(again.iter().map(|e| requests_of(e)).sum::<u64>(), 490, "{again:?}");
    }

    /// An event reports a write that does not return.
    #[test]
    fn a_hanging_disk_is_told() {
        let folder = tempfile::tempdir().unwrap();
        let hub = Arc::new(Hub::default());
        let archive = Archive::open(folder.path(), Arc::clone(&hub)).unwrap();
        // As if the write had begun long ago.
        archive.change(|waiting| waiting.writes_since = Instant::now().checked_sub(2 * HANGS));
        let begun = Instant::now();
        while !messages(&hub).contains(&"audit_hangs".to_owned()) {
            assert!(begun.elapsed() < Duration::from_secs(60));
            std::thread::sleep(Duration::from_millis(10));
        }
    }
}
