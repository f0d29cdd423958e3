//! All tests in one program, which is compiled and linked once. Those that count the resources of a process are beside
//! it.

mod bad_libraries;
mod common;
mod killed;
mod welds;
#[cfg(target_os = "linux")]
mod whole_files;
