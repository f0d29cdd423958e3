//! Cost of planning motion and of playing it.

#![allow(missing_docs, reason = "the benchmark macros make public items")]

mod feed_override;
mod fine;
mod jog;
mod plan;
mod pulses;
mod redundancy;
mod speed_profile;

use criterion::{criterion_group, criterion_main};

criterion_group!(
    group,
    feed_override::benches,
    feed_override::runs,
    fine::benches,
    jog::benches,
    plan::benches,
    pulses::benches,
    redundancy::benches,
    speed_profile::profiles,
    speed_profile::finely
);
criterion_main!(group);
