//! Beam mode in simulation (EBW-2004): the beam looks ahead in short interruptions of the weld, machine axes and
//! deflection correct, and later passes replay the deviations found.

mod eye;
mod head;
mod rig;
mod scene;
mod shows;
mod tally;

pub use eye::{BeamEye, Glance, Offsets, Pixels, Shown};
pub(crate) use eye::{Hidden, Noise};
pub use head::BeamHead;
pub(crate) use head::{END_MM, LOOK_S, STEP_MM, UnderWay};
pub use rig::{BeamOutcome, weld};
pub use scene::{BeamScene, PLACED_WRONG, placed_wrong};
pub use shows::{BeamJob, MOVED_MM, beam_rows, moved_since};
pub(crate) use tally::BeamTally;
