//! Camera simulators: frames and stripes as the cell's cameras would see them, with seeded disturbances.

pub mod acceptance;
mod distortion;
mod plate;
pub(crate) mod random;
pub mod scene;
mod simulator;
pub mod stripe;

pub use distortion::Distortion;
pub use plate::plate;
pub use random::Random;
pub use simulator::{Appearance, CameraSimulator};
