//! Arguments of `seamwright study`.

use super::cluster::ClusterArgs;
use super::planning::PlanningArgs;
use clap::Args;
use std::path::PathBuf;

#[derive(Debug, Args)]
#[command(after_help = "Example: seamwright study examples/studies/saddle.toml -o out/study
A study file names a job, the quantities that are uncertain (keys of the job or the machine, errors of the work's position
and of axes) with their distributions, the number of draws and the seed. Every draw is planned anew. The results are the
probability that the weld can be made, that of each finding, distributions of margins, clearance, speed, heat input and
other figures, and which quantity causes how much of their variance.
With --spark the workers of a cluster plan; the results are the same.
A study that was interrupted goes on where it was: call it again. The same seed gives the same draws with any --jobs.
Exit code 1 if no draw can be welded as requested.")]
pub(crate) struct StudyArgs {
    /// Study file (TOML)
    #[arg(value_name = "STUDY")]
    pub(crate) study: PathBuf,
    /// Folder for draws.csv, draws.parquet, summary.json, report.html and draws.jsonl, which keeps what is done
    #[arg(short, long, value_name = "DIR")]
    pub(crate) output: PathBuf,
    /// Number of draws [default: that of the file]
    #[arg(long, value_name = "N")]
    pub(crate) draws: Option<u64>,
    /// Seed of the draws [default: that of the file]
    #[arg(long, value_name = "N")]
    pub(crate) seed: Option<u64>,
    /// Number of draws planned at the same time [default: the number of processors]
    #[arg(long, value_name = "N")]
    pub(crate) jobs: Option<usize>,
    /// The summary as JSON instead of text
    #[arg(long)]
    pub(crate) json: bool,
    #[command(flatten)]
    pub(crate) cluster: ClusterArgs,
    #[command(flatten)]
    pub(crate) planning: PlanningArgs,
}
