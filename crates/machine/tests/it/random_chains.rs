//! Random chains of 2 to 10 axes in any arrangement: round trip, Jacobian, and branches against brute force.

use crate::common::{conditioning, random_chain, random_joints, same};
use seamwright_machine::{Joints, Machine, Unreachable};
use seamwright_testkit::{Random, cases};

/// Maximum volume of five unit columns at which a pose counts as near a singular one.
const SINGULAR: f64 = 1e-3;

fn chains() -> impl Iterator<Item = (u32, Machine)> {
    (0..cases(200)).map(|seed| {
        let mut random = Random::of_case(seed);
        let count = 2 + seed % 9;
        let machine = Machine::read("random.toml", &random_chain(&mut random, count)).unwrap_or_else(|e| panic!("{e}"));
        (seed, machine)
    })
}

/// Start of the inverse: the redundant axes as in `q`, the others at home.
fn from_home(machine: &Machine, q: &Joints) -> Joints {
    let mut near = machine.home();
    machine.free().iter().for_each(|axis| near[axis] = q[axis]);
    near
}

#[test]
fn poses_come_back() {
    let (mut point, mut direction, mut jacobian, mut poses) = (0.0f64, 0.0f64, 0.0f64, 0);
    for (seed, machine) in chains() {
        let mut random = Random::of_case(seed + 1_000_000);
        for _ in 0..100 {
            let q = random_joints(&machine, &mut random);
            jacobian = jacobian.max(jacobian_error(&machine, &q));
            if conditioning(&machine, &q) < SINGULAR {
                continue;
            }
            poses += 1;
            let pose = machine.forward(&q);
            let near = machine.inverse_near(pose, &q).unwrap_or_else(|e| panic!("{seed}: {e}"));
            assert!(same(&machine, &near.joints, &q, 1e-6), "{seed}: the neighbour is itself");
            let again = machine.forward(&near.joints);
            point = point.max((again.point - pose.point).length());
            direction = direction.max((again.direction - pose.direction).length().to_degrees());
        }
    }
    assert!(point <= 1e-9 && direction <= 1e-9 && jacobian <= 1e-6 && poses > 10_000);
}

/// Maximum relative difference of the Jacobian from central differences.
fn jacobian_error(machine: &Machine, q: &Joints) -> f64 {
    let columns = machine.jacobian(q);
    let mut worst = 0.0f64;
    for (i, column) in columns.iter().enumerate().take(machine.axes.len()) {
        let h = 1e-4;
        let moved = |d: f64| {
            let mut q = *q;
            q[i] += d;
            machine.forward(&q)
        };
        let (l, r) = (moved(-h), moved(h));
        let point = (r.point - l.point) / (2.0 * h) - column.0;
        let direction = (r.direction - l.direction) / (2.0 * h) - column.1;
        worst = worst.max(point.length() / column.0.length().max(1.0)).max(direction.length());
    }
    worst
}

/// Every branch is found: the original positions of the pose are among the solutions from elsewhere, and all solutions
/// reach the pose.
#[test]
fn the_branch_a_pose_was_made_with_is_found() {
    let (mut asked, mut missing) = (0, Vec::new());
    for (seed, machine) in chains() {
        let mut random = Random::of_case(seed + 2_000_000);
        for _ in 0..3 {
            let q = random_joints(&machine, &mut random);
            if conditioning(&machine, &q) < 0.02 {
                continue;
            }
            let pose = machine.forward(&q);
            asked += 1;
            match machine.inverse(pose, &from_home(&machine, &q)) {
                Ok(branches) => {
                    for b in branches.iter().filter(|b| b.attitude_error < 1e-9) {
                        let again = machine.forward(&b.joints);
                        assert!((again.point - pose.point).length() < 1e-7, "{seed}");
                        assert!((again.direction - pose.direction).length() < 1e-9, "{seed}");
                    }
                    if !branches.iter().any(|b| same(&machine, &b.joints, &q, 1e-5)) {
                        missing.push(seed);
                    }
                }
                Err(e) => {
                    assert!(!matches!(e, Unreachable::Pair(_)), "{seed}: {e}");
                    missing.push(seed);
                }
            }
        }
    }
    assert!(asked > cases(300) && missing.is_empty(), "missing on chains {missing:?}");
}
