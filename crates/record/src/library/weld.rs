use super::Library;
use super::alarm::{Alarm, add_event};
use super::document::Document;
use crate::error::Error;
use crate::event::Event;
use crate::figures::{Basis, Value};
use crate::moment::Moment;
use crate::stored_message;
use rusqlite::{Row, params};
use seamwright_message::{Message, display_by_message};
use serde::Serialize;
use std::fmt;
use std::str::FromStr;

/// Result of a weld.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum WeldResult {
    /// It runs, or the program that welded it crashed and the weld has not been recovered.
    Running,
    /// Done, within its tolerance.
    Good,
    /// Done, but not all of it as its tolerance or its procedure asks.
    Deviating,
    /// Stopped before its end.
    Stopped,
    /// The program or the power failed.
    Interrupted,
}

impl WeldResult {
    /// All of them.
    pub const ALL: [Self; 5] = [Self::Running, Self::Good, Self::Deviating, Self::Stopped, Self::Interrupted];

    /// Name in the table.
    pub fn name(self) -> &'static str {
        match self {
            Self::Running => "running",
            Self::Good => "good",
            Self::Deviating => "deviating",
            Self::Stopped => "stopped",
            Self::Interrupted => "interrupted",
        }
    }
}

impl fmt::Display for WeldResult {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for WeldResult {
    type Err = InvalidResult;

    fn from_str(text: &str) -> Result<Self, InvalidResult> {
        Self::ALL.into_iter().find(|r| r.name() == text).ok_or(InvalidResult)
    }
}

/// A text is not the name of a [`WeldResult`].
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct InvalidResult;

impl InvalidResult {
    /// Returns its message: the names.
    pub fn message(&self) -> Message {
        let names = Message::verbatim(WeldResult::ALL.map(WeldResult::name).join(", "));
        Message::new("document-allowed").message("allowed", names)
    }
}

display_by_message!(InvalidResult);

/// A weld at its start. Documents by their numbers.
#[derive(Debug, Clone, PartialEq)]
pub struct NewWeld {
    /// Number of the part, as the shop has it.
    pub part: String,
    /// The job's title.
    pub title: String,
    /// No metal was welded.
    pub simulated: bool,
    /// The job file, if it was not a program.
    pub job: Option<i64>,
    /// The program.
    pub program: i64,
    /// The machine file.
    pub machine: i64,
    /// The welding procedure.
    pub procedure: Option<i64>,
    /// Name of the welder.
    pub welder: Option<String>,
    /// Start.
    pub begun: Moment,
    /// Inputs of the figures.
    pub basis: Basis,
    /// Note made at the start of the weld.
    pub note: Message,
}

/// A file in the weld's folder.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct WeldFile {
    /// Its name.
    pub name: String,
    /// SHA-256.
    pub sha256: String,
    /// Its size.
    pub bytes: u64,
    /// Rows, of a part of the trace.
    pub rows: Option<u64>,
}

/// End of a weld.
#[derive(Debug, Clone, PartialEq)]
pub struct WeldEnd {
    /// End.
    pub ended: Moment,
    /// Result of the weld.
    pub result: WeldResult,
    /// Further remarks, for example on missing parts of the record; may be empty.
    pub note: Message,
    /// Minimum, mean and maximum heat input, kJ/mm.
    pub heat_input_kj_mm: Option<[f64; 3]>,
    /// Maximum distance of the torch tip from the seam (mm), and its position (mm).
    pub worst_deviation_mm: Option<(f64, f64)>,
    /// Values against their windows.
    pub values: Vec<Value>,
    /// The trace and further files.
    pub files: Vec<WeldFile>,
    /// Events that the library does not have yet.
    pub events: Vec<Event>,
}

/// A weld as the library has it.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct WeldRecord {
    /// Its number.
    pub id: i64,
    /// Number of the part.
    pub part: String,
    /// The job's title.
    pub title: String,
    /// No metal was welded.
    pub simulated: bool,
    /// Start.
    #[serde(serialize_with = "crate::moment::written")]
    pub begun: Moment,
    /// End.
    #[serde(serialize_with = "crate::moment::written_option")]
    pub ended: Option<Moment>,
    /// Result of the weld.
    #[serde(serialize_with = "written_result")]
    pub result: WeldResult,
    /// Further remarks; empty without any.
    #[serde(serialize_with = "stored_message::english")]
    pub note: Message,
    /// Name and version of the job.
    pub job: Option<(String, i64)>,
    /// Name, version and SHA-256 of the program.
    pub program: (String, i64, String),
    /// Name and version of the machine.
    pub machine: (String, i64),
    /// Number and version of the procedure.
    pub procedure: Option<(String, i64)>,
    /// Name of the welder.
    pub welder: Option<String>,
    /// Minimum, mean and maximum heat input, kJ/mm.
    pub heat_input_kj_mm: Option<[f64; 3]>,
    /// Maximum distance of the torch tip from the seam (mm), and its position (mm).
    pub worst_deviation_mm: Option<(f64, f64)>,
}

/// Everything that the library has of a weld.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct WeldDetail {
    /// The weld.
    #[serde(flatten)]
    pub weld: WeldRecord,
    /// Values against their windows.
    pub values: Vec<Value>,
    /// Alarms, in the order in which they came.
    pub alarms: Vec<Alarm>,
    /// Events, in the order in which they came.
    pub events: Vec<Event>,
    /// Its files.
    pub files: Vec<WeldFile>,
}

fn written_result<S: serde::Serializer>(result: &WeldResult, out: S) -> Result<S::Ok, S::Error> {
    out.serialize_str(result.name())
}

impl Library {
    /// Keeps the beginning of a weld; its number, which is greater than `after` and than any that there was.
    pub fn begin_weld(&self, weld: &NewWeld, after: i64) -> Result<i64, Error> {
        if let Some(name) = &weld.welder {
            self.run("INSERT INTO welder (name) VALUES (?1) ON CONFLICT DO NOTHING", [name])?;
        }
        let basis = serde_json::to_string(&weld.basis)
            .map_err(|e| Error::wrong(Message::outside(&e), Message::new("record-finite-numbers")))?;
        let NewWeld { part, title, simulated, job, program, machine, procedure, welder, begun, note, .. } = weld;
        self.run(
            "INSERT INTO weld (id, part, title, simulated, job, program, machine, procedure, welder, begun, result, basis, note)
             VALUES (1 + max(?12, coalesce((SELECT seq FROM sqlite_sequence WHERE name = 'weld'), 0)), ?1, ?2, ?3, ?4, ?5, ?6, ?7, (SELECT id FROM welder WHERE name = ?8), ?9, 'running', ?10, ?11)",
            params![part, title, simulated, job, program, machine, procedure, welder, begun.0, basis, stored_message::written(note), after],
        )?;
        Ok(self.db.last_insert_rowid())
    }

    /// Removes a weld of which only the start was recorded. Its number is not given again.
    /// Fails if the library cannot be written, or refers to the weld.
    pub(crate) fn take_back_weld(&self, id: i64) -> Result<(), Error> {
        self.run("DELETE FROM weld WHERE id = ?1 AND result = 'running'", [id]).map(drop)
    }

    /// Records the end of a weld in one transaction.
    pub fn end_weld(&mut self, id: i64, end: &WeldEnd) -> Result<(), Error> {
        let path = self.path.clone();
        let failed = |e| Error::database(&path, e);
        let change = self.db.transaction().map_err(failed)?;
        let [least, mean, greatest] = end.heat_input_kj_mm.map_or([None; 3], |h| h.map(Some));
        let (worst, worst_at) = end.worst_deviation_mm.unzip();
        let sql = "UPDATE weld SET ended = ?2, result = ?3, note = ?4, heat_input_min_kj_mm = ?5,
            heat_input_mean_kj_mm = ?6, heat_input_max_kj_mm = ?7, worst_deviation_mm = ?8, worst_deviation_at_mm = ?9
            WHERE id = ?1";
        let row = params![
            id,
            end.ended.0,
            end.result.name(),
            stored_message::written(&end.note),
            least,
            mean,
            greatest,
            worst,
            worst_at
        ];
        change.execute(sql, row).map_err(failed)?;
        for file in &end.files {
            let sql = "INSERT OR REPLACE INTO weld_file (weld, name, sha256, bytes, rows) VALUES (?1, ?2, ?3, ?4, ?5)";
            let whole = |n: u64| i64::try_from(n).unwrap_or(i64::MAX);
            let row = params![id, file.name, file.sha256, whole(file.bytes), file.rows.map(whole)];
            change.execute(sql, row).map_err(failed)?;
        }
        for event in &end.events {
            add_event(&change, Some(id), event).map_err(failed)?;
        }
        for v in &end.values {
            let sql = "INSERT OR REPLACE INTO weld_value (weld, pass, name, least, mean, greatest, allowed_least,
                allowed_greatest, outside_s, outside_mm) VALUES (?1, ?2, ?3, ?4, ?5, ?6, ?7, ?8, ?9, ?10)";
            let (low, high) = v.allowed.unzip();
            let row = params![id, v.pass, v.name, v.least, v.mean, v.greatest, low, high, v.outside_s, v.outside_mm];
            change.execute(sql, row).map_err(failed)?;
        }
        change.commit().map_err(failed)?;
        // Moves the entry out of the write-ahead log, because SQLite takes damage in it for its end. A reader blocks
        // this once; the next checkpoint includes it.
        let _ = self.db.query_row("PRAGMA wal_checkpoint(PASSIVE)", (), |_| Ok(()));
        Ok(())
    }

    /// Numbers of all welds, in order.
    pub fn weld_numbers(&self) -> Result<Vec<i64>, Error> {
        self.all("SELECT id FROM weld ORDER BY id", (), |row| row.get(0))
    }

    /// A weld.
    pub fn weld(&self, id: i64) -> Result<WeldRecord, Error> {
        let found = self.row(&format!("{SELECT} WHERE weld.id = ?1"), [id], weld_record)?;
        found.ok_or_else(|| {
            let most = self.one::<Option<i64>>("SELECT max(id) FROM weld", ()).ok().flatten();
            let allowed = most.map_or(Message::new("record-no-welds-yet"), |n| {
                Message::new("document-between").number("min", 1.0, 0).number("max", n as f64, 0)
            });
            let what = Message::new("record-no-weld").text("path", self.path.display().to_string());
            Error::wrong(what.number("id", id as f64, 0), allowed)
        })
    }

    /// A weld with all its data.
    pub fn detail(&self, id: i64) -> Result<WeldDetail, Error> {
        Ok(WeldDetail {
            weld: self.weld(id)?,
            values: self.values(id)?,
            alarms: self.alarms(id)?,
            events: self.events(id)?,
            files: self.files(id)?,
        })
    }

    /// Inputs of a weld's figures.
    pub fn basis(&self, id: i64) -> Result<Basis, Error> {
        let text: String = self.one("SELECT basis FROM weld WHERE id = ?1", [id])?;
        serde_json::from_str(&text).map_err(|e| {
            let why = Message::new("record-weld-damaged").number("id", id as f64, 0).text("why", e.to_string());
            Error::damaged(&self.path, why, Message::new("record-whole-library"))
        })
    }

    /// The program of a weld, at the time of welding.
    pub fn program_of(&self, id: i64) -> Result<Document, Error> {
        self.weld(id)?;
        self.document(self.one("SELECT program FROM weld WHERE id = ?1", [id])?)
    }

    /// Files of a weld, by name.
    ///
    /// # Errors
    /// If the library cannot be read, or names a file elsewhere: it may come from anywhere, by [`crate::restore`].
    pub fn files(&self, weld: i64) -> Result<Vec<WeldFile>, Error> {
        // A shorter name comes first: trace.parquet, trace-2.parquet, trace-10.parquet.
        let sql = "SELECT name, sha256, bytes, rows FROM weld_file WHERE weld = ?1
            ORDER BY rows IS NULL, length(name), name";
        let files = self.all(sql, [weld], |row| {
            let whole = |n: i64| u64::try_from(n).unwrap_or(0);
            let rows = row.get::<_, Option<i64>>(3)?.map(whole);
            Ok(WeldFile { name: row.get(0)?, sha256: row.get(1)?, bytes: whole(row.get(2)?), rows })
        })?;
        let inside = |name: &str| !matches!(name, "" | "." | "..") && !name.contains(['/', '\\']);
        match files.iter().find(|file| !inside(&file.name)) {
            Some(file) => {
                let why = Message::new("record-foreign-file").text("name", &file.name).number("id", weld as f64, 0);
                Err(Error::damaged(&self.path, why, Message::new("record-own-files")))
            }
            None => Ok(files),
        }
    }

    /// Values of a weld against their windows.
    pub fn values(&self, weld: i64) -> Result<Vec<Value>, Error> {
        let sql = "SELECT pass, name, least, mean, greatest, allowed_least, allowed_greatest, outside_s, outside_mm
            FROM weld_value WHERE weld = ?1 ORDER BY pass, name";
        self.all(sql, [weld], |row| {
            let (low, high): (Option<f64>, Option<f64>) = (row.get(5)?, row.get(6)?);
            Ok(Value {
                pass: row.get(0)?,
                name: row.get(1)?,
                least: row.get(2)?,
                mean: row.get(3)?,
                greatest: row.get(4)?,
                allowed: low.zip(high),
                outside_s: row.get(7)?,
                outside_mm: row.get(8)?,
                outside_along: None,
            })
        })
    }
}

/// Welds with the names of their inputs.
pub(super) const SELECT: &str = "SELECT weld.id, part, title, simulated, begun, ended, result, note,
    j.name, j.version, p.name, p.version, p.sha256, m.name, m.version, w.name, w.version, welder.name,
    heat_input_min_kj_mm, heat_input_mean_kj_mm, heat_input_max_kj_mm, worst_deviation_mm, worst_deviation_at_mm
    FROM weld LEFT JOIN document j ON j.id = job JOIN document p ON p.id = program JOIN document m ON m.id = machine
    LEFT JOIN document w ON w.id = procedure LEFT JOIN welder ON welder.id = weld.welder";

pub(super) fn weld_record(row: &Row) -> rusqlite::Result<WeldRecord> {
    let named = |at: usize| -> rusqlite::Result<Option<(String, i64)>> {
        Ok(row.get::<_, Option<String>>(at)?.zip(row.get(at + 1)?))
    };
    let result: String = row.get(6)?;
    let heat: [Option<f64>; 3] = [row.get(18)?, row.get(19)?, row.get(20)?];
    Ok(WeldRecord {
        id: row.get(0)?,
        part: row.get(1)?,
        title: row.get(2)?,
        simulated: row.get(3)?,
        begun: Moment(row.get(4)?),
        ended: row.get::<_, Option<i64>>(5)?.map(Moment),
        // The table has no others.
        result: result.parse().unwrap_or(WeldResult::Running),
        note: stored_message::column(row, 7)?,
        job: named(8)?,
        program: (row.get(10)?, row.get(11)?, row.get(12)?),
        machine: (row.get(13)?, row.get(14)?),
        procedure: named(15)?,
        welder: row.get(17)?,
        heat_input_kj_mm: if let [Some(a), Some(b), Some(c)] = heat { Some([a, b, c]) } else { None },
        worst_deviation_mm: row.get::<_, Option<f64>>(21)?.zip(row.get(22)?),
    })
}
