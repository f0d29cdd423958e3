//! All tests in one program, which is compiled and linked once. Those that count what a process takes are beside it.

mod axis;
mod drive;
mod random;
mod response;
mod tune;
