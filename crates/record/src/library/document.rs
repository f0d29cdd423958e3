use super::Library;
use crate::error::Error;
use crate::hash::sha256;
use crate::moment::Moment;
use rusqlite::{Row, params};
use seamwright_message::Message;

/// Kind of a text.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum DocumentKind {
    /// A job file.
    Job,
    /// A weld program.
    Program,
    /// A machine file.
    Machine,
    /// A welding procedure.
    Procedure,
}

impl DocumentKind {
    /// Name in the table.
    pub fn name(self) -> &'static str {
        match self {
            Self::Job => "job",
            Self::Program => "program",
            Self::Machine => "machine",
            Self::Procedure => "procedure",
        }
    }
}

/// A version of a text.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Document {
    /// Its number in the library.
    pub id: i64,
    /// Its name, for example a procedure's number.
    pub name: String,
    /// Counted from 1 for each name.
    pub version: i64,
    /// SHA-256 of the text.
    pub sha256: String,
    /// The text.
    pub text: String,
    /// Time of its first use.
    pub added: Moment,
}

impl Library {
    /// The number of this text under this name: the version that has it, or a new one.
    pub fn add_document(&self, kind: DocumentKind, name: &str, text: &str) -> Result<i64, Error> {
        let hash = sha256(text.as_bytes());
        let known = "SELECT id FROM document WHERE kind = ?1 AND name = ?2 AND sha256 = ?3";
        let insert = "INSERT INTO document (kind, name, version, sha256, text, added)
            SELECT ?1, ?2, 1 + coalesce(max(version), 0), ?3, ?4, ?5 FROM document WHERE kind = ?1 AND name = ?2
            ON CONFLICT (kind, name, sha256) DO NOTHING";
        self.run(insert, params![kind.name(), name, hash, text, Moment::now().0])?;
        self.one(known, params![kind.name(), name, hash])
    }

    /// All versions of a text, the first first.
    pub fn documents(&self, kind: DocumentKind, name: &str) -> Result<Vec<Document>, Error> {
        let sql = format!("{SELECT} WHERE kind = ?1 AND name = ?2 ORDER BY version");
        self.all(&sql, params![kind.name(), name], document)
    }

    /// The text of that number.
    pub fn document(&self, id: i64) -> Result<Document, Error> {
        let found = self.row(&format!("{SELECT} WHERE id = ?1"), [id], document)?;
        found.ok_or_else(|| {
            Error::wrong(
                Message::new("record-no-document").number("id", id as f64, 0),
                Message::new("record-known-number"),
            )
        })
    }
}

const SELECT: &str = "SELECT id, name, version, sha256, text, added FROM document";

fn document(row: &Row) -> rusqlite::Result<Document> {
    Ok(Document {
        id: row.get(0)?,
        name: row.get(1)?,
        version: row.get(2)?,
        sha256: row.get(3)?,
        text: row.get(4)?,
        added: Moment(row.get(5)?),
    })
}
