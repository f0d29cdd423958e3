//! Every shipped machine, and random ones, by round trip and against differences; the trunnion against LinuxCNC.

use crate::common::{random_joints, shipped_machine};
use glam::DVec3;
use proptest::prelude::*;
use seamwright_geometry::Pose;
use seamwright_machine::{AxisKind, Joints, Machine, SHIPPED, Unreachable};
use seamwright_testkit::{Random, cases};

fn machines() -> Vec<Machine> {
    SHIPPED.iter().map(|s| Machine::read(s.name, s.text).unwrap_or_else(|e| panic!("{e}"))).collect()
}

/// Round trip of one set of positions: worst difference of the pose (mm, rad) and of the axes, and whether the
/// pose is far enough from a singular one for the axes to be compared.
fn round_trip(machine: &Machine, q: &Joints) -> (f64, f64, f64) {
    let pose = machine.forward(q);
    let branches = machine.inverse(pose, q).unwrap();
    let mut worst = (0.0f64, 0.0f64);
    for s in branches.iter().filter(|s| s.attitude_error < 1e-9) {
        let again = machine.forward(&s.joints);
        worst.0 = worst.0.max((again.point - pose.point).length());
        worst.1 = worst.1.max((again.direction - pose.direction).length());
    }
    let nearest = machine.inverse_near(pose, q).unwrap();
    let off = machine.axes.iter().zip(nearest.joints.iter().zip(q)).map(|(axis, (a, b))| {
        let scale = if axis.kind == AxisKind::Rotary { 1f64.to_degrees() } else { 1.0 };
        (a - b).abs() * scale
    });
    (worst.0, worst.1, off.fold(0.0, f64::max))
}

#[test]
fn a_hundred_thousand_random_poses_a_machine_come_back() {
    // Arms have tests of their own.
    for machine in machines().into_iter().filter(|machine| !machine.has_free_roll()) {
        let mut random = Random::new(7);
        let (mut point, mut direction, mut axes, mut compared) = (0.0f64, 0.0f64, 0.0f64, 0);
        for _ in 0..100_000 {
            let q = random_joints(&machine, &mut random);
            let (p, d, a) = round_trip(&machine, &q);
            point = point.max(p);
            direction = direction.max(d.to_degrees());
            // Within 0.001 degrees of a singular pose an axis is not determined to 1e-9 by a pose in doubles.
            if sine_to_singular(&machine, &q) > 2e-5 {
                axes = axes.max(a);
                compared += 1;
            }
        }
        assert!(point <= 1e-9 && direction <= 1e-9, "{}: {point:e} mm {direction:e} deg", machine.name);
        assert!(axes <= 1e-9 && compared > 99_900, "{}: {axes:e} of {compared}", machine.name);
    }
}

/// Distance of the pose from a singular one: the minimum sine between the torch's rotations by the decided axes; 1
/// without such rotations.
fn sine_to_singular(machine: &Machine, q: &Joints) -> f64 {
    let columns = machine.jacobian(q);
    let head = &machine.heads[0];
    let decided =
        |i: &usize| machine.axes[*i].kind == AxisKind::Rotary && head.chain.axes().has(*i) && !head.free().has(*i);
    let turning: Vec<DVec3> = (0..machine.axes.len()).filter(decided).map(|i| columns[i].1).collect();
    match turning.as_slice() {
        [a, b] if machine.axes.len() >= 5 => a.cross(*b).length(),
        _ => 1.0,
    }
}

#[test]
fn jacobians_match_differences() {
    for machine in machines() {
        let mut random = Random::new(3);
        for _ in 0..500 {
            let q = random_joints(&machine, &mut random);
            check_jacobian(&machine, &q);
        }
    }
}

fn check_jacobian(machine: &Machine, q: &Joints) {
    let columns = machine.jacobian(q);
    for (i, column) in columns.iter().enumerate().take(machine.axes.len()) {
        let h = 1e-5;
        let moved = |d: f64| {
            let mut q = *q;
            q[i] += d;
            machine.forward(&q)
        };
        let (l, r) = (moved(-h), moved(h));
        assert!(((r.point - l.point) / (2.0 * h) - column.0).length() < 1e-5, "{} axis {i}", machine.name);
        assert!(((r.direction - l.direction) / (2.0 * h) - column.1).length() < 1e-8, "{} axis {i}", machine.name);
    }
}

#[test]
fn the_saddle_welder_is_the_papers_formula() {
    let machine = shipped_machine("saddle-4axis");
    let mut random = Random::new(11);
    for _ in 0..1000 {
        let q = random_joints(&machine, &mut random);
        let (theta, s, h, beta) = (q[0], q[1], q[2], q[3]);
        let rho = 400.0 + s + 100.0 * beta.sin();
        let expected = DVec3::new(rho * theta.cos(), rho * theta.sin(), 100.0 + h - 100.0 * beta.cos());
        assert!((machine.forward(&q).point - expected).length() < 1e-11);
    }
}

/// LinuxCNC 2.9, xyzac-trt-kins with its defaults (switchkins-type 0, rotary offsets y 20, z 10).
#[test]
fn the_trunnion_agrees_with_linuxcnc() {
    let machine = shipped_machine("table-tilting-xyzac");
    let index = |name| machine.axis(name).unwrap();
    let mut near = Joints::default();
    near[index("a")] = 8f64.to_radians();
    near[index("c")] = 60f64.to_radians();
    let expected = [("x", 7.1077), ("y", 33.3687), ("z", 32.0754)];
    // Forward: LinuxCNC's joints put the tip on its tool pose.
    let mut q = near;
    for (name, value) in expected {
        q[index(name)] = value;
    }
    let pose = machine.forward(&q);
    assert!((pose.point - DVec3::new(35.0, 12.0, 30.0)).length() < 1e-4, "{}", pose.point);
    // Inverse: the pose with that direction gives LinuxCNC's joints.
    let pose = Pose { point: DVec3::new(35.0, 12.0, 30.0), direction: pose.direction };
    let found = machine.inverse_near(pose, &near).unwrap();
    for (name, value) in expected {
        assert!((found.joints[index(name)] - value).abs() < 1e-4, "{name}: {}", found.joints[index(name)]);
    }
}

#[test]
fn what_cannot_be_reached_says_why() {
    let up = Pose { point: DVec3::new(1.0, 2.0, 3.0), direction: DVec3::NEG_Z };
    let xy = shipped_machine("ellipse-xy");
    assert!(matches!(xy.inverse(up, &Joints::default()), Err(Unreachable::Point { by }) if (by - 3.0).abs() < 1e-12));
    let tilted = Pose { point: DVec3::new(1.0, 2.0, 0.0), direction: DVec3::new(0.6, 0.0, -0.8) };
    let s = xy.inverse_near(tilted, &Joints::default()).unwrap();
    assert!((s.attitude_error - 0.6f64.asin()).abs() < 1e-12);
    let q = s.joints;
    assert!(xy.outside(&q).is_none());
    let far = Pose { point: DVec3::new(700.0, 0.0, 0.0), ..tilted };
    let v = xy.outside(&xy.inverse_near(far, &Joints::default()).unwrap().joints).unwrap();
    assert!(v.axis == 0 && (v.by() - 100.0).abs() < 1e-9);
}

#[test]
fn a_free_axis_stays_where_it_is() {
    let machine = shipped_machine("table-tilting-xyzac");
    let c = machine.axis("c").unwrap();
    let mut near = Joints::default();
    near[c] = 1.25;
    let s = machine.inverse_near(Pose { point: DVec3::ONE, direction: DVec3::NEG_Z }, &near).unwrap();
    assert!(s.singular && (s.joints[c] - 1.25).abs() < 1e-15);
}

#[test]
fn turns_are_counted_from_where_the_axis_is() {
    let machine = shipped_machine("saddle-4axis");
    let mut q = Joints::default();
    for turns in [-7.1, -6.2, 0.0, 6.3, 6.9] {
        q[0] = turns;
        let found = machine.inverse_near(machine.forward(&q), &q).unwrap();
        assert!((found.joints[0] - turns).abs() < 1e-12);
    }
}

/// A machine with three linear and two rotary axes in random order, sense, side and direction.
fn random_machine() -> impl Strategy<Value = Machine> {
    let step = (prop::array::uniform3(-1.0..1.0f64), prop::array::uniform3(-200.0..200.0f64), any::<bool>());
    let order = Just([0usize, 1, 2, 3, 4]).prop_shuffle();
    (prop::collection::vec(step, 5), order, prop::array::uniform3(-1.0..1.0f64)).prop_filter_map(
        "axes must span space",
        |(steps, order, torch)| {
            let mut text = String::from("schema = 1\nname = \"random\"\ntitle = \"random\"\n");
            for k in order {
                let ([x, y, z], [a, b, c], tool) = steps[k];
                let side = if tool { "tool" } else { "work" };
                let limits = |u: &str| {
                    format!("range_{u} = [-170, 170]\nmax_speed_{u}_s = 1\nmax_acceleration_{u}_s2 = 1\nmax_jerk_{u}_s3 = 1\n")
                };
                let (kind, limits) = if k < 3 {
                    (format!("move = [{x}, {y}, {z}]\n"), limits("mm"))
                } else {
                    (format!("turn = [{x}, {y}, {z}]\nat_mm = [{a}, {b}, {c}]\n"), limits("deg"))
                };
                text += &format!("[[{side}]]\naxis = \"q{k}\"\n{kind}{limits}");
                text += &format!("[[{side}]]\nfixed = {{ move_mm = [{c}, {a}, {b}], turn = [{z}, {x}, {y}], angle_deg = {a} }}\n");
            }
            text += &format!("[torch]\ndirection = [{}, {}, {}]\n", torch[0], torch[1], torch[2]);
            Machine::read("random.toml", &text).ok()
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig { cases: cases(3000), failure_persistence: None, ..ProptestConfig::default() })]

    /// The inverse is chosen from the structure: any three linear and two rotary axes pass the round trip, or give a
    /// reason.
    #[test]
    fn random_machines_come_back(machine in random_machine(), seed in any::<u32>()) {
        let mut random = Random::of_case(seed);
        let q = random_joints(&machine, &mut random);
        check_jacobian(&machine, &q);
        let pose = machine.forward(&q);
        match machine.inverse(pose, &q) {
            Ok(branches) => {
                for s in branches.iter() {
                    let again = machine.forward(&s.joints);
                    let big = s.joints.iter().fold(1.0f64, |m, v| m.max(v.abs()));
                    prop_assert!((again.point - pose.point).length() < 1e-11 * big.max(100.0) * 10.0);
                    prop_assert!((again.direction - pose.direction).length() < 1e-7);
                }
                let near = machine.inverse_near(pose, &q).unwrap();
                let worst = near.joints.iter().zip(&q).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
                let conditioned = sine_to_singular(&machine, &q) > 0.05;
                let spanned = near.joints.iter().all(|v| v.abs() < 1e4);
                prop_assert!(!conditioned || !spanned || worst < 1e-4, "axes off by {worst:e}");
            }
            Err(e) => prop_assert!(matches!(e, Unreachable::Flat), "{e}"),
        }
    }
}

/// For a far point the linear axes are the reason, even if a rotary one is also out of range.
#[test]
fn a_far_point_is_out_of_reach() {
    let torch = shipped_machine("torch-5axis");
    for (point, direction) in [(DVec3::new(1e9, 0.0, 0.0), DVec3::Y), (DVec3::new(0.0, -1e9, 20.0), -DVec3::Z)] {
        let pose = Pose { point, direction: (direction - 0.3 * DVec3::Z).normalize() };
        let why = torch.reach(pose, &torch.home()).unwrap_err();
        let Unreachable::OutOfReach { by, .. } = &why else { panic!("{why}") };
        assert!((by - 1e9).abs() < 1e4, "{why}");
        assert!(why.to_string().starts_with("out of reach by 99"), "{why}");
    }
}
