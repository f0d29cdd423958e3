//! All benchmarks in one program, which is compiled and linked once.

#![allow(missing_docs, unreachable_pub, reason = "the benchmark macros make public items")]

mod feed_override;
mod fine;
mod jog;
mod motion;
mod pulses;
mod redundancy;
mod speed_profile;

criterion::criterion_main!(
    feed_override::group,
    fine::group,
    jog::group,
    motion::group,
    pulses::group,
    redundancy::group,
    speed_profile::group
);
