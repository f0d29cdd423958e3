//! Weld programs as part programs of real controls.
//!
//! Floor 2. A planned pass is cut into straight blocks of the control's own axes (or of the torch tip) that stay within
//! a chord tolerance of the exact path and keep its timing; a dialect writes them down. So far: LinuxCNC.

#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::print_stdout, clippy::print_stderr))]

mod blocks;
mod error;
mod linuxcnc;
mod number;
mod ramps;

pub use blocks::{Block, Level, Linearisation, linearise};
pub use error::Error;
pub use linuxcnc::{Options, linuxcnc};
