//! Arguments of `seamwright simulate`.

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
    /// Job or program file
    pub(crate) job: PathBuf,
    /// Folder for trace.parquet, report.json and report.html; made if missing
    #[arg(short, long, value_name = "DIR")]
    pub(crate) output: PathBuf,
    /// Seed of the disturbances: the same seed gives the same weld
    #[arg(long, default_value_t = 1)]
    pub(crate) seed: u64,
    /// How the part differs from the planned one: misplaced, bent, moved by heat, with tacks (docs/tracking.md). The seam is
    /// then tracked by the machine's stripe sensors, or by its beam
    #[arg(long, value_name = "FILE")]
    pub(crate) distortion: Option<PathBuf>,
    /// Correct all passes by the deviations that a beam found in an earlier weld (deviations-pass-N.csv), if they still fit
    #[arg(long, value_name = "FILE", conflicts_with = "no_tracking")]
    pub(crate) replay: Option<PathBuf>,
    /// Weld a distorted part as planned
    #[arg(long)]
    pub(crate) no_tracking: bool,
    /// A fault of a device, like drives:silent@12.5 or source:wrong@30+0.5 (docs/faults.md): the weld runs under the executive, from
    /// switching on; may be repeated. Writes trace.parquet, events.jsonl and run.json
    #[arg(long, value_name = "SPEC", conflicts_with_all = ["distortion", "no_tracking", "replay"])]
    pub(crate) fault: Vec<seamwright_cell::devices::Fault>,
    #[command(flatten)]
    pub(crate) record: RecordArgs,
    /// Print report.json instead of a summary
    #[arg(long)]
    pub(crate) json: bool,
}
