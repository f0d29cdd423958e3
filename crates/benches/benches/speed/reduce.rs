//! Polylines of a million points (but for the spiral) to lines and arcs, by both methods.

use crate::measure::time;
use glam::DVec3;
use seamwright_geometry::reduce::{Method, Tolerances, reduce};
use seamwright_testkit::Random;
use std::hint::black_box;

const POINTS: usize = 1_000_000;
const TOLERANCE: f64 = 0.01;

/// Lines and arcs of a thousand points each, noise a fifth of the tolerance.
fn mixed(count: usize) -> Vec<DVec3> {
    let mut random = Random::new(1);
    let (mut at, mut points) = (DVec3::ZERO, Vec::new());
    while points.len() < count {
        let (tangent, other) = (random.direction(), random.vector(1.0));
        let inward = tangent.cross(other).normalize();
        let radius = if random.yes() { 1e9 } else { random.within(20.0, 60.0) };
        let from = at;
        for i in 1..=1000 {
            let way = 0.1 * f64::from(i);
            let half = 0.5 * way / radius;
            at = from + 2.0 * radius * half.sin() * (half.cos() * tangent + half.sin() * inward);
            points.push(at + random.vector(0.2 * TOLERANCE / 3f64.sqrt()));
        }
    }
    points.truncate(count);
    points
}

fn line(count: usize) -> Vec<DVec3> {
    let mut random = Random::new(2);
    (0..count).map(|i| DVec3::new(0.01 * i as f64, 0.0, 0.0) + random.vector(0.4 * TOLERANCE)).collect()
}

fn circle(count: usize) -> Vec<DVec3> {
    let mut random = Random::new(3);
    let angle = |i: usize| std::f64::consts::TAU * i as f64 / (count - 1) as f64;
    let point = |i| 500.0 * DVec3::new(angle(i).cos(), angle(i).sin(), 0.0) + random.vector(0.2 * TOLERANCE);
    (0..count).map(point).collect()
}

/// A spiral that opens by 5 mm a turn, of exact points.
fn spiral(count: usize) -> Vec<DVec3> {
    let mut angle: f64 = 10.0;
    let next = |_| {
        let radius = 5.0 / std::f64::consts::TAU * angle;
        angle += 0.05 / radius;
        radius * DVec3::new(angle.cos(), angle.sin(), 0.0)
    };
    (0..count).map(next).collect()
}

fn walk(count: usize) -> Vec<DVec3> {
    let (mut random, mut at) = (Random::new(5), DVec3::ZERO);
    let step = |_| {
        at += random.vector(1.0);
        at
    };
    (0..count).map(step).collect()
}

pub(crate) fn benches() {
    let paths = [
        ("mixed", mixed(POINTS)),
        ("line", line(POINTS)),
        ("circle", circle(POINTS)),
        ("spiral of 100,000", spiral(POINTS / 10)),
        ("walk", walk(POINTS)),
    ];
    let tolerances = Tolerances { path_mm: TOLERANCE, columns: 1.0 };
    for (name, points) in paths {
        for (method, called) in [(Method::Greedy, "greedy"), (Method::Fewest, "fewest")] {
            time(&format!("reduce/{name}, {called}"), || reduce(black_box(&points), &[], tolerances, method));
        }
    }
}
