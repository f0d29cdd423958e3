//! Arguments of everything that welds a simulated part.

use clap::Args;
use std::path::PathBuf;

#[derive(Debug, Args)]
pub(crate) struct PartArgs {
    /// Deviation of the part from the plan: misplaced, bent, moved by heat, with tacks (docs/explanation/tracking.md). The seam is
    /// then tracked by the machine's stripe sensors, or by its beam
    #[arg(long, value_name = "FILE")]
    pub(crate) distortion: Option<PathBuf>,
    /// Correct all passes by the deviations measured by a beam in an earlier weld (deviations-pass-N.csv), if they still fit
    #[arg(long, value_name = "FILE", conflicts_with = "no_tracking")]
    pub(crate) replay: Option<PathBuf>,
    /// Weld a distorted part without tracking
    #[arg(long)]
    pub(crate) no_tracking: bool,
}
