//! Plans of many seams from one table, and of one seam with many drawn values.
//!
//! A [`Table`] has one row a seam: a template job, values that replace those of the template by their keys, and the
//! machines that may weld it. [`Schedule`] plans every row on every machine, keeps what is done in a journal, and writes
//! results, programs and a report. Rows that have not changed are not planned again.
//!
//! A [`Study`] draws uncertain quantities of one job, and a [`StudyRun`] plans every draw and summarises what follows.
//!
//! - `table`: rows of CSV and TOML tables, and their faults by row and column.
//! - `job_text`: the job of a row.
//! - `plan_row`: one row planned, with its figures.
//! - `journal`: results on disk as they come.
//! - `threads`: work by several threads.
//! - `columns`: result files with a line for each row.
//! - `keys`: names of keys of a format.
//! - `cluster`: rows and draws planned by workers of a Spark cluster.
//! - `run`: all rows by several threads.
//! - `machine_load`: parts distributed over the machines.
//! - `output`: result files and report.
//! - `study`: studies of tolerances.

#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::print_stdout, clippy::print_stderr))]

mod cluster;
mod columns;
mod job_text;
mod journal;
mod keys;
mod machine_load;
mod output;
mod plan_row;
mod run;
mod study;
mod table;
mod threads;

pub use cluster::{Spark, Worker};
pub use machine_load::{MachineLoad, Occupation, Task, machine_load};
pub use plan_row::{RowResult, Status};
pub use run::{Progress, Schedule, Summary};
pub use study::{
    DrawResult, FigureSummary, FindingSummary, IndexSummary, Outcome, Overrides, Quantiles, QuantitySummary, Study,
    StudyProgress, StudyRun, StudySummary, SweepFigure, SweepPoint, SweepSummary, Swing,
};
pub use table::{Row, Setting, Table};
