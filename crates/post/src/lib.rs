//! Weld programs as part programs of real controls.
//!
//! Floor 2. A planned pass is cut into straight blocks of the control's own axes (or of the torch tip) that stay within
//! a chord tolerance of the exact path and keep its timing; a dialect writes them down. So far: LinuxCNC.

#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::print_stdout, clippy::print_stderr))]

mod blocks;
mod control;
mod error;
mod feed;
mod guess;
mod linuxcnc;
mod number;
mod part_program;
mod play;
mod points;
mod ramps;
mod read;
mod verify;

pub use blocks::{Block, Linearisation, linearise};
pub use control::{Code, Control, Dialect};
pub use error::Error;
pub use feed::Group;
pub use linuxcnc::{Options, linuxcnc};
pub use part_program::{Arc, Channel, ChannelKind, Event, Level, Move, PartProgram, Path, Step, What};
pub use play::{Segment, play};
pub use points::to_program;
pub use read::{LeftOut, ReadError, ReadOptions, Reading, read};
pub use verify::{PassVerification, Planned, Verification, verify};
