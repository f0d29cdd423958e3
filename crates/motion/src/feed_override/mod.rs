//! Time control of a running motion: override, hold, resume, reverse and stops at path lengths, always on the path and
//! within limits.
//!
//! [`FeedOverride`] plays a motion in time ([`Timed`]) with a feed override that changes within every axis' limits. [`Run`]
//! adds the process: arc or beam off before rest, crater fill, restart with overlap.
//!
//! **Method.** The planned profile `L(theta)` is played at the rate `dtheta/dt`, so set-points stay on the path. A
//! steady rate up to 1 is always within limits. Each period takes the fastest change of the rate whose return to a
//! steady rate has been verified before.

mod control;
mod course;
mod error;
mod hold_and_restart;
mod limit_check;
mod run_phase;
mod timed_motion;
mod timed_pass;

pub use crate::tip_channels::{CHANNELS, ChannelLimits, channel_limits};
pub use control::{FeedOverride, Played};
pub use error::FeedOverrideError;
pub use hold_and_restart::Run;
pub use run_phase::{Instant, Order, RunPhase};
pub use timed_motion::{Rates, Timed, Tip};
pub use timed_pass::PassTimed;

/// Command to the feed override, effective from the next period.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Command {
    /// Fraction of the planned speed, 0 to 1, or up to 1.5 with a profile for a higher speed.
    Override(f64),
    /// Stop on the path as soon as possible.
    Hold,
    /// Go forward.
    Resume,
    /// Go back along the path.
    Reverse,
    /// Go to path length s (mm), in either direction, and stop there exactly; go on if it is too near.
    StopAt(f64),
}
