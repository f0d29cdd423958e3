use super::Library;
use crate::error::Error;
use crate::hash::sha256;
use crate::moment::Moment;
use rusqlite::{Connection, TransactionBehavior, params};
use seamwright_message::Message;

/// A command with its user and station.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct AuditEntry {
    /// Time.
    pub at: Moment,
    /// User of the command.
    pub user: String,
    /// Station of the command.
    pub station: String,
    /// The command.
    pub command: String,
    /// The value before; may be empty.
    pub old: String,
    /// The value after; may be empty.
    pub new: String,
    /// Result of the command.
    pub result: String,
}

/// Search in the audit log.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct AuditQuery {
    /// Only entries whose number is lower.
    pub before: Option<i64>,
    /// Only entries whose number is higher.
    pub after: i64,
    /// Only entries with this in one of their texts; empty: all. Upper and lower case are the same. Words of messages are
    /// found in every language.
    pub text: String,
    /// So many at most.
    pub most: u32,
}

/// Result of [`Library::verify_audit`].
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct AuditCheck {
    /// Entries up to the first that does not hold.
    pub entries: u64,
    /// Number of the first entry that does not hold, and why.
    pub broken: Option<(i64, Message)>,
}

/// The hash before the first entry.
const BEGIN: &str = "0000000000000000000000000000000000000000000000000000000000000000";

impl AuditEntry {
    /// SHA-256 of the hash before, the number and all fields. Each has its length, so that no text can move from one
    /// field into the next.
    fn hash(&self, id: i64, before: &str) -> String {
        let mut bytes = before.as_bytes().to_vec();
        bytes.extend_from_slice(&id.to_le_bytes());
        bytes.extend_from_slice(&self.at.0.to_le_bytes());
        for field in [&self.user, &self.station, &self.command, &self.old, &self.new, &self.result] {
            bytes.extend_from_slice(&(field.len() as u64).to_le_bytes());
            bytes.extend_from_slice(field.as_bytes());
        }
        sha256(&bytes)
    }
}

/// An entry with its number, from the columns as they stand.
pub(super) fn numbered(row: &rusqlite::Row<'_>) -> rusqlite::Result<(i64, AuditEntry)> {
    let entry = AuditEntry {
        at: Moment(row.get(1)?),
        user: row.get(2)?,
        station: row.get(3)?,
        command: row.get(4)?,
        old: row.get(5)?,
        new: row.get(6)?,
        result: row.get(7)?,
    };
    Ok((row.get(0)?, entry))
}

/// Appends to the audit log within a transaction. Returns the entry's hash.
pub(super) fn append(db: &Connection, entry: &AuditEntry) -> rusqlite::Result<String> {
    let last = "SELECT id, hash FROM audit ORDER BY id DESC LIMIT 1";
    let last = db.query_row(last, (), |row| Ok((row.get::<_, i64>(0)?, row.get::<_, String>(1)?)));
    let (id, before) = match last {
        Err(rusqlite::Error::QueryReturnedNoRows) => (0, BEGIN.to_owned()),
        last => last?,
    };
    let hash = entry.hash(id + 1, &before);
    let AuditEntry { at, user, station, command, old, new, result } = entry;
    let sql = "INSERT INTO audit (id, at, user, station, command, old, new, result, hash)
        VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8, ?9)";
    let row = params![id + 1, at.0, user, station, command, old, new, result, hash];
    db.prepare_cached(sql)?.execute(row)?;
    Ok(hash)
}

impl Library {
    /// Appends to the audit log; the entry's hash.
    pub fn audit(&mut self, entry: &AuditEntry) -> Result<String, Error> {
        let path = self.path.clone();
        let failed = |e| Error::database(&path, e);
        let change = self.db.transaction_with_behavior(TransactionBehavior::Immediate).map_err(failed)?;
        let hash = append(&change, entry).map_err(failed)?;
        change.commit().map_err(failed)?;
        Ok(hash)
    }

    /// The last `most` entries of the audit log, the newest first.
    pub fn audit_entries(&self, most: u32) -> Result<Vec<AuditEntry>, Error> {
        let page = self.audit_page(&AuditQuery { most, ..AuditQuery::default() })?;
        Ok(page.into_iter().map(|(_, entry)| entry).collect())
    }

    /// Entries of the audit log that match `query`, the newest first, each with its number.
    pub fn audit_page(&self, query: &AuditQuery) -> Result<Vec<(i64, AuditEntry)>, Error> {
        let sql = "SELECT id, at, user, station, command, old, new, result FROM audit
            WHERE id < ?1 AND id > ?4 AND (?2 = '' OR has_words(user, ?2) OR has_words(station, ?2)
                OR has_words(command, ?2) OR has_words(old, ?2) OR has_words(new, ?2) OR has_words(result, ?2))
            ORDER BY id DESC LIMIT ?3";
        let before = query.before.unwrap_or(i64::MAX);
        self.all(sql, params![before, query.text, query.most, query.after], numbered)
    }

    /// Checks every link of the audit log. Entries cut off its end are detected by the count that SQLite keeps beside
    /// the table. A change of that count too is detected only by a hash kept elsewhere.
    pub fn verify_audit(&self) -> Result<AuditCheck, Error> {
        let (mut before, mut entries, mut next, mut broken) = (BEGIN.to_owned(), 0, 1, None);
        let sql = "SELECT id, at, user, station, command, old, new, result, hash FROM audit ORDER BY id";
        let mut query = self.db.prepare(sql).map_err(|e| self.failed(e))?;
        let mut rows = query.query(()).map_err(|e| self.failed(e))?;
        while let Some(row) = rows.next().map_err(|e| self.failed(e))? {
            let read = || rusqlite::Result::Ok((numbered(row)?, row.get::<_, String>(8)?));
            let ((id, entry), hash) = read().map_err(|e| self.failed(e))?;
            if id != next {
                broken = Some((next, Message::new("record-audit-missing")));
                break;
            }
            if entry.hash(id, &before) != hash {
                broken = Some((id, Message::new("record-audit-hash")));
                break;
            }
            (before, entries, next) = (hash, entries + 1, next + 1);
        }
        let counted =
            self.row("SELECT seq FROM sqlite_sequence WHERE name = 'audit'", (), |row| row.get::<_, i64>(0))?;
        if broken.is_none() && counted.unwrap_or(0) >= next {
            broken = Some((next, Message::new("record-audit-cut-off")));
        }
        Ok(AuditCheck { entries, broken })
    }
}
