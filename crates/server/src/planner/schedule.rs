//! Plans of all rows of a table.

use super::{OnProgress, Progress};
use crate::http::Refused;
use crate::wire::ScheduleOptions;
use seamwright_message::{Message, Unit};
use seamwright_project::posting::PostTarget;
use seamwright_schedule::{Schedule, Table};
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};
use std::time::Duration;

/// Minimum and maximum time limit of the searches of a plan, s.
const LIMIT_S: [f64; 2] = [1.0, 3600.0];

/// A table among the jobs, and where its results go.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct ScheduleWork {
    /// Path of the table.
    pub(crate) table: PathBuf,
    /// Folder for results.
    pub(crate) output: PathBuf,
    pub(crate) options: ScheduleOptions,
}

/// Number of rows, and of those that can be welded.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct Planned {
    pub(crate) rows: u64,
    pub(crate) weldable: u64,
}

impl ScheduleWork {
    /// Opens the table and calls `with` with its schedule and number of rows.
    pub(crate) fn with<T>(
        &self,
        jobs: &Path,
        with: impl FnOnce(&Schedule, u64) -> Result<T, Refused>,
    ) -> Result<T, Refused> {
        let (table, rows) = Table::open_foreign(&self.table, jobs)?;
        with(&self.schedule(&table)?, rows)
    }

    /// The schedule of an open table, with the options of this work.
    pub(crate) fn schedule<'a>(&'a self, table: &'a Table) -> Result<Schedule<'a>, Refused> {
        let ScheduleOptions { post, limit_s, .. } = &self.options;
        let [min, max] = LIMIT_S;
        if !(min..=max).contains(limit_s) {
            let message = Message::new("server-schedule-limit").value("value", *limit_s, Unit::S);
            return Err(message.value("min", min, Unit::S).value("max", max, Unit::S).into());
        }
        let target = |name: &String| {
            PostTarget::named(name).ok_or_else(|| {
                let allowed = PostTarget::all().map(PostTarget::name).collect::<Vec<_>>().join(", ");
                Refused::input(Message::new("server-no-dialect").text("name", name).text("allowed", allowed))
            })
        };
        // One core is left to the cell and its panel.
        let threads = std::thread::available_parallelism().map_or(1, usize::from).saturating_sub(1).max(1);
        let limit = Duration::from_secs_f64(*limit_s);
        let post = post.as_ref().map(target).transpose()?;
        Ok(Schedule { table, output: &self.output, threads, limit, post, cancel: None, spark: None })
    }

    /// Plans all rows that have no result yet, and writes the result files.
    pub(super) fn plan(&self, jobs: &Path, progress: OnProgress) -> Result<Planned, Refused> {
        self.with(jobs, |schedule, total| {
            progress(Progress { done: 0, total, kept: 0 });
            let summary = schedule.run(&|of| progress(Progress { done: of.done, total, kept: of.kept }))?;
            Ok(Planned { rows: summary.rows, weldable: summary.weldable })
        })
    }
}
