//! Weld programs as part programs of real controls.
//!
//! [`part_program`] cuts planned passes into blocks (lines, arcs, cubics in time, splines) of the control's axes or of
//! the torch tip. The blocks stay within a tolerance of the exact path and keep its timing. [`write()`] writes such a
//! [`PartProgram`], or one from elsewhere, in the language of Sinumerik, LinuxCNC, grblHAL or PMAC ([`Dialect`]).
//! [`read()`] reads it back, and [`verify()`] proves that it matches the plan. [`to_program`] converts a part program
//! into a weld program. [`robot`] has the same for six-axis arms: RAPID, KRL, FANUC LS, URScript and INFORM.
//!
//! Posts, readers and the verification share one form: rows of all channels, and steps (`part_program.rs`). The
//! verification plays the text that was read back (`play.rs`) and takes the plan from the motion, never from the
//! writer.
//!
//! # Examples
//!
//! Read a part program of Sinumerik:
//!
//! ```
//! use seamwright_machine::{Machine, shipped};
//! use seamwright_post::{Control, Dialect, ReadOptions, What, read};
//!
//! let machine = Machine::read("ebw-7axis", shipped("ebw-7axis").unwrap().text)?;
//! let control = Control::new(&machine, Dialect::Sinumerik)?;
//! let text = include_str!(concat!(env!("CARGO_MANIFEST_DIR"), "/../../examples/ebw-fig1.mpf"));
//! let program = read(&control, "ebw-fig1.mpf", text, &ReadOptions::default())?.program;
//! assert_eq!(program.steps.iter().filter(|step| matches!(step.what, What::Move(_))).count(), 7);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::print_stdout, clippy::print_stderr))]

mod control;
mod dialect_guess;
mod error;
mod even_speed;
mod feed;
mod part_program;
mod plan;
mod play;
mod points;
mod polynomial;
mod read;
pub mod robot;
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
