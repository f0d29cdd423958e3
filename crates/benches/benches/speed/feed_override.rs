//! Cost of a period: at a steady override (aim: a few microseconds) and while it changes (aim: tens); the same of a run
//! on a real weld.

#[path = "../../../motion/tests/it/override_profile/mod.rs"]
mod override_profile;

use crate::measure::time;
use override_profile::Case;
use override_profile::orders::sequence;
use seamwright_machine::{Machine, shipped};
use seamwright_motion::PassMotion;
use seamwright_motion::feed_override::{Command, FeedOverride, Order, Run, RunPhase, channel_limits};
use seamwright_program::AtHold;
use seamwright_testkit::Random;
use seamwright_weld::Welding;
use std::hint::black_box;

pub(crate) fn benches() {
    let case = Case::random(&mut Random::new(4));
    let fresh = || {
        let mut feed_override = FeedOverride::new(&case.limits(), 1e-3, &case.base).unwrap();
        feed_override.command(Command::Resume).unwrap();
        feed_override
    };
    let mut feed_override = fresh();
    time("period, feed_override steady", || {
        if feed_override.at_end() {
            feed_override = fresh();
        }
        black_box(feed_override.step())
    });
    let mut feed_override = fresh();
    let mut periods = 0u32;
    time("period, commands every 20", || {
        if feed_override.at_end() {
            feed_override = fresh();
        }
        periods += 1;
        if periods.is_multiple_of(20) {
            feed_override.command(if periods.is_multiple_of(40) { Command::Resume } else { Command::Hold }).unwrap();
        }
        black_box(feed_override.step())
    });
}

/// One step of a run along the example saddle, on its machine with four axes.
pub(crate) fn runs() {
    let welding = Welding::read("saddle", include_str!("../../../../examples/saddle.toml")).unwrap();
    let program = &welding.program.value;
    let machine = Machine::read("m", shipped(&program.machine).unwrap().text).unwrap();
    let motion = PassMotion::plan(&machine, &welding.path(0), &program.passes[0], 1).unwrap();
    let (profile, limits) = (motion.timed(&machine), channel_limits(&machine));
    let fresh = || {
        let mut run = Run::new(FeedOverride::new(&limits, 1e-3, &profile).unwrap(), sequence(AtHold::Crater), &[]);
        run.order(Order::Resume).unwrap();
        run
    };
    let mut run = fresh();
    time("step of a run, welding", || {
        if run.now().phase == RunPhase::Ended {
            run = fresh();
        }
        black_box(run.step().unwrap())
    });
    let mut run = fresh();
    let mut periods = 0usize;
    time("step of a run, orders every 20", || {
        if run.now().phase == RunPhase::Ended {
            run = fresh();
        }
        periods += 1;
        if periods.is_multiple_of(20) {
            let orders = [Order::Override(0.4), Order::Resume, Order::Override(1.0), Order::Hold, Order::Resume];
            run.order(orders[periods / 20 % orders.len()]).unwrap();
        }
        black_box(run.step().unwrap())
    });
}
