//! The running machine: an executive on real or simulated devices.
//!
//! The [`executive`] runs programs on devices. [`simulate`] runs them in virtual time on simulated devices: position
//! loop, velocity loop, inertia, friction, encoder, current limit; source, sensors, inputs. It finds the true torch tip
//! from the true axis positions with the machine's own kinematic chain. It measures the tip's distance from the seam
//! and its speed along the seam.

#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::print_stdout, clippy::print_stderr))]

pub mod campaign;
pub mod devices;
mod disturbance;
mod drives;
mod error;
pub mod executive;
pub mod eyes;
mod foreign;
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
