//! Simulated eyes: frames and stripes as the cell's cameras would see them, with seeded disturbances.

pub mod stripe;
