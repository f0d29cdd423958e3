//! Records of welds: the trace of a weld as a Parquet file, and pulses as a value change dump.
//!
//! Columns of a trace are named with their unit and indexed by time and by path length `s_mm`; every column's unit
//! stands in the file's key-value metadata too (`unit:<column>`).

#![cfg_attr(not(test), warn(clippy::unwrap_used, clippy::expect_used, clippy::print_stdout, clippy::print_stderr))]

mod trace;
mod vcd;

pub use trace::{Error, TraceWriter};
pub use vcd::{VcdAxis, VcdWriter, Wire};
