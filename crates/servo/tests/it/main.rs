//! All tests in one program, which is compiled and linked once.

mod axis;
mod drive;
mod no_alloc;
mod random;
mod response;
mod tune;
