//! Arguments of `seamwright simulate`.

use super::part::PartArgs;
use super::planning::{AppendixArgs, PlanningArgs};
use super::records::RecordArgs;
use clap::Args;
use std::path::PathBuf;

#[derive(Debug, Args)]
#[command(
    allow_negative_numbers = true,
    after_help = "Examples:
  seamwright simulate examples/saddle.toml -o out/saddle --seed 7
  seamwright simulate examples/saddle.toml -o out/misplaced --distortion examples/distortions/misplaced.toml
  seamwright simulate examples/saddle.toml -o out/saddle --data records --part N-17 --welder 'A. Welder'"
)]
pub(crate) struct SimulateArgs {
    /// Job or program file, or the name of an example
    pub(crate) job: PathBuf,
    /// Folder for trace.parquet, report.json, report.html, events.jsonl and run.json; made if missing
    #[arg(short, long, value_name = "DIR")]
    pub(crate) output: PathBuf,
    /// Seed of the disturbances: the same seed gives the same weld
    #[arg(long, default_value_t = 1)]
    pub(crate) seed: u64,
    #[command(flatten)]
    pub(crate) planning: PlanningArgs,
    #[command(flatten)]
    pub(crate) part: PartArgs,
    /// A fault of a device, like drives:silent@12.5 or source:wrong@30+0.5 (docs/explanation/faults.md), s from switching on; may be
    /// repeated. The events are then printed
    #[arg(long, value_name = "SPEC")]
    pub(crate) fault: Vec<seamwright_simulation::devices::Fault>,
    #[command(flatten)]
    pub(crate) record: RecordArgs,
    #[command(flatten)]
    pub(crate) appendix: AppendixArgs,
    /// Print report.json instead of a summary
    #[arg(long)]
    pub(crate) json: bool,
}
