//! Independent values by brute force.

use glam::DVec3;
use seamwright_geometry::numeric::bisect;
use std::f64::consts::TAU;

/// Heights along a line at which it is searched for a body.
pub(crate) struct Heights {
    pub(crate) from: f64,
    pub(crate) to: f64,
    pub(crate) steps: i32,
}

/// The first point of a line inside a body, where `level` is negative: in steps along its heights, then by bisection.
/// None if it starts inside.
pub(crate) fn first_inside(level: impl Fn(DVec3) -> f64, foot: DVec3, d: DVec3, heights: &Heights) -> Option<DVec3> {
    let at = |i: i32| heights.from + (heights.to - heights.from) * f64::from(i) / f64::from(heights.steps);
    let is_inside = |h: f64| level(foot + h * d) < 0.0;
    let first = (0..=heights.steps).find(|i| is_inside(at(*i))).filter(|i| *i > 0)?;
    Some(foot + bisect(at(first), at(first - 1), 80, is_inside).0 * d)
}

/// Length of a closed curve over a turn: by chords, extrapolated to chords of no length; and the last correction.
pub(crate) fn length(point: impl Fn(f64) -> DVec3, chords: u32) -> (f64, f64) {
    let sum = |n: u32| {
        let at = |i: u32| point(TAU * f64::from(i) / f64::from(n));
        (0..n).map(|i| at(i).distance(at(i + 1))).sum::<f64>()
    };
    let (some, more) = (sum(chords), sum(2 * chords));
    (more + (more - some) / 3.0, more - some)
}
