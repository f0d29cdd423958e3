//! Time control while running: override, hold, resume, reverse and stops at places, always on the path and in limits.
//!
//! [`Pace`] plays a law of motion ([`Timed`]) at a pace that changes within every axis' limits; [`Run`] puts the
//! process around it: arc or beam off before standing still, crater fill, restart with overlap.

mod control;
mod course;
mod error;
mod order;
mod pass;
mod run;
mod shield;
mod timed;

pub use control::{Pace, Played};
pub use error::PaceError;
pub use order::{Instant, Order, RunPhase};
pub use pass::PassTimed;
pub use run::Run;
pub use timed::{AxisLimits, CHANNELS, Limits, Rates, Timed, Tip};

/// What the pace shall do from the next period on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Command {
    /// Part of the planned speed, 0 to 1, or up to 1.5 with a law for a greater speed.
    Override(f64),
    /// Stop on the path as soon as can be.
    Hold,
    /// Go forward.
    Resume,
    /// Go back along the path.
    Reverse,
    /// Go to path length s (mm), either way, and stop there exactly; if it is too near to stop at, go on.
    StopAt(f64),
}
