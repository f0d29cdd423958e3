//! Step and direction pulses for steppers (INTERSECT-2006).
//!
//! [`Microstepping`] chooses how many pulses a full step has. A [`Generator`] turns the positions of one axis at the
//! ends of equal periods into a [`Train`] of pulses a period; [`Lines`] puts the trains of all axes in the order of
//! time. Time is counted in ticks of a timer.
//!
//! **Where the pulses lie.** Between two positions the axis moves evenly. A pulse comes in the tick in which this
//! straight line passes half a step, so the count of the pulses is the position in steps, rounded, at all times and
//! not only at the ends of periods. Positions are absolute and of 2^-24 of a step; the rest is whole numbers:
//! nothing adds up over any number of periods. Pulses of a period are equally far apart but for the rounding to a tick,
//! and so are those on both sides of a border between periods of equal speed.
//!
//! **Guarantees**, tested on random positions with reversals:
//! - after each period the count is the position rounded to whole steps;
//! - rising edges are never closer than the driver's highest frequency allows, and the step line is high, and low,
//!   for its
//!   shortest time at least;
//! - within a period a pulse is less than one tick before its place among equally spaced ones;
//! - the direction line changes `direction_hold` after a falling edge or later, and `direction_setup` before a rising
//!   one or earlier.
//!
//! After a reversal the first pulses may have to wait for the direction line; those of that period are then spread
//! evenly over what is left of it up to the place of the last. Where they do not fit, [`Error`] says so.

mod choice;
mod generator;
mod lines;
mod timing;
mod train;

pub use choice::{Bound, Microstepping};
pub use generator::Generator;
pub use lines::{Edge, Event, Lines};
pub use timing::Timing;
pub use train::Train;

/// Why pulses cannot be made. The generator is left as it was.
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum Error {
    /// The period asks for more pulses than the driver takes.
    #[error("{asked} pulses are asked for in a period, at most {most} can be made")]
    TooFast {
        /// Steps of the period, fractions included.
        asked: f64,
        /// Most steps of a period.
        most: f64,
    },
    /// The pulses do not fit beside the change of direction, or beside pulses that waited for one.
    #[error("{pulses} pulses do not fit between the change of direction and the end of the period")]
    Crowded {
        /// Pulses of the period.
        pulses: u64,
    },
    /// The position is no number, or too many steps from zero to be counted.
    #[error("the position {steps} steps cannot be counted; allowed: up to 1e11 from zero")]
    Position {
        /// The position.
        steps: f64,
    },
    /// The period is no tick, or too many.
    #[error("a period of {ticks} ticks of the timer; allowed: 1 to 2.7e11")]
    Period {
        /// Ticks of the period.
        ticks: u64,
    },
}
