//! The running machine: an executive on real or simulated devices.
//!
//! - [`executive`] runs programs on devices: modes, process, interlocks, alarms, hold and resume.
//! - [`devices`] are drives, process source and inputs: simulated ones, LinuxCNC's HAL, step pulses, Modbus.
//! - [`simulate()`] runs a weld in virtual time on simulated devices: position loop, velocity loop, inertia, friction,
//!   encoder and current limit. It finds the true torch tip from the true axis positions with the machine's own chain,
//!   and measures its distance from the seam and its speed along the seam ([`Summary`]).
//! - [`tracking`] corrects passes during welding, and [`teach`] teaches a seam by camera.
//!
//! ```
//! use seamwright_cell::{Conditions, Error, simulate};
//! use seamwright_machine::{Clamped, Machine, Surroundings, shipped};
//! use seamwright_motion::WeldMotion;
//! use seamwright_weld::Welding;
//!
//! let job = include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/ellipse.toml"));
//! let welding = Welding::read("ellipse.toml", job).unwrap();
//! let (pass, path) = (&welding.program.value.passes[0], welding.path(0));
//! let machine = Machine::read("ellipse-xy", shipped("ellipse-xy").unwrap().text).unwrap();
//! let around = Surroundings::new(&machine, &Clamped::default()).unwrap();
//! let motion = WeldMotion::plan(&machine, &around, &[(&path, pass)], 30.0).unwrap();
//! let conditions = Conditions { seed: 1, ..Conditions::default() };
//! let passes = simulate(&machine, &[(&path, pass)], &motion, conditions, |_| Ok::<(), Error>(())).unwrap();
//! assert!(passes[0].path_error_mm.max < 0.05);
//! ```

#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::print_stdout, clippy::print_stderr))]

pub mod camera_simulator;
pub mod devices;
mod disturbance;
mod drives;
mod error;
pub mod executive;
pub mod fault_injection;
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
