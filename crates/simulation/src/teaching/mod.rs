//! Teaching by camera on a simulated machine, and the true distance of the line found from the seam.

mod rig;
mod truth;

pub use rig::SimulatedRig;
pub use truth::{Truth, truth};
