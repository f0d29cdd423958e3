//! A period never allocates, at any change of the override.

mod override_profile;

use assert_no_alloc::{AllocDisabler, assert_no_alloc, violation_count};
use override_profile::{Case, Uniform};
use seamwright_motion::feed_override::{Command, FeedOverride};
use std::hint::black_box;

#[global_allocator]
static ALLOCATOR: AllocDisabler = AllocDisabler;

#[test]
fn periods_do_not_allocate() {
    let random = &mut Uniform::new(3);
    let case = Case::random(random);
    let mut feed_override =
        FeedOverride::new(&case.limits(), 1e-3, &case.base).unwrap().with_faster(&case.faster, 1.5).unwrap();
    let commands = [Command::Resume, Command::Override(1.4), Command::Hold, Command::StopAt(0.5 * case.base.length)];
    assert_no_alloc(|| {
        for command in commands.into_iter().cycle().take(40) {
            feed_override.command(command).ok();
            for _ in 0..25 {
                black_box(feed_override.step());
            }
        }
    });
    assert_eq!(violation_count(), 0);
    // The count counts.
    assert_no_alloc(|| black_box(vec![1]));
    assert!(violation_count() > 0);
}
