//! All benchmarks in one program, which is compiled and linked once.

#![allow(missing_docs, unreachable_pub, reason = "the benchmark macros make public items")]

mod joint;
mod stripe;

criterion::criterion_main!(joint::group, stripe::group);
