//! All tests in one program, which is compiled and linked once. Those that need a process of their own are beside it.

mod bad_libraries;
mod common;
mod killed;
mod welds;
