//! Manual motion: continuous and incremental jogging of axes and of the torch tip, and point-to-point motion.
//!
//! [`PointToPoint`] takes all axes from any state to rest at a target within speed, acceleration, jerk and range;
//! [`Jog`] turns commands into set-points, one a period, behind a safety shield. Every set-point has a fastest stop,
//! and is only accepted if this stop stays within all limits and clear of everything. Else the stop of the previous
//! set-point, already verified, is followed. So a verified stop always exists, for every command, lost signal or delay.
//!
//! The clearance of the stop is proven from distances: a distance less the maximum travel until rest, from the levers
//! of the axes, is a lower bound. So the loss of the enabling switch's signal, or of a cycle, leaves a verified stop.

mod clearance;
mod error;
mod jogging;
mod point_to_point;
mod ramp;
mod state;
mod stop;
mod tip;

pub use clearance::MotionClearance;
pub use error::{AxisName, AxisValue, JogError, JogSetting};
pub use jogging::{Command, Halt, Jog, JogPoint, JogSettings, Signals};
pub use point_to_point::PointToPoint;
pub use state::State;
pub use tip::TipFrame;
