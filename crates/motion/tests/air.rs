//! Air moves: clear all along by dense sampling, or refused with the reason; legs within every limit.

#![allow(clippy::float_cmp, reason = "ends of legs are met without rounding")]

use glam::{DAffine3, DVec3};
use seamwright_clearance::{Shape, Solid};
use seamwright_machine::{AxisSet, Clamped, Course, Joints, Machine, Surroundings, shipped};
use seamwright_motion::air::{AirMove, Blocked, Leg, route};

fn read(name: &str) -> Machine {
    Machine::read(name, shipped(name).unwrap().text).unwrap()
}

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
            assert!(around.is_clear(&leg.at(f64::from(i) / 500.0)));
        }
    }
}

#[test]
fn goes_round_a_wall_over_a_table() {
    let machine = read("torch-5axis");
    // A wall of 1 mm across the table, higher than the torch is at both ends, with room over it.
    let wall = solid(Shape::Box { size: DVec3::new(700.0, 1.0, 300.0) }, DVec3::new(0.0, 0.0, 150.0));
    let clamped = Clamped { part: vec![wall], least_mm: 2.0, ..Clamped::default() };
    let around = Surroundings::new(&machine, &clamped).unwrap();
    let (from, to) = (joints(&machine, &[("y", -200.0), ("z", 40.0)]), joints(&machine, &[("y", 200.0), ("z", 40.0)]));
    let way = route(&machine, &around, &from, &to, AxisSet::default()).unwrap();
    assert!(way.len() > 2 && way[0] == from && way[way.len() - 1] == to);
    check_clear(&machine, &around, &way);
    // The same question has the same answer; without the wall the way is straight.
    assert_eq!(way, route(&machine, &around, &from, &to, AxisSet::default()).unwrap());
    let free = Surroundings::new(&machine, &Clamped::default()).unwrap();
    assert_eq!(route(&machine, &free, &from, &to, AxisSet::default()).unwrap().len(), 2);
    println!("{} legs, {:.1} s", way.len() - 1, AirMove::new(&machine, &way).duration());
}

#[test]
fn what_cannot_be_gone_round_is_refused() {
    let machine = read("ellipse-xy");
    let wall = solid(Shape::Box { size: DVec3::new(5.0, 3000.0, 300.0) }, DVec3::new(50.0, 0.0, 150.0));
    let clamped = Clamped { part: vec![wall], least_mm: 2.0, ..Clamped::default() };
    let around = Surroundings::new(&machine, &clamped).unwrap();
    let (from, to) = (joints(&machine, &[("x", -200.0)]), joints(&machine, &[("x", 200.0)]));
    let e = route(&machine, &around, &from, &to, AxisSet::default()).unwrap_err();
    println!("{e}");
    assert!(matches!(&e, Blocked::NoWay { what } if what.contains("wall") && what.contains("torch")));
    let inside = joints(&machine, &[("x", 45.0)]);
    let e = route(&machine, &around, &inside, &to, AxisSet::default()).unwrap_err();
    assert!(matches!(e, Blocked::End { which: "its start", .. }), "{e}");
}

#[test]
fn legs_keep_every_limit_and_end_where_they_should() {
    for name in ["saddle-4axis", "torch-5axis", "ebw-7axis", "dual-laser-10axis"] {
        let machine = read(name);
        for k in 1..200 {
            // Long and short ones.
            let (from, far) = (machine.spread(k), machine.spread(k + 1000));
            let scale = [1.0, 0.1, 1e-3][k as usize % 3];
            let to: Joints = std::array::from_fn(|i| from[i] + scale * (far[i] - from[i]));
            let leg = Leg::new(&machine, &from, &to);
            assert_eq!(leg.at_time(0.0), from);
            assert_eq!(leg.at_time(leg.duration()), to);
            let (mut full, h) = (0.0f64, leg.duration() / 4000.0);
            for i in 1..4000 {
                let t = f64::from(i) * h;
                let [a, b, c] = [t - h, t, t + h].map(|t| leg.at_time(t));
                for (i, axis) in machine.axes.iter().enumerate() {
                    let (v, w) = ((c[i] - a[i]) / (2.0 * h), (c[i] - 2.0 * b[i] + a[i]) / (h * h));
                    let rounding = 1e-12 * b[i].abs().max(1.0) / (h * h);
                    assert!(
                        v.abs() <= axis.max_speed * (1.0 + 1e-9)
                            && w.abs() <= axis.max_acceleration * (1.0 + 1e-6) + rounding
                    );
                    full = full.max(v.abs() / axis.max_speed).max(w.abs() / axis.max_acceleration);
                }
            }
            assert!(full > 0.99, "{name}: some limit is used");
        }
    }
    let machine = read("ellipse-xy");
    let still = Leg::new(&machine, &machine.home(), &machine.home());
    assert!(still.duration() == 0.0 && still.at_time(0.3) == machine.home());
}
