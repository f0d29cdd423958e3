//! Libraries that come from elsewhere: their schema held against ours, their rows copied into a file of our own.

use super::{Library, schema};
use crate::error::Error;
use rusqlite::{Connection, OpenFlags};
use seamwright_message::Message;
use std::collections::BTreeMap;
use std::path::Path;

/// Objects of a schema by kind and name, each with its statement.
type Objects = BTreeMap<(String, String), String>;

fn objects(db: &Connection) -> rusqlite::Result<Objects> {
    let mut query = db.prepare("SELECT type, name, coalesce(sql, '') FROM sqlite_schema")?;
    // Space does not matter: it changes with the version of SQLite that added a column.
    let plain = |sql: String| sql.split_whitespace().collect::<Vec<_>>().join(" ");
    let rows = query.query_map((), |row| Ok(((row.get(0)?, row.get(1)?), plain(row.get(2)?))))?;
    rows.collect()
}

/// An empty library of this schema version.
fn empty(db: Connection, version: i64) -> rusqlite::Result<Connection> {
    let steps = usize::try_from(version).unwrap_or(0).min(schema::MIGRATIONS.len());
    schema::MIGRATIONS[..steps].iter().try_for_each(|step| db.execute_batch(step))?;
    let marks = format!("PRAGMA application_id = {}; PRAGMA user_version = {steps};", schema::APPLICATION);
    db.execute_batch(&marks)?;
    Ok(db)
}

impl Library {
    /// Compares the schema with that of its version. Returns descriptions of foreign, changed and missing parts.
    pub fn foreign_schema(&self) -> Result<Vec<Message>, Error> {
        let version = self.version()?;
        let expected = Connection::open_in_memory().and_then(|db| objects(&empty(db, version)?));
        let (expected, found) = (expected.map_err(|e| self.failed(e))?, objects(&self.db).map_err(|e| self.failed(e))?);
        let mut problems = Vec::new();
        for ((kind, name), sql) in &found {
            match expected.get(&(kind.clone(), name.clone())) {
                None => problems.push(schema_problem("record-schema-foreign", kind, name)),
                Some(ours) if ours != sql => problems.push(schema_problem("record-schema-changed", kind, name)),
                Some(_) => {}
            }
        }
        let missing = expected.keys().filter(|key| !found.contains_key(*key));
        problems.extend(missing.map(|(kind, name)| schema_problem("record-schema-missing", kind, name)));
        Ok(problems)
    }

    /// Copies the rows of a library of foreign origin into a new file: only rows that fit our schema are copied. True
    /// if archives of its version have a manifest.
    ///
    /// # Errors
    /// A file that is no library or damaged, a foreign schema, rows that do not fit, a full disk.
    pub(crate) fn rebuild(from: &Path, to: &Path) -> Result<bool, Error> {
        let flags = OpenFlags::SQLITE_OPEN_READ_ONLY | OpenFlags::SQLITE_OPEN_NO_MUTEX;
        let source = Self::connect(from, flags)?;
        let version = source.version()?;
        if version < 1 {
            return Err(Error::damaged(from, Message::new("record-no-library"), Message::new("record-own-archive")));
        }
        if let Some(problem) = source.foreign_schema()?.first() {
            return Err(Error::damaged(from, problem.clone(), Message::new("record-own-schema")));
        }
        let has_manifests = source.has_manifests()?;
        drop(source);
        let failed = |e| Error::database(from, e);
        let db = Connection::open(to).and_then(|db| empty(db, version)).map_err(failed)?;
        copy(&db, from).map_err(failed)?;
        Ok(has_manifests)
    }
}

fn schema_problem(code: &'static str, kind: &str, name: &str) -> Message {
    Message::new(code).text("kind", kind).text("name", name)
}

/// Copies the rows of all tables.
fn copy(db: &Connection, from: &Path) -> rusqlite::Result<()> {
    db.execute_batch("PRAGMA foreign_keys = ON; PRAGMA trusted_schema = OFF; PRAGMA synchronous = FULL")?;
    db.execute("ATTACH DATABASE ?1 AS source", [from.to_string_lossy()])?;
    db.execute_batch("BEGIN")?;
    // Referenced tables come first: in the order of creation.
    let tables: Vec<String> = db
        .prepare("SELECT name FROM main.sqlite_schema WHERE type = 'table' AND name NOT LIKE 'sqlite\\_%' ESCAPE '\\' ORDER BY rowid")?
        .query_map((), |row| row.get(0))?
        .collect::<rusqlite::Result<_>>()?;
    for table in tables {
        let columns: Vec<String> = db
            .prepare("SELECT name FROM pragma_table_info(?1, 'main') ORDER BY cid")?
            .query_map([&table], |row| row.get::<_, String>(0).map(|name| format!("\"{name}\"")))?
            .collect::<rusqlite::Result<_>>()?;
        let columns = columns.join(", ");
        db.execute(
            &format!(
                "INSERT INTO main.\"{table}\" ({columns}) SELECT {columns} FROM source.\"{table}\" ORDER BY rowid"
            ),
            (),
        )?;
    }
    // Last numbers of the tables: they reveal entries cut off the end of the audit log.
    db.execute_batch(
        "DELETE FROM main.sqlite_sequence;
         INSERT INTO main.sqlite_sequence (name, seq)
            SELECT name, max(seq) FROM source.sqlite_sequence WHERE name IN (SELECT name FROM main.sqlite_schema) GROUP BY name;
         COMMIT; DETACH DATABASE source",
    )
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::library::audit::AuditEntry;
    use crate::library::document::DocumentKind;
    use crate::moment::Moment;
    use std::path::PathBuf;

    fn audit(library: &mut Library, command: &str) {
        let text = |t: &str| t.to_owned();
        let (user, station, old, new) = (text("ada"), text("panel"), text(""), text(""));
        let (command, result) = (text(command), text("taken"));
        library.audit(&AuditEntry { at: Moment(5), user, station, command, old, new, result }).unwrap();
    }

    fn library(folder: &Path) -> PathBuf {
        let path = folder.join("from.sqlite");
        let mut library = Library::open(&path).unwrap();
        library.add_document(DocumentKind::Job, "job.toml", "text").unwrap();
        audit(&mut library, "arm");
        audit(&mut library, "start");
        path
    }

    #[test]
    fn rows_are_copied_and_the_chain_goes_on() {
        let folder = tempfile::tempdir().unwrap();
        let (from, to) = (library(folder.path()), folder.path().join("to.sqlite"));
        assert_eq!(Library::open_to_read(&from).unwrap().foreign_schema().unwrap(), []);
        Library::rebuild(&from, &to).unwrap();
        let mut back = Library::open(&to).unwrap();
        assert_eq!(back.documents(DocumentKind::Job, "job.toml").unwrap().len(), 1);
        audit(&mut back, "stop");
        let check = back.verify_audit().unwrap();
        assert!(check.entries == 3 && check.broken.is_none(), "{check:?}");
        assert!(back.foreign_schema().unwrap().is_empty() && back.integrity().unwrap().is_empty());
    }

    /// Every addition to the schema is named and refused.
    #[test]
    fn foreign_schemas_are_named_and_refused() {
        for (sql, said) in [
            ("CREATE TRIGGER spy AFTER INSERT ON audit BEGIN DELETE FROM document; END", "trigger `spy`"),
            ("CREATE VIEW spy AS SELECT * FROM audit", "view `spy`"),
            ("CREATE TABLE spy (x)", "table `spy`"),
            ("CREATE INDEX spy ON audit (user)", "index `spy`"),
            ("ALTER TABLE audit ADD COLUMN spy TEXT", "table `audit` was changed"),
            ("DROP TRIGGER audit_is_not_changed", "`audit_is_not_changed` is missing"),
            (
                "DROP TRIGGER audit_is_not_changed; CREATE TRIGGER audit_is_not_changed BEFORE UPDATE ON audit BEGIN SELECT 1; END",
                "trigger `audit_is_not_changed` was changed",
            ),
        ] {
            let folder = tempfile::tempdir().unwrap();
            let (from, to) = (library(folder.path()), folder.path().join("to.sqlite"));
            Connection::open(&from).unwrap().execute_batch(sql).unwrap();
            let found = Library::open_to_read(&from).unwrap().foreign_schema().unwrap();
            assert!(found.iter().any(|problem| problem.to_string().contains(said)), "{sql}: {found:?}");
            let refused = Library::rebuild(&from, &to).unwrap_err().to_string();
            assert!(refused.contains('`') && !to.exists(), "{sql}: {refused}");
        }
    }

    /// A library of an older version is copied as that, and brought up to date when it is opened.
    #[test]
    fn older_libraries_are_copied_too() {
        let folder = tempfile::tempdir().unwrap();
        let (from, to) = (folder.path().join("from.sqlite"), folder.path().join("to.sqlite"));
        let old = empty(Connection::open(&from).unwrap(), 1).unwrap();
        old.execute_batch("INSERT INTO welder (name) VALUES ('ada')").unwrap();
        drop(old);
        Library::rebuild(&from, &to).unwrap();
        let library = Library::open(&to).unwrap();
        assert_eq!(library.one::<String>("SELECT name FROM welder", ()).unwrap(), "ada");
        assert!(library.foreign_schema().unwrap().is_empty());
    }
}
