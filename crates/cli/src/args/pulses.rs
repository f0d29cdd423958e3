//! Arguments of `seamwright tools pulses`.

use clap::Args;
use std::path::PathBuf;

#[derive(Debug, Args)]
#[command(
    allow_negative_numbers = true,
    after_help = "Examples:
  seamwright tools pulses examples/head-nozzle.toml --period-ms 1 -o head-nozzle.vcd
  seamwright tools pulses examples/head-nozzle.toml --period-ms 1 > pulses.csv
  seamwright tools pulses examples/head-nozzle.toml --motors --json"
)]
pub(crate) struct PulsesArgs {
    /// Job or program file, or the name of an example
    pub(crate) job: PathBuf,
    #[command(flatten)]
    pub(crate) planning: super::planning::PlanningArgs,
    /// Period of the set-points, ms, a whole number of ticks [default: the machine's servo period]
    #[arg(long, value_name = "T")]
    pub(crate) period_ms: Option<f64>,
    /// Tick of the pulse timer, ns
    #[arg(long, value_name = "N", default_value_t = 100, value_parser = clap::value_parser!(u32).range(1..=1_000_000))]
    pub(crate) tick_ns: u32,
    /// Include the transfer moves from home to the first weld and from the last back home
    #[arg(long)]
    pub(crate) air: bool,
    /// Also simulate the motors with these pulses; exit code 1 if a motor loses steps
    #[arg(long)]
    pub(crate) motors: bool,
    /// Write the lines as a value change dump (GTKWave) to this file and print a summary, instead of pulses as CSV
    #[arg(short, long, value_name = "FILE.vcd")]
    pub(crate) output: Option<PathBuf>,
    /// Print the summary as JSON instead of pulses or text
    #[arg(long)]
    pub(crate) json: bool,
}
