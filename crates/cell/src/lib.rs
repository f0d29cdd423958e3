//! The running machine: an executive on real or simulated devices.
//!
//! The [`executive`] runs programs on devices. [`simulate`] has it do so in virtual time with simulated ones (position loop, velocity
//! loop, inertia, friction, encoder, current limit; source, sensors, inputs), finds the true torch tip from the true axis positions
//! with the machine's own chain, and measures how far it is from the seam and how fast it runs along it.

#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::print_stdout, clippy::print_stderr))]

pub mod campaign;
pub mod devices;
mod disturbance;
mod drives;
mod error;
pub mod executive;
pub mod eyes;
pub mod frames;
pub mod gate;
pub mod realtime;
mod sample;
mod simulate;
mod summary;
pub mod teach;
pub mod tracking;

pub use drives::{check_drives, tune_axis};
pub use error::Error;
pub use sample::Sample;
pub use simulate::{CellDevices, Conditions, Judge, SimulatedCell, simulate};
pub use summary::{AxisSummary, Extremes, Summary};
