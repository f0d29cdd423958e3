//! Camera simulators: frames and stripes as the cell's cameras would see them, with seeded disturbances.

mod distortion;
mod eye;
pub mod gates;
mod plate;
mod random;
pub mod scene;
mod seam_line;
pub mod stripe;

pub use distortion::Distortion;
pub use eye::{Appearance, Eye};
pub use plate::plate;
pub use random::Random;
pub use seam_line::{Foot, STATION_MM, SeamLine, Station};
