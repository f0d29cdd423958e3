//! All tests in one program, which is compiled and linked once.

mod bounds_in_docs;
mod errors;
mod nesting;
