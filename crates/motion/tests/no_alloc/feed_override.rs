//! A period never allocates, at any change of the override.

use crate::allocations;
use crate::override_profile::{Case, Uniform};
use seamwright_motion::feed_override::{Command, FeedOverride};
use std::hint::black_box;

#[test]
fn periods_do_not_allocate() {
    let random = &mut Uniform::new(3);
    let case = Case::random(random);
    let mut feed_override =
        FeedOverride::new(&case.limits(), 1e-3, &case.base).unwrap().with_faster(&case.faster, 1.5).unwrap();
    let commands = [Command::Resume, Command::Override(1.4), Command::Hold, Command::StopAt(0.5 * case.base.length)];
    let allocated = allocations(|| {
        for command in commands.into_iter().cycle().take(40) {
            feed_override.command(command).ok();
            for _ in 0..25 {
                black_box(feed_override.step());
            }
        }
    });
    assert_eq!(allocated, 0);
}
