//! Beads: how a groove is filled, layer by layer, all along the seam.

mod file;
mod fill;
mod layers;
mod plan;
#[cfg(test)]
mod tests;

pub use file::{Adapt, Beads, Order, Run};
pub use fill::BeadAt;
pub use layers::Layer;
pub use plan::BeadPlan;
