//! Entries on their way into the library: stored many at a time, and once only, also after a crash.

use super::alarm::{self, Alarm};
use super::audit::{self, AuditEntry};
use super::{Error, Library};
use crate::event::Place;
use crate::moment::Moment;
use crate::stored_message;
use rusqlite::{Connection, TransactionBehavior, params};
use seamwright_message::Message;
use serde::{Deserialize, Serialize};
use std::collections::HashMap;

/// An entry that is not in the library yet.
#[derive(Debug, Clone, PartialEq)]
pub enum PendingEntry {
    /// An entry of the audit log.
    Audit(AuditEntry),
    /// An alarm, with or without a weld; it goes on the panel's list.
    Alarm {
        /// Number of the weld.
        weld: Option<i64>,
        /// The alarm.
        alarm: Box<Alarm>,
    },
    /// An acknowledgement of listed alarms.
    Acknowledge {
        /// Name of the alarm; `None`: all.
        name: Option<Message>,
        /// The user.
        by: String,
        /// Time.
        at: Moment,
    },
}

/// An entry as it stands in a file.
#[derive(Serialize, Deserialize)]
enum Written {
    Audit { at: i64, user: String, station: String, command: String, old: String, new: String, result: String },
    Alarm(WrittenAlarm),
    Acknowledge { name: Option<Message>, by: String, at: i64 },
}

#[derive(Serialize, Deserialize)]
struct WrittenAlarm {
    weld: Option<i64>,
    name: Message,
    cause: Message,
    priority: String,
    pass: Option<u32>,
    s_mm: Option<f64>,
    t_s: Option<f64>,
    raised: i64,
    first_out: bool,
}

impl From<&PendingEntry> for Written {
    fn from(entry: &PendingEntry) -> Self {
        match entry.clone() {
            PendingEntry::Audit(AuditEntry { at, user, station, command, old, new, result }) => {
                Self::Audit { at: at.0, user, station, command, old, new, result }
            }
            PendingEntry::Alarm { weld, alarm } => {
                let Alarm { name, cause, priority, place, raised, first_out, acknowledged: _ } = *alarm;
                let Place { pass, s_mm, t_s } = place;
                let raised = raised.0;
                Self::Alarm(WrittenAlarm { weld, name, cause, priority, pass, s_mm, t_s, raised, first_out })
            }
            PendingEntry::Acknowledge { name, by, at } => Self::Acknowledge { name, by, at: at.0 },
        }
    }
}

impl From<Written> for PendingEntry {
    fn from(written: Written) -> Self {
        match written {
            Written::Audit { at, user, station, command, old, new, result } => {
                Self::Audit(AuditEntry { at: Moment(at), user, station, command, old, new, result })
            }
            Written::Alarm(w) => {
                let place = Place { pass: w.pass, s_mm: w.s_mm, t_s: w.t_s };
                let WrittenAlarm { weld, name, cause, priority, first_out, .. } = w;
                let raised = Moment(w.raised);
                let alarm = Alarm { name, cause, priority, place, raised, first_out, acknowledged: None };
                Self::Alarm { weld, alarm: Box::new(alarm) }
            }
            Written::Acknowledge { name, by, at } => Self::Acknowledge { name, by, at: Moment(at) },
        }
    }
}

impl PendingEntry {
    /// Returns it as bytes for [`WaitingFile`](crate::WaitingFile).
    pub(crate) fn to_bytes(&self) -> Vec<u8> {
        // Plain data with text keys: serialising cannot fail.
        serde_json::to_vec(&Written::from(self)).unwrap_or_default()
    }

    /// Returns the entry of such bytes; `None` for other bytes.
    pub(crate) fn from_bytes(bytes: &[u8]) -> Option<Self> {
        serde_json::from_slice::<Written>(bytes).ok().map(Self::from)
    }

    /// Returns about how many bytes it takes in memory.
    pub fn memory_bytes(&self) -> usize {
        let own = std::mem::size_of::<Self>();
        own + match self {
            Self::Audit(e) => {
                let texts = [&e.user, &e.station, &e.command, &e.old, &e.new, &e.result];
                texts.into_iter().map(String::len).sum::<usize>()
            }
            Self::Alarm { alarm, .. } => std::mem::size_of::<Alarm>() + 2 * alarm.name.as_data().len() + 256,
            Self::Acknowledge { name, by, .. } => by.len() + name.as_ref().map_or(0, |name| 2 * name.as_data().len()),
        }
    }

    fn insert(&self, db: &Connection, is_again: bool) -> rusqlite::Result<()> {
        match self {
            Self::Audit(entry) => audit::append(db, entry).map(drop),
            Self::Alarm { weld, alarm } => alarm::insert(db, *weld, alarm, true).map(drop),
            Self::Acknowledge { name, by, at } => {
                // An alarm that came after the acknowledgement may be in the library already.
                let until = if is_again { *at } else { Moment(i64::MAX) };
                alarm::acknowledge(db, name.as_ref(), by, *at, until).map(drop)
            }
        }
    }
}

/// Number of the newest rows among which entries are looked for that a crash may have stored already.
const RECENT: i64 = 100_000;

/// Newest rows of the library, each counted.
#[derive(Default)]
struct Stored {
    audit: HashMap<AuditEntry, usize>,
    alarms: HashMap<String, usize>,
}

fn alarm_key(alarm: &Alarm) -> String {
    format!("{} {:?} {}", alarm.raised.0, alarm.place.t_s, stored_message::written(&alarm.name))
}

impl Stored {
    /// Reads the rows that can be equal to one of `entries`.
    fn read(db: &Connection, entries: &[PendingEntry]) -> rusqlite::Result<Self> {
        let times = || {
            entries.iter().filter_map(|entry| match entry {
                PendingEntry::Audit(entry) => Some(entry.at.0),
                PendingEntry::Alarm { alarm, .. } => Some(alarm.raised.0),
                PendingEntry::Acknowledge { .. } => None,
            })
        };
        let mut stored = Self::default();
        let (Some(first), Some(last)) = (times().min(), times().max()) else { return Ok(stored) };
        let span = params![RECENT, first, last];
        let sql = "SELECT id, at, user, station, command, old, new, result FROM audit
            WHERE id > (SELECT coalesce(max(id), 0) - ?1 FROM audit) AND at BETWEEN ?2 AND ?3";
        for row in db.prepare(sql)?.query_map(span, audit::numbered)? {
            *stored.audit.entry(row?.1).or_default() += 1;
        }
        let sql = format!(
            "{} WHERE id > (SELECT coalesce(max(id), 0) - ?1 FROM alarm) AND raised BETWEEN ?2 AND ?3",
            alarm::SELECT
        );
        for row in db.prepare(&sql)?.query_map(span, alarm::alarm)? {
            *stored.alarms.entry(alarm_key(&row?)).or_default() += 1;
        }
        Ok(stored)
    }

    /// Returns true if a row equals the entry. Each row stands for one entry.
    fn take(&mut self, entry: &PendingEntry) -> bool {
        let count = match entry {
            PendingEntry::Audit(entry) => self.audit.get_mut(entry),
            PendingEntry::Alarm { alarm, .. } => self.alarms.get_mut(&alarm_key(alarm)),
            // To acknowledge twice changes nothing.
            PendingEntry::Acknowledge { .. } => None,
        };
        count.filter(|count| **count > 0).map(|count| *count -= 1).is_some()
    }
}

impl Library {
    /// Stores entries in one transaction: all of them, or none.
    pub fn store(&mut self, entries: &[PendingEntry]) -> Result<(), Error> {
        self.in_one(|db| entries.iter().try_for_each(|entry| entry.insert(db, false)))
    }

    /// Stores entries of which a crash may have stored some already: each is stored once. Equal entries of the same
    /// millisecond are counted. Returns the number of new ones.
    pub fn store_missing(&mut self, entries: &[PendingEntry]) -> Result<usize, Error> {
        self.in_one(|db| {
            let mut stored = Stored::read(db, entries)?;
            let missing = entries.iter().filter(|entry| !stored.take(entry));
            missing.map(|entry| entry.insert(db, true)).collect::<rusqlite::Result<Vec<()>>>().map(|all| all.len())
        })
    }

    /// Does `work` in one transaction.
    fn in_one<T>(&mut self, work: impl FnOnce(&Connection) -> rusqlite::Result<T>) -> Result<T, Error> {
        let path = self.path.clone();
        let failed = |e| Error::database(&path, e);
        let change = self.db.transaction_with_behavior(TransactionBehavior::Immediate).map_err(failed)?;
        let result = work(&change).map_err(failed)?;
        change.commit().map_err(failed)?;
        Ok(result)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn order(n: i64) -> PendingEntry {
        let text = |t: &str| t.to_owned();
        PendingEntry::Audit(AuditEntry {
            at: Moment(n),
            user: text("ada"),
            station: text("panel"),
            command: format!("order {n} \u{0}\n\"]\\"),
            old: text(""),
            new: text(""),
            result: text("accepted"),
        })
    }

    fn alarm(n: i64) -> PendingEntry {
        let name = Message::new("alarm-of").message("title", Message::new("alarm-2-title")).text("of", n.to_string());
        let place = Place { pass: Some(1), s_mm: Some(0.5), t_s: Some(n as f64) };
        let (cause, priority, raised) = (Message::new("alarm-2-cause"), "medium".to_owned(), Moment(n));
        let alarm = Alarm { name, cause, priority, place, raised, first_out: n == 1, acknowledged: None };
        PendingEntry::Alarm { weld: None, alarm: Box::new(alarm) }
    }

    fn acknowledged(at: i64) -> PendingEntry {
        PendingEntry::Acknowledge { name: None, by: "eve".to_owned(), at: Moment(at) }
    }

    #[test]
    fn an_entry_is_the_same_after_its_bytes() {
        for entry in [order(7), alarm(1), acknowledged(3)] {
            assert_eq!(PendingEntry::from_bytes(&entry.to_bytes()), Some(entry));
        }
        assert_eq!(PendingEntry::from_bytes(b"{}"), None);
    }

    /// However many entries were stored before a crash, each is there once afterwards.
    #[test]
    fn entries_are_stored_once() {
        // Equal entries of the same millisecond are two.
        let entries = [order(1), alarm(2), order(3), order(3), acknowledged(4), alarm(5), order(6)];
        for stored in 0..=entries.len() {
            let folder = tempfile::tempdir().unwrap();
            let mut library = Library::open(&folder.path().join("library.sqlite")).unwrap();
            library.store(&entries[..stored]).unwrap();
            let new = library.store_missing(&entries).unwrap();
            let known = entries[..stored].iter().filter(|e| !matches!(e, PendingEntry::Acknowledge { .. })).count();
            assert_eq!(new, entries.len() - known, "{stored}");
            assert_eq!(library.audit_entries(100).unwrap().len(), 4, "{stored}");
            let listed = library.listed_alarms().unwrap();
            assert_eq!(listed.iter().map(|alarm| alarm.raised).collect::<Vec<_>>(), [Moment(5)], "{stored}");
            assert!(library.verify_audit().unwrap().broken.is_none());
        }
    }

    /// An alarm of a weld that the library has lost is stored without it.
    #[test]
    fn a_lost_weld_loses_no_alarm() {
        let folder = tempfile::tempdir().unwrap();
        let mut library = Library::open(&folder.path().join("library.sqlite")).unwrap();
        let PendingEntry::Alarm { alarm, .. } = alarm(1) else { unreachable!() };
        library.store(&[PendingEntry::Alarm { weld: Some(99), alarm }]).unwrap();
        assert_eq!(library.listed_alarms().unwrap().len(), 1);
    }
}
