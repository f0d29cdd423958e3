//! Beam mode in simulation (EBW-2004): the beam looks ahead in short interruptions of the weld, machine axes and deflection
//! correct, and later passes replay what was found.

mod eye;
mod rig;
mod scene;
mod shows;
mod tally;

pub use eye::{BeamEye, Glance, Offsets, Pixels, Shown};
pub use rig::{BeamHead, BeamOutcome, weld};
pub use scene::{BeamScene, PLACED_WRONG, placed_wrong};
pub use shows::{BeamJob, MOVED_MM, beam_rows, moved_since};
