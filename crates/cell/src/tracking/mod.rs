//! Welding with tracking, in simulation: seams that lie and move otherwise than they were taught, sensors that lead the
//! torches, the slides' drives, and how far each weld truly is from its seam.

mod displacement;
mod error;
pub mod gates;
mod motion;
mod rig;
mod scenario;
mod sensor;
pub mod shows;
mod tally;
mod world;

pub use displacement::{Displacement, Part};
pub use error::Error;
pub use motion::Leg;
pub use rig::{Method, Outcome, run};
pub use scenario::{HeadScene, Scenario, Seam};
pub use sensor::{Fault, SensorModel};
pub use world::{Placement, World};
