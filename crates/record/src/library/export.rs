//! Audit log and alarms as they leave the library for other programs: English words, and codes with arguments.

use super::alarm::{self, Alarm};
use super::audit::{self, AuditEntry};
use super::{Error, Library};
use crate::moment::Moment;
use crate::stored_message;
use rusqlite::params;
use seamwright_message::{Argument, Language, Message};
use serde::{Serialize, Serializer};
use std::collections::BTreeMap;

/// Entries to export.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Span {
    /// Only entries whose number is higher.
    pub after: i64,
    /// Only entries at this time or later.
    pub since: Moment,
    /// Only entries before this time.
    pub until: Moment,
}

impl Default for Span {
    /// All entries.
    fn default() -> Self {
        Self { after: 0, since: Moment(i64::MIN), until: Moment(i64::MAX) }
    }
}

/// A message for other programs.
#[derive(Debug, Clone, PartialEq, Serialize)]
struct Words {
    text: String,
    code: String,
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    arguments: BTreeMap<String, Argument>,
}

impl Words {
    fn of(message: &Message) -> Self {
        let arguments = message.arguments.iter().map(|(name, argument)| (name.to_string(), argument.clone()));
        // The words of a sentence stand in the text.
        let arguments = if message.is_verbatim() { BTreeMap::new() } else { arguments.collect() };
        Self { text: message.in_language(Language::English), code: message.code.to_string(), arguments }
    }
}

fn rfc3339<S: Serializer>(at: &Moment, out: S) -> Result<S::Ok, S::Error> {
    out.serialize_str(&at.rfc3339())
}

/// An entry of the audit log.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ExportedAudit {
    kind: &'static str,
    /// Its number.
    pub id: i64,
    #[serde(serialize_with = "rfc3339")]
    at: Moment,
    user: String,
    station: Words,
    command: Words,
    old: String,
    new: String,
    result: Words,
    /// Its link in the chain of hashes.
    pub hash: String,
}

impl ExportedAudit {
    fn new(id: i64, entry: AuditEntry, hash: String) -> Self {
        let [station, command, result] =
            [entry.station, entry.command, entry.result].map(|column| Words::of(&stored_message::read(column)));
        let AuditEntry { at, user, old, new, .. } = entry;
        Self { kind: "audit", id, at, user, station, command, old, new, result, hash }
    }
}

/// An alarm.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct ExportedAlarm {
    kind: &'static str,
    /// Its number in the library.
    pub id: i64,
    #[serde(serialize_with = "rfc3339")]
    at: Moment,
    weld: Option<i64>,
    priority: String,
    alarm: Words,
    cause: Words,
    first_out: bool,
    pass: Option<u32>,
    s_mm: Option<f64>,
    t_s: Option<f64>,
    acknowledged_by: Option<String>,
    #[serde(serialize_with = "optional_rfc3339")]
    acknowledged: Option<Moment>,
}

fn optional_rfc3339<S: Serializer>(at: &Option<Moment>, out: S) -> Result<S::Ok, S::Error> {
    at.map(Moment::rfc3339).serialize(out)
}

impl ExportedAlarm {
    fn new(id: i64, weld: Option<i64>, of: Alarm) -> Self {
        let (acknowledged_by, acknowledged) = of.acknowledged.unzip();
        Self {
            kind: "alarm",
            id,
            at: of.raised,
            weld,
            priority: of.priority,
            alarm: Words::of(&of.name),
            cause: Words::of(&of.cause),
            first_out: of.first_out,
            pass: of.place.pass,
            s_mm: of.place.s_mm,
            t_s: of.place.t_s,
            acknowledged_by,
            acknowledged,
        }
    }
}

impl Library {
    /// Passes entries of the audit log to `each`, the oldest first, until it returns an error. The log is read row by
    /// row, as it is at the start of the call.
    pub fn export_audit<E: From<Error>>(
        &self,
        span: &Span,
        mut each: impl FnMut(&ExportedAudit) -> Result<(), E>,
    ) -> Result<(), E> {
        let sql = "SELECT id, at, user, station, command, old, new, result, hash FROM audit
            WHERE id > ?1 AND at >= ?2 AND at < ?3 ORDER BY id";
        let mut query = self.db.prepare(sql).map_err(|e| self.failed(e))?;
        let mut rows = query.query(params![span.after, span.since.0, span.until.0]).map_err(|e| self.failed(e))?;
        while let Some(row) = rows.next().map_err(|e| self.failed(e))? {
            let read = || Ok((audit::numbered(row)?, row.get(8)?));
            let ((id, entry), hash) = read().map_err(|e| self.failed(e))?;
            each(&ExportedAudit::new(id, entry, hash))?;
        }
        Ok(())
    }

    /// Passes alarms to `each`, the oldest first, until it returns an error.
    pub fn export_alarms<E: From<Error>>(
        &self,
        span: &Span,
        mut each: impl FnMut(&ExportedAlarm) -> Result<(), E>,
    ) -> Result<(), E> {
        let columns = alarm::SELECT.replace(" FROM alarm", ", id, weld FROM alarm");
        let sql = format!("{columns} WHERE id > ?1 AND raised >= ?2 AND raised < ?3 ORDER BY id");
        let mut query = self.db.prepare(&sql).map_err(|e| self.failed(e))?;
        let mut rows = query.query(params![span.after, span.since.0, span.until.0]).map_err(|e| self.failed(e))?;
        while let Some(row) = rows.next().map_err(|e| self.failed(e))? {
            let read = || Ok((row.get(10)?, row.get(11)?, alarm::alarm(row)?));
            let (id, weld, alarm) = read().map_err(|e| self.failed(e))?;
            each(&ExportedAlarm::new(id, weld, alarm))?;
        }
        Ok(())
    }
}
