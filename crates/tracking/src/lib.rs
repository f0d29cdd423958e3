//! Teaching a path by camera, and tracking it during welding. Plain state machines: frames, positions and time are
//! arguments.

#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::print_stdout, clippy::print_stderr))]

pub mod actuator;
pub mod beam;
pub mod lead;
pub mod teach;
