//! All benchmarks in one program, which is compiled and linked once.

#![allow(missing_docs, unreachable_pub, reason = "the benchmark macros make public items")]

mod read;
mod write;

criterion::criterion_main!(read::group, write::group);
