//! Six-axis arms in closed form: every branch against forward kinematics, singular poses, poses out of reach.

use crate::common::{random_joints, same, shipped_machine};
use glam::{DVec3, dvec3};
use seamwright_machine::{ArmConfiguration, Elbow, Joints, Machine, SHIPPED, Shoulder, Target, Unreachable, WristSide};
use seamwright_testkit::{Random, cases};
use std::f64::consts::PI;

/// A row of Denavit and Hartenberg's parameters: turn about z by the axis, then `d` along z, `a` along x, `alpha`
/// about x; mm and degrees.
struct Row {
    d: f64,
    a: f64,
    alpha: f64,
}

const fn row(d: f64, a: f64, alpha: f64) -> Row {
    Row { d, a, alpha }
}

/// Data sheet of Universal Robots: UR10e.
const UR10E: [Row; 6] = [
    row(180.7, 0.0, 90.0),
    row(0.0, -612.7, 0.0),
    row(0.0, -571.55, 0.0),
    row(174.15, 0.0, 90.0),
    row(119.85, 0.0, -90.0),
    row(116.55, 0.0, 0.0),
];
/// An ortho-parallel arm with all offsets.
const OPW: [Row; 6] = [
    row(445.0, 150.0, -90.0),
    row(0.0, 700.0, 180.0),
    row(37.0, 115.0, -90.0),
    row(-795.0, 0.0, 90.0),
    row(0.0, 0.0, -90.0),
    row(-85.0, 0.0, 180.0),
];
/// A leaning first axis, a third axis of opposite sense and a wrist with neighbours at 70 and 60 degrees.
const OBLIQUE: [Row; 6] = [
    row(400.0, 180.0, -80.0),
    row(25.0, 590.0, 180.0),
    row(10.0, 115.0, 90.0),
    row(720.0, 0.0, 70.0),
    row(0.0, 0.0, 60.0),
    row(100.0, 0.0, 0.0),
];
const ARMS: [(&str, &[Row; 6]); 3] = [("ur10e", &UR10E), ("opw", &OPW), ("oblique", &OBLIQUE)];

fn arm(rows: &[Row; 6], range_deg: f64, before: &str, work: &str) -> Machine {
    let mut text = format!("schema = 1\nname = \"arm\"\ntitle = \"arm\"\n{before}");
    for (i, Row { d, a, alpha }) in rows.iter().enumerate() {
        text += &format!(
            "[[tool]]\naxis = \"j{}\"\nturn = [0, 0, 1]\nrange_deg = [-{range_deg}, {range_deg}]\n\
             max_speed_deg_s = 120\nmax_acceleration_deg_s2 = 300\n\
             [[tool]]\nfixed = {{ move_mm = [{a}, 0, {d}], turn = [1, 0, 0], angle_deg = {alpha} }}\n",
            i + 1
        );
    }
    text += "[[tool]]\nfixed = { move_mm = [90, 0, 330], turn = [0, 1, 0], angle_deg = 35 }\n\
             [torch]\ndirection = [0, 0, 1]\n";
    Machine::read("arm.toml", &(text + work)).unwrap_or_else(|e| panic!("{e}"))
}

fn plain(rows: &[Row; 6]) -> Machine {
    arm(rows, 180.0, "", "")
}

fn framed(machine: &Machine, q: &Joints) -> Target {
    Target { across: Some(machine.across(q)), ..Target::from(machine.forward(q)) }
}

/// Distance of the frame at `q` from the target: mm, and the larger chord of its two directions.
fn miss(machine: &Machine, target: &Target, q: &Joints) -> (f64, f64) {
    let pose = machine.forward(q);
    let across = machine.across(q) - target.across.unwrap();
    (
        (pose.point - target.first.point).length(),
        (pose.direction - target.first.direction).length().max(across.length()),
    )
}

#[test]
fn every_branch_reaches_the_frame_and_the_own_one_is_among_them() {
    for (name, rows) in ARMS {
        let machine = plain(rows);
        assert!(machine.has_free_roll() && !machine.heads[0].is_numeric() && machine.free().is_empty(), "{name}");
        let mut random = Random::new(1);
        let (mut point, mut direction, mut most, mut regular) = (0.0f64, 0.0f64, 0, 0);
        for _ in 0..cases(10_000) {
            let q = random_joints(&machine, &mut random);
            let near = random_joints(&machine, &mut random);
            let target = framed(&machine, &q);
            let branches = machine.inverse(target, &near).unwrap_or_else(|e| panic!("{name}: {e} at {q:?}"));
            for b in branches.iter() {
                let (p, d) = miss(&machine, &target, &b.joints);
                (point, direction) = (point.max(p), direction.max(d));
                assert!(b.joints[6..].iter().all(|v| *v == 0.0));
            }
            for (i, a) in branches.iter().enumerate() {
                assert!(branches[..i].iter().all(|b| !same(&machine, &a.joints, &b.joints, 1e-9)), "{name}: twice");
            }
            most = most.max(branches.len());
            if machine.arm_margins(&q).unwrap().min() > 1e-4 {
                regular += 1;
                assert!(branches.iter().any(|b| same(&machine, &b.joints, &q, 1e-8)), "{name}: missing {q:?}");
            }
        }
        assert!(point < 1e-9 && direction < 1e-11, "{name}: {point:e} mm, {direction:e}");
        assert!(most == 8 && f64::from(regular) > 0.99 * f64::from(cases(10_000)), "{name}: {most} {regular}");
    }
}

/// Other solutions that descent from a grid of starts finds, without the code under test.
#[test]
fn no_branch_is_missing() {
    for (name, rows) in ARMS {
        let machine = plain(rows);
        let mut random = Random::new(2);
        for _ in 0..cases(6) {
            let q = random_joints(&machine, &mut random);
            if machine.arm_margins(&q).unwrap().min() < 0.1 {
                continue;
            }
            let target = framed(&machine, &q);
            let branches = machine.inverse(target, &q).unwrap();
            let mut found: Vec<Joints> = Vec::new();
            for _ in 0..400 {
                let start = random_joints(&machine, &mut random);
                if let Some(end) = descend(&machine, &target, start)
                    && !found.iter().any(|f| same(&machine, f, &end, 1e-5))
                {
                    assert!(branches.iter().any(|b| same(&machine, &b.joints, &end, 1e-5)), "{name}: {end:?}");
                    found.push(end);
                }
            }
            assert_eq!(found.len(), branches.len(), "{name}");
        }
    }
}

/// Newton's method with a Jacobian by differences and elimination with pivots.
fn descend(machine: &Machine, target: &Target, mut q: Joints) -> Option<Joints> {
    let residual = |q: &Joints| -> [f64; 6] {
        let (pose, across) = (machine.forward(q), machine.across(q));
        let p = target.first.point - pose.point;
        let third = |d: DVec3, a: DVec3| d.cross(a);
        let turn = 0.5
            * (pose.direction.cross(target.first.direction)
                + across.cross(target.across.unwrap())
                + third(pose.direction, across).cross(third(target.first.direction, target.across.unwrap())));
        [p.x, p.y, p.z, 500.0 * turn.x, 500.0 * turn.y, 500.0 * turn.z]
    };
    for _ in 0..60 {
        let here = residual(&q);
        let mut rows = [[0.0; 7]; 6];
        for i in 0..6 {
            let mut moved = q;
            moved[i] += 1e-6;
            let there = residual(&moved);
            (0..6).for_each(|k| rows[k][i] = (here[k] - there[k]) / 1e-6);
        }
        (0..6).for_each(|k| rows[k][6] = here[k]);
        let step = eliminate(rows)?;
        let part = (0.4 / step.iter().fold(0.0f64, |m, v| m.max(v.abs()))).min(1.0);
        (0..6).for_each(|i| q[i] += part * step[i]);
    }
    let (p, d) = miss(machine, target, &q);
    (p < 1e-6 && d < 1e-8).then_some(q)
}

fn eliminate(mut rows: [[f64; 7]; 6]) -> Option<[f64; 6]> {
    for i in 0..6 {
        let pivot = (i..6).max_by(|a, b| rows[*a][i].abs().total_cmp(&rows[*b][i].abs()))?;
        rows.swap(i, pivot);
        if rows[i][i].abs() < 1e-12 {
            return None;
        }
        for k in (0..6).filter(|k| *k != i) {
            let part = rows[k][i] / rows[i][i];
            (i..7).for_each(|c| rows[k][c] -= part * rows[i][c]);
        }
    }
    Some(std::array::from_fn(|i| rows[i][6] / rows[i][i]))
}

#[test]
fn configurations_name_the_branches() {
    for (name, rows) in ARMS {
        let machine = plain(rows);
        let mut random = Random::new(3);
        let mut eights = 0;
        for _ in 0..cases(1000) {
            let q = random_joints(&machine, &mut random);
            let branches = machine.inverse(framed(&machine, &q), &q).unwrap();
            if machine.arm_margins(&q).unwrap().min() < 1e-4 || branches.len() < 8 {
                continue;
            }
            eights += 1;
            let of = |q: &Joints| ArmConfiguration { turns: [0; 6], ..machine.arm_configuration(q).unwrap() };
            let names: std::collections::HashSet<_> = branches.iter().map(|b| of(&b.joints)).collect();
            assert_eq!(names.len(), 8, "{name}");
        }
        assert!(eights > 100, "{name}: {eights}");
    }
}

#[test]
fn an_upright_arm_has_elbow_and_wrist_as_engineers_name_them() {
    let of = |q: [f64; 6]| {
        let mut joints = Joints::default();
        q.iter().zip(&mut joints).for_each(|(a, b)| *b = a.to_radians());
        plain(&OPW).arm_configuration(&joints).unwrap()
    };
    // Upper arm upright, forearm forwards: the elbow is above the line to the wrist.
    let up = of([0.0, -90.0, 0.0, 0.0, 30.0, 270.0]);
    let named = (Shoulder::Front, Elbow::Up, WristSide::NoFlip, [0, 0, 0, 0, 0, 1]);
    assert_eq!((up.shoulder, up.elbow, up.wrist, up.turns), named);
    assert_eq!(of([0.0, -180.0, 10.0, 0.0, -30.0, 0.0]).shoulder, Shoulder::Back);
    assert_eq!(of([0.0, -90.0, 0.0, 0.0, -30.0, 0.0]).wrist, WristSide::Flip);
}

/// KUKA counts its first axis clockwise: the elbow is up with A3 beyond the stretched position all the same.
#[test]
fn a_first_axis_that_points_down_changes_no_name() {
    let of = |name: &str, deg: [f64; 6]| {
        let machine = shipped_machine(name);
        let mut joints = Joints::default();
        deg.iter().zip(&mut joints).for_each(|(a, b)| *b = a.to_radians());
        machine.arm_configuration(&joints).unwrap()
    };
    for (elbow, a3) in [(Elbow::Up, 90.0), (Elbow::Up, 30.0), (Elbow::Down, -30.0)] {
        assert_eq!(of("kr-16", [0.0, -60.0, a3, 0.0, 30.0, 0.0]).elbow, elbow, "{a3}");
    }
    assert_eq!(of("irb-2600", [0.0, 0.0, 0.0, 0.0, 30.0, 0.0]).elbow, Elbow::Up);
    assert_eq!(
        of("ur10e", [0.0, -90.0, -90.0, -90.0, 90.0, 0.0]).elbow,
        of("ur10e", [0.0, -45.0, -60.0, 0.0, 90.0, 0.0]).elbow
    );
}

#[test]
fn singular_poses_keep_the_free_axis_where_it_is() {
    let arms = [("ur10e", plain(&UR10E)), ("opw", plain(&OPW))];
    for (name, machine) in &arms {
        let mut random = Random::new(4);
        for _ in 0..cases(2000) {
            let mut q = random_joints(machine, &mut random);
            q[4] = 0.0;
            let found = machine.inverse(framed(machine, &q), &q).unwrap();
            assert!(machine.arm_margins(&q).unwrap().wrist < 1e-12, "{name}");
            // Nearly stretched, rounding of the other axes moves the wrist out of its singularity.
            let margins = machine.arm_margins(&q).unwrap();
            if margins.elbow.min(margins.shoulder) > 0.05 {
                assert!(found.iter().any(|b| b.singular && same(machine, &b.joints, &q, 1e-6)), "{name}");
            }
            for b in found.iter() {
                let (p, d) = miss(machine, &framed(machine, &q), &b.joints);
                assert!(p < 1e-9 && d < 1e-11, "{name}: {p:e} {d:e}");
            }
        }
    }
    // Near the singularities the frame is still reached to rounding.
    for (name, machine) in &arms {
        let mut random = Random::new(5);
        for k in 0..cases(3000) {
            let mut q = random_joints(machine, &mut random);
            let off = 10f64.powf(random.within(-14.0, -2.0));
            let axis = if k % 2 == 0 { 4 } else { 2 };
            let stretched = if axis == 2 && *name == "opw" { -(795f64 / 115.0).atan() } else { 0.0 };
            q[axis] = stretched + off;
            let target = framed(machine, &q);
            for b in machine.inverse(target, &q).unwrap().iter() {
                let (p, d) = miss(machine, &target, &b.joints);
                assert!(p < 1e-9 && d < 1e-11, "{name}: {p:e} {d:e} at {off:e} of axis {axis}");
            }
        }
    }
}

#[test]
fn the_wrist_on_the_first_axis_leaves_it_free() {
    let mut rows = OPW;
    rows[2].d = 0.0;
    let machine = plain(&rows);
    // The wrist's centre over the base: found by bisection of axis 2.
    let margin = |q2: f64| {
        let mut q = Joints::default();
        (q[0], q[1], q[2], q[4]) = (0.7, q2, -0.9, 0.5);
        (q, machine.arm_margins(&q).unwrap().shoulder_mm)
    };
    let steps = (0..400_000).map(|k| -PI + 2.0 * PI * f64::from(k) / 400_000.0);
    let best = steps.min_by(|a, b| margin(*a).1.total_cmp(&margin(*b).1)).unwrap();
    let (q, near) = margin(best);
    assert!(near < 1e-2, "{near}");
    let found = machine.inverse(framed(&machine, &q), &q).unwrap();
    assert!(found.iter().any(|b| same(&machine, &b.joints, &q, 1e-6)));
}

#[test]
fn a_pose_out_of_reach_says_by_how_much() {
    for (name, rows) in ARMS {
        let machine = plain(rows);
        let mut q = Joints::default();
        (q[1], q[2], q[4]) = (-0.6, 0.5, 0.7);
        let target = framed(&machine, &q);
        let far = |by: f64| Target {
            first: seamwright_geometry::Pose {
                point: target.first.point + by * dvec3(0.8, 0.6, 0.0),
                direction: target.first.direction,
            },
            ..target
        };
        let by = |d: f64| match machine.inverse(far(d), &q) {
            Err(Unreachable::Point { by }) => by,
            other => panic!("{name}: {other:?}"),
        };
        let (a, b) = (by(5000.0), by(5100.0));
        // Far away the excess grows as the distance does.
        assert!((b - a - 100.0).abs() < 3.0 && a > 2000.0 && a < 5000.0, "{name}: {a} {b}");
    }
}

#[test]
fn without_a_wish_the_rotation_about_the_torch_stays() {
    for (name, rows) in ARMS {
        let machine = plain(rows);
        let mut random = Random::new(6);
        for _ in 0..cases(500) {
            let q = random_joints(&machine, &mut random);
            if machine.arm_margins(&q).unwrap().min() < 1e-3 {
                continue;
            }
            let found = machine.inverse_near(machine.forward(&q), &q).unwrap();
            assert!(same(&machine, &found.joints, &q, 1e-7), "{name}");
        }
    }
}

#[test]
fn a_rail_and_a_positioner_keep_their_positions() {
    let rail = "[[tool]]\naxis = \"rail\"\nmove = [0, 1, 0]\nrange_mm = [-2000, 2000]\nmax_speed_mm_s = 500\n\
                max_acceleration_mm_s2 = 1000\n[[tool]]\nfixed = { move_mm = [0, 30, 200] }\n";
    let axis = |name: &str, turn: &str| {
        format!(
            "[[work]]\naxis = \"{name}\"\nturn = {turn}\nrange_deg = [-180, 180]\nmax_speed_deg_s = 30\n\
             max_acceleration_deg_s2 = 60\n"
        )
    };
    let work = format!(
        "[[work]]\nfixed = {{ move_mm = [850, 100, 50] }}\n{}[[work]]\nfixed = {{ move_mm = [0, 0, 100] }}\n{}",
        axis("tilt", "[0, 1, 0]"),
        axis("turn", "[0, 0, 1]")
    );
    for (name, rows) in ARMS {
        let machine = arm(rows, 180.0, rail, &work);
        assert_eq!(
            machine.free().iter().map(|i| machine.axes[i].name.as_str()).collect::<Vec<_>>(),
            ["rail", "tilt", "turn"]
        );
        let mut random = Random::new(7);
        for _ in 0..cases(2000) {
            let q = random_joints(&machine, &mut random);
            let mut near = random_joints(&machine, &mut random);
            machine.free().iter().for_each(|axis| near[axis] = q[axis]);
            let target = framed(&machine, &q);
            let branches = machine.inverse(target, &near).unwrap();
            assert!(branches.iter().all(|b| miss(&machine, &target, &b.joints).0 < 2e-9), "{name}");
            if machine.arm_margins(&q).unwrap().min() > 1e-4 {
                assert!(branches.iter().any(|b| same(&machine, &b.joints, &q, 1e-8)), "{name}");
            }
        }
    }
}

#[test]
fn the_shipped_arms_come_back() {
    let arms = SHIPPED.iter().map(|s| shipped_machine(s.name)).filter(Machine::has_free_roll);
    let mut count = 0;
    for machine in arms {
        count += 1;
        let mut random = Random::new(8);
        for _ in 0..cases(10_000) {
            let q = random_joints(&machine, &mut random);
            let mut near = random_joints(&machine, &mut random);
            machine.free().iter().for_each(|axis| near[axis] = q[axis]);
            let target = framed(&machine, &q);
            let branches = machine.inverse(target, &near).unwrap_or_else(|e| panic!("{}: {e}", machine.name));
            for b in branches.iter() {
                let (p, d) = miss(&machine, &target, &b.joints);
                assert!(
                    p < 1e-9 * (1e-3 * target.first.point.length()).max(1.0) && d < 1e-11,
                    "{}: {p:e}",
                    machine.name
                );
            }
            let regular = machine.arm_margins(&q).unwrap().min() > 1e-4;
            assert!(!regular || branches.iter().any(|b| same(&machine, &b.joints, &q, 1e-8)), "{}", machine.name);
        }
    }
    assert_eq!(count, 12);
}

/// Lines in the base frame, against Denavit and Hartenberg's parameters.
#[test]
fn the_shipped_ur10e_is_that_of_its_data_sheet() {
    let (shipped, by_parameters) = (shipped_machine("ur10e"), plain(&UR10E));
    let mut random = Random::new(9);
    for _ in 0..1000 {
        let q = random_joints(&shipped, &mut random);
        let (a, b) = (shipped.forward(&q), by_parameters.forward(&q));
        assert!((a.point - dvec3(700.0, 0.0, 0.0) - b.point).length() < 1e-9);
        assert!((a.direction - b.direction).length() < 1e-12);
    }
}

#[test]
fn turns_fill_the_ranges() {
    let machine = arm(&UR10E, 360.0, "", "");
    let q = [0.1, -0.2, 0.3, -0.4, 0.5, -0.6, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0];
    let all = machine.turns_in_range(&q);
    assert_eq!(all.len(), 64);
    assert!(all.iter().all(|t| machine.outside(t).is_none() && same(&machine, t, &q, 1e-12)));
}

/// Calibrated arms are not quite of the structure: they are solved by Newton's method, as exactly.
#[test]
fn an_arm_of_another_structure_is_solved_numerically() {
    let mut rows = UR10E;
    rows[2].alpha = 0.001;
    let machine = plain(&rows);
    assert!(!machine.has_free_roll() && machine.heads[0].is_numeric());
    let mut rows = OPW;
    rows[4].a = 0.01;
    assert!(!plain(&rows).has_free_roll());
}
