use super::weld::{SELECT, weld_record};
use super::{Library, WeldRecord, WeldResult};
use crate::{Error, Moment, stored};
use rusqlite::types::Value;
use seamwright_message::Language;
use std::collections::HashMap;

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
    /// count alike, large and small. Words of notes and alarms are found in every language.
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
        let somewhere = "(part LIKE ?# ESCAPE '\\' OR title LIKE ?# ESCAPE '\\' OR (note LIKE ?# ESCAPE '\\' AND note NOT LIKE '{%')
            OR welder.name LIKE ?# ESCAPE '\\' OR j.text LIKE ?# ESCAPE '\\' OR p.text LIKE ?# ESCAPE '\\'
            OR EXISTS (SELECT 1 FROM alarm WHERE alarm.weld = weld.id
                AND ((alarm.name LIKE ?# ESCAPE '\\' AND alarm.name NOT LIKE '{%')
                    OR (cause LIKE ?# ESCAPE '\\' AND cause NOT LIKE '{%'))) OR weld.id IN (+))";
        if let Some(text) = &query.text {
            let said: Vec<String> = self.with_words(text)?.iter().map(i64::to_string).collect();
            condition(&somewhere.replace('+', &said.join(", ")), Value::Text(pattern(text)));
        }
        let filter = if conditions.is_empty() { String::new() } else { format!("WHERE {}", conditions.join(" AND ")) };
        let sql = format!("{SELECT} {filter} ORDER BY begun DESC, weld.id DESC");
        self.all(&sql, rusqlite::params_from_iter(values), weld_record)
    }
}

impl Library {
    /// Welds with `text` in the words of their notes or alarms, in any language: columns have codes instead of words.
    fn with_words(&self, text: &str) -> Result<Vec<i64>, Error> {
        let wanted = text.to_lowercase();
        let sql = "SELECT id, note FROM weld WHERE note LIKE '{%'
            UNION ALL SELECT weld, name FROM alarm WHERE weld IS NOT NULL AND name LIKE '{%'
            UNION ALL SELECT weld, cause FROM alarm WHERE weld IS NOT NULL AND cause LIKE '{%'";
        let mut known = HashMap::new();
        let mut found = Vec::new();
        let rows: Vec<(i64, String)> = self.all(sql, (), |row| Ok((row.get(0)?, row.get(1)?)))?;
        for (weld, column) in rows {
            let says = *known.entry(column).or_insert_with_key(|column| {
                let message = stored::read(column.clone());
                Language::ALL.into_iter().any(|of| message.in_language(of).to_lowercase().contains(&wanted))
            });
            found.extend(says.then_some(weld));
        }
        Ok(found)
    }
}

/// Pattern with which LIKE finds `text` literally.
pub(super) fn pattern(text: &str) -> String {
    let plain = text.replace('\\', "\\\\").replace('%', "\\%").replace('_', "\\_");
    format!("%{plain}%")
}
