//! Teaching a path by eye, and tracking it while it is welded. Plain state machines: frames, positions and time come in as
//! arguments.

#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::print_stdout, clippy::print_stderr))]

pub mod actuator;
pub mod beam;
pub mod lead;
pub mod teach;
