//! Camera simulators: frames and stripes as the cell's cameras would see them, with seeded disturbances.

mod distortion;
pub mod gates;
mod plate;
mod random;
pub mod scene;
mod seam_line;
mod simulator;
pub mod stripe;

pub use distortion::Distortion;
pub use plate::plate;
pub use random::Random;
pub use seam_line::{Foot, STATION_MM, SeamLine, Station};
pub use simulator::{Appearance, CameraSimulator};
