//! All tests in one program, compiled and linked once. Tests that count the allocations of a process are beside it.

mod beam;
mod lead;
mod over_axes;
