use super::layers::{MAX_BEADS, Runs};
use super::plan::{MAX_BEAD_STATIONS, MAX_STATIONS};
use crate::allowed::between;
use crate::joint::NoGroove;
use seamwright_message::{Message, Unit};
use seamwright_program::Preparation;

/// Reason why beads cannot be laid out along a seam.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum NoPlan {
    /// A position (mm) without a groove.
    NoGroove {
        s: f64,
        why: NoGroove,
    },
    /// Number of beads, and the areas of groove and smallest bead, mm^2.
    Beads {
        groove: f64,
        beads: f64,
        smallest: f64,
    },
    Stations(usize),
    /// A scan after as many layers as the plan has, or more: its entry in `joint.fit_up`, and their number.
    Layers {
        entry: usize,
        layers: usize,
    },
    /// Numbers of passes and of stations of each.
    Positions {
        passes: usize,
        stations: usize,
    },
}

seamwright_message::display_by_message!(NoPlan);

/// Beads smaller than this are the mistake, not the groove, mm^2: a wire of 0.6 mm leaves 0.3 mm^2 as it is.
const SMALL_MM2: f64 = 0.3;

impl NoPlan {
    /// Description of the fault.
    pub(crate) fn message(&self) -> Message {
        match self {
            Self::NoGroove { s, why } => why.at(*s),
            Self::Beads { groove, beads, smallest } => Message::new("weld-too-many-beads")
                .quantity("groove", *groove, Unit::Mm2, 0)
                .number("beads", *beads, 0)
                .quantity("bead", *smallest, Unit::Mm2, 3),
            Self::Stations(count) => Message::new("weld-too-many-stations").count("count", *count),
            Self::Layers { layers, .. } => Message::new("weld-scan-after-last-layer").count("layers", *layers),
            Self::Positions { passes, stations } => {
                Message::new("weld-too-many-bead-positions").count("passes", *passes).count("rows", *stations)
            }
        }
    }

    /// The key of the job to look at, and the allowed values; `stations` is the key of the distance of stations, or the
    /// table that leaves it at its default.
    pub(crate) fn cure(&self, preparation: &Preparation, runs: &Runs, stations: &str) -> (String, Message) {
        let groove = format!("joint.preparation.{}", preparation.key());
        let up_to = |code, max| Message::new(code).count("max", max);
        match self {
            Self::NoGroove { why, .. } => (groove, why.cure().1),
            Self::Beads { smallest, .. } if *smallest < SMALL_MM2 => {
                let run = if runs.fill.area <= runs.cap.area { "beads.fill" } else { "beads.cap" };
                (run.to_owned(), up_to("weld-allowed-larger-beads", MAX_BEADS))
            }
            Self::Beads { .. } => {
                (format!("{groove}.{}", preparation.size_key()), up_to("weld-allowed-smaller-groove", MAX_BEADS))
            }
            Self::Stations(_) => (stations.to_owned(), up_to("weld-allowed-stations", MAX_STATIONS)),
            Self::Layers { entry, layers } => {
                let allowed = between(0.0, *layers as f64 - 1.0, Unit::One);
                (format!("joint.fit_up[{entry}].after_layer"), allowed)
            }
            Self::Positions { .. } => (stations.to_owned(), up_to("weld-allowed-bead-positions", MAX_BEAD_STATIONS)),
        }
    }
}
