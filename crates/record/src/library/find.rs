use super::Library;
use super::weld::{SELECT, WeldRecord, WeldResult, weld_record};
use crate::error::Error;
use crate::moment::Moment;
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
    /// Somewhere in part, title, welder, note, the texts of job or program, or names and causes of alarms. Upper and lower
    /// case are the same. Words of notes and alarms are found in every language.
    pub text: Option<String>,
    /// Maximum number of welds, the newest; none: all.
    pub limit: Option<u32>,
}

impl Library {
    /// Welds that fit, the newest first.
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
        if let Some(text) = &query.text {
            values.extend([Value::Text(pattern(text)), Value::Text(text.clone())]);
            let (pattern, words) = (values.len() - 1, values.len());
            conditions.push(format!(
                "(has_words(part, ?{words}) OR has_words(title, ?{words}) OR has_words(welder.name, ?{words})
                OR has_words(note, ?{words}) OR j.text LIKE ?{pattern} ESCAPE '\\' OR p.text LIKE ?{pattern} ESCAPE '\\'
                OR EXISTS (SELECT 1 FROM alarm WHERE alarm.weld = weld.id
                    AND (has_words(alarm.name, ?{words}) OR has_words(cause, ?{words}))))"
            ));
        }
        let filter = if conditions.is_empty() { String::new() } else { format!("WHERE {}", conditions.join(" AND ")) };
        values.push(Value::Integer(query.limit.map_or(-1, i64::from)));
        let sql = format!("{SELECT} {filter} ORDER BY begun DESC, weld.id DESC LIMIT ?{}", values.len());
        self.all(&sql, rusqlite::params_from_iter(values), weld_record)
    }
}

/// Pattern with which LIKE finds `text` literally.
fn pattern(text: &str) -> String {
    let plain = text.replace('\\', "\\\\").replace('%', "\\%").replace('_', "\\_");
    format!("%{plain}%")
}
