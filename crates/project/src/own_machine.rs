//! The machine of a cell as it was found to be: tools that were calibrated, drives that were tuned, kept in its file.

use crate::failure::Failure;
use crate::files;
use crate::load::{Loaded, machine_foreign, own_copy};
use seamwright_machine::{Machine, shipped};
use seamwright_message::Message;
use std::path::{Path, PathBuf};
use toml_edit::{Array, ArrayOfTables, DocumentMut, Item, Table, TomlError, Value, value};

/// The machine file of a job, and the path for changes to it.
pub struct OwnMachine {
    /// Path of the file: the file itself, or the cell's own copy of one that ships.
    pub path: PathBuf,
    /// Its text now.
    pub text: String,
}

/// New value of a key; `None` removes it.
#[derive(Debug, Clone, PartialEq)]
pub enum Setting {
    /// A number.
    Number(Option<f64>),
    /// Numbers in a row.
    Row(Vec<f64>),
    /// Tables: each with these keys.
    Tables(Vec<Vec<(&'static str, Setting)>>),
}

impl OwnMachine {
    /// That of a job among `jobs`.
    ///
    /// # Errors
    /// An unreadable file, or one that is elsewhere.
    pub fn of(loaded: &Loaded, jobs: &Path) -> Result<Self, Failure> {
        let name = &loaded.welding.program.value.machine;
        match (&loaded.machine_file, shipped(name)) {
            (Some(path), _) => Ok(Self { path: path.clone(), text: files::read(path)? }),
            (None, Some(shipped)) => Ok(Self { path: jobs.join(own_copy(name)), text: shipped.text.to_owned() }),
            (None, None) => Err(Failure::Input(Message::new("project-machine-without-file").text("name", name))),
        }
    }

    /// Its text with the settings of the table at `table`: a name, or a name and a number in an array of tables, from
    /// the root.
    ///
    /// # Errors
    /// A text in which the table is missing and cannot be added.
    pub fn with(&self, table: &[Step<'_>], settings: &[(&str, Setting)]) -> Result<String, Failure> {
        let not_a_table = |step: &Step<'_>| {
            let why = Message::new("project-not-a-table").key("table", step.to_string());
            self.fault(why)
        };
        let mut document = self.parsed()?;
        let mut at = document.as_item_mut();
        for step in table {
            at = step.enter(at).ok_or_else(|| not_a_table(step))?;
        }
        let at = at.as_table_like_mut().ok_or_else(|| not_a_table(table.last().unwrap_or(&Step::Table(""))))?;
        for (key, setting) in settings {
            // An inline table stays inline: it cannot hold other tables.
            let inline = at.get(key).is_some_and(Item::is_value);
            match (setting.item(inline), at.get_mut(key)) {
                (None, _) => drop(at.remove(key)),
                // The comment behind the old value stays.
                (Some(Item::Value(mut new)), Some(Item::Value(old))) => {
                    *new.decor_mut() = old.decor().clone();
                    *old = new;
                }
                (Some(item), Some(old)) => *old = item,
                (Some(item), None) => drop(at.insert(key, item)),
            }
        }
        Ok(document.to_string())
    }

    fn parsed(&self) -> Result<DocumentMut, Failure> {
        self.text.parse().map_err(|e: TomlError| self.fault(Message::outside(&e)))
    }

    fn fault(&self, why: Message) -> Failure {
        let file = self.path.display().to_string();
        Failure::Input(Message::new("project-in-file").text("file", file).message("why", why))
    }

    /// The table of the step in which the axis called `name` stands.
    pub fn axis_table(&self, name: &str) -> Option<Vec<Step<'static>>> {
        let document: DocumentMut = self.text.parse().ok()?;
        let nth = |table: Option<&Item>| {
            let steps = table?.as_array_of_tables()?;
            steps.iter().position(|step| step.get("axis").and_then(Item::as_str) == Some(name))
        };
        let own = ["tool", "work"]
            .into_iter()
            .find_map(|branch| nth(document.get(branch)).map(|i| vec![Step::Nth(branch, i)]));
        own.or_else(|| {
            let mut heads = document.get("heads")?.as_array_of_tables()?.iter().enumerate();
            heads.find_map(|(h, head)| {
                nth(head.get("steps")).map(|i| vec![Step::Nth("heads", h), Step::Nth("steps", i)])
            })
        })
    }

    /// True if the file has a table of this name.
    pub fn has(&self, table: &str) -> bool {
        self.text.parse().is_ok_and(|document: DocumentMut| document.contains_key(table))
    }

    /// The numbers at `keys` of a table; `None` for missing keys.
    ///
    /// # Errors
    /// A text that is not TOML.
    pub fn numbers(&self, table: &[Step<'_>], keys: &[&str]) -> Result<Vec<Option<f64>>, Failure> {
        Ok(self.rows(table, keys)?.into_iter().map(|row| if let [one] = row[..] { Some(one) } else { None }).collect())
    }

    /// The same for keys with several numbers in a row, or one; empty for missing keys.
    ///
    /// # Errors
    /// A text that is not TOML.
    pub fn rows(&self, table: &[Step<'_>], keys: &[&str]) -> Result<Vec<Vec<f64>>, Failure> {
        let document = self.parsed()?;
        let mut at = Some(document.as_item());
        for step in table {
            at = at.and_then(|item| step.of(item));
        }
        let number = |value: &Value| value.as_float().or_else(|| value.as_integer().map(|i| i as f64));
        let row = |item: &Item| match item.as_array() {
            Some(array) => array.iter().filter_map(number).collect(),
            None => item.as_value().and_then(number).into_iter().collect(),
        };
        Ok(keys.iter().map(|key| at.and_then(|item| item.get(key)).map_or_else(Vec::new, row)).collect())
    }

    /// The machine of `text`, which replaces this file.
    ///
    /// # Errors
    /// Any fault of the text.
    pub fn check(&self, text: &str) -> Result<Machine, Failure> {
        let name = self.path.file_name().map_or_else(|| "machine.toml".into(), |n| n.to_string_lossy());
        machine_foreign(&name, text, self.path.parent().unwrap_or(Path::new(".")))
    }

    /// Checks `text` and writes it, whole; the previous file stays beside it, with `.before` behind its name.
    ///
    /// # Errors
    /// Invalid text, or a folder that is not writable.
    pub fn keep(&self, text: &str) -> Result<Machine, Failure> {
        let folder = self.path.parent().unwrap_or(Path::new("."));
        files::make_private(folder).map_err(|e| files::not_writable(folder, &e))?;
        let machine = self.check(text)?;
        let mut before = self.path.clone().into_os_string();
        before.push(".before");
        files::write(Path::new(&before), &self.text)?;
        files::write(&self.path, text)?;
        Ok(machine)
    }
}

/// A step into a document.
#[derive(Debug, Clone, Copy)]
pub enum Step<'a> {
    /// The table of this name, made if missing.
    Table(&'a str),
    /// This table of an array of tables.
    Nth(&'a str, usize),
}

impl std::fmt::Display for Step<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Table(name) => write!(f, "{name}"),
            Self::Nth(name, i) => write!(f, "{name}[{i}]"),
        }
    }
}

impl Step<'_> {
    fn of<'i>(&self, item: &'i Item) -> Option<&'i Item> {
        match self {
            Self::Table(name) => item.get(name),
            Self::Nth(name, i) => item.get(name)?.get(i),
        }
    }

    fn enter<'i>(&self, item: &'i mut Item) -> Option<&'i mut Item> {
        match self {
            Self::Table(name) => {
                let table = item.as_table_like_mut()?;
                if table.get(name).is_none() {
                    table.insert(name, Item::Table(Table::new()));
                }
                table.get_mut(name)
            }
            Self::Nth(name, i) => item.as_table_like_mut()?.get_mut(name)?.get_mut(*i),
        }
    }
}

impl Setting {
    /// Item of the document; `None` if the key is to be removed.
    fn item(&self, inline: bool) -> Option<Item> {
        match self {
            Self::Number(number) => number.map(value),
            Self::Row(row) if row.is_empty() => None,
            Self::Row(row) => Some(value(row.iter().copied().collect::<Array>())),
            Self::Tables(rows) if rows.is_empty() => None,
            Self::Tables(rows) => {
                let tables = rows.iter().map(|row| {
                    row.iter().filter_map(|(key, setting)| Some((*key, setting.item(true)?))).collect::<Table>()
                });
                Some(if inline {
                    value(tables.map(Table::into_inline_table).collect::<Array>())
                } else {
                    Item::ArrayOfTables(tables.collect::<ArrayOfTables>())
                })
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::load::load_foreign;

    const JOB: &str = "saddle-4axis";

    fn own(jobs: &Path) -> OwnMachine {
        let text = crate::examples::EXAMPLES[0].text;
        assert!(text.contains(JOB));
        OwnMachine::of(&load_foreign("job.toml", text, jobs).unwrap(), jobs).unwrap()
    }

    #[test]
    fn what_is_kept_is_found_by_the_next_job() {
        let jobs = tempfile::tempdir().unwrap();
        let first = own(jobs.path());
        let tip = vec![0.5, -0.25, 1.0];
        let text = first.with(&[Step::Table("torch")], &[("tip_mm", Setting::Row(tip))]).unwrap();
        first.keep(&text).unwrap();
        let second = own(jobs.path());
        assert_eq!(second.text, text);
        let gains = [("kp_per_s", Setting::Number(Some(30.0))), ("velocity_bandwidth_hz", Setting::Number(Some(20.0)))];
        let text = second.with(&[Step::Table("drives"), Step::Table("theta")], &gains).unwrap();
        let machine = second.keep(&text).unwrap();
        assert_eq!(machine.heads[0].tip, glam::DVec3::new(0.5, -0.25, 1.0));
        let drive = machine.axes[0].drive.as_ref().unwrap();
        assert_eq!((drive.gains.unwrap().kp, drive.velocity_bandwidth_hz), (30.0, 20.0));
        // Line by line: one more of each key, one changed.
        let (old, new): (Vec<&str>, Vec<&str>) = (first.text.lines().collect(), text.lines().collect());
        assert_eq!(new.len(), old.len() + 2);
        assert_eq!(old.iter().filter(|line| !new.contains(line)).count(), 1);
        assert_eq!(std::fs::read_to_string(second.path.with_extension("toml.before")).unwrap(), second.text);
        // Taken away again.
        let third = own(jobs.path());
        let none = third.with(&[Step::Table("drives"), Step::Table("theta")], &[("kp_per_s", Setting::Number(None))]);
        assert!(third.keep(&none.unwrap()).unwrap().axes[0].drive.as_ref().unwrap().gains.is_none());
    }

    #[test]
    fn what_the_loader_refuses_is_not_kept() {
        let jobs = tempfile::tempdir().unwrap();
        let own = own(jobs.path());
        for (key, number) in [("kp_per_s", -1.0), ("force_limit_n", 1.0), ("no_such_key", 1.0)] {
            let text = own.with(&[Step::Table("drives"), Step::Table("s")], &[(key, Setting::Number(Some(number)))]);
            let refused = own.keep(&text.unwrap()).err().map(|e| e.text()).unwrap_or_default();
            assert!(refused.contains(key), "{key}: {refused}");
            assert!(!own.path.exists());
        }
        let notch = [("frequency_hz", 80.0), ("depth", 0.1), ("width_hz", 40.0)];
        let notch = notch.map(|(key, number)| (key, Setting::Number(Some(number))));
        let notches = Setting::Tables(vec![notch.to_vec()]);
        let text = own.with(&[Step::Table("drives"), Step::Table("s")], &[("notches", notches)]).unwrap();
        assert_eq!(own.check(&text).unwrap().axes[1].drive.as_ref().unwrap().notches.len(), 1);
        assert!(own.with(&[Step::Nth("heads", 0)], &[]).is_err());
    }
}
