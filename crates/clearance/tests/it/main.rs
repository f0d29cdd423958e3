//! All tests in one program, which is compiled and linked once.

mod along;
mod common;
mod degenerate;
mod distance;
mod files;
mod zones;
