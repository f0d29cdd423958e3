//! A hold soon after the start of a transfer move.

use crate::planning::shipped_machine;
use seamwright_motion::feed_override::{Command, FeedOverride, channel_limits};
use seamwright_motion::transfer::Leg;

const PERIOD: f64 = 1e-3;

/// Periods after the start in which a hold is commanded, and maximum number of periods until rest. It took up to 2,900
/// when courses failed because of changes within a period, or were replaced by slower ones that end nearer to rest.
const FIRST: i32 = 80;
const MAX_PERIODS_TO_REST: usize = 450;

/// A hold in any of the first periods of a move of any length: the speed is still low, and soon 0.
#[test]
fn a_hold_just_after_the_start_is_no_slow_stop() {
    let mut random = seamwright_testkit::Random::new(11);
    let mut slow = Vec::new();
    for name in ["saddle-4axis", "torch-5axis", "ebw-7axis"] {
        let machine = shipped_machine(name);
        let limits = channel_limits(&machine);
        for way in 0..12 {
            let from = machine.home();
            let mut to = from;
            let size = random.decades(1e-3, 1.0);
            for (i, axis) in machine.axes.iter().enumerate() {
                let (low, high) = axis.range.unwrap_or((-3.0, 3.0));
                to[i] += (random.within(low, high) - from[i]) * size;
            }
            let leg = Leg::new(&machine, &from, &to);
            for periods in 1..=FIRST {
                let mut feed_override = FeedOverride::new(&limits, PERIOD, &leg).unwrap();
                feed_override.command(Command::Resume).unwrap();
                (0..periods).for_each(|_| {
                    feed_override.step();
                });
                feed_override.command(Command::Hold).unwrap();
                let took = (0..20_000).take_while(|_| {
                    let rests = feed_override.at_rest();
                    feed_override.step();
                    !rests
                });
                let took = took.count();
                if took > MAX_PERIODS_TO_REST {
                    slow.push(format!("{name}, way {way}: held after {periods} periods, at rest {took} later"));
                }
            }
        }
    }
    assert!(slow.is_empty(), "{} are slow: {:?}", slow.len(), &slow[..slow.len().min(12)]);
}
