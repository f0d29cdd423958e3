use super::Library;
use crate::error::Error;
use crate::event::{Event, Place};
use crate::moment::Moment;
use crate::stored_message;
use rusqlite::{Connection, Row, params};
use seamwright_message::{Language, Message};
use serde::Serialize;

/// An alarm.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Alarm {
    /// Its title in the catalogue, with what it is about.
    #[serde(flatten, serialize_with = "stored_message::name")]
    pub name: Message,
    /// Cause.
    #[serde(serialize_with = "stored_message::english")]
    pub cause: Message,
    /// Priority: `critical`, `high`, `medium`, `low`; empty in records of older versions.
    pub priority: String,
    /// Position.
    #[serde(flatten)]
    pub place: Place,
    /// Time.
    #[serde(serialize_with = "crate::moment::written")]
    pub raised: Moment,
    /// It was the first of those that came together.
    pub first_out: bool,
    /// User who acknowledged it, and the time.
    #[serde(serialize_with = "acknowledged")]
    pub acknowledged: Option<(String, Moment)>,
}

fn acknowledged<S: serde::Serializer>(value: &Option<(String, Moment)>, out: S) -> Result<S::Ok, S::Error> {
    value.as_ref().map(|(by, at)| format!("{by}, {at}")).serialize(out)
}

pub(super) const SELECT: &str =
    "SELECT name, cause, pass, s_mm, t_s, raised, first_out, acknowledged_by, acknowledged, priority FROM alarm";

pub(super) fn alarm(row: &Row<'_>) -> rusqlite::Result<Alarm> {
    let by: Option<String> = row.get(7)?;
    let at: Option<i64> = row.get(8)?;
    Ok(Alarm {
        name: stored_message::column(row, 0)?,
        cause: stored_message::column(row, 1)?,
        priority: row.get(9)?,
        place: Place { pass: row.get(2)?, s_mm: row.get(3)?, t_s: row.get(4)? },
        raised: Moment(row.get(5)?),
        first_out: row.get(6)?,
        acknowledged: by.zip(at.map(Moment)),
    })
}

/// Adds an alarm to the table, with its weld if the library has it. Returns its number.
pub(super) fn insert(db: &Connection, weld: Option<i64>, alarm: &Alarm, is_listed: bool) -> rusqlite::Result<i64> {
    let (by, at) = alarm.acknowledged.as_ref().map(|(by, at)| (by, at.0)).unzip();
    let Place { pass, s_mm, t_s } = alarm.place;
    let sql = "INSERT INTO alarm
            (weld, name, cause, pass, s_mm, t_s, raised, first_out, acknowledged_by, acknowledged, priority, listed)
        VALUES ((SELECT id FROM weld WHERE id = ?1), ?2, ?3, ?4, ?5, ?6, ?7, ?8, ?9, ?10, ?11, ?12)";
    let (name, cause) = (stored_message::written(&alarm.name), stored_message::written(&alarm.cause));
    let (raised, priority) = (alarm.raised.0, &alarm.priority);
    db.prepare_cached(sql)?.execute(params![
        weld,
        name,
        cause,
        pass,
        s_mm,
        t_s,
        raised,
        alarm.first_out,
        by,
        at,
        priority,
        is_listed
    ])?;
    Ok(db.last_insert_rowid())
}

/// Acknowledges the alarms on the panel's list: all, or those of a name, also as a sentence of an older version. Alarms
/// raised after `until` stay.
pub(super) fn acknowledge(
    db: &Connection,
    name: Option<&Message>,
    by: &str,
    at: Moment,
    until: Moment,
) -> rusqlite::Result<usize> {
    let sql = "UPDATE alarm SET listed = 0, acknowledged_by = coalesce(acknowledged_by, ?1),
        acknowledged = coalesce(acknowledged, ?2) WHERE listed = 1 AND raised <= ?3 AND (?4 IS NULL OR name IN (?4, ?5))";
    let (stored, english) =
        name.map(|name| (stored_message::written(name), name.in_language(Language::English))).unzip();
    db.prepare_cached(sql)?.execute(params![by, at.0, until.0, stored, english])
}

pub(super) fn add_event(db: &Connection, weld: Option<i64>, event: &Event) -> rusqlite::Result<()> {
    let Place { pass, s_mm, t_s } = event.place;
    let sql = "INSERT INTO event (weld, at, text, pass, s_mm, t_s) VALUES (?1, ?2, ?3, ?4, ?5, ?6)";
    let row = params![weld, event.at.0, stored_message::written(&event.text), pass, s_mm, t_s];
    db.prepare_cached(sql)?.execute(row).map(drop)
}

/// Acknowledgements of every alarm, whenever it was raised.
const ALWAYS: Moment = Moment(i64::MAX);

impl Library {
    /// Adds an alarm, with or without a weld. Returns its number.
    pub fn add_alarm(&self, weld: Option<i64>, alarm: &Alarm) -> Result<i64, Error> {
        insert(&self.db, weld, alarm, false).map_err(|e| self.failed(e))
    }

    /// Acknowledges the alarm; the first acknowledgement counts.
    pub fn acknowledge(&self, alarm: i64, by: &str, at: Moment) -> Result<(), Error> {
        let sql = "UPDATE alarm SET acknowledged_by = coalesce(acknowledged_by, ?2),
            acknowledged = coalesce(acknowledged, ?3) WHERE id = ?1";
        match self.run(sql, params![alarm, by, at.0])? {
            0 => Err(Error::wrong(
                Message::new("record-no-alarm").number("id", alarm as f64, 0),
                Message::new("record-known-number"),
            )),
            _ => Ok(()),
        }
    }

    /// Puts an alarm on the panel's list, where it stays until [`Library::acknowledge_listed`].
    pub fn list_alarm(&self, alarm: i64) -> Result<(), Error> {
        self.run("UPDATE alarm SET listed = 1 WHERE id = ?1", [alarm]).map(drop)
    }

    /// Acknowledges all alarms on the panel's list. Returns their number.
    pub fn acknowledge_listed(&self, by: &str, at: Moment) -> Result<usize, Error> {
        acknowledge(&self.db, None, by, at, ALWAYS).map_err(|e| self.failed(e))
    }

    /// Acknowledges the alarms of this name on the panel's list, also those with the sentence of an older version.
    /// Returns their number.
    pub fn acknowledge_named(&self, name: &Message, by: &str, at: Moment) -> Result<usize, Error> {
        acknowledge(&self.db, Some(name), by, at, ALWAYS).map_err(|e| self.failed(e))
    }

    /// Alarms on the panel's list, in the order in which they came.
    pub fn listed_alarms(&self) -> Result<Vec<Alarm>, Error> {
        self.all(&format!("{SELECT} WHERE listed = 1 ORDER BY id"), (), alarm)
    }

    /// Alarms of a weld, in the order in which they came.
    pub fn alarms(&self, weld: i64) -> Result<Vec<Alarm>, Error> {
        self.all(&format!("{SELECT} WHERE weld = ?1 ORDER BY id"), [weld], alarm)
    }

    /// Adds an event, with or without a weld.
    pub fn add_event(&self, weld: Option<i64>, event: &Event) -> Result<(), Error> {
        add_event(&self.db, weld, event).map_err(|e| self.failed(e))
    }

    /// Events of a weld, in the order in which they came.
    pub fn events(&self, weld: i64) -> Result<Vec<Event>, Error> {
        let sql = "SELECT at, text, pass, s_mm, t_s FROM event WHERE weld = ?1 ORDER BY id";
        self.all(sql, [weld], |row| {
            let place = Place { pass: row.get(2)?, s_mm: row.get(3)?, t_s: row.get(4)? };
            Ok(Event { at: Moment(row.get(0)?), text: stored_message::column(row, 1)?, place })
        })
    }
}
