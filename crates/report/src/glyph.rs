//! Shapes of symbols as path data, px.

use crate::number::px;
use std::fmt::Write;

pub(crate) type Point = (f64, f64);

/// Returns a line through the points; empty without any.
pub(crate) fn polyline(points: &[Point]) -> String {
    let mut d = String::new();
    for (i, (x, y)) in points.iter().enumerate() {
        // Writing to a String cannot fail.
        let _ = write!(d, "{}{},{}", if i == 0 { 'M' } else { ' ' }, px(*x), px(*y));
    }
    d
}

/// Returns the outline of an area; empty without any point.
pub(crate) fn closed(points: &[Point]) -> String {
    if points.is_empty() { String::new() } else { polyline(points) + "Z" }
}

pub(crate) fn distance(a: Point, b: Point) -> f64 {
    (b.0 - a.0).hypot(b.1 - a.1)
}

pub(crate) fn unit(v: Point) -> Point {
    let length = v.0.hypot(v.1).max(1e-12);
    (v.0 / length, v.1 / length)
}

pub(crate) fn shifted(p: Point, way: Point, by: f64) -> Point {
    (p.0 + by * way.0, p.1 + by * way.1)
}

/// Returns a filled arrow head with its tip at `tip`, pointing along the unit vector `way`.
pub(crate) fn arrow_head(tip: Point, way: Point, length: f64) -> String {
    let foot = shifted(tip, way, -length);
    let side = |by: f64| shifted(foot, (-way.1, way.0), by * 0.42 * length);
    polyline(&[tip, side(1.0), side(-1.0)]) + "z"
}

pub(crate) fn cross(x: f64, y: f64, half: f64) -> String {
    let half = half * std::f64::consts::FRAC_1_SQRT_2;
    polyline(&[(x - half, y - half), (x + half, y + half)]) + &polyline(&[(x - half, y + half), (x + half, y - half)])
}

/// Returns two strokes across a line along `way`: the symbol for a continued line.
pub(crate) fn zigzag(at: Point, way: Point) -> String {
    let slanted = (2.5 * way.0 - 6.0 * way.1, 2.5 * way.1 + 6.0 * way.0);
    let stroke = |by: f64| polyline(&[-1.0, 1.0].map(|side| shifted(shifted(at, way, by), slanted, side)));
    stroke(-2.0) + &stroke(2.0)
}

/// Direction of an axis for a viewer: right, up, towards the viewer.
pub(crate) type Seen = (f64, f64, f64);

/// Minimum component towards the viewer with which a rotation is drawn, so that its ring does not collapse to a line.
const MIN_TOWARDS: f64 = 0.36;

/// Returns three quarters of a turn by the right-hand rule about an axis through `centre`, its open quarter behind the
/// axis. Points in px, y down.
pub(crate) fn turn(centre: Point, axis: Seen, radius: f64) -> Vec<Point> {
    let (mut u, mut v, mut w) = axis;
    let flat = u.hypot(v);
    if w.abs() < MIN_TOWARDS {
        w = if w < 0.0 { -MIN_TOWARDS } else { MIN_TOWARDS };
        let scale = (1.0 - w * w).sqrt() / flat.max(1e-9);
        (u, v) = (u * scale, v * scale);
    }
    // Two directions perpendicular to the axis and to each other, the first in the plane of the view.
    let flat = u.hypot(v);
    let first = if flat > 1e-6 { (-v / flat, u / flat) } else { (1.0, 0.0) };
    // Cross product of axis and `first`.
    let second = (-w * first.1, w * first.0);
    let point = |degrees: f64| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        let (x, y) = (cos * first.0 + sin * second.0, cos * first.1 + sin * second.1);
        (centre.0 + radius * x, centre.1 - radius * y)
    };
    (0..=36).map(|i| point(-45.0 + 7.5 * f64::from(i))).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Returns the area enclosed by the arc and its chord, positive if counter-clockwise for the viewer.
    fn sense(points: &[Point]) -> f64 {
        let closed = points.iter().zip(points.iter().cycle().skip(1));
        closed.map(|(a, b)| 0.5 * (b.0 * a.1 - a.0 * b.1)).sum::<f64>()
    }

    #[test]
    fn turns_follow_the_right_hand() {
        assert!(sense(&turn((50.0, 50.0), (0.0, 0.0, 1.0), 20.0)) > 900.0);
        assert!(sense(&turn((50.0, 50.0), (0.0, 0.0, -1.0), 20.0)) < -900.0);
        // About an axis to the right, the part facing the viewer (t = 45 to 135 degrees, the middle) moves down.
        let points = turn((0.0, 0.0), (1.0, 0.0, 0.0), 20.0);
        assert!(points[22].1 > points[14].1, "{points:?}");
        // About an axis up, it moves to the right.
        let points = turn((0.0, 0.0), (0.0, 1.0, 0.0), 20.0);
        assert!(points[22].0 > points[14].0, "{points:?}");
        let points = turn((0.0, 0.0), (0.0, -1.0, 0.0), 20.0);
        assert!(points[22].0 < points[14].0, "{points:?}");
    }
}
