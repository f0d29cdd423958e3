//! Arguments of `seamwright schedule`.

use super::cluster::ClusterArgs;
use super::planning::PlanningArgs;
use super::post::PostTargetArg;
use clap::Args;
use std::path::PathBuf;

#[derive(Debug, Args)]
#[command(after_help = "Example: seamwright schedule examples/nozzles.csv -o out/nozzles --post linuxcnc
A table is CSV with a row a seam: name, template (a job beside the table, or an example), and as needed machine (several
with | between them), procedure, count, setup_min, and keys of the job such as seam.nozzle.radius_mm. Empty cells keep the
template's values; a row with the name * gives those of the rows below it. Tables in TOML have [defaults] and [[seams]].
With --spark the workers of a cluster plan; the results are the same.
A schedule that was interrupted goes on where it was: call it again. Rows that have not changed are not planned again.
Exit code 1 if a row cannot be welded as requested.")]
pub(crate) struct ScheduleArgs {
    /// Table of seams: CSV or TOML
    #[arg(value_name = "TABLE")]
    pub(crate) table: PathBuf,
    /// Folder for schedule.csv, schedule.parquet, machines.csv, report.html, programs/ and rows.jsonl, which keeps what is
    /// done
    #[arg(short, long, value_name = "DIR")]
    pub(crate) output: PathBuf,
    /// Number of rows planned at the same time [default: the number of processors]
    #[arg(long, value_name = "N")]
    pub(crate) jobs: Option<usize>,
    /// Write a part program for each row that can be welded, proven by reading it back
    #[arg(long, value_name = "DIALECT")]
    pub(crate) post: Option<PostTargetArg>,
    #[command(flatten)]
    pub(crate) cluster: ClusterArgs,
    #[command(flatten)]
    pub(crate) planning: PlanningArgs,
}
