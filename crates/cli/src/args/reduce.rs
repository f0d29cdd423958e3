//! Arguments of `seamwright tools reduce`.

use clap::{Args, ValueEnum};
use std::path::PathBuf;

#[derive(Debug, Args)]
#[command(
    allow_negative_numbers = true,
    after_help = "Example:
  seamwright tools reduce examples/taught-joint.csv --tolerance-mm 0.05 --axis-tolerance 0.1 --svg joint.svg
Points are x_mm,y_mm,z_mm; every further column is an axis that goes along linearly by path length. Out: a row a line
or arc, from point `first` to point `last` (counted from 0), with the arc's centre, radius and the unit normal about
which it goes counter-clockwise, and the maximum distance of its points from it. Between points too no span leaves the
polyline by more than the tolerance; points may turn back by up to the tolerance. A full circle takes two arcs."
)]
pub(crate) struct ReduceArgs {
    /// CSV of points, or - for standard input
    pub(crate) points: PathBuf,
    /// Maximum distance of a point from its line or arc, mm
    #[arg(long, value_name = "T")]
    pub(crate) tolerance_mm: f64,
    /// Maximum deviation of a further column from its linear course, in its own unit [default: the number of --tolerance-mm]
    #[arg(long, value_name = "A")]
    pub(crate) axis_tolerance: Option<f64>,
    /// Method of dividing the points into runs
    #[arg(long, value_enum, default_value_t = MethodArg::Fewest)]
    pub(crate) method: MethodArg,
    /// Draw points, lines, arcs and their ends to this file
    #[arg(long, value_name = "FILE")]
    pub(crate) svg: Option<PathBuf>,
    /// JSON with a summary instead of CSV
    #[arg(long)]
    pub(crate) json: bool,
}

/// Method of dividing the points into runs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub(crate) enum MethodArg {
    /// The longest run from the start, then the next (EBW-2004)
    Greedy,
    /// Minimum number of lines and arcs
    Fewest,
}
