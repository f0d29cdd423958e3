//! Arguments of `seamwright tools follow`.

use clap::{Args, ValueEnum};
use std::path::PathBuf;

#[derive(Debug, Args)]
#[command(after_help = "Example: seamwright tools seam examples/trunnion-saddle.toml --every-mm 0.5 > seam.csv
         seamwright tools follow seam.csv --machine table-tilting-xyzac --speed-mm-s 10 > set-points.csv
Points are axis positions (one column per axis, mm or degrees) or positions of the tip (x_mm,y_mm,z_mm and, if the torch
is not to point straight down, its direction ax,ay,az or the bisector bx,by,bz of `seamwright tools seam`). A turn by more
than 30 degrees is a corner. Read and planned as it goes, in constant memory: a file of
any length will do. If a point cannot be reached, or the machine's own shapes come too near to each other, the motion ends at rest before it and the exit code is 1.")]
pub(crate) struct FollowArgs {
    /// CSV of points, or - for standard input
    pub(crate) points: PathBuf,
    /// Shipped machine, or a machine file
    #[arg(long)]
    pub(crate) machine: String,
    /// Speed of the torch tip relative to the work, mm/s
    #[arg(long, value_name = "V")]
    pub(crate) speed_mm_s: f64,
    /// Period of the set-points, ms [default: the machine's servo period]
    #[arg(long, value_name = "T")]
    pub(crate) period_ms: Option<f64>,
    /// Behaviour at corners
    #[arg(long, value_enum, default_value_t = CornerArg::Stop)]
    pub(crate) corner: CornerArg,
    /// Maximum distance of a blend from its corner, mm
    #[arg(long, value_name = "D", default_value_t = 0.1)]
    pub(crate) corner_mm: f64,
    /// Maximum distance of an omitted point from the path, mm
    #[arg(long, value_name = "D", default_value_t = 0.01)]
    pub(crate) tolerance_mm: f64,
    /// Look-ahead time of the speed profile, s
    #[arg(long, value_name = "S", default_value_t = 5.0)]
    pub(crate) window_s: f64,
    /// JSON instead of CSV
    #[arg(long)]
    pub(crate) json: bool,
}

/// Behaviour at a corner.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum CornerArg {
    /// Stop exactly at the corner
    Stop,
    /// Blend smoothly, within --corner-mm
    Blend,
}
