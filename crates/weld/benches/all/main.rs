//! All benchmarks in one program, which is compiled and linked once.

#![allow(missing_docs, unreachable_pub, reason = "the benchmark macros make public items")]

mod beads;
mod seam_point;

criterion::criterion_main!(beads::group, seam_point::group);
