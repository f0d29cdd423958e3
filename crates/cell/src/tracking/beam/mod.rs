//! Beam mode in simulation (EBW-2004): the beam looks ahead in short interruptions of the weld, machine axes and
//! deflection correct, and later passes replay the deviations found.

mod camera;
mod head;
mod rig;
mod scene;
mod shows;
mod tally;

pub use camera::{BeamCamera, Glance, Offsets, Pixels, Shown};
pub(crate) use camera::{Hidden, Noise};
pub use head::BeamHead;
pub(crate) use head::{END_MM, LOOK_S, STEP_MM, UnderWay};
pub use rig::{BeamOutcome, weld};
pub use scene::{BeamScene, PLACED_WRONG, placed_wrong};
pub use shows::{BeamJob, MOVED_MM, beam_rows, moved_since};
pub(crate) use tally::BeamTally;
