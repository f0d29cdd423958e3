//! The judgement of a round trip.

use seamwright_machine::check::RoundTrip;
use seamwright_machine::{Machine, Solution, shipped};

/// A solution with any part beyond its limit fails.
#[test]
fn what_does_not_come_back_fails() {
    let machine = Machine::read("m", shipped("torch-5axis").unwrap().text).unwrap();
    let q = machine.spread(3);
    let pose = machine.forward(&q);
    let judged = |change: &dyn Fn(&mut RoundTrip, &mut Solution)| {
        let mut found = RoundTrip::default();
        found.poses = 1;
        let mut solution = machine.inverse_near(pose, &q).unwrap();
        change(&mut found, &mut solution);
        found.compare(&machine, &[pose], &q, &solution, true);
        found.judge(false, 1.0);
        found.passed
    };
    assert!(judged(&|_, _| ()));
    assert!(!judged(&|_, s| s.joints[0] += 3e-9));
    assert!(!judged(&|_, s| s.joints[3] += 3e-9));
    assert!(!judged(&|_, s| s.joints[2] = f64::NAN));
    assert!(!judged(&|_, s| s.attitude_error = 1e-6));
    assert!(!judged(&|f, _| f.unsolved = 1));
    assert!(!judged(&|f, _| f.branch_missed = 1));
    assert!(!judged(&|f, _| f.axes_mm_or_deg = 2e-9));
}
