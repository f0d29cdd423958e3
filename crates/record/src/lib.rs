//! Records of welds. So far: the trace of a weld as a Parquet file.
//!
//! Columns are named with their unit and indexed by time and by path length `s_mm`; every column's unit stands in the
//! file's key-value metadata too (`unit:<column>`).

mod trace;

pub use trace::{Error, TraceWriter};
