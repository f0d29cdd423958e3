//! The trace of a weld: one row a period.
//!
//! While the weld runs, [`TraceWriter`] appends rows to a raw file: a header with columns and units, then blocks with a
//! checksum, on the disk at least every half second. When the weld ends, each raw file is converted to a Parquet file,
//! written whole, and removed. After a crash [`recover()`] reads the raw file up to its last whole block. [`Trace`]
//! reads the Parquet files.
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
mod outline;
mod parquet_file;
mod raw;
mod read;
pub(crate) mod recover;
mod writer;

pub use column::{Column, Kind};
pub use outline::Outline;
pub use read::Trace;
pub use recover::{RecoveredPart, recover};
pub use writer::{Part, TraceWriter};
