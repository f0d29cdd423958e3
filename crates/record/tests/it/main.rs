//! All tests in one program, which is compiled and linked once. A test that measures the
//! memory of its process is beside it.

mod bad_libraries;
mod common;
mod killed;
mod no_alloc;
mod welds;
#[cfg(target_os = "linux")]
mod whole_files;
