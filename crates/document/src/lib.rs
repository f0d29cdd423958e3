//! TOML documents whose errors have an address.
//!
//! Every Seamwright file (job, machine, program) is TOML with `schema = 1` and keys that carry their unit. This room
//! reads one into a type and turns whatever is wrong into one [`DocumentError`] that names file, line, key, the
//! value found and the values allowed. Checks that need more than one key are made by the caller, who asks
//! [`Document::error_at`] for an error at a key's address.
//!
//! The number types ([`Positive`], [`NonNegative`], [`Finite`]) refuse bad values while reading, so that the address
//! is exact, and describe themselves in the JSON Schema. Then every number is held against the bound of the unit that
//! its key ends in ([`BOUNDS`]): a key that is added to a format is bounded without a further line.

#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::print_stdout, clippy::print_stderr))]

mod address;
mod bounds;
mod document;
mod error;
mod number;
mod vector;

pub use bounds::{BOUNDS, Bound};
pub use document::{Document, closest};
pub use error::DocumentError;
/// Names of columns in tables and traces, which no axis and no process value may have.
pub const RESERVED_COLUMNS: [&str; 11] = [
    "t_s",
    "pass",
    "s_mm",
    "speed_mm_s",
    "arc",
    "error",
    "attitude_error_deg",
    "path_error_mm",
    "speed_set_mm_s",
    "tip_s_mm",
    "tip_speed_mm_s",
];

pub use number::{Finite, NonNegative, Positive, SchemaVersion};
pub use vector::{Direction, Point, Transform};
