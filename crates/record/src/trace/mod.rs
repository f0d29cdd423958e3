//! The trace of a weld: one row a period.
//!
//! While the weld runs, [`TraceWriter`] appends rows to a raw file: a header with columns and units, then blocks with a
//! checksum, on the disk at least every half second. When the weld has ended, or after a crash, [`recover()`] converts
//! each raw file up to its last whole block to a Parquet file, written whole, and removes it. [`Trace`] reads the Parquet
//! files.
//!
//! # The raw file
//! All numbers are little-endian.
//!
//! | bytes | what |
//! |---|---|
//! | 8 | `SEAMTRC1` |
//! | 4 | length of the header |
//! | .. | the header, JSON: `columns` of `name`, `unit`, `kind`; `about`, pairs of texts |
//! | 4 | CRC-32 of the header |
//!
//! Then blocks: `BLCK`, count of rows (4), number of the first row (8), the rows, CRC-32 (4) of everything in the block
//! before it. A row has its values one after the other: `f64` 8 bytes, `f32` and `u32` 4, `u8` 1.

mod column;
#[cfg(feature = "library")]
mod outline;
#[cfg(feature = "library")]
mod parquet_file;
mod raw;
#[cfg(feature = "library")]
mod read;
#[cfg(feature = "library")]
pub(crate) mod recover;
mod writer;

pub use column::{Column, Kind};
#[cfg(feature = "library")]
pub use outline::Outline;
#[cfg(feature = "library")]
pub use read::Trace;
#[cfg(feature = "library")]
pub use recover::{RecoveredPart, recover};
pub use writer::TraceWriter;
