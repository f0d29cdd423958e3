//! Nothing that runs in the control cycle allocates.

mod feed_override;
mod jog;
#[path = "../override_profile/mod.rs"]
mod override_profile;
mod pulses;
mod set_points;

use assert_no_alloc::{AllocDisabler, assert_no_alloc, violation_count};
use std::hint::black_box;

#[global_allocator]
static ALLOCATOR: AllocDisabler = AllocDisabler;

/// Number of allocations of `work`, which are counted thread by thread.
fn allocations(work: impl FnOnce()) -> u32 {
    let before = violation_count();
    assert_no_alloc(work);
    violation_count() - before
}

#[test]
fn allocations_are_counted() {
    assert!(allocations(|| drop(black_box(vec![1]))) > 0);
}
