//! The executive of a welding cell: modes, process, interlocks, alarms, and the cycle that drives real or simulated
//! devices.
//!
//! # Where to start
//!
//! | task | item |
//! |---|---|
//! | understand modes, process, interlocks, alarms, hold and resume | [`Executive`], [`Mode`], [`Alarm`] |
//! | connect a device: drives, process source, inputs, sensors | [`devices`] |
//! | run the cycle in real time, and connect other threads to it | [`realtime`] |
//! | correct passes during welding | [`tracking`] |
//!
//! Simulation and real cell are the same executive. Only devices and time differ. On a real cell a
//! [`devices::DeviceSet`] has real devices, and [`realtime::live()`] connects the executive with the panel. The
//! simulated devices are those of `seamwright-simulation`.
//!
//! - [`Executive`] runs in one thread, with one cycle per servo period: [`Executive::serve`].
//! - [`Mode`] and [`Event`] form one table of transitions: [`Mode::after`].
//! - [`Devices::exchange`] sends orders to the devices and gets reports. It is the only place that waits.
//! - [`Port`] is the outside: commands come in, and every cycle is shown.
//! - A [`Guide`] may correct the planned set-point of a pass before it becomes an order: seam tracking enters here.
//! - [`Work`], built before the weld, holds everything that allocates.
//!
//! # A cycle
//!
//! 1. Orders go out, reports come in.
//! 2. The reports are compared with conditions and alarms.
//! 3. Commands are taken, or refused with a reason ([`Missing`]).
//! 4. The cycle is shown to the outside ([`Cycle`]).
//!
//! # Guarantees
//!
//! - Every action needs a command: power, motion and process each come from one, the process only if it was armed for
//!   that start.
//! - The process is off within one cycle of its cause.
//! - A cycle neither allocates nor locks.
//!
//! # Structure
//!
//! One thread runs nested loops (a program, a stretch of it, cycles) instead of one state machine of everything. The
//! mode, one table, decides the next step of the loops. `simulate` runs the same code with simulated devices, an
//! operator who requests one weld, and a judge who knows the true positions (`Reports::truth`).
//!
//! The state is grouped by concern: devices, clock, alarms, supervision, process, activity, requests, guide. Above it are
//! the steps of a cycle (`cycle.rs`), then the activities that run cycles (`homing.rs`, `jogging.rs`, `program.rs`), then
//! the choice among them (`dispatch.rs`).
//!
//! # Units
//!
//! Lengths are in mm, angles in rad, times in s. Path lengths count from the start of a pass, times from the start of
//! the executive.

#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::print_stdout, clippy::print_stderr))]

pub mod devices;
mod error;
mod executive;
pub mod realtime;
pub mod tracking;

pub use error::Error;
pub use executive::*;
