use super::layers::{MAX_BEADS, Runs};
use super::plan::{MAX_BEAD_STATIONS, MAX_STATIONS};
use crate::joint::NoGroove;
use seamwright_program::Preparation;

/// Reason why beads cannot be laid out along a seam.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub(crate) enum NoPlan {
    #[error("at s = {s:.1} mm: {why}")]
    NoGroove { s: f64, why: NoGroove },
    #[error("the groove of {groove:.0} mm^2 takes {beads:.0} beads of {smallest:.3} mm^2")]
    Beads { groove: f64, beads: f64, smallest: f64 },
    #[error("the beads would be laid out at {0} stations")]
    Stations(usize),
    #[error("{passes} passes with {stations} rows each are too many")]
    Positions { passes: usize, stations: usize },
}

/// Beads smaller than this are the mistake, not the groove, mm^2: a wire of 0.6 mm leaves 0.3 mm^2 as it is.
const SMALL_MM2: f64 = 0.3;

impl NoPlan {
    /// The key of the job to look at, and the allowed values; `stations` is the key of the distance of stations, or the
    /// table that leaves it at its default.
    pub(crate) fn cure(&self, preparation: &Preparation, runs: &Runs, stations: &str) -> (String, String) {
        let groove = format!("joint.preparation.{}", preparation.key());
        match self {
            Self::NoGroove { why, .. } => (groove, why.cure().1),
            Self::Beads { smallest, .. } if *smallest < SMALL_MM2 => {
                let run = if runs.fill.area <= runs.cap.area { "beads.fill" } else { "beads.cap" };
                (run.to_owned(), format!("larger beads: slower, or more wire; up to {MAX_BEADS} beads fill a groove"))
            }
            Self::Beads { .. } => {
                let key = format!("{groove}.{}", preparation.size_key());
                (key, format!("up to {MAX_BEADS} beads: a smaller groove, or larger beads"))
            }
            Self::Stations(_) => (stations.to_owned(), format!("up to {MAX_STATIONS} stations: a larger distance")),
            Self::Positions { .. } => {
                let allowed = format!("up to {MAX_BEAD_STATIONS} positions: a larger distance, or larger beads");
                (stations.to_owned(), allowed)
            }
        }
    }
}
