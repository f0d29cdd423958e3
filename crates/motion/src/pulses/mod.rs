//! Step and direction pulses for steppers (INTERSECT-2006).
//!
//! [`Microstepping`] chooses the number of pulses per full step. A [`Generator`] turns the positions of one axis at the
//! ends of equal periods into a [`Train`] of pulses a period; [`Lines`] merges the trains of all axes in time order.
//! Time is counted in ticks of a timer.
//!
//! **Position of the pulses.** Between two positions the axis moves evenly. A pulse comes in the tick in which this
//! straight line passes half a step. So the pulse count is the rounded position in steps at all times, not only at the
//! ends of periods. Positions are absolute with a resolution of 2^-24 of a step; all else is integer: no error
//! accumulates over any number of periods. Pulses of a period are equally spaced except for the rounding to a tick,
//! also across a border between periods of equal speed.
//!
//! **Guarantees**, tested on random positions with reversals:
//! - after each period the count is the position rounded to whole steps;
//! - rising edges are never closer than the driver's maximum frequency allows, and the step line is high and low for at
//!   least its minimum times;
//! - within a period a pulse is less than one tick before its position among equally spaced ones;
//! - the direction line changes `direction_hold` after a falling edge or later, and `direction_setup` before a rising
//!   one or earlier.
//!
//! After a reversal the first pulses may have to wait for the direction line; those of that period are then spread
//! evenly over its rest up to the last pulse's position. If they do not fit, the result is [`Error::Crowded`].

mod generator;
mod lines;
mod microstepping;
mod timing;
mod train;

use seamwright_message::{Message, Unit};

pub use generator::Generator;
pub use lines::{Edge, Event, Lines};
pub use microstepping::{Bound, Microstepping};
pub use timing::Timing;
pub use train::Train;

/// Error of pulse generation. The generator is left unchanged.
#[derive(Debug, Clone, Copy, PartialEq)]
#[allow(missing_docs, reason = "the fields say what they are")]
pub enum Error {
    /// The period has more steps, fractions included, than the driver accepts.
    TooFast { asked: f64, most: f64 },
    /// The pulses do not fit beside the change of direction, or beside pulses that waited for one.
    Crowded { pulses: u64 },
    /// The position is NaN or too many steps from zero.
    Position { steps: f64 },
    /// The period has 0 ticks, or too many.
    Period { ticks: u64 },
}

impl Error {
    /// Describes the error.
    pub fn message(&self) -> Message {
        match *self {
            Self::TooFast { asked, most } => {
                Message::new("motion-pulses-too-fast").value("asked", asked, Unit::One).value("max", most, Unit::One)
            }
            Self::Crowded { pulses } => {
                Message::new("motion-pulses-crowded").count("pulses", usize::try_from(pulses).unwrap_or(usize::MAX))
            }
            Self::Position { steps } => Message::new("motion-pulses-position").text("steps", format!("{steps}")),
            Self::Period { ticks } => Message::new("motion-pulses-period").text("ticks", ticks.to_string()),
        }
    }
}

seamwright_message::display_by_message!(Error);
