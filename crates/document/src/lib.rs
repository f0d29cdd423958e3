//! TOML documents whose errors have an address.
//!
//! Every Seamwright file (job, machine, program) is TOML with `schema = 1` and keys that carry their unit. [`Document`]
//! reads one into a type. It converts every fault into a [`DocumentError`] that names file, line, key, the value found
//! and the values allowed. Checks that need more than one key are made by the caller, with [`Document::error_at`] for
//! an error at a key's address.
//!
//! The number types ([`Positive`], [`NonNegative`], [`Finite`]) refuse bad values while reading, so that the address is
//! exact, and describe themselves in the JSON Schema. Then every number is checked against the bound of its key's unit
//! ([`BOUNDS`]): a new key of a format is bounded without further code.
//!
//! [`TomlText`] reads a text of any format for a form, and changes single entries of it; everything else of the text stays
//! byte by byte.
//!
//! # Examples
//!
//! Read a file, and report an invalid value at its key:
//!
//! ```
//! use seamwright_document::{Document, Positive};
//!
//! #[derive(Debug, serde::Deserialize)]
//! struct Job {
//!     weld: Weld,
//! }
//!
//! #[derive(Debug, serde::Deserialize)]
//! struct Weld {
//!     speed_mm_s: Positive,
//! }
//!
//! let job = Document::<Job>::read("job.toml", "[weld]\nspeed_mm_s = 8.5\n")?;
//! assert!((job.value.weld.speed_mm_s.get() - 8.5).abs() < 1e-12);
//! let error = Document::<Job>::read("job.toml", "[weld]\nspeed_mm_s = -3\n").unwrap_err();
//! assert_eq!((error.line, error.key.as_str(), error.value.as_str()), (2, "weld.speed_mm_s", "-3"));
//! # Ok::<(), seamwright_document::DocumentError>(())
//! ```

#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::print_stdout, clippy::print_stderr))]

mod address;
mod bounds;
mod change;
mod deserializer;
mod document;
mod entries;
mod error;
mod key_path;
mod nesting;
mod number;
mod vector;
mod write;

pub use bounds::{BOUNDS, Bound};
pub use change::Change;
pub use document::{Document, closest, fault_in_serde, in_serde, serde_text};
pub use entries::{Entry, EntryValue, TableEntries, TomlText};
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

pub use key_path::{Step, path_of, steps};
pub use nesting::check_nesting;
pub use number::{Finite, NonNegative, Positive, SchemaVersion};
pub use vector::{Direction, Point, Transform};
pub use write::{to_table, to_toml};
