//! Arguments of `seamwright machine move`.

use clap::Args;

#[derive(Debug, Args)]
#[command(
    allow_negative_numbers = true,
    after_help = "Example: seamwright machine move torch-5axis --to x=200,z=120,b=-15 --period-ms 1 > set-points.csv
Exit code 1 if a distance is too small. Only the shapes of the machine file are checked, not a part."
)]
pub(crate) struct MoveArgs {
    /// Shipped machine, or a machine file
    pub(crate) machine: String,
    /// Target: axes with their positions, mm or degrees; other axes stay
    #[arg(long, value_name = "AXIS=V,..", value_delimiter = ',', required = true, allow_hyphen_values = true)]
    pub(crate) to: Vec<String>,
    /// Start: axes with their positions; other axes are at home
    #[arg(long, value_name = "AXIS=V,..", value_delimiter = ',', allow_hyphen_values = true)]
    pub(crate) from: Vec<String>,
    /// Period of the set-points, ms [default: the machine's servo period]
    #[arg(long, value_name = "T")]
    pub(crate) period_ms: Option<f64>,
    /// Feed override relative to the axes' maximum speeds, percent
    #[arg(long, value_name = "P", default_value_t = 100.0)]
    pub(crate) override_percent: f64,
    /// JSON instead of CSV
    #[arg(long)]
    pub(crate) json: bool,
}
