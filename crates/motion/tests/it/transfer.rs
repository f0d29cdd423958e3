//! Transfer moves: clear everywhere by dense sampling, or refused with the reason; legs within every limit.

#![allow(clippy::float_cmp, reason = "ends of legs are met without rounding")]

use crate::planning::shipped_machine;
use glam::{DAffine3, DVec3};
use seamwright_clearance::{Shape, Solid};
use seamwright_machine::{AxisSet, Clamped, Course, Joints, Machine, Surroundings};
use seamwright_motion::feed_override::{Command, FeedOverride, Timed, channel_limits};
use seamwright_motion::transfer::{Leg, route};
use seamwright_testkit::Random;

fn solid(shape: Shape, at: DVec3) -> Solid {
    Solid::new("wall", shape, DAffine3::from_translation(at)).unwrap()
}

fn joints(machine: &Machine, values: &[(&str, f64)]) -> Joints {
    let mut q = machine.home();
    for (name, value) in values {
        let i = machine.axis(name).unwrap();
        q[i] = machine.axes[i].from_file(*value);
    }
    q
}

fn check_clear(machine: &Machine, around: &Surroundings, way: &[Joints]) {
    for w in way.windows(2) {
        let leg = Leg::new(machine, &w[0], &w[1]);
        for i in 0..=500 {
            assert!(around.is_clear(&Course::at(&leg, f64::from(i) / 500.0)));
        }
    }
}

#[test]
fn goes_round_a_wall_over_a_table() {
    let machine = shipped_machine("torch-5axis");
    // A wall of 1 mm across the table, higher than the torch is at both ends, with room over it.
    let wall = solid(Shape::Box { size: DVec3::new(700.0, 1.0, 300.0) }, DVec3::new(0.0, 0.0, 150.0));
    let clamped = Clamped { part: vec![wall], least_mm: 2.0, ..Clamped::default() };
    let around = Surroundings::new(&machine, &clamped).unwrap();
    let (from, to) = (joints(&machine, &[("y", -200.0), ("z", 40.0)]), joints(&machine, &[("y", 200.0), ("z", 40.0)]));
    let way = route(&machine, &around, &from, &to, AxisSet::default()).unwrap();
    assert!(way.len() > 2 && way[0] == from && way[way.len() - 1] == to);
    check_clear(&machine, &around, &way);
    // The same request has the same result; without the wall the move is straight.
    assert_eq!(way, route(&machine, &around, &from, &to, AxisSet::default()).unwrap());
    let free = Surroundings::new(&machine, &Clamped::default()).unwrap();
    assert_eq!(route(&machine, &free, &from, &to, AxisSet::default()).unwrap().len(), 2);
}

#[test]
fn what_cannot_be_gone_round_is_refused() {
    let machine = shipped_machine("ellipse-xy");
    let wall = solid(Shape::Box { size: DVec3::new(5.0, 3000.0, 300.0) }, DVec3::new(50.0, 0.0, 150.0));
    let clamped = Clamped { part: vec![wall], least_mm: 2.0, ..Clamped::default() };
    let around = Surroundings::new(&machine, &clamped).unwrap();
    let (from, to) = (joints(&machine, &[("x", -200.0)]), joints(&machine, &[("x", 200.0)]));
    let e = route(&machine, &around, &from, &to, AxisSet::default()).unwrap_err();
    let text = e.to_string();
    assert!(e.code == "motion-transfer-none" && text.contains("wall") && text.contains("torch"), "{text}");
    let inside = joints(&machine, &[("x", 45.0)]);
    let e = route(&machine, &around, &inside, &to, AxisSet::default()).unwrap_err();
    assert!(e.code == "motion-transfer-start", "{e}");
}

#[test]
fn legs_keep_every_limit_and_end_where_they_should() {
    for name in ["saddle-4axis", "torch-5axis", "ebw-7axis", "dual-laser-10axis"] {
        let machine = shipped_machine(name);
        for k in 1..200 {
            // Long and short ones.
            let (from, far) = (machine.spread(k), machine.spread(k + 1000));
            let scale = [1.0, 0.1, 1e-3][k as usize % 3];
            let to: Joints = std::array::from_fn(|i| from[i] + scale * (far[i] - from[i]));
            let leg = Leg::new(&machine, &from, &to);
            assert_eq!(leg.at_time(0.0), from);
            assert_eq!(leg.at_time(leg.duration()), to);
            // The rates are those of the positions and within the limits, and so are their differences.
            let (mut full, h) = (0.0f64, leg.duration() / 4000.0);
            for i in 1..4000 {
                let t = f64::from(i) * h;
                let [a, b, c] = [t - h, t, t + h].map(|t| (leg.at_time(t), leg.rates(t)));
                for (i, axis) in machine.axes.iter().enumerate() {
                    let (v, w, j) = (axis.max_speed, axis.max_acceleration, axis.jerk());
                    let rounding = 1e-12 * b.0[i].abs().max(1.0) / h;
                    let slope = |a: f64, c: f64| (c - a) / (2.0 * h);
                    let (speed, acceleration) = (b.1.0[i], b.1.1[i]);
                    assert!((slope(a.0[i], c.0[i]) - speed).abs() <= j * h * h + rounding);
                    assert!((slope(a.1.0[i], c.1.0[i]) - acceleration).abs() <= j * h + 1e-9 * w);
                    let jerk = slope(a.1.1[i], c.1.1[i]).abs();
                    let uses = [speed.abs() / v, acceleration.abs() / w, jerk / j];
                    assert!(uses.iter().all(|u| *u <= 1.0 + 1e-6), "{name} {k}: {} {uses:?}", axis.name);
                    full = uses.into_iter().fold(full, f64::max);
                }
            }
            assert!(full > 0.99, "{name}: some limit is used");
        }
    }
    // Without a maximum jerk the full acceleration takes 20 ms.
    let mut machine = shipped_machine("ellipse-xy");
    let (from, mut to) = (machine.home(), machine.home());
    to[0] += 100.0;
    machine.axes[0].max_jerk = f64::INFINITY;
    let leg = Leg::new(&machine, &from, &to);
    let highest = machine.axes[0].max_acceleration;
    assert!((leg.rates(0.01).1[0] / highest - 0.5).abs() < 1e-9 && (leg.rates(0.02).1[0] / highest - 1.0).abs() < 1e-9);
    let still = Leg::new(&machine, &machine.home(), &machine.home());
    assert!(still.duration() == 0.0 && still.at_time(0.3) == machine.home());
}

/// A leg held, reversed and slowed at random times keeps to its line and to every limit, by differences.
#[test]
fn legs_can_be_held() {
    let machine = shipped_machine("torch-5axis");
    let period = 1e-3;
    let random = &mut Random::new(11);
    for case in 0..60 {
        let mut at = || {
            let axes = machine.axes.iter().map(|a| a.range.unwrap_or((-3.0, 3.0)));
            let mut q = Joints::default();
            for (i, (low, high)) in axes.enumerate() {
                q[i] = random.within(low, high);
            }
            q
        };
        let (from, to) = (at(), at());
        let leg = Leg::new(&machine, &from, &to);
        for part in [0.1, 0.37, 0.5, 0.9] {
            assert!((Timed::at(&leg, leg.time_of(part), false).tip.s - part).abs() < 1e-12);
        }
        let mut feed_override = FeedOverride::new(&channel_limits(&machine), period, &leg).unwrap();
        feed_override.command(Command::Resume).unwrap();
        let mut seen: Vec<Joints> = vec![from; 3];
        let mut steps = 0;
        while !feed_override.at_end() {
            match random.below(400) {
                0 => feed_override.command(Command::Hold).unwrap(),
                1 => feed_override.command(Command::Reverse).unwrap(),
                2 => feed_override.command(Command::Override(random.within(0.2, 1.0))).unwrap(),
                _ if steps > 8000 || feed_override.at_rest() => feed_override.command(Command::Resume).unwrap(),
                _ => {}
            }
            seen.push(feed_override.step().rates.q);
            steps += 1;
            assert!(steps < 200_000, "case {case}");
        }
        assert_eq!(seen.last(), Some(&to));
        for w in seen.windows(4) {
            for (i, a) in machine.axes.iter().enumerate() {
                let d = [w[1][i] - w[0][i], w[2][i] - w[1][i], w[3][i] - w[2][i]].map(|d| d / period);
                let dd = [(d[1] - d[0]) / period, (d[2] - d[1]) / period];
                let slack = 1e-9 / period.powi(3);
                assert!(d[2].abs() < a.max_speed * 1.0001 && dd[1].abs() < a.max_acceleration * 1.0001 + slack);
                assert!((dd[1] - dd[0]).abs() / period < a.jerk() * 1.001 + slack, "case {case}");
                // On the straight line.
                let part = |i: usize| (w[3][i] - from[i]) / (to[i] - from[i]);
                assert!((part(i) - part(0)).abs() < 1e-9);
            }
        }
    }
}
