//! The library: one SQLite file of the inputs and results of all welds.
//!
//! It is in write-ahead mode and synced at every commit: data are on the disk when a call returns. Reading never waits
//! for writing. `docs/reference/records.md` has the tables.

mod alarm;
mod audit;
mod document;
mod export;
mod find;
mod pending;
mod rebuild;
mod schema;
mod weld;
mod word_search;

pub use crate::event::{Event, Place};
pub use alarm::Alarm;
pub use audit::{AuditCheck, AuditEntry, AuditQuery};
pub use document::{Document, DocumentKind};
pub use export::{ExportedAlarm, ExportedAudit, Span};
pub use find::Query;
pub use pending::PendingEntry;
pub use weld::{InvalidResult, NewWeld, WeldDetail, WeldEnd, WeldFile, WeldRecord, WeldResult};

use crate::error::Error;
use crate::private_files;
use rusqlite::{Connection, OpenFlags, Params, Row};
use seamwright_message::Message;
use std::path::{Path, PathBuf};
use std::time::Duration;

/// Maximum wait of a call for another program's.
const PATIENCE: Duration = Duration::from_secs(5);

/// An open library. Every method fails if its file cannot be read or written, or if it does not have what a
/// number names.
#[derive(Debug)]
pub struct Library {
    path: PathBuf,
    db: Connection,
}

/// Ends queries of a library from another thread.
pub struct Interrupt(rusqlite::InterruptHandle);

impl Interrupt {
    /// Ends the query that is running, if any: it fails with [`Error::Interrupted`].
    pub fn now(&self) {
        self.0.interrupt();
    }
}

impl Library {
    /// Opens the library at `path` to read and write; created if missing, migrated to this version's schema if older.
    ///
    /// # Errors
    /// If it cannot be written, is damaged, is no library, or is of a later version.
    pub fn open(path: &Path) -> Result<Self, Error> {
        if !path.exists() {
            // SQLite gives files beside it the same permissions. If it cannot be created, SQLite reports the reason.
            drop(private_files::options().write(true).create_new(true).open(path));
        }
        let flags = OpenFlags::SQLITE_OPEN_READ_WRITE | OpenFlags::SQLITE_OPEN_CREATE | OpenFlags::SQLITE_OPEN_NO_MUTEX;
        let mut library = Self::connect(path, flags)?;
        library.migrate()?;
        Ok(library)
    }

    /// Writes a copy of the present state, without blocking other users.
    /// Fails if `to` exists or cannot be written.
    pub(crate) fn copy_to(&self, to: &Path) -> Result<(), Error> {
        let sql = "VACUUM INTO ?1";
        self.db.execute(sql, [to.to_string_lossy()]).map(drop).map_err(|e| self.failed(e))
    }

    /// Opens the library at `path` only to read it, also in a read-only folder.
    ///
    /// # Errors
    /// If it is missing, damaged, or of another version.
    pub fn open_to_read(path: &Path) -> Result<Self, Error> {
        if !path.is_file() {
            let what = Message::new("record-library-missing").text("path", path.display().to_string());
            return Err(Error::wrong(what, Message::new("record-begin-library")));
        }
        let flags = OpenFlags::SQLITE_OPEN_READ_ONLY | OpenFlags::SQLITE_OPEN_NO_MUTEX;
        let library = match Self::connect(path, flags) {
            // In a folder where SQLite cannot create its shared memory, there are no writers either.
            Err(Error::ReadOnly { .. }) if !path.with_extension("sqlite-wal").exists() => {
                let address = format!("file:{}?immutable=1", escaped(path));
                Self::connect(Path::new(&address), flags | OpenFlags::SQLITE_OPEN_URI)
                    .map(|library| Self { path: path.to_owned(), ..library })?
            }
            library => library?,
        };
        match library.version()? {
            v if v == schema::MIGRATIONS.len() as i64 => Ok(library),
            v => {
                let why = Message::new("record-schema-version").number("found", v as f64, 0);
                let why = why.number("known", schema::MIGRATIONS.len() as f64, 0);
                Err(Error::damaged(path, why, Message::new("record-migrate")))
            }
        }
    }

    fn connect(path: &Path, flags: OpenFlags) -> Result<Self, Error> {
        let failed = |e| Error::database(path, e);
        let db = Connection::open_with_flags(path, flags).map_err(failed)?;
        let library = Self { path: path.to_owned(), db };
        library.db.busy_timeout(PATIENCE).map_err(failed)?;
        let found: i64 = library.one("PRAGMA application_id", ())?;
        let version = library.version()?;
        let empty = library.one::<i64>("SELECT count(*) FROM sqlite_schema", ())? == 0;
        if found != schema::APPLICATION && !empty {
            return Err(Error::damaged(path, Message::new("record-no-library"), Message::new("record-other-folder")));
        }
        let known = schema::MIGRATIONS.len() as i64;
        if version > known {
            return Err(Error::Newer { path: path.to_owned(), found: version, known });
        }
        let settings = "PRAGMA foreign_keys = ON; PRAGMA synchronous = FULL; PRAGMA trusted_schema = OFF;";
        library.db.execute_batch(settings).and_then(|()| word_search::define(&library.db)).map_err(failed)?;
        Ok(library)
    }

    fn version(&self) -> Result<i64, Error> {
        self.one("PRAGMA user_version", ())
    }

    fn migrate(&mut self) -> Result<(), Error> {
        let path = self.path.clone();
        let failed = |e| Error::database(&path, e);
        self.db.execute_batch("PRAGMA journal_mode = WAL").map_err(failed)?;
        let known = schema::MIGRATIONS.len() as i64;
        if self.version()? == known {
            return Ok(());
        }
        let change = self.db.transaction_with_behavior(rusqlite::TransactionBehavior::Immediate).map_err(failed)?;
        // Another program may have been first.
        let version: i64 = change.query_row("PRAGMA user_version", (), |row| row.get(0)).map_err(failed)?;
        for step in &schema::MIGRATIONS[version as usize..] {
            change.execute_batch(step).map_err(failed)?;
        }
        let marks = format!("PRAGMA application_id = {}; PRAGMA user_version = {known};", schema::APPLICATION);
        change.execute_batch(&marks).and_then(|()| change.commit()).map_err(failed)
    }

    /// True for a library of a version whose archives have a manifest.
    pub(crate) fn has_manifests(&self) -> Result<bool, Error> {
        Ok(self.version()? >= schema::MANIFEST_VERSION)
    }

    /// Returns a handle that ends its queries.
    pub fn interrupt(&self) -> Interrupt {
        Interrupt(self.db.get_interrupt_handle())
    }

    /// Path of the library.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Lets the file grow to this many pages (of 4 KiB) and no further.
    pub fn limit_pages(&self, pages: u32) -> Result<(), Error> {
        let set = self.db.query_row(&format!("PRAGMA max_page_count = {pages}"), (), |_| Ok(()));
        set.map_err(|e| self.failed(e))
    }

    /// Takes the lock for writing and gives it back, to know whether the library can be written. Waits some seconds for
    /// another program.
    pub fn check_writable(&self) -> Result<(), Error> {
        self.db.execute_batch("BEGIN IMMEDIATE; ROLLBACK").map_err(|e| self.failed(e))
    }

    /// Faults that SQLite finds in the file; empty if it is whole.
    pub fn integrity(&self) -> Result<Vec<Message>, Error> {
        let found: Vec<String> = self.all("PRAGMA integrity_check", (), |row| row.get(0))?;
        let mut found: Vec<Message> = found.into_iter().filter(|text| text != "ok").map(Message::verbatim).collect();
        let loose = self.all("PRAGMA foreign_key_check", (), |row| {
            Ok(Message::new("record-loose-row").text("table", row.get::<_, String>(0)?))
        })?;
        found.extend(loose);
        Ok(found)
    }

    fn one<T: rusqlite::types::FromSql>(&self, sql: &str, params: impl Params) -> Result<T, Error> {
        self.db.query_row(sql, params, |row| row.get(0)).map_err(|e| self.failed(e))
    }

    fn row<T>(
        &self,
        sql: &str,
        params: impl Params,
        read: impl FnOnce(&Row) -> rusqlite::Result<T>,
    ) -> Result<Option<T>, Error> {
        use rusqlite::OptionalExtension;
        self.db.query_row(sql, params, read).optional().map_err(|e| self.failed(e))
    }

    fn all<T>(
        &self,
        sql: &str,
        params: impl Params,
        read: impl FnMut(&Row) -> rusqlite::Result<T>,
    ) -> Result<Vec<T>, Error> {
        let rows = self.db.prepare_cached(sql).and_then(|mut query| query.query_map(params, read)?.collect());
        rows.map_err(|e| self.failed(e))
    }

    /// Runs a statement; how many rows it changed.
    fn run(&self, sql: &str, params: impl Params) -> Result<usize, Error> {
        self.db.prepare_cached(sql).and_then(|mut statement| statement.execute(params)).map_err(|e| self.failed(e))
    }

    fn failed(&self, cause: rusqlite::Error) -> Error {
        Error::database(&self.path, cause)
    }
}

fn escaped(path: &Path) -> String {
    path.display().to_string().replace('%', "%25").replace('?', "%3f").replace('#', "%23")
}
