//! Arguments of `seamwright machine io`.

use clap::Args;

#[derive(Debug, Args)]
#[command(after_help = "Examples:
  seamwright machine io my-machine.toml
  seamwright machine io my-machine.toml --every-s 0.5 --times 20
It only reads, outputs too: a cell may run at the same time, and a watchdog is not kept alive. Exit code 3 if a device cannot be
reached.")]
pub(crate) struct IoArgs {
    /// Shipped machine, or a machine file, with devices on Modbus
    pub(crate) machine: String,
    /// Read again after this number of seconds, until stopped
    #[arg(long, value_name = "S")]
    pub(crate) every_s: Option<f64>,
    /// Number of readings
    #[arg(long, value_name = "N", requires = "every_s")]
    pub(crate) times: Option<u64>,
    /// JSON instead of CSV
    #[arg(long)]
    pub(crate) json: bool,
}
