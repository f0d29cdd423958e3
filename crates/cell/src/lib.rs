//! The process of the cycle: executive and devices behind a socket, apart from the panel, its planner and its library.
//!
//! # Where to start
//!
//! | task | item |
//! |---|---|
//! | run a cell until its end | [`run()`], [`Listeners`] |
//! | start a cell as a process of its own, or in threads of this one, and talk to it | [`CellClient`] |
//! | stop a cell, whatever else happens | [`StopLine`] |
//! | see what crosses between the two sides | [`protocol`] |
//! | read random bytes as these messages, in tests | [`fuzzing`] |
//!
//! # Processes
//!
//! `seamwright cell` runs the executive with its devices. The panel (`seamwright serve`) starts it and talks to it over
//! a Unix socket. Neither side waits for the other: the cycle passes fixed-size queues to a thread that owns the socket,
//! and that thread drops cycles which the panel does not read. If the panel dies or freezes, jogging stops and a weld is
//! held or goes on, as the machine file says ([`seamwright_machine::PanelLost`]). If the cell dies, the panel reports it.
//!
//! # Threads of a cell
//!
//! | thread | work |
//! |---|---|
//! | cycle | the executive, in real time: no allocation, lock or system call but the wait |
//! | link | the socket of the panel: commands in, cycles and notes out; prepared programs to the cycle |
//! | stop | the socket of STOP, which depends on nothing else |
//! | record | trace, log and journal of the weld that runs |
//! | preparation | reads and checks a program, connects its devices; one at a time |
//!
//! # Units
//!
//! Those of the executive: mm, rad, s.

#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::print_stdout, clippy::print_stderr))]

mod client;
mod cycle;
mod devices;
mod frame;
pub mod fuzzing;
mod link;
mod loader;
mod machine_source;
mod prepared_task;
mod program;
pub mod protocol;
mod recorder;
mod resting;
mod run;
mod safe_outputs;
mod sockets;
mod stop;
mod task;
mod tracking;

pub use client::{CellClient, CellLost};
pub use machine_source::MachineSource;
pub use prepared_task::fingerprint;
pub use program::{CrossingPlan, Program, decode_plan, encode_plan, try_program};
pub use run::{CellStart, run};
pub use sockets::Listeners;
pub use stop::StopLine;
