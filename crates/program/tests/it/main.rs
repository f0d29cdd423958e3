//! All tests in one program, which is compiled and linked once.

mod common;
mod positions;
mod procedure_files;
mod windows;
