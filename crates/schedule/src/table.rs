//! Rows of a table, from CSV or TOML.
//!
//! **CSV.** The first line names the columns. `name`, `template`, `machine`, `procedure`, `count` and `setup_min` are
//! the row's own; every other column is the path of a key of the job. An empty cell keeps the template's value. A row
//! with the name `*` gives the values of empty cells in the rows below it, up to the next such row.
//!
//! **TOML.** `[defaults]`, and a `[[seams]]` table for each row with the same names; keys of the job are written as in
//! the job.

use crate::job_text::{folder_of, foreign_template, template};
use crate::keys::Keys;
use schemars::schema_for;
use seamwright_document::TomlText;
use seamwright_message::Message;
use seamwright_project::FileStore;
use seamwright_project::failure::Failure;
use seamwright_project::files;
use seamwright_weld::Job;
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::collections::{BTreeMap, HashSet};
use std::fs::File;
use std::hash::{BuildHasher, RandomState};
use std::path::{Path, PathBuf};

/// Columns that are no keys of the job.
const OWN: [&str; 6] = ["name", "template", "machine", "procedure", "count", "setup_min"];
/// Name of a row with defaults.
const DEFAULTS: &str = "*";
/// Maximum number of equal parts of a row.
const MAX_COUNT: u32 = 100_000;
/// Maximum set-up time, min: a week.
const MAX_SETUP_MIN: f64 = 10_080.0;
/// Maximum length of a name: it is the name of a file.
const MAX_NAME: usize = 80;

/// A value that replaces one of the template.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Setting {
    /// Path of the key in the job, as in `seam.nozzle.radius_mm`.
    pub path: String,
    /// The value.
    pub value: Value,
    /// The value as it is written in the table.
    pub written: String,
}

/// One seam of a table.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Row {
    /// Number, from 1.
    pub number: u64,
    /// Line in the file, from 1; 0 in TOML.
    pub line: u64,
    /// Name, unique in the table.
    pub name: String,
    /// The template: a job file beside the table, or the name of an example.
    pub template: String,
    /// Machines that may weld it; empty: that of the template.
    pub machines: Vec<String>,
    /// Number of equal parts.
    pub count: u32,
    /// Time to set up one part, min.
    pub setup_min: f64,
    /// Values that replace those of the template.
    pub settings: Vec<Setting>,
}

/// A table of seams on disk. It is read row by row.
#[derive(Debug, Clone)]
pub struct Table {
    path: PathBuf,
    /// Folder that templates are relative to.
    folder: PathBuf,
    keys: Keys,
    /// Source of its templates, and of the files that they name.
    store: FileStore,
}

/// Cells of a row by column.
type Cells = BTreeMap<String, Cell>;

#[derive(Debug, Clone)]
struct Cell {
    value: Value,
    written: String,
}

impl Table {
    /// The table in the file `path`, checked: its columns, and the cells of every row. Returns the number of rows too.
    ///
    /// # Errors
    /// With file, line and column: unknown columns, wrong values, names twice, missing templates.
    pub fn open(path: &Path) -> Result<(Self, u64), Failure> {
        Self::carried(path.to_owned(), FileStore::Disk).checked()
    }

    /// The same for a table whose author may not read all files: templates, machines and other files are plain files in
    /// `folder` and below.
    ///
    /// # Errors
    /// As [`Table::open`].
    pub fn open_foreign(path: &Path, folder: &Path) -> Result<(Self, u64), Failure> {
        let store = FileStore::Fenced(folder.to_owned());
        Self { folder: folder.to_owned(), ..Self::carried(path.to_owned(), store) }.checked()
    }

    fn checked(self) -> Result<(Self, u64), Failure> {
        let mut count = 0;
        // Hashes of the names: a million names take 16 MB.
        let (mut names, hashes) = (HashSet::new(), RandomState::new());
        let mut templates = HashSet::new();
        self.each(&mut |row| {
            count += 1;
            if !names.insert(hashes.hash_one(&row.name)) {
                let message = Message::new("schedule-name-twice").text("name", &row.name);
                return Err(self.fault(row.line, row.number, "name", message, Message::new("schedule-unique-names")));
            }
            if templates.insert(row.template.clone()) {
                self.template(&row.template).map_err(|why| {
                    let message = Message::new("schedule-template-unreadable").message("why", why.message());
                    self.fault(row.line, row.number, "template", message, Message::new("schedule-job-or-example"))
                })?;
            }
            Ok(true)
        })?;
        if count == 0 {
            let message = Message::new("schedule-no-rows").text("file", self.name());
            return Err(Failure::refused(message, Message::new("schedule-rows-needed")));
        }
        Ok((self, count))
    }

    /// A table that is not checked, with templates of `store`.
    pub(crate) fn carried(path: PathBuf, store: FileStore) -> Self {
        let folder = folder_of(&path).to_owned();
        Self { path, folder, keys: Keys::of(&schema_for!(Job)), store }
    }

    /// Source of the files of its jobs.
    pub(crate) fn store(&self) -> &FileStore {
        &self.store
    }

    /// Its file.
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// Folder that templates are relative to.
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// True if its author may read only plain files in a folder.
    fn is_foreign(&self) -> bool {
        matches!(self.store, FileStore::Fenced(_))
    }

    /// Calls `row` with every row, until it returns false.
    ///
    /// # Errors
    /// Faults of the file, with line and column, and those of `row`.
    pub fn each(&self, row: &mut dyn FnMut(Row) -> Result<bool, Failure>) -> Result<(), Failure> {
        match self.path.extension().and_then(|e| e.to_str()) {
            Some("toml") => self.each_of_toml(row),
            _ => self.each_of_csv(row),
        }
    }

    /// Text of a template, and the folder that its files are relative to.
    pub(crate) fn template(&self, name: &str) -> Result<(String, PathBuf), Failure> {
        let job = match self.is_foreign() {
            true => foreign_template(self.folder(), name),
            false => template(self.folder(), name, &self.store),
        };
        job.map(|job| (job.text, job.folder))
    }

    fn each_of_csv(&self, row: &mut dyn FnMut(Row) -> Result<bool, Failure>) -> Result<(), Failure> {
        let unreadable = |why: Message| {
            Failure::Input(Message::new("schedule-unreadable").text("file", self.name()).message("why", why))
        };
        let file = File::open(&self.path).map_err(|e| unreadable(Message::verbatim(e.to_string())))?;
        let mut reader = csv::ReaderBuilder::new().flexible(true).trim(csv::Trim::All).from_reader(file);
        let of_csv = |e: csv::Error| unreadable(Message::verbatim(e.to_string()));
        let columns: Vec<String> = reader
            .headers()
            .map_err(of_csv)?
            .iter()
            .map(|name| name.trim_start_matches('\u{feff}').to_owned())
            .collect();
        self.check_columns(&columns)?;
        let (mut defaults, mut number, mut record) = (Cells::new(), 0, csv::StringRecord::new());
        while reader.read_record(&mut record).map_err(of_csv)? {
            let line = record.position().map_or(0, csv::Position::line);
            if record.len() > columns.len() {
                let message = Message::new("schedule-too-many-cells").number("found", record.len() as f64, 0);
                let allowed = Message::new("schedule-up-to-columns").number("columns", columns.len() as f64, 0);
                return Err(self.fault(line, number + 1, "", message, allowed));
            }
            let filled = columns.iter().zip(record.iter()).filter(|(_, text)| !text.is_empty());
            let cells: Cells = filled.map(|(name, text)| (name.clone(), Cell::parse(text))).collect();
            if cells.is_empty() {
                continue;
            }
            if cells.get("name").is_some_and(|cell| cell.written == DEFAULTS) {
                defaults = cells;
                continue;
            }
            number += 1;
            let mut all = defaults.clone();
            all.extend(cells);
            if !row(self.row(number, line, all)?)? {
                break;
            }
        }
        Ok(())
    }

    fn each_of_toml(&self, row: &mut dyn FnMut(Row) -> Result<bool, Failure>) -> Result<(), Failure> {
        let text = files::read(&self.path)?;
        TomlText::parse(&self.name(), &text)?;
        let root: toml::Table = toml::from_str(&text).map_err(|e| {
            let why = Message::verbatim(e.message().to_owned());
            Failure::Input(Message::new("schedule-unreadable").text("file", self.name()).message("why", why))
        })?;
        if let Some(key) = root.keys().find(|key| !["defaults", "seams"].contains(&key.as_str())) {
            let message = Message::new("schedule-unknown-table").key("key", key);
            return Err(self.fault(0, 0, key, message, Message::new("schedule-tables")));
        }
        let table = |value: &toml::Value| value.as_table().cloned();
        let defaults = root.get("defaults").and_then(table).unwrap_or_default();
        let seams = root.get("seams").and_then(toml::Value::as_array).cloned().unwrap_or_default();
        for (i, seam) in seams.iter().enumerate() {
            let mut cells = Cells::new();
            flatten("", &defaults, &mut cells);
            flatten("", &table(seam).unwrap_or_default(), &mut cells);
            self.check_columns(&cells.keys().cloned().collect::<Vec<_>>())?;
            if !row(self.row(i as u64 + 1, 0, cells)?)? {
                break;
            }
        }
        Ok(())
    }

    fn check_columns(&self, columns: &[String]) -> Result<(), Failure> {
        let missing = |name: &str| !columns.iter().any(|column| column == name);
        if let Some(name) = ["name", "template"].into_iter().find(|name| missing(name)) {
            let message = Message::new("schedule-column-missing").key("column", name);
            return Err(self.fault(1, 0, name, message, OWN.join(", ")));
        }
        for (i, column) in columns.iter().enumerate() {
            if columns[..i].contains(column) {
                let message = Message::new("schedule-column-twice").key("column", column);
                return Err(self.fault(1, 0, column, message, Message::new("schedule-columns-once")));
            }
            if !OWN.contains(&column.as_str()) && !self.keys.knows(column) {
                let message = Message::new("schedule-column-unknown").key("column", column);
                let allowed = match self.keys.closest_path(column) {
                    Some(meant) => Message::new("schedule-column-meant").key("name", &meant),
                    None => Message::new("schedule-columns").text("names", OWN.join(", ")),
                };
                return Err(self.fault(1, 0, column, message, allowed));
            }
        }
        Ok(())
    }

    fn row(&self, number: u64, line: u64, mut cells: Cells) -> Result<Row, Failure> {
        let fault =
            |column: &str, message: Message, allowed: Message| self.fault(line, number, column, message, allowed);
        let mut text = |column: &str| cells.remove(column).map(|cell| cell.written);
        let name = text("name").unwrap_or_default();
        if !is_file_name(&name) {
            let message = Message::new("schedule-name-unfit").text("name", &name);
            let allowed = Message::new("schedule-allowed-names").number("max", MAX_NAME as f64, 0);
            return Err(fault("name", message, allowed));
        }
        let Some(template) = text("template") else {
            let message = Message::new("schedule-no-template").text("name", &name);
            return Err(fault("template", message, Message::new("schedule-job-or-example")));
        };
        let machines = text("machine").unwrap_or_default();
        let machines: Vec<String> =
            machines.split('|').map(str::trim).filter(|name| !name.is_empty()).map(str::to_owned).collect();
        let procedure = text("procedure");
        let count = number_of(text("count"), 1.0, |v| v.fract() == 0.0 && (1.0..=f64::from(MAX_COUNT)).contains(&v));
        let count = count.map_err(|written| {
            let message = Message::new("schedule-count-unfit").text("value", written);
            fault("count", message, Message::new("schedule-allowed-count").number("max", f64::from(MAX_COUNT), 0))
        })?;
        let setup_min = number_of(text("setup_min"), 0.0, |v| (0.0..=MAX_SETUP_MIN).contains(&v));
        let setup_min = setup_min.map_err(|written| {
            let message = Message::new("schedule-setup-unfit").text("value", written);
            fault("setup_min", message, Message::new("schedule-allowed-setup").number("max", MAX_SETUP_MIN, 0))
        })?;
        let setting = |(path, cell): (String, Cell)| Setting { path, value: cell.value, written: cell.written };
        let mut settings: Vec<Setting> = cells.into_iter().map(setting).collect();
        settings.extend(procedure.map(|written| Setting {
            path: "procedure".into(),
            value: Value::String(written.clone()),
            written,
        }));
        Ok(Row { number, line, name, template, machines, count: count as u32, setup_min, settings })
    }

    /// A fault in a row and column.
    pub(crate) fn fault(
        &self,
        line: u64,
        row: u64,
        column: &str,
        why: Message,
        allowed: impl Into<Message>,
    ) -> Failure {
        let code = match (line, row) {
            (0, 0) => "schedule-in-table",
            (0, _) => "schedule-in-row",
            _ => "schedule-in-line",
        };
        let message = Message::new(code).text("file", self.name()).number("line", line as f64, 0);
        let message = message.number("row", row as f64, 0).text("column", column).message("why", why);
        Failure::refused(message, allowed)
    }

    /// Its name in messages: without folders if its author does not see them.
    fn name(&self) -> String {
        let file = self.path.file_name().filter(|_| self.is_foreign());
        file.map_or_else(|| self.path.display().to_string(), |file| file.to_string_lossy().into_owned())
    }
}

impl Cell {
    /// A cell as it would stand in a job: a number, truth, list or table of TOML, otherwise a text.
    fn parse(written: &str) -> Self {
        let read = toml::from_str::<toml::Table>(&format!("v = {written}"));
        let value = read.ok().filter(|table| table.len() == 1).and_then(|mut table| table.remove("v"));
        let value = value.map_or_else(|| Value::String(written.to_owned()), json);
        Self { value, written: written.to_owned() }
    }
}

/// A value of TOML as one of JSON; dates are texts.
fn json(value: toml::Value) -> Value {
    match value {
        toml::Value::String(text) => Value::String(text),
        toml::Value::Integer(number) => number.into(),
        toml::Value::Float(number) => number.into(),
        toml::Value::Boolean(truth) => truth.into(),
        toml::Value::Datetime(date) => Value::String(date.to_string()),
        toml::Value::Array(list) => list.into_iter().map(json).collect(),
        toml::Value::Table(table) => table.into_iter().map(|(key, value)| (key, json(value))).collect(),
    }
}

/// Adds the values of a table by their paths.
fn flatten(above: &str, table: &toml::Table, cells: &mut Cells) {
    for (key, value) in table {
        let path = if above.is_empty() { key.clone() } else { format!("{above}.{key}") };
        match value {
            toml::Value::Table(inner) => flatten(&path, inner, cells),
            toml::Value::Array(list) if path == "machine" => {
                let names: Vec<&str> = list.iter().filter_map(toml::Value::as_str).collect();
                let written = names.join("|");
                cells.insert(path, Cell { value: Value::String(written.clone()), written });
            }
            other => {
                let written = other.as_str().map_or_else(|| other.to_string(), str::to_owned);
                cells.insert(path, Cell { value: json(other.clone()), written });
            }
        }
    }
}

/// The number of a cell, `missing` without one; the cell if it is not a number or not allowed.
fn number_of(cell: Option<String>, missing: f64, is_allowed: impl Fn(f64) -> bool) -> Result<f64, String> {
    let Some(written) = cell else { return Ok(missing) };
    written.parse::<f64>().ok().filter(|value| is_allowed(*value)).ok_or(written)
}

/// True for names of files on all systems.
fn is_file_name(name: &str) -> bool {
    let is_fit = |c: char| c.is_alphanumeric() || " ._-+()".contains(c);
    !name.is_empty()
        && name.len() <= MAX_NAME
        && name.chars().all(is_fit)
        && !name.starts_with(['.', ' '])
        && !name.ends_with(['.', ' '])
}

#[cfg(test)]
mod tests {
    use super::*;
    use tempfile::TempDir;

    fn table(name: &str, text: &str) -> (TempDir, Result<Vec<Row>, String>) {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join(name);
        std::fs::write(&path, text).unwrap();
        let rows = Table::open(&path).and_then(|(table, count)| {
            let mut rows = Vec::new();
            table.each(&mut |row| {
                rows.push(row);
                Ok(true)
            })?;
            assert_eq!(rows.len() as u64, count);
            Ok(rows)
        });
        (folder, rows.map_err(|e| e.text()))
    }

    #[test]
    fn csv_and_toml_give_the_same_rows() {
        let csv = "name,template,machine,count,setup_min,seam.nozzle.radius_mm,title\n\
                   *,hillside,torch-5axis|irb-2600,,15,,\n\
                   N1,,,3,,55.5,\"Nozzle, first\"\nN2,saddle,saddle-4axis,,,,\n";
        let toml = "[defaults]\ntemplate = \"hillside\"\nmachine = [\"torch-5axis\", \"irb-2600\"]\nsetup_min = 15\n\
                    [[seams]]\nname = \"N1\"\ncount = 3\nseam.nozzle.radius_mm = 55.5\ntitle = \"Nozzle, first\"\n\
                    [[seams]]\nname = \"N2\"\ntemplate = \"saddle\"\nmachine = \"saddle-4axis\"\n";
        let without_line = |mut row: Row| {
            row.line = 0;
            row
        };
        let of_csv: Vec<Row> = table("t.csv", csv).1.unwrap().into_iter().map(without_line).collect();
        assert_eq!(of_csv, table("t.toml", toml).1.unwrap());
        assert_eq!(of_csv[0].machines, ["torch-5axis", "irb-2600"]);
        assert_eq!((of_csv[0].count, of_csv[1].count), (3, 1));
        assert_eq!(of_csv[0].settings.len(), 2);
    }

    /// A table of somebody who may read only the folder of jobs.
    #[test]
    fn a_foreign_table_names_files_of_its_folder_only() {
        let folder = tempfile::tempdir().unwrap();
        let jobs = folder.path().join("jobs");
        std::fs::create_dir_all(&jobs).unwrap();
        std::fs::write(folder.path().join("secret.toml"), "password = 1\n").unwrap();
        std::fs::write(jobs.join("own.toml"), seamwright_project::examples::EXAMPLES[0].text).unwrap();
        let path = folder.path().join("t.csv");
        let open = |template: &str| {
            std::fs::write(&path, format!("name,template\nN1,{template}\n")).unwrap();
            Table::open_foreign(&path, &jobs).map(|(_, rows)| rows).map_err(|e| e.text())
        };
        for good in ["own.toml", "saddle", "saddle.toml"] {
            assert_eq!(open(good), Ok(1), "{good}");
        }
        for bad in ["../secret.toml", "/etc/passwd", "/dev/zero", "nothing.toml"] {
            let text = open(bad).unwrap_err();
            assert!(text.contains("t.csv:2") && !text.contains("password"), "{text}");
            assert!(!text.contains(folder.path().to_str().unwrap()), "{text}");
        }
    }

    #[test]
    fn faults_name_file_row_and_column() {
        for (text, parts) in [
            ("name,template,seam.nozzle.radius_cm\nN1,saddle,5\n", ["radius_cm", "seam.nozzle.radius_mm"]),
            ("name,template\nN1,saddle\nN1,saddle\n", ["t.csv:3", "name"]),
            ("name,template\nN1,sadle\n", ["t.csv:2", "template"]),
            ("name,machine\nN1,saddle\n", ["template", "t.csv"]),
            ("name,template,count\nN1,saddle,2.5\n", ["t.csv:2", "2.5"]),
            ("name,template,setup_min\nN1,saddle,-1\n", ["t.csv:2", "-1"]),
            ("name,template\na/b,saddle\n", ["t.csv:2", "a/b"]),
            ("name,template,name\nN1,saddle,\n", ["name", "t.csv"]),
            ("name,template\nN1,saddle,7\n", ["t.csv:2", "3"]),
            ("name,template\n", ["t.csv", ""]),
        ] {
            let error = table("t.csv", text).1.unwrap_err();
            assert!(parts.iter().all(|part| error.contains(part)), "{text}{error}");
        }
    }
}
