//! Weld programs as part programs of real controls.
//!
//! Floor 2. [`part_program`] cuts planned passes into blocks (lines, arcs, cubics in time, splines) of the control's
//! axes or of the torch tip. They stay within a tolerance of the exact path and keep its timing. [`write()`] writes
//! such a [`PartProgram`], or one from elsewhere, in the language of Sinumerik, LinuxCNC, grblHAL or PMAC. [`read()`]
//! reads it back, and [`verify()`] proves that it is the requested one. [`to_program`] converts a part program that was
//! read into a weld program.
//!
//! Posts, readers and the verification share one form: rows of all channels, and steps (`part_program.rs`). The
//! verification plays the text that was read back (`play.rs`) and takes the plan from the motion, never from the
//! writer.

#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::print_stdout, clippy::print_stderr))]

mod control;
mod error;
mod even_speed;
mod feed;
mod guess;
mod part_program;
mod plan;
mod play;
mod points;
mod polynomial;
mod read;
mod verify;
mod write;

pub use control::{Code, Control, Dialect};
pub use error::Error;
pub use feed::Group;
pub use part_program::{Arc, Channel, ChannelKind, Curve, Event, Level, Move, PartProgram, Path, Step, What, Xyz};
pub use plan::{
    BRIEFEST_S, Block, Interpolation, Linearisation, Options, Shape, Speeds, linearise, part_program,
    points_part_program,
};
pub use play::{Segment, play};
pub use points::to_program;
pub use polynomial::{Evenly, POWERS};
pub use read::{LeftOut, ReadError, ReadOptions, Reading, read};
pub use verify::{PassVerification, Planned, Verification, verify};
pub use write::{Feed, WriteOptions, write};
