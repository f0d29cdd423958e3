//! All tests in one program, compiled and linked once. Tests that count allocations are separate programs.

mod axis;
mod drive;
mod random;
mod response;
mod tune;
