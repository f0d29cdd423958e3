//! Moving by hand: continuous and step-wise jogging, of axes and of the torch tip, and point-to-point motion.
//!
//! [`PointToPoint`] takes all axes from any state to rest at a target within speed, acceleration, jerk and range;
//! [`Jog`] turns commands into set-points, one a period, behind a shield: with every set-point goes the fastest stop
//! from it, and a set-point is only taken if this stop stays within all limits and clear of everything. Else the stop
//! of the set-point before is followed, which was verified when that one was taken. So there is always a verified way
//! to rest, whatever is commanded, lost, or too late.

mod clearance;
mod error;
mod jogging;
mod limits;
mod point_to_point;
mod ramp;
mod state;
mod stop;
mod tip;

pub use clearance::MotionClearance;
pub use error::{AxisName, JogError};
pub use jogging::{Command, Halt, Jog, JogPoint, JogSettings, Signals};
pub use limits::AxisLimits;
pub use point_to_point::PointToPoint;
pub use state::State;
pub use tip::TipFrame;
