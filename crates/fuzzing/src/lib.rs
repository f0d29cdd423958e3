//! Every reader of data from outside, as a function of bytes: for the fuzzer in `fuzz/`, and for tests of the inputs
//! that it kept.
//!
//! | task | item |
//! |---|---|
//! | all inputs of the program | [`TARGETS`] |
//! | read an input within its memory limit | [`Target::run`] |
//! | first inputs, words for the fuzzer's dictionary | [`Target::seeds`], [`Target::words`] |
//! | change an input at random | [`mutate`], [`mutate_text`] |
//! | inputs that were kept | [`kept_inputs`] |
//!
//! # Guarantees
//! A reader refuses an invalid input with an error: it neither panics nor allocates more than its limit. A target calls
//! the functions that the program itself calls with such bytes. Where bytes have checksums, the target corrects these
//! first, so that changed inputs pass them.
//!
//! # Limitations
//! The limit of memory holds for a whole process, so run one target at a time.
//!
//! # Adding a target
//! 1. Its reader, seeds and words: a `Target` in one of the modules, and its row in [`TARGETS`].
//! 2. `fuzz/src/bin/NAME.rs`, one line.

mod archives;
mod cell;
mod corpora;
mod mutation;
mod panel;
mod part_programs;
mod pictures;
mod robots;
mod scratch;
mod tables;
mod target;
mod texts;
mod words;

pub use archives::{ARCHIVE, LIBRARY, RAW_TRACE, TRACE};
pub use cell::{CELL_MOTION, CELL_REPORT, CELL_REQUEST};
pub use corpora::{KeptInput, kept_inputs};
pub use mutation::{Random, mutate, mutate_text};
pub use panel::{REQUEST_BODY, SOCKET_MESSAGE};
pub use part_programs::{GRBLHAL, LINUXCNC, PMAC, SINUMERIK};
pub use pictures::{FRAME_LIST, FRAME_STREAM, JPEG, PICTURE_SEARCH, PNG, PNM};
pub use robots::{EGM, RSI, RTDE};
pub use tables::{POINT_TABLE, STL, STRIPE_PROFILE};
pub use target::Target;
pub use texts::{DISTORTION, JOB, MACHINE, PROCEDURE, PROGRAM, URDF};

/// All inputs of the program, each with its reader.
pub const TARGETS: &[&Target] = &[
    // Files of users.
    &JOB,
    &MACHINE,
    &URDF,
    &PROGRAM,
    &PROCEDURE,
    &DISTORTION,
    &POINT_TABLE,
    &STL,
    // Part programs of other controls.
    &SINUMERIK,
    &LINUXCNC,
    &GRBLHAL,
    &PMAC,
    // Frames and profiles.
    &PNG,
    &JPEG,
    &PNM,
    &FRAME_STREAM,
    &FRAME_LIST,
    &STRIPE_PROFILE,
    &PICTURE_SEARCH,
    // Data folder.
    &ARCHIVE,
    &LIBRARY,
    &TRACE,
    &RAW_TRACE,
    // The panel.
    &SOCKET_MESSAGE,
    &REQUEST_BODY,
    // Robot controls.
    &RTDE,
    &EGM,
    &RSI,
    // Between the processes of a cell.
    &CELL_REQUEST,
    &CELL_REPORT,
    &CELL_MOTION,
];
