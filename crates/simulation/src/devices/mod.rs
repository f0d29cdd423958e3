//! Simulated devices of a cell, and the injection of faults into any device.
//!
//! [`Faulty`] wraps a device, real or simulated, and injects the faults of a plan.

pub(crate) mod fault;
pub(crate) mod simulated;

pub use fault::{Device, Fault, FaultKind, Faulty, InvalidFault, When};
pub use simulated::{SimulatedDrives, SimulatedInputs, SimulatedSource, simulated_devices};
