//! Records of welds. So far: the trace of a weld as a Parquet file.
//!
//! Columns are named with their unit and indexed by time and by path length `s_mm`; every column's unit stands in the
//! file's key-value metadata too (`unit:<column>`).

#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::print_stdout, clippy::print_stderr))]

mod trace;

pub use trace::{Error, TraceWriter};
