//! Tables of seams and studies of tolerances.

use crate::fault::exception;
use crate::stoppable::{limit, run};
use crate::values::from_json;
use pyo3::exceptions::PyValueError;
use pyo3::prelude::*;
use seamwright::project::posting::PostTarget;
use seamwright_schedule::{Overrides, Schedule, Spark, Study, StudyRun, Table};
use std::path::PathBuf;
use std::sync::atomic::AtomicBool;

/// Outcome of a table.
#[pyclass(frozen, get_all, module = "seamwright")]
#[derive(Clone)]
pub(crate) struct ScheduleSummary {
    /// Number of rows.
    rows: u64,
    /// Rows that can be welded as asked.
    weldable: u64,
    /// Rows that were not planned again.
    kept: u64,
    /// Files that were written.
    files: Vec<PathBuf>,
}

#[pymethods]
impl ScheduleSummary {
    fn __repr__(&self) -> String {
        format!("<schedule: {} of {} rows can be welded, {} kept>", self.weldable, self.rows, self.kept)
    }
}

/// Number of plans at the same time.
fn threads(jobs: Option<usize>) -> PyResult<usize> {
    match jobs {
        Some(0) => Err(PyValueError::new_err("jobs = 0: must be at least 1")),
        Some(jobs) => Ok(jobs),
        None => Ok(std::thread::available_parallelism().map_or(1, usize::from)),
    }
}

/// The cluster at an address, reached through this Python.
fn cluster(py: Python<'_>, address: Option<String>) -> PyResult<Option<Spark>> {
    let Some(address) = address else { return Ok(None) };
    let python = py.import("sys")?.getattr("executable")?.extract()?;
    Ok(Some(Spark { address, python }))
}

/// Plans rows or draws on a worker of a cluster: see `seamwright.spark`.
#[pyclass(frozen, module = "seamwright._native")]
pub(crate) struct Worker(seamwright_schedule::Worker);

#[pymethods]
impl Worker {
    #[new]
    fn new(py: Python<'_>, task: &[u8]) -> PyResult<Self> {
        let worker = py.detach(|| seamwright_schedule::Worker::new(task));
        worker.map(Self).map_err(|failure| exception(py, failure))
    }

    /// The result of a piece.
    fn plan(&self, py: Python<'_>, piece: &str) -> PyResult<String> {
        py.detach(|| self.0.plan(piece)).map_err(|failure| exception(py, failure))
    }
}

/// Plans every row of a table, and writes the results into the folder `output`.
#[pyfunction]
#[pyo3(signature = (table, output, *, jobs = None, time_limit_s = 60.0, post = None, spark = None))]
pub(crate) fn schedule(
    py: Python<'_>,
    table: PathBuf,
    output: PathBuf,
    jobs: Option<usize>,
    time_limit_s: f64,
    post: Option<&str>,
    spark: Option<String>,
) -> PyResult<ScheduleSummary> {
    let (limit, threads, spark) = (limit(time_limit_s)?, threads(jobs)?, cluster(py, spark)?);
    let unknown = |name: &str| PyValueError::new_err(format!("unknown control {name:?}"));
    let post = post.map(|name| PostTarget::named(name).ok_or_else(|| unknown(name))).transpose()?;
    let summary = run(py, |cancel: &AtomicBool| {
        let (table, _) = Table::open(&table)?;
        let schedule = Schedule {
            table: &table,
            output: &output,
            threads,
            spark: spark.as_ref(),
            limit,
            post,
            cancel: Some(cancel),
        };
        schedule.run(&|_| {})
    })?;
    let seamwright_schedule::Summary { rows, weldable, kept, files } = summary;
    Ok(ScheduleSummary { rows, weldable, kept, files })
}

/// Plans every draw of a study, writes the results into the folder `output`, and returns the summary.
#[pyfunction]
#[pyo3(signature = (study, output, *, draws = None, seed = None, jobs = None, time_limit_s = 60.0, spark = None))]
#[expect(clippy::too_many_arguments, reason = "keyword arguments of Python")]
pub(crate) fn study<'py>(
    py: Python<'py>,
    study: PathBuf,
    output: PathBuf,
    draws: Option<u64>,
    seed: Option<u64>,
    jobs: Option<usize>,
    time_limit_s: f64,
    spark: Option<String>,
) -> PyResult<Bound<'py, PyAny>> {
    let (limit, threads, spark) = (limit(time_limit_s)?, threads(jobs)?, cluster(py, spark)?);
    let summary = run(py, |cancel: &AtomicBool| {
        let study = Study::open(&study, Overrides { draws, seed })?;
        let run =
            StudyRun { study: &study, output: &output, threads, spark: spark.as_ref(), limit, cancel: Some(cancel) };
        run.run(&|_| {}).map(|(summary, _)| summary)
    })?;
    let value = serde_json::to_value(&summary);
    let value = value.map_err(|e| exception(py, seamwright::Failure::environment(e.to_string())))?;
    from_json(py, &value)
}
