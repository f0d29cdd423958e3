//! Beam mode in simulation (EBW-2004): the beam looks ahead in short interruptions of the weld, machine axes and
//! deflection correct, and later passes replay the deviations found.

mod acceptance;
pub(super) mod camera;
pub(super) mod picture_queue;
pub(super) mod recent_positions;
mod scene;
mod weld;

pub use acceptance::{BeamJob, MOVED_MM, beam_rows, moved_since};
pub use camera::{BeamCamera, Glance, Offsets, Pixels, Shown};
pub use scene::{BeamScene, PLACED_WRONG, placed_wrong};
pub use weld::{BeamOutcome, weld};
