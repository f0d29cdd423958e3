//! All rows of a table, by several threads.

use crate::cluster::{RowPiece, RowPlanned, Run, Spark, Task, Work as TaskWork, parsed, text};
use crate::job_text::{JobText, Templates, carry};
use crate::journal::Journal;
use crate::output;
use crate::plan_row::{RowResult, RowTerms, Status, plan_contained};
use crate::table::{Row, Table};
use crate::threads::{in_threads, locked};
use seamwright_message::Language;
use seamwright_project::failure::Failure;
use seamwright_project::files;
use seamwright_project::posting::PostTarget;
use std::cell::{Cell, RefCell};
use std::collections::{BTreeMap, HashSet};
use std::path::{Path, PathBuf};
use std::sync::Mutex;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::Duration;

/// A table to be planned.
#[derive(Debug)]
pub struct Schedule<'a> {
    /// The table.
    pub table: &'a Table,
    /// Folder for results.
    pub output: &'a Path,
    /// Number of threads, without a cluster.
    pub threads: usize,
    /// Cluster whose workers plan the rows.
    pub spark: Option<&'a Spark>,
    /// Time limit of the searches of a row on one machine.
    pub limit: Duration,
    /// Control to write part programs for.
    pub post: Option<PostTarget>,
    /// Set to end it: what is done is kept.
    pub cancel: Option<&'a AtomicBool>,
}

/// How far it has come.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Progress {
    /// Number of rows done, also by an earlier run.
    pub done: u64,
    /// Those among them that were not planned again.
    pub kept: u64,
}

/// Outcome of all rows.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Summary {
    /// Number of rows.
    pub rows: u64,
    /// Rows that can be welded.
    pub weldable: u64,
    /// Rows that were not planned again.
    pub kept: u64,
    /// Files that were written.
    pub files: Vec<PathBuf>,
}

/// Results of rows.
pub(crate) type Rows = Journal<String, RowResult>;

/// A row to be planned.
struct Work {
    row: Row,
    jobs: Vec<JobText>,
    hash: String,
}

impl Schedule<'_> {
    /// Plans all rows that have no result yet, and writes the results of all.
    ///
    /// # Errors
    /// Faults of the table, failures to write. A row that fails is a result.
    pub fn run(&self, progress: &(dyn Fn(Progress) + Sync)) -> Result<Summary, Failure> {
        std::fs::create_dir_all(self.programs()).map_err(|e| files::not_writable(self.output, &e))?;
        let journal = Rows::open(&self.output.join("rows.jsonl"))?;
        let kept = self.plan(&journal, progress)?;
        let mut summary = output::write(self, &|row, templates| self.result(row, templates, &journal))?;
        summary.kept = kept;
        Ok(summary)
    }

    /// Calls `each` with every row and its result, none if it is not planned yet, until it returns false. Another process
    /// may be planning the same schedule.
    ///
    /// # Errors
    /// Faults of the table, failures to read, and those of `each`.
    pub fn results(
        &self,
        each: &mut dyn FnMut(Row, Option<RowResult>) -> Result<bool, Failure>,
    ) -> Result<(), Failure> {
        let journal = Rows::open_to_read(&self.output.join("rows.jsonl"))?;
        let mut templates = Templates::default();
        self.table.each(&mut |row| {
            let result = match templates.jobs(self.table, &row) {
                Ok(jobs) => {
                    let hash = self.hash(&row, &jobs, &mut templates);
                    journal.as_ref().map(|journal| journal.get(&hash)).transpose()?.flatten()
                }
                Err(failure) => Some(RowResult::without_plan(Status::Invalid, failure.text())),
            };
            each(row, result)
        })
    }

    /// The job of the row called `name` on `machine`, or on its first machine; none if there is no such row.
    ///
    /// # Errors
    /// Faults of the table, and a value that has no place in the template.
    pub fn job_of(&self, name: &str, machine: Option<&str>) -> Result<Option<String>, Failure> {
        let (mut templates, mut found) = (Templates::default(), None);
        self.table.each(&mut |row| {
            if row.name != name {
                return Ok(true);
            }
            let jobs = templates.jobs(self.table, &row)?;
            let at = row.machines.iter().position(|known| Some(known.as_str()) == machine).unwrap_or(0);
            found = jobs.into_iter().nth(at).map(|job| job.text);
            Ok(false)
        })?;
        Ok(found)
    }

    /// Everything besides the job that a result depends on.
    fn options(&self) -> String {
        format!("{:?} {:?}", self.post, self.limit)
    }

    pub(crate) fn programs(&self) -> PathBuf {
        self.output.join("programs")
    }

    /// File of the part program of the row called `name`.
    pub(crate) fn program(&self, name: &str) -> Option<String> {
        let end = self.post?.file_name().rsplit('.').next()?;
        Some(format!("{name}.{end}"))
    }

    /// Plans the rows without a result. Returns the number of those that had one.
    fn plan(&self, journal: &Rows, progress: &(dyn Fn(Progress) + Sync)) -> Result<u64, Failure> {
        let counts = Mutex::new(Progress { done: 0, kept: 0 });
        let count = |kept: bool| {
            let mut counts = locked(&counts);
            counts.done += 1;
            counts.kept += u64::from(kept);
            progress(*counts);
        };
        match self.spark {
            None => {
                let work = |work: Work| self.plan_one(work, journal).map(|()| count(false));
                in_threads(self.threads, &work, |send| self.each_open(journal, &count, &|work| Ok(send(work))))?;
            }
            Some(spark) => {
                let Some(task) = self.task(journal)? else {
                    self.each_open(journal, &count, &|_| Ok(true))?;
                    return Ok(locked(&counts).kept);
                };
                let done = |result: &str| self.keep(parsed(result)?, journal).map(|()| count(false));
                spark.plan(&Run { task: &task, cancel: self.cancel, done: &done }, |send| {
                    let send = |Work { row, hash, .. }: Work| Ok(send(text(&RowPiece { hash, row })?));
                    self.each_open(journal, &count, &send)
                })?;
            }
        }
        let kept = locked(&counts).kept;
        Ok(kept)
    }

    /// Calls `send` with every row that has no result yet, until it returns false. Other rows are counted.
    fn each_open(
        &self,
        journal: &Rows,
        count: &dyn Fn(bool),
        send: &dyn Fn(Work) -> Result<bool, Failure>,
    ) -> Result<(), Failure> {
        let (mut templates, mut begun) = (Templates::default(), HashSet::new());
        self.table.each(&mut |row| {
            match templates.jobs(self.table, &row) {
                Ok(jobs) => {
                    let hash = self.hash(&row, &jobs, &mut templates);
                    if journal.has(&hash) && self.has_program(&row, journal, &hash) {
                        count(true);
                    } else if begun.insert(hash.clone()) {
                        return send(Work { row, jobs, hash });
                    } else {
                        // An equal row above is planned.
                        count(true);
                    }
                }
                // It is a result of the row, made when results are written.
                Err(_) => count(false),
            }
            Ok(true)
        })
    }

    /// Task of the workers of a cluster for the rows without a result; none if all have one.
    pub(crate) fn task(&self, journal: &Rows) -> Result<Option<Task>, Failure> {
        let (files, templates) = (RefCell::new(BTreeMap::new()), RefCell::new(Templates::default()));
        let open = Cell::new(0u64);
        self.each_open(journal, &|_| {}, &|work| {
            open.set(open.get() + 1);
            let mut files = files.borrow_mut();
            let path = self.table.folder().join(&work.row.template);
            if path.is_file() {
                carry(&path, &mut files)?;
            }
            templates.borrow_mut().carry(&work.jobs, &mut files)?;
            Ok(true)
        })?;
        if open.get() == 0 {
            return Ok(None);
        }
        let post = self.post.map(|target| target.name().to_owned());
        let work = TaskWork::Table { path: self.table.path().to_owned(), post };
        Ok(Some(Task::new(work, self.limit, files.into_inner())))
    }

    /// The name is part of it where a part program is written, whose file has that name.
    fn hash(&self, row: &Row, jobs: &[JobText], templates: &mut Templates) -> String {
        let name = if self.post.is_some() { row.name.as_str() } else { "" };
        templates.hash(jobs, &format!("{} {name}", self.options()))
    }

    /// False if the part program of a row that can be welded is not there.
    fn has_program(&self, row: &Row, journal: &Rows, hash: &String) -> bool {
        let Some(file) = self.program(&row.name) else { return true };
        let is_weldable = journal.get(hash).ok().flatten().is_some_and(|r| r.status == Status::Weldable);
        !is_weldable || self.programs().join(file).is_file()
    }

    fn plan_one(&self, Work { row, jobs, hash }: Work, journal: &Rows) -> Result<(), Failure> {
        if self.cancel.is_some_and(|cancel| cancel.load(Ordering::Relaxed)) {
            return Err(Failure::Cancelled);
        }
        let language = Language::of_process();
        let terms = RowTerms { limit: self.limit, post: self.post, cancel: self.cancel, language };
        let (result, program) = plan_contained(self.table, &row, &jobs, terms)?;
        self.keep(RowPlanned { hash, name: row.name, result, program }, journal)
    }

    /// Keeps a planned row.
    fn keep(&self, planned: RowPlanned, journal: &Rows) -> Result<(), Failure> {
        let RowPlanned { hash, name, result, program } = planned;
        // The program first: a result in the journal has one.
        if let (Some(text), Some(file)) = (program, self.program(&name)) {
            files::write(&self.programs().join(file), &text)?;
        }
        journal.add(&hash, &result)
    }

    /// The result of a row that was planned; of one without a job, why.
    fn result(&self, row: &Row, templates: &mut Templates, journal: &Rows) -> Result<RowResult, Failure> {
        match templates.jobs(self.table, row) {
            Ok(jobs) => {
                let hash = self.hash(row, &jobs, templates);
                let missing = || RowResult::failed(Language::of_process());
                Ok(journal.get(&hash)?.unwrap_or_else(missing))
            }
            Err(failure) => Ok(RowResult::without_plan(Status::Invalid, failure.text())),
        }
    }
}
