//! Weld programs as part programs of real controls.
//!
//! Floor 2. [`part_program`] cuts planned passes into blocks (lines, arcs, cubics in time, splines) of the control's own
//! axes or of the torch tip that stay within a tolerance of the exact path and keep its timing. [`write()`] puts such a
//! [`PartProgram`], or one from elsewhere, down in the language of Sinumerik, LinuxCNC, grblHAL or PMAC.

#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::print_stdout, clippy::print_stderr))]

mod control;
mod error;
mod feed;
mod part_program;
mod plan;
mod write;

pub use control::{Code, Control, Dialect};
pub use error::Error;
pub use feed::Group;
pub use part_program::{Arc, Channel, ChannelKind, Event, Level, Move, PartProgram, Path, Step, What};
pub use plan::{Block, Interpolation, Linearisation, Options, Shape, Speeds, linearise, part_program};
pub use write::{Feed, WriteOptions, write};
