//! All tests in one program, compiled and linked once. Tests that count allocations are separate programs.

mod grid;
mod joint;
