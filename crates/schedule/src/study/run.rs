use super::columns::write_rows;
use super::draw::{DrawResult, DrawTerms};
use super::open::Study;
use super::report::page;
use super::summary::{Nominals, StudySummary};
use crate::cluster::{DrawPiece, DrawPlanned, Run, Spark, parsed, text};
use crate::journal::Journal;
use crate::threads::{in_threads, locked};
use seamwright_message::Language;
use seamwright_project::failure::Failure;
use seamwright_project::files;
use std::cell::Cell;
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

/// Results of draws.
pub(crate) type Draws = Journal<u64, DrawResult>;

/// A study to be run.
pub struct StudyRun<'a> {
    /// The study.
    pub study: &'a Study,
    /// Folder for results.
    pub output: &'a Path,
    /// Number of threads, without a cluster.
    pub threads: usize,
    /// Cluster whose workers plan the draws.
    pub spark: Option<&'a Spark>,
    /// Time limit of the searches of a draw.
    pub limit: Duration,
    /// Set to end it: what is done is kept.
    pub cancel: Option<&'a AtomicBool>,
}

/// How far it has come.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct StudyProgress {
    /// Number of draws done, also by an earlier run.
    pub done: u64,
    /// Those among them that were not planned again.
    pub kept: u64,
}

/// A draw to be planned.
struct Work {
    values: Vec<f64>,
    hash: u64,
}

impl StudyRun<'_> {
    /// Number of plans: draws, the nominal one, and two for each quantity.
    pub fn plans(&self) -> u64 {
        self.study.rows() + 1 + 2 * self.study.quantities.len() as u64
    }

    /// Plans all draws that have no result yet, and writes the results of all. Returns the summary and the files.
    ///
    /// # Errors
    /// Failures to read or write. A draw that fails is a result.
    pub fn run(&self, progress: &(dyn Fn(StudyProgress) + Sync)) -> Result<(StudySummary, Vec<PathBuf>), Failure> {
        std::fs::create_dir_all(self.output).map_err(|e| files::not_writable(self.output, &e))?;
        let journal = Draws::open(&self.output.join("draws.jsonl"))?;
        let kept = self.plan(&journal, progress)?;
        let [csv, parquet, json, html] =
            ["draws.csv", "draws.parquet", "summary.json", "report.html"].map(|name| self.output.join(name));
        let counts = write_rows(self.study, [&csv, &parquet], &|values| self.result(&journal, values))?;
        let nominals = self.nominals(&journal)?;
        let summary = StudySummary::new(self.study, &counts, &nominals, &parquet, kept)?;
        let text = serde_json::to_string_pretty(&summary).map_err(|e| Failure::environment(e.to_string()))?;
        files::write(&json, &(text + "\n"))?;
        files::write(&html, &page(self.study, &summary, &parquet)?.render())?;
        Ok((summary, vec![csv, parquet, json, html]))
    }

    /// Plans the draws without a result. Returns the number of those that had one.
    fn plan(&self, journal: &Draws, progress: &(dyn Fn(StudyProgress) + Sync)) -> Result<u64, Failure> {
        let counts = Mutex::new(StudyProgress { done: 0, kept: 0 });
        let count = |kept: bool| {
            let mut counts = locked(&counts);
            counts.done += 1;
            counts.kept += u64::from(kept);
            progress(*counts);
        };
        let terms = DrawTerms { limit: self.limit, cancel: self.cancel, language: Language::of_process() };
        match self.spark {
            None => {
                let work = |Work { values, hash }: Work| {
                    if self.cancel.is_some_and(|cancel| cancel.load(Ordering::Relaxed)) {
                        return Err(Failure::Cancelled);
                    }
                    journal.add(&hash, &self.study.plan(&values, terms)?)?;
                    count(false);
                    Ok(())
                };
                in_threads(self.threads, &work, |send| self.each_open(journal, &count, &|work| Ok(send(work))))?;
            }
            Some(spark) => {
                let open = Cell::new(false);
                self.each_open(journal, &|_| {}, &|_| {
                    open.set(true);
                    Ok(false)
                })?;
                if !open.get() {
                    self.each_open(journal, &count, &|_| Ok(true))?;
                    return Ok(locked(&counts).kept);
                }
                let task = self.study.task(self.limit)?;
                let done = |result: &str| {
                    let DrawPlanned { hash, result } = parsed(result)?;
                    journal.add(&hash, &result)?;
                    count(false);
                    Ok(())
                };
                spark.plan(&Run { task: &task, cancel: self.cancel, done: &done }, |send| {
                    let send = |Work { values, hash }: Work| Ok(send(text(&DrawPiece { hash, values })?));
                    self.each_open(journal, &count, &send)
                })?;
            }
        }
        let kept = locked(&counts).kept;
        Ok(kept)
    }

    /// Calls `send` with every draw that has no result yet, until it returns false. Other draws are counted.
    fn each_open(
        &self,
        journal: &Draws,
        count: &dyn Fn(bool),
        send: &dyn Fn(Work) -> Result<bool, Failure>,
    ) -> Result<(), Failure> {
        let special = self.special().into_iter();
        for values in special.chain((0..self.study.rows()).map(|row| self.study.values(row))) {
            let hash = self.study.hash_of(&values, self.limit);
            if journal.has(&hash) {
                count(true);
            } else if !send(Work { values, hash })? {
                break;
            }
        }
        Ok(())
    }

    /// Values of the nominal plan, and of those with one quantity at an end.
    fn special(&self) -> Vec<Vec<f64>> {
        let ends = (0..self.study.quantities.len()).flat_map(|i| self.study.swing_values(i));
        std::iter::once(self.study.nominal_values()).chain(ends).collect()
    }

    fn nominals(&self, journal: &Draws) -> Result<Nominals, Failure> {
        let mut results = self.special().into_iter().map(|values| self.result(journal, &values));
        let nominal = results.next().unwrap_or_else(|| Ok(DrawResult::failed(Language::of_process())))?;
        let ends = results.collect::<Result<Vec<_>, _>>()?;
        Ok(Nominals { nominal, ends })
    }

    fn result(&self, journal: &Draws, values: &[f64]) -> Result<DrawResult, Failure> {
        let found = journal.get(&self.study.hash_of(values, self.limit))?;
        Ok(found.unwrap_or_else(|| DrawResult::failed(Language::of_process())))
    }
}
