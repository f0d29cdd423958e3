//! All tests in one program, which is compiled and linked once. Those that count what a process takes are beside it.

mod beam;
mod crawl;
mod lead;
mod over_axes;
