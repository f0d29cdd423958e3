//! All tests in one program, which is compiled and linked once.

mod beam;
mod beam_no_alloc;
mod lead;
mod lead_no_alloc;
mod over_axes;
