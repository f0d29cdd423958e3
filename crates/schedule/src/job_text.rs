//! The job of a row on one machine.

use crate::table::{Row, Table};
use seamwright_document::{Change, DocumentError, TomlText};
use seamwright_project::FileStore;
use seamwright_project::failure::Failure;
use seamwright_project::files::{read_bytes, read_foreign};
use seamwright_record::sha256;
use serde_json::Value;
use std::collections::{BTreeMap, HashMap};
use std::path::{Path, PathBuf};

/// A job as text, with the folder that its files are relative to.
#[derive(Debug, Clone)]
pub(crate) struct JobText {
    pub(crate) text: String,
    pub(crate) folder: PathBuf,
}

/// Reads a job: a file relative to `folder`, or an example.
pub(crate) fn template(folder: &Path, name: &str, store: &FileStore) -> Result<JobText, Failure> {
    let path = folder.join(name);
    if let Some(example) = seamwright_project::examples::example(name).filter(|_| !store.has(&path)) {
        return Ok(JobText { text: example.text.to_owned(), folder: PathBuf::from(".") });
    }
    let text = store.text(&path)?;
    TomlText::parse(&path.display().to_string(), &text)?;
    Ok(JobText { text, folder: folder_of(&path).to_owned() })
}

/// The same where the author of the table may read only plain files in `folder`: a job there, or an example.
pub(crate) fn foreign_template(folder: &Path, name: &str) -> Result<JobText, Failure> {
    let example = seamwright_project::examples::example(name.strip_suffix(".toml").unwrap_or(name));
    let text = match example.filter(|_| !folder.join(name).is_file()) {
        Some(example) => example.text.to_owned(),
        None => read_foreign(folder, name)?,
    };
    TomlText::parse(name, &text)?;
    Ok(JobText { text, folder: folder.to_owned() })
}

/// The folder of a file.
pub(crate) fn folder_of(path: &Path) -> &Path {
    path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."))
}

/// Templates read so far, and the hashes of files that jobs name.
#[derive(Debug, Default)]
pub(crate) struct Templates {
    read: HashMap<String, JobText>,
    hashes: HashMap<PathBuf, Option<String>>,
}

impl Templates {
    /// The jobs of a row: one for each of its machines.
    ///
    /// # Errors
    /// A template that has become unreadable, or a value that has no place in it, with row and column.
    pub(crate) fn jobs(&mut self, table: &Table, row: &Row) -> Result<Vec<JobText>, Failure> {
        if !self.read.contains_key(&row.template) {
            let (text, folder) = table.template(&row.template)?;
            self.read.insert(row.template.clone(), JobText { text, folder });
        }
        let template = &self.read[&row.template];
        let mut machines: Vec<Option<&String>> = row.machines.iter().map(Some).collect();
        if machines.is_empty() {
            machines.push(None);
        }
        let one = |machine: Option<&String>| {
            let set = |path: &str, value: Value| Change::Set { path: path.to_owned(), value };
            let mut changes: Vec<Change> = row.settings.iter().map(|s| set(&s.path, s.value.clone())).collect();
            changes.extend(machine.map(|name| set("machine", Value::String(name.clone()))));
            let text = TomlText::parse(&row.template, &template.text)?.changed(&row.template, &changes);
            let text = text.map_err(|e| in_row(table, row, e))?.text().to_owned();
            Ok(JobText { text, folder: template.folder.clone() })
        };
        machines.into_iter().map(one).collect()
    }

    /// Hash of everything that a row's result depends on: its jobs, the files that they name, `options` and the version.
    pub(crate) fn hash(&mut self, jobs: &[JobText], options: &str) -> String {
        let mut all = format!("{}\n{options}\n", env!("CARGO_PKG_VERSION"));
        for job in jobs {
            all += &job.text;
            self.each_file(&job.text, &job.folder, 0, &mut |_, hash| all.push_str(hash));
        }
        sha256(all.as_bytes())
    }

    /// Adds the files of jobs that [`Templates::hash`] regards.
    ///
    /// # Errors
    /// A file that has become unreadable.
    pub(crate) fn carry(&mut self, jobs: &[JobText], files: &mut BTreeMap<PathBuf, Vec<u8>>) -> Result<(), Failure> {
        let mut paths = Vec::new();
        for job in jobs {
            self.each_file(&job.text, &job.folder, 0, &mut |path, _| paths.push(path.to_owned()));
        }
        for path in paths {
            carry(&path, files)?;
        }
        Ok(())
    }

    /// Calls `found` with path and hash of all files that the texts of a file name, and of those that TOML files among them
    /// name.
    fn each_file(&mut self, text: &str, folder: &Path, depth: u32, found: &mut dyn FnMut(&Path, &str)) {
        let Ok(root) = toml::from_str::<toml::Table>(text) else { return };
        let mut names = Vec::new();
        texts(&toml::Value::Table(root), &mut names);
        for name in names {
            for path in [
                folder.join(&name),
                folder.join(format!("{name}.toml")),
                folder.join("machines").join(format!("{name}.toml")),
            ] {
                if let Some(hash) = self.hash_of(&path) {
                    found(&path, &hash);
                    let is_toml = path.extension().is_some_and(|e| e == "toml");
                    if is_toml && depth < 3 {
                        let text = std::fs::read_to_string(&path).unwrap_or_default();
                        self.each_file(&text, path.parent().unwrap_or(folder), depth + 1, found);
                    }
                }
            }
        }
    }

    fn hash_of(&mut self, path: &Path) -> Option<String> {
        if !self.hashes.contains_key(path) {
            // Any text of a job is tried as a name: devices and pipes are not read.
            let hash = path.is_file().then(|| std::fs::read(path).ok()).flatten().map(|bytes| sha256(&bytes));
            self.hashes.insert(path.to_owned(), hash);
        }
        self.hashes[path].clone()
    }
}

/// Adds a file, unless it is there.
///
/// # Errors
/// An unreadable file.
pub(crate) fn carry(path: &Path, files: &mut BTreeMap<PathBuf, Vec<u8>>) -> Result<(), Failure> {
    if !files.contains_key(path) {
        files.insert(path.to_owned(), read_bytes(path, &path.display().to_string())?);
    }
    Ok(())
}

/// All texts in a value that may be names of files.
fn texts(value: &toml::Value, found: &mut Vec<String>) {
    match value {
        toml::Value::String(text) if !text.is_empty() && text.len() < 200 && !text.contains('\n') => {
            found.push(text.clone());
        }
        toml::Value::Array(list) => list.iter().for_each(|value| texts(value, found)),
        toml::Value::Table(table) => table.values().for_each(|value| texts(value, found)),
        _ => {}
    }
}

/// The fault of a row's job, at the column whose value it is about if there is one.
pub(crate) fn in_row(table: &Table, row: &Row, error: DocumentError) -> Failure {
    let of_key =
        |path: &str| error.key == path || error.key.strip_prefix(path).is_some_and(|rest| rest.starts_with(['.', '[']));
    let column = match error.key.as_str() {
        "machine" if !row.machines.is_empty() => Some("machine"),
        _ => row.settings.iter().map(|s| s.path.as_str()).find(|path| of_key(path)),
    };
    match column {
        Some(column) => {
            let allowed = error.allowed.clone().unwrap_or_default();
            let value = row.settings.iter().find(|s| s.path == column).map_or(String::new(), |s| s.written.clone());
            let address = if value.is_empty() { column.to_owned() } else { format!("{column} = {value}") };
            table.fault(row.line, row.number, &address, error.message, allowed)
        }
        None => Failure::Document(Box::new(error)),
    }
}
