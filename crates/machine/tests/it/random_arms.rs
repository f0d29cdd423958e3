//! Random arms with a random tilt-turn positioner: spherical wrist, three parallel axes, six axes in any arrangement, seven
//! axes. What `arms` and `seven_axes` show of a few arms holds for a structure.

use crate::common::{random_joints, same};
use glam::{DVec3, dvec3};
use seamwright_machine::{Joints, Machine, Target};
use seamwright_testkit::{Random, cases};
use std::f64::consts::PI;

/// Smallest margin from the singular poses at which positions are expected back to 1e-7 rad.
const REGULAR: f64 = 0.01;

/// An axis of an arm: where it is with all axes at zero, mm.
struct Line {
    at: DVec3,
    along: DVec3,
}

fn line(at: DVec3, along: DVec3) -> Line {
    Line { at, along }
}

/// The machine file of an arm with these axes and a positioner.
fn with_positioner(lines: &[Line], random: &mut Random) -> Machine {
    let limits = "range_deg = [-175, 175]\nmax_speed_deg_s = 90\nmax_acceleration_deg_s2 = 300\n";
    let axis = |side: &str, name: &str, Line { at, along }: &Line| {
        let (at, along) = (at.to_array(), along.to_array());
        format!("[[{side}]]\naxis = \"{name}\"\nturn = {along:?}\nat_mm = {at:?}\n{limits}")
    };
    let mut text = "schema = 1\nname = \"arm\"\ntitle = \"arm\"\n".to_owned();
    for (i, line) in lines.iter().enumerate() {
        text += &axis("tool", &format!("j{}", i + 1), line);
    }
    let tip = lines.last().map_or(DVec3::ZERO, |last| last.at) + random.vector(200.0);
    let (turn, tip) = (random.direction().to_array(), tip.to_array());
    text += &format!("[[tool]]\nfixed = {{ move_mm = {tip:?}, turn = {turn:?}, angle_deg = 35 }}\n");
    text += "[torch]\ndirection = [0, 0, 1]\n";
    let beside = dvec3(900.0, 0.0, 100.0) + random.vector(200.0);
    text += &axis("work", "tilt", &line(beside, random.direction()));
    text += &axis("work", "turn", &line(beside + random.vector(100.0), random.direction()));
    Machine::read("arm.toml", &text).unwrap_or_else(|e| panic!("{e}\n{text}"))
}

/// A direction between 15 and 90 degrees off `axis`.
fn off(axis: DVec3, random: &mut Random) -> DVec3 {
    loop {
        let direction = random.direction();
        if direction.dot(axis).abs() < 15f64.to_radians().cos() {
            return direction;
        }
    }
}

/// Two parallel axes after the first, and the last three through a point.
fn spherical_wrist(random: &mut Random) -> Vec<Line> {
    let first = random.direction();
    let upper = off(first, random);
    let wrist = random.vector(900.0);
    let fourth = off(upper, random);
    let fifth = off(fourth, random);
    let sixth = off(fifth, random);
    vec![
        line(random.vector(300.0), first),
        line(random.vector(400.0), upper),
        line(random.vector(900.0), if random.yes() { upper } else { -upper }),
        line(wrist, fourth),
        line(wrist, fifth),
        line(wrist, sixth),
    ]
}

/// The axes 2 to 4 parallel, each later one through a point of the one before it.
fn three_parallel(random: &mut Random) -> Vec<Line> {
    let first = random.direction();
    let upper = off(first, random);
    let fourth = random.vector(900.0);
    // Only right angles have a closed form.
    let fifth = upper.cross(off(upper, random)).normalize();
    let sixth = fifth.cross(off(fifth, random)).normalize();
    vec![
        line(random.vector(300.0), first),
        line(random.vector(300.0), upper),
        line(random.vector(600.0), upper),
        line(fourth, upper),
        line(fourth, fifth),
        line(fourth + fifth * random.within(60.0, 200.0), sixth),
    ]
}

fn any_six(random: &mut Random) -> Vec<Line> {
    (0..6).map(|i| line(random.vector(300.0) + DVec3::X * 200.0 * f64::from(i), random.direction())).collect()
}

/// Shoulder and wrist of three axes through a point each, and an elbow.
fn seven(random: &mut Random) -> Vec<Line> {
    let (shoulder, wrist) = (random.vector(200.0), random.vector(200.0) + dvec3(0.0, 0.0, 900.0));
    let first = random.direction();
    let second = off(first, random);
    let third = off(second, random);
    let fourth = off(third, random);
    let fifth = off(fourth, random);
    let sixth = off(fifth, random);
    let seventh = off(sixth, random);
    vec![
        line(shoulder, first),
        line(shoulder, second),
        line(shoulder, third),
        line(random.vector(100.0) + dvec3(80.0, 0.0, 450.0), fourth),
        line(wrist, fifth),
        line(wrist, sixth),
        line(wrist, seventh),
    ]
}

type Kind = (&'static str, fn(&mut Random) -> Vec<Line>);
const KINDS: [Kind; 4] = [
    ("spherical wrist", spherical_wrist),
    ("three parallel axes", three_parallel),
    ("six axes in any arrangement", any_six),
    ("seven axes", seven),
];

/// Poses of 200 arms come back: all branches reach the frame, and the positions that made it are among them; with the
/// positioner and the free axes held.
#[test]
fn frames_come_back() {
    for (k, (name, kind)) in KINDS.into_iter().enumerate() {
        let (mut worst, mut regular, mut closed, mut arms) = ((0.0f64, 0.0f64), 0, 0, 0);
        for case in 0..cases(50) {
            let mut random = Random::of_case(1000 * k as u32 + case);
            let lines = kind(&mut random);
            let machine = with_positioner(&lines, &mut random);
            arms += 1;
            closed += u32::from(machine.arm_margins(&machine.home()).is_some());
            for _ in 0..40 {
                let q = random_joints(&machine, &mut random);
                let Some((off, turned, own)) = back(&machine, &q, &mut random) else { continue };
                worst = (worst.0.max(off), worst.1.max(turned));
                regular += 1;
                assert!(own, "{name} {case}: {q:?} is missing");
            }
        }
        // Axes in any arrangement have no closed form: Newton's method from the neighbour.
        assert_eq!(closed, if name.contains("any") { 0 } else { arms }, "{name}");
        assert!(worst.0 < 1e-8 && worst.1 < 1e-10 && regular > 15 * arms, "{name}: {worst:?}, {regular} of {arms}");
    }
}

/// Maximum error of the solutions of the frame at `q`: of the point (mm) and of the directions; and whether `q` is one of
/// them. None near singular poses.
fn back(machine: &Machine, q: &Joints, random: &mut Random) -> Option<(f64, f64, bool)> {
    let pose = machine.forward(q);
    let margins = machine.arm_margins(q);
    let (target, near) = match margins {
        Some(margins) if margins.min() < REGULAR => return None,
        Some(_) => {
            let mut near = random_joints(machine, random);
            machine.free().iter().for_each(|axis| near[axis] = q[axis]);
            (Target { across: Some(machine.across(q)), ..Target::from(pose) }, near)
        }
        None if crate::common::conditioning(machine, q) < 0.01 => return None,
        None => (Target::from(pose), *q),
    };
    let solutions = solutions(machine, target, &near)?;
    let mut worst = (0.0f64, 0.0f64);
    for joints in &solutions {
        let found = machine.forward(joints);
        let across = target.across.map_or(0.0, |across| (machine.across(joints) - across).length());
        worst.0 = worst.0.max((found.point - pose.point).length());
        worst.1 = worst.1.max((found.direction - pose.direction).length().max(across));
    }
    Some((worst.0, worst.1, solutions.iter().any(|joints| same(machine, joints, q, 1e-7))))
}

/// All branches of an arm in closed form; of others the neighbour.
fn solutions(machine: &Machine, target: Target, near: &Joints) -> Option<Vec<Joints>> {
    if target.across.is_none() {
        return Some(vec![machine.inverse_near(target, near).ok()?.joints]);
    }
    Some(machine.inverse(target, near).ok()?.iter().map(|branch| branch.joints).collect())
}

/// Along a line in the axes' space, half a degree a step, the neighbour of the last positions is found.
#[test]
fn the_neighbour_is_found_along_a_way() {
    for (k, (name, kind)) in KINDS.into_iter().enumerate() {
        let mut steps = 0;
        for case in 0..cases(50) {
            let mut random = Random::of_case(1000 * k as u32 + case);
            let lines = kind(&mut random);
            let machine = with_positioner(&lines, &mut random);
            let from = random_joints(&machine, &mut random);
            let by: Joints =
                std::array::from_fn(|i| if i < machine.axes.len() { random.within(-1.0, 1.0) } else { 0.0 });
            let mut last = from;
            for step in 0..40 {
                let q: Joints = std::array::from_fn(|i| from[i] + f64::from(step) * (0.5 * PI / 180.0) * by[i]);
                let inside = machine.axes.iter().zip(&q).all(|(a, q)| a.range.is_none_or(|(l, h)| (l..=h).contains(q)));
                let margins = machine.arm_margins(&q);
                let near_singular = match margins {
                    Some(margins) => margins.min() < 0.1,
                    None => crate::common::conditioning(&machine, &q) < 0.05,
                };
                if !inside || near_singular {
                    break;
                }
                // The free axes are given, as a planner gives them.
                let mut near = last;
                machine.free().iter().for_each(|axis| near[axis] = q[axis]);
                let across = margins.map(|_| machine.across(&q));
                let target = Target { across, ..Target::from(machine.forward(&q)) };
                let solutions = solutions(&machine, target, &near).unwrap_or_else(|| panic!("{name} {case}: {q:?}"));
                let apart = |s: &Joints| s.iter().zip(&near).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
                let nearest = solutions.iter().map(apart).fold(f64::INFINITY, f64::min);
                assert!(nearest <= apart(&q) + 1e-6, "{name} {case}, step {step}: {nearest} to the nearest of {q:?}");
                assert!(solutions.iter().any(|s| same(&machine, s, &q, 1e-6)), "{name} {case}, step {step}: {q:?}");
                last = q;
                steps += 1;
            }
        }
        assert!(steps > 500, "{name}: {steps}");
    }
}
