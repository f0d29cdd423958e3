//! Actuators that bring the torch over the seam: cross slides and beam deflection, each within its limits.
//!
//! [`Slide`] is one axis of a cross slide; [`Deflection`] bends a beam; [`OverAxes`] shifts the torch with the
//! machine's own axes. [`SlideAuthority`] splits corrections between slides and the axes that carry them.
//! [`HeadTracking`] combines the tracker and the cross slide of one head. Every cycle it returns the slide's
//! set-points, the torch's feed override and alarms.
//!
//! **Target of a slide.** It is the mean of the highest and the lowest curve of bounded slope. A point follows it
//! within speed and acceleration, and a mean over 40 ms of that point keeps the jerk.

mod deflection;
mod following;
mod head_tracking;
mod limits;
mod over_axes;
mod preview;
mod slide;
mod slide_authority;

pub(crate) use following::Following;

pub use deflection::Deflection;
pub use head_tracking::{Alarm, Cause, HeadTracking, Lag, MAX_LAG_S, Orders};
pub use limits::SlideLimits;
pub use over_axes::{OutOfReach, OverAxes, RESERVE};
pub use slide::Slide;
pub use slide_authority::SlideAuthority;
