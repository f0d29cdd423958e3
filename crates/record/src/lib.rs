//! Traces of welds as Parquet.
