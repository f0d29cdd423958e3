//! Simulation of a welding cell: simulated devices, sensors and cameras under the executive of a real cell, hidden true
//! positions, injected faults, and acceptance tests.
//!
//! # Where to start
//!
//! | task | item |
//! |---|---|
//! | simulate a whole weld in virtual time | [`simulate()`] |
//! | run the executive on simulated devices | [`SimulatedCell`], [`devices`] |
//! | track seams that deviate from the plan | [`tracking`] |
//! | paint camera images and laser stripes | [`camera_simulator`] |
//! | teach a seam by a simulated camera | [`teaching`] |
//! | weld distorted grooves layer by layer, with scans between | [`groove`] |
//! | drive axes by a simulated robot control | [`robot`] |
//! | test the response to every fault of every device | [`fault_injection`] |
//!
//! Simulation and real cell are the same executive. Only devices and time differ.
//!
//! # Simulation
//!
//! [`simulate()`] models position loop, velocity loop, inertia, friction, encoder and current limit. It finds the true
//! torch tip from the true axis positions with the machine's own chain. It measures the distance of the tip from the
//! seam and its speed along the seam ([`Summary`]). The same seed gives the same weld, bit for bit.
//!
//! # Units
//!
//! Lengths are in mm, angles in rad, times in s; [`Summary`] has angles in degrees. Path lengths count from the start
//! of a pass, times from the start of the executive.
//!
//! # Examples
//!
//! Plan and simulate a supplied example:
//!
//! ```
//! use seamwright_simulation::{Conditions, Error, simulate};
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
//!
//! The same weld with a fault: the drives fall silent after 12 s. Process and power go off, and the cell is in the mode
//! fault.
//!
//! ```
//! # use seamwright_simulation::{Conditions, Error, simulate};
//! # use seamwright_machine::{Clamped, Machine, Surroundings, shipped};
//! # use seamwright_motion::WeldMotion;
//! # use seamwright_weld::Welding;
//! # let job = include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/ellipse.toml"));
//! # let welding = Welding::read("ellipse.toml", job).unwrap();
//! # let (pass, path) = (&welding.program.value.passes[0], welding.path(0));
//! # let machine = Machine::read("ellipse-xy", shipped("ellipse-xy").unwrap().text).unwrap();
//! # let around = Surroundings::new(&machine, &Clamped::default()).unwrap();
//! # let motion = WeldMotion::plan(&machine, &around, &[(&path, pass)], 30.0).unwrap();
//! use seamwright_simulation::devices::Fault;
//! use seamwright_executive::Mode;
//!
//! let faults: [Fault; 1] = ["drives:silent@12".parse().unwrap()];
//! let conditions = Conditions { seed: 1, faults: &faults, ..Conditions::default() };
//! let mut mode = Mode::Off;
//! let observer = |sample: &seamwright_simulation::Sample| {
//!     mode = sample.mode;
//!     Ok::<(), Error>(())
//! };
//! simulate(&machine, &[(&path, pass)], &motion, conditions, observer).unwrap();
//! assert_eq!(mode, Mode::Fault);
//! ```

#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::print_stdout, clippy::print_stderr))]

pub mod acceptance;
pub mod camera_simulator;
mod conditions;
pub mod devices;
mod disturbance;
mod drives;
mod error;
pub mod fault_injection;
pub mod groove;
pub mod robot;
mod sample;
mod simulate;
mod summary;
pub mod teaching;
pub mod tracking;

pub use conditions::Conditions;
pub use drives::{check_drives, tune_axis};
pub use error::Error;
pub use sample::Sample;
pub use simulate::{CellDevices, Judge, SimulatedCell, WeldOperator, simulate};
pub use summary::{AxisSummary, Extremes, Summary};
