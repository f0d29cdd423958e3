//! Arguments of `seamwright machine move`.

use clap::Args;

#[derive(Debug, Args)]
#[command(
    allow_negative_numbers = true,
    after_help = "Example: seamwright machine move torch-5axis --to x=200,z=120,b=-15 --period-ms 1 > set-points.csv
Exit code 1 if something would come too near; parts are not known here, only what the machine file describes."
)]
pub(crate) struct MoveArgs {
    /// Machine that ships, or a machine file
    pub(crate) machine: String,
    /// Where to: axes with their positions, mm or degrees; other axes stay
    #[arg(long, value_name = "AXIS=V,..", value_delimiter = ',', required = true, allow_hyphen_values = true)]
    pub(crate) to: Vec<String>,
    /// Where from: the same; other axes are at home
    #[arg(long, value_name = "AXIS=V,..", value_delimiter = ',', allow_hyphen_values = true)]
    pub(crate) from: Vec<String>,
    /// Period of the set-points, ms [default: the machine's servo period]
    #[arg(long, value_name = "T")]
    pub(crate) period_ms: Option<f64>,
    /// Share of the axes' highest speeds, percent
    #[arg(long, value_name = "P", default_value_t = 100.0)]
    pub(crate) override_percent: f64,
    /// JSON instead of CSV
    #[arg(long)]
    pub(crate) json: bool,
}
