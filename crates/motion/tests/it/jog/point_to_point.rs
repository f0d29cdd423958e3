//! Point to point: limits, synchronised arrival, replaced targets, and the library's pitfalls.

use super::{Follower, joints};
use crate::planning::shipped_machine;
use seamwright_machine::{Joints, MAX_AXES};
use seamwright_motion::jog::{JogError, PointToPoint, State};
use seamwright_motion::transfer::Leg;
use seamwright_testkit::{Random, cases};

#[test]
fn targets_are_met_at_once_within_every_limit_however_often_they_are_replaced() {
    for (k, name) in ["saddle-4axis", "torch-5axis", "ebw-7axis", "dual-laser-10axis"].into_iter().enumerate() {
        let machine = shipped_machine(name);
        let mut random = Random::new(k as u8);
        let mut plan = PointToPoint::new(&machine);
        let h = 2e-3;
        for _ in 0..cases(60) {
            let mut state = State::at_rest(&joints(&mut random, &machine));
            let mut follower = Follower::new(&machine, h, &state);
            let share = if random.unit() < 0.5 { 1.0 } else { random.within(0.05, 1.0) };
            let mut target = state.q;
            for _ in 0..1 + random.below(6) {
                let (far, scale) = (joints(&mut random, &machine), 10f64.powf(random.within(-4.0, 0.0)));
                target = std::array::from_fn(|i| state.q[i] + scale * (far[i] - state.q[i]));
                plan.plan(&state, &target, share).unwrap();
                let periods = random.below(1 + (plan.duration() / h) as usize).min(400);
                for i in 1..=periods {
                    state = plan.at(i as f64 * h);
                    let most = follower.next(&state);
                    assert!(most <= 1.0 + 1e-5, "{name}: {most}");
                }
            }
            plan.plan(&state, &target, share).unwrap();
            let end = plan.at(plan.duration());
            let off = (0..MAX_AXES).map(|i| (end.q[i] - target[i]).abs()).fold(0.0, f64::max);
            assert!(off <= 2e-7, "{name}: {off}");
            assert!(end.speed.iter().chain(&end.acceleration).all(|x| x.abs() < 1e-6));
        }
    }
}

/// One axis from rest to rest has one fastest motion: the library's and the closed form of a leg agree.
#[test]
fn legs_take_as_long_as_the_library() {
    let machine = shipped_machine("dual-laser-10axis");
    let mut random = Random::new(3);
    let mut plan = PointToPoint::new(&machine);
    for _ in 0..cases(3000) {
        let from = joints(&mut random, &machine);
        let axis = random.below(machine.axes.len());
        let mut to = from;
        to[axis] += 10f64.powf(random.within(-4.0, 0.0)) * (joints(&mut random, &machine)[axis] - from[axis]);
        plan.plan(&State::at_rest(&from), &to, 1.0).unwrap();
        let leg = Leg::new(&machine, &from, &to);
        // The library meets targets within 1e-8, and ends stay 1e-7 inside the range.
        let slowest = 1e-7 / machine.axes[axis].max_speed;
        assert!((plan.duration() - leg.duration()).abs() <= 1e-5 * leg.duration() + slowest, "{axis}");
        let t = random.unit() * leg.duration();
        assert!((plan.at(t).q[axis] - leg.at_time(t)[axis]).abs() <= 1e-6);
        // Straight in axis space takes at least as long as every axis on its own.
        let to = joints(&mut random, &machine);
        plan.plan(&State::at_rest(&from), &to, 1.0).unwrap();
        assert!(plan.duration() <= Leg::new(&machine, &from, &to).duration() * (1.0 + 1e-9));
    }
}

#[test]
fn what_is_not_finite_is_refused() {
    let machine = shipped_machine("torch-5axis");
    let mut plan = PointToPoint::new(&machine);
    let home = State::at_rest(&machine.home());
    let broken: Joints = std::array::from_fn(|i| if i == 2 { f64::NAN } else { 0.0 });
    assert_eq!(plan.plan(&home, &broken, 1.0), Err(JogError::NoMotion));
    assert_eq!(plan.plan(&State::at_rest(&broken), &home.q, 1.0), Err(JogError::NoMotion));
    assert_eq!(plan.plan(&home, &home.q, f64::INFINITY), Err(JogError::NoMotion));
    assert_eq!(plan.plan(&home, &home.q, 0.0), Err(JogError::NoMotion));
    plan.plan(&home, &home.q, 1.0).unwrap();
    assert!(plan.duration() == 0.0 && plan.at(1.0) == home);
}
