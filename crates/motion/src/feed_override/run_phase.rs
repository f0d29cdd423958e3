use super::control::Played;
use serde::{Deserialize, Serialize};

/// Order of the operator.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Order {
    /// Fraction of the planned speed, 0 to 1, or up to 1.5 with a profile for a higher speed. Values below 0.001 hold,
    /// as such a weld would never end.
    Override(f64),
    /// Stop on the path, with the process as defined by the sequence.
    Hold,
    /// Start, or go on after a hold: with overlap, if the process was on.
    Resume,
    /// Stop, and go back along the path with the process off.
    Reverse,
    /// Weld on (or start) and hold at the next stop.
    Step,
    /// Weld on (or start) and hold at path length s (mm), beyond the welded part; as soon as possible if that is too
    /// near.
    StepTo(f64),
    /// Stop, switch the process off and end the run.
    Abort,
}

/// Process phase at an instant of a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub enum RunPhase {
    /// At rest, process off, waiting for an order.
    Held,
    /// At rest with gas flow only.
    Preflow,
    /// The arc (or beam) is on and the torch rests before it travels.
    TravelDelay,
    /// The torch travels with the arc (or beam) on; it may be slowing down.
    Travel,
    /// The beam is off and the torch slows down.
    RunOut,
    /// The torch rests with the arc on.
    Crater,
    /// The arc (or beam) is off, gas still flows.
    Postflow,
    /// The torch moves along the path with everything off.
    Move,
    /// The run is over.
    Ended,
}

impl RunPhase {
    /// True if arc or beam is on.
    pub fn arc(self) -> bool {
        matches!(self, Self::TravelDelay | Self::Travel | Self::Crater)
    }

    /// One-word name, as in tables and in the protocol.
    pub fn name(self) -> &'static str {
        match self {
            Self::Held => "held",
            Self::Preflow => "preflow",
            Self::TravelDelay => "travel_delay",
            Self::Travel => "travel",
            Self::RunOut => "run_out",
            Self::Crater => "crater",
            Self::Postflow => "postflow",
            Self::Move => "move",
            Self::Ended => "ended",
        }
    }
}

/// One instant of a run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Instant {
    /// Process phase from now on.
    pub phase: RunPhase,
    /// Remaining time of a phase at rest, s.
    pub left_s: f64,
    /// Set positions and rates of the axes.
    pub played: Played,
}
