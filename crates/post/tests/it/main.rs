//! All tests in one program, which is compiled and linked once.

mod common;
mod corners;
mod linuxcnc;
mod polynomials;
mod read;
mod read_arcs;
mod read_errors;
mod read_random;
mod reading;
mod robot_streams;
mod robots;
mod round_trip;
#[path = "common/text.rs"]
mod text;
mod write_dialects;
mod write_examples;
