//! Results on disk as they come: a line each, so that a run that was killed goes on where it was.

use seamwright_project::failure::Failure;
use seamwright_project::files::not_writable;
use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use std::collections::HashMap;
use std::fs::{File, OpenOptions};
use std::hash::Hash;
use std::io::{BufRead, BufReader, Seek, SeekFrom, Write};
use std::marker::PhantomData;
use std::path::{Path, PathBuf};
use std::sync::Mutex;

/// A line of the file.
#[derive(Debug, Serialize, Deserialize)]
struct Line<H, R> {
    hash: H,
    result: R,
}

/// Results `R` by the hash of what they depend on.
#[derive(Debug)]
pub(crate) struct Journal<H, R> {
    path: PathBuf,
    inner: Mutex<Inner<H>>,
    results: PhantomData<fn() -> R>,
}

#[derive(Debug)]
struct Inner<H> {
    file: File,
    /// Place of a result's line in the file.
    places: HashMap<H, u64>,
    end: u64,
}

impl<H: Eq + Hash + Clone + Serialize + DeserializeOwned, R: Serialize + DeserializeOwned> Journal<H, R> {
    /// Opens the journal `path` or begins a new one. A last line that is not whole is cut off.
    ///
    /// # Errors
    /// Failure to read or write the file.
    pub(crate) fn open(path: &Path) -> Result<Self, Failure> {
        let failed = |e: std::io::Error| not_writable(path, &e);
        let file = OpenOptions::new().read(true).write(true).create(true).truncate(false).open(path).map_err(failed)?;
        let journal = Self::of(path, file)?;
        let inner = journal.locked();
        inner.file.set_len(inner.end).map_err(failed)?;
        drop(inner);
        Ok(journal)
    }

    /// Opens a journal that another process may be writing, to read its whole lines; none if it is missing.
    ///
    /// # Errors
    /// Failure to read the file.
    pub(crate) fn open_to_read(path: &Path) -> Result<Option<Self>, Failure> {
        match File::open(path) {
            Ok(file) => Self::of(path, file).map(Some),
            Err(e) if e.kind() == std::io::ErrorKind::NotFound => Ok(None),
            Err(e) => Err(not_writable(path, &e)),
        }
    }

    /// The journal in `file`, with the places of its whole lines.
    fn of(path: &Path, file: File) -> Result<Self, Failure> {
        let failed = |e: std::io::Error| not_writable(path, &e);
        let mut reader = BufReader::new(&file);
        let (mut places, mut end, mut line) = (HashMap::new(), 0, String::new());
        loop {
            line.clear();
            let read = reader.read_line(&mut line).map_err(failed)? as u64;
            if read == 0 || !line.ends_with('\n') {
                break;
            }
            // Lines of other versions are no results.
            if let Ok(found) = serde_json::from_str::<Line<H, R>>(&line) {
                places.insert(found.hash, end);
            }
            end += read;
        }
        drop(reader);
        Ok(Self { path: path.to_owned(), inner: Mutex::new(Inner { file, places, end }), results: PhantomData })
    }

    pub(crate) fn has(&self, hash: &H) -> bool {
        self.locked().places.contains_key(hash)
    }

    /// Adds a result; it is on disk when this returns.
    pub(crate) fn add(&self, hash: &H, result: &R) -> Result<(), Failure> {
        let line = Line { hash, result };
        let mut text = serde_json::to_string(&line).map_err(|e| Failure::environment(e.to_string()))?;
        text.push('\n');
        let failed = |e: std::io::Error| not_writable(&self.path, &e);
        let mut inner = self.locked();
        let end = inner.end;
        inner.file.seek(SeekFrom::Start(end)).map_err(failed)?;
        inner.file.write_all(text.as_bytes()).map_err(failed)?;
        inner.places.insert(hash.clone(), end);
        inner.end = end + text.len() as u64;
        Ok(())
    }

    /// The result with this hash, if it is there.
    pub(crate) fn get(&self, hash: &H) -> Result<Option<R>, Failure> {
        let failed = |e: std::io::Error| not_writable(&self.path, &e);
        let mut inner = self.locked();
        let Some(place) = inner.places.get(hash).copied() else { return Ok(None) };
        inner.file.seek(SeekFrom::Start(place)).map_err(failed)?;
        let mut text = String::new();
        BufReader::new(&mut inner.file).read_line(&mut text).map_err(failed)?;
        Ok(serde_json::from_str::<Line<H, R>>(&text).ok().map(|line| line.result))
    }

    fn locked(&self) -> std::sync::MutexGuard<'_, Inner<H>> {
        // A thread that panicked with the lock may have left a line at the end, which is not counted.
        self.inner.lock().unwrap_or_else(std::sync::PoisonError::into_inner)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::plan_row::{RowResult, Status};

    fn rows(path: &Path) -> Journal<String, RowResult> {
        Journal::open(path).unwrap()
    }

    #[test]
    fn results_survive_a_line_that_is_not_whole() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("rows.jsonl");
        let result = |passes: usize| RowResult { passes, ..RowResult::without_plan(Status::Weldable, String::new()) };
        let journal = rows(&path);
        (0..20).for_each(|i| journal.add(&format!("h{i}"), &result(i)).unwrap());
        drop(journal);
        let whole = std::fs::read(&path).unwrap();
        // Cut anywhere: all whole lines are there, and the journal goes on.
        for cut in [0, 1, whole.len() / 2, whole.len() - 1, whole.len()] {
            std::fs::write(&path, &whole[..cut]).unwrap();
            let count = whole[..cut].iter().filter(|b| **b == b'\n').count();
            let journal = rows(&path);
            for i in 0..20 {
                assert_eq!(journal.get(&format!("h{i}")).unwrap(), (i < count).then(|| result(i)), "cut at {cut}");
            }
            journal.add(&"new".to_owned(), &result(99)).unwrap();
            assert_eq!(rows(&path).get(&"new".to_owned()).unwrap(), Some(result(99)));
        }
        // Reading beside a writer leaves half a line alone.
        std::fs::write(&path, &whole[..whole.len() - 1]).unwrap();
        let read = Journal::<String, RowResult>::open_to_read(&path).unwrap().unwrap();
        assert_eq!((read.has(&"h18".to_owned()), read.has(&"h19".to_owned())), (true, false));
        assert_eq!(std::fs::read(&path).unwrap().len(), whole.len() - 1);
        assert!(Journal::<String, RowResult>::open_to_read(&folder.path().join("none")).unwrap().is_none());
    }
}
