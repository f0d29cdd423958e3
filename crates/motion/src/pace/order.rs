use super::control::Played;

/// What the operator asks for.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Order {
    /// Part of the planned speed, 0 to 1, or up to 1.5 with a law for a greater speed. 0 holds, and so does all below
    /// 0.001: at such a pace a weld would have no end.
    Override(f64),
    /// Stop on the path with the process as the sequence says.
    Hold,
    /// Start, or go on after a hold: with overlap, if the process was on.
    Resume,
    /// Stop, and go back along the path with the process off.
    Reverse,
    /// Weld on (or start) and hold at the next place.
    Step,
    /// Weld on (or start) and hold at path length s (mm), beyond what is welded; as soon as can be if that is too near.
    StepTo(f64),
    /// Stop, switch the process off and end the run.
    Abort,
}

/// What the process does at an instant of a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum RunPhase {
    /// At rest, process off, waiting for an order.
    Held,
    /// Gas flows at rest, nothing else.
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

    /// In one word, as in tables and on the wire.
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
    /// What the process does from now on.
    pub phase: RunPhase,
    /// How long a phase at rest goes on, s.
    pub left_s: f64,
    /// Where the axes shall be and how they move.
    pub played: Played,
}
