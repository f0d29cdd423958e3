//! What brings the torch over the seam: cross slides and beam deflection, each within its limits.
//!
//! [`Slide`] is one axis of a cross slide; [`Deflection`] bends a beam. [`HeadTracking`] has a tracker and a cross
//! slide of one head and gives orders every cycle: where the slide is to be, how fast the torch may go, and what is
//! wrong.

mod deflection;
mod head_tracking;
mod limits;
mod preview;
mod slide;

pub use deflection::{Deflection, DeflectionLimits};
pub use head_tracking::{Alarm, HeadTracking, Orders};
pub use limits::SlideLimits;
pub use slide::Slide;
