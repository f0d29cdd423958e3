//! Arguments of `seamwright run` and `seamwright latency`.

use clap::Args;
use seamwright_cell::devices::Fault;
use std::path::PathBuf;

#[derive(Debug, Args)]
#[command(
    after_help = "Orders come a line each from standard input: on, home, arm, weld, dry, hold, resume, reverse, stop,
override PERCENT, acknowledge, reset, off, quit; wait MODE, wait N s, wait N mm. `?` says what stands between now and a start.
When they end the cell stops and switches off.

Example:
  printf 'on\\nhome\\nwait ready\\narm\\nweld\\nwait ready\\n' | seamwright run examples/ellipse.toml -o out/run

So far the devices are simulated ones, in real time. Exit code 1 if an order is refused, 3 if the cell ends in a fault."
)]
pub(crate) struct RunArgs {
    /// Job or program file
    pub(crate) job: PathBuf,
    /// Folder for trace.parquet, events.jsonl and run.json; made if missing
    #[arg(short, long, value_name = "DIR")]
    pub(crate) output: PathBuf,
    /// CPU that the cycle stays on
    #[arg(long, value_name = "N")]
    pub(crate) cpu: Option<usize>,
    /// A fault of a simulated device, like drives:silent@12.5 or inputs:disconnect@3+0.5 (docs/faults.md); may be repeated
    #[arg(long, value_name = "SPEC")]
    pub(crate) fault: Vec<Fault>,
    /// Seed of the simulated devices
    #[arg(long, default_value_t = 1)]
    pub(crate) seed: u64,
    /// Events as JSON, a line each
    #[arg(long)]
    pub(crate) json: bool,
}

#[derive(Debug, Args)]
#[command(after_help = "Example: seamwright latency --period-ms 1 --seconds 10")]
pub(crate) struct LatencyArgs {
    /// Period of the cycle, ms
    #[arg(long, value_name = "T", default_value_t = 1.0)]
    pub(crate) period_ms: f64,
    /// How long to measure, s
    #[arg(long, value_name = "S", default_value_t = 10.0)]
    pub(crate) seconds: f64,
    /// CPU that the cycle stays on
    #[arg(long, value_name = "N")]
    pub(crate) cpu: Option<usize>,
    /// JSON instead of text
    #[arg(long)]
    pub(crate) json: bool,
}
