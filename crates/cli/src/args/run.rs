//! Arguments of `seamwright run` and `seamwright machine latency`.

use super::part::PartArgs;
use super::planning::PlanningArgs;
use super::records::RecordArgs;
use clap::Args;
use seamwright_executive::Place;
use seamwright_simulation::devices::Fault;
use std::path::PathBuf;

#[derive(Debug, Args)]
#[command(after_help = "Standard input has one order per line: on, home, arm, weld, dry, hold, resume, reverse, stop,
override PERCENT, acknowledge, reset, off, quit; wait MODE, wait N s, wait N mm. `?` reports the state of the cell and the missing permissives.
At the end of the orders the cell stops and switches off.

Example:
  printf 'on\\nhome\\nwait ready\\narm\\nweld\\nwait ready\\n' | seamwright run examples/ellipse.toml -o out/run

With --data the weld is recorded (docs/reference/records.md), and its position is on the disk twenty times a second: after a power failure
`run` reports the position, and --from resumes there, with the overlap of the pass.

The devices are those of the machine file ([devices.NAME], docs/reference/machine.md), the others are simulated. Exit code 1 if an order is
refused, 3 if a device cannot be reached or the cell ends in a fault.")]
pub(crate) struct RunArgs {
    /// Job or program file, or the name of an example
    pub(crate) job: PathBuf,
    /// Folder for trace.parquet, events.jsonl and run.json; made if missing
    #[arg(short, long, value_name = "DIR")]
    pub(crate) output: PathBuf,
    /// Resume an earlier weld: the pass, and its welded length from its start, mm
    #[arg(long, value_name = "PASS,MM", value_parser = place)]
    pub(crate) from: Option<Place>,
    #[command(flatten)]
    pub(crate) record: RecordArgs,
    #[command(flatten)]
    pub(crate) planning: PlanningArgs,
    #[command(flatten)]
    pub(crate) part: PartArgs,
    /// CPU of the cycle
    #[arg(long, value_name = "N")]
    pub(crate) cpu: Option<usize>,
    /// A fault of a device, simulated or not, like drives:silent@12.5 or inputs:disconnect@3+0.5 (docs/explanation/faults.md); may be repeated
    #[arg(long, value_name = "SPEC")]
    pub(crate) fault: Vec<Fault>,
    /// Seed of the simulated devices
    #[arg(long, default_value_t = 1)]
    pub(crate) seed: u64,
    /// Events as JSON, one per line
    #[arg(long)]
    pub(crate) json: bool,
}

fn place(text: &str) -> Result<Place, String> {
    let bad = || "allowed is PASS,MM, like 1,45.2: the pass from 1, and path length in it from 0".to_owned();
    let (pass, mm) = text.split_once(',').ok_or_else(bad)?;
    let pass = pass.trim().parse::<usize>().ok().filter(|pass| *pass > 0).ok_or_else(bad)?;
    let s_mm = mm.trim().parse::<f64>().ok().filter(|mm| mm.is_finite() && *mm >= 0.0).ok_or_else(bad)?;
    Ok(Place { pass, s_mm })
}

#[derive(Debug, Args)]
#[command(after_help = "Example: seamwright machine latency --period-ms 1 --seconds 10")]
pub(crate) struct LatencyArgs {
    /// Period of the cycle, ms
    #[arg(long, value_name = "T", default_value_t = 1.0)]
    pub(crate) period_ms: f64,
    /// Duration of the measurement, s
    #[arg(long, value_name = "S", default_value_t = 10.0)]
    pub(crate) seconds: f64,
    /// CPU of the cycle
    #[arg(long, value_name = "N")]
    pub(crate) cpu: Option<usize>,
    /// JSON instead of text
    #[arg(long)]
    pub(crate) json: bool,
}
