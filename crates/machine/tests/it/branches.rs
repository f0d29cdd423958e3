//! Every branch of the closed forms, against brute force on a grid of the rotary axes.

use crate::common::{conditioning, random_joints, same};
use glam::DVec3;
use seamwright_geometry::Pose;
use seamwright_machine::{AxisKind, Joints, Machine, SHIPPED};
use seamwright_testkit::Random;
use std::f64::consts::{PI, TAU};

/// The linear axes that best meet the point with the rotary axes as in `q`, and the remaining error: mm of the point
/// and 100 mm per rad of the direction. The tip is linear in these axes, so that differences are exact.
fn left_over(machine: &Machine, pose: &Pose, q: &Joints, linear: &[usize]) -> (Joints, f64) {
    let mut q = *q;
    linear.iter().for_each(|&i| q[i] = 0.0);
    let at_zero = machine.forward(&q);
    let columns: Vec<DVec3> = linear
        .iter()
        .map(|&i| {
            let mut moved = q;
            moved[i] = 1.0;
            machine.forward(&moved).point - at_zero.point
        })
        .collect();
    // Gauss-Seidel on the normal equations: slow, and independent of the code under test.
    let mut rest = pose.point - at_zero.point;
    for _ in 0..400 {
        for (&i, c) in linear.iter().zip(&columns) {
            let step = c.dot(rest) / c.length_squared();
            q[i] += step;
            rest -= step * *c;
        }
    }
    let direction = machine.forward(&q).direction - pose.direction;
    (q, rest.length().hypot(100.0 * direction.length()))
}

/// Descends from a point of the grid by shrinking steps along each rotary axis.
fn refine(
    machine: &Machine,
    pose: &Pose,
    start: Joints,
    linear: &[usize],
    rotary: &[usize],
    step: f64,
) -> (Joints, f64) {
    let (mut best, mut least) = left_over(machine, pose, &start, linear);
    let mut step = step;
    while step > 1e-12 {
        let mut better = false;
        let diagonal = rotary.len() == 2;
        let moves: &[(f64, f64)] = if diagonal {
            &[(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0), (0.7, 0.7), (0.7, -0.7), (-0.7, 0.7), (-0.7, -0.7)]
        } else {
            &[(1.0, 0.0), (-1.0, 0.0)]
        };
        for (a, b) in moves {
            let mut q = best;
            q[rotary[0]] += a * step;
            if diagonal {
                q[rotary[1]] += b * step;
            }
            let (q, left) = left_over(machine, pose, &q, linear);
            if left < least {
                (best, least, better) = (q, left, true);
            }
        }
        step *= if better { 1.0 } else { 0.5 };
    }
    (best, least)
}

fn by_brute_force(machine: &Machine, pose: &Pose, near: &Joints, linear: &[usize], rotary: &[usize]) -> Vec<Joints> {
    const N: usize = 36;
    let angle = |i: usize| TAU * i as f64 / N as f64 - PI;
    let second = if rotary.len() == 2 { N } else { 1 };
    let mut grid = vec![vec![(*near, 0.0); second]; N];
    for (i, row) in grid.iter_mut().enumerate() {
        for (j, cell) in row.iter_mut().enumerate() {
            let mut q = *near;
            q[rotary[0]] = angle(i);
            if rotary.len() == 2 {
                q[rotary[1]] = angle(j);
            }
            *cell = left_over(machine, pose, &q, linear);
        }
    }
    let mut found: Vec<Joints> = Vec::new();
    for i in 0..N {
        for j in 0..second {
            let here = grid[i][j].1;
            let around = (0..9).map(|k| (i + N + k / 3 - 1, j + second + k % 3 - 1));
            if around.into_iter().any(|(a, b)| grid[a % N][b % second].1 < here) {
                continue;
            }
            let (q, left) = refine(machine, pose, grid[i][j].0, linear, rotary, TAU / N as f64);
            if left < 1e-6 && !found.iter().any(|f| same(machine, f, &q, 1e-4)) {
                found.push(q);
            }
        }
    }
    found
}

#[test]
fn closed_forms_find_what_a_grid_finds() {
    for shipped in SHIPPED {
        let machine = Machine::read(shipped.name, shipped.text).unwrap();
        if machine.has_free_roll() {
            // Arms have tests of their own.
            continue;
        }
        let decided: Vec<usize> = machine.heads[0].chain.axes().iter().filter(|&i| !machine.free().has(i)).collect();
        let of_kind = |kind| decided.iter().copied().filter(|&i| machine.axes[i].kind == kind).collect::<Vec<_>>();
        let (linear, rotary) = (of_kind(AxisKind::Linear), of_kind(AxisKind::Rotary));
        if rotary.is_empty() {
            continue;
        }
        let mut random = Random::new(5);
        let mut compared = 0;
        for _ in 0..12 {
            let q = random_joints(&machine, &mut random);
            if conditioning(&machine, &q) < 0.05 {
                continue;
            }
            let pose = machine.forward(&q);
            let brute = by_brute_force(&machine, &pose, &q, &linear, &rotary);
            let branches = machine.inverse(pose, &q).unwrap();
            let exact: Vec<_> = branches.iter().filter(|b| b.attitude_error < 1e-9).collect();
            for b in &exact {
                assert!(brute.iter().any(|f| same(&machine, f, &b.joints, 1e-3)), "{}: invented", machine.name);
            }
            for f in &brute {
                assert!(exact.iter().any(|b| same(&machine, f, &b.joints, 1e-3)), "{}: missing {f:?}", machine.name);
            }
            compared += 1;
        }
        assert!(compared >= 8);
    }
}
