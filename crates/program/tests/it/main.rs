//! All tests in one program, which is compiled and linked once.

mod editing;
mod positions;
mod procedure_files;
mod windows;
