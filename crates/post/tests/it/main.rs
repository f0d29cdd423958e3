//! All tests in one program, which is compiled and linked once. Those that need a process of their own are beside it.

mod common;
mod corners;
mod linuxcnc;
mod polynomials;
mod read;
mod read_arcs;
mod read_errors;
mod read_mutations;
mod read_random;
mod reading;
mod round_trip;
#[path = "common/text.rs"]
mod text;
mod write_dialects;
mod write_examples;
