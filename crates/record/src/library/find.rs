use super::weld::{SELECT, weld_record};
use super::{Library, WeldRecord, WeldResult};
use crate::{Error, Moment};
use rusqlite::types::Value;

/// Search for welds; a missing criterion matches all.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Query {
    /// The whole number of the part.
    pub part: Option<String>,
    /// Begun at this moment or later.
    pub since: Option<Moment>,
    /// Begun before this moment.
    pub until: Option<Moment>,
    /// SHA-256 of the program.
    pub program: Option<String>,
    /// Number of the procedure.
    pub procedure: Option<String>,
    /// Name of the machine.
    pub machine: Option<String>,
    /// Result of the weld.
    pub result: Option<WeldResult>,
    /// Somewhere in part, title, welder, note, the texts of job or program, or names and causes of alarms; letters
    /// count alike, large and small.
    pub text: Option<String>,
}

impl Library {
    /// Welds that fit, the newest first.
    ///
    /// # Errors
    /// If the library cannot be read.
    pub fn find(&self, query: &Query) -> Result<Vec<WeldRecord>, Error> {
        let (mut conditions, mut values) = (Vec::new(), Vec::new());
        let mut condition = |sql: &str, value: Value| {
            values.push(value);
            conditions.push(sql.replace('#', &values.len().to_string()));
        };
        let text = |text: &String| Value::Text(text.clone());
        query.part.iter().for_each(|v| condition("part = ?#", text(v)));
        query.since.iter().for_each(|v| condition("begun >= ?#", Value::Integer(v.0)));
        query.until.iter().for_each(|v| condition("begun < ?#", Value::Integer(v.0)));
        query.program.iter().for_each(|v| condition("p.sha256 = ?#", text(v)));
        query.procedure.iter().for_each(|v| condition("w.name = ?#", text(v)));
        query.machine.iter().for_each(|v| condition("m.name = ?#", text(v)));
        query.result.iter().for_each(|v| condition("result = ?#", Value::Text(v.name().to_owned())));
        let somewhere = "(part LIKE ?# ESCAPE '\\' OR title LIKE ?# ESCAPE '\\' OR note LIKE ?# ESCAPE '\\'
            OR welder.name LIKE ?# ESCAPE '\\' OR j.text LIKE ?# ESCAPE '\\' OR p.text LIKE ?# ESCAPE '\\'
            OR EXISTS (SELECT 1 FROM alarm WHERE alarm.weld = weld.id
                AND (alarm.name LIKE ?# ESCAPE '\\' OR cause LIKE ?# ESCAPE '\\')))";
        query.text.iter().for_each(|v| condition(somewhere, Value::Text(pattern(v))));
        let filter = if conditions.is_empty() { String::new() } else { format!("WHERE {}", conditions.join(" AND ")) };
        let sql = format!("{SELECT} {filter} ORDER BY begun DESC, weld.id DESC");
        self.all(&sql, rusqlite::params_from_iter(values), weld_record)
    }
}

/// Pattern with which LIKE finds `text` literally.
pub(super) fn pattern(text: &str) -> String {
    let plain = text.replace('\\', "\\\\").replace('%', "\\%").replace('_', "\\_");
    format!("%{plain}%")
}
