//! Cost of one step of a jog.
#![allow(missing_docs, reason = "the benchmark macros make public items")]
fn main() {}
