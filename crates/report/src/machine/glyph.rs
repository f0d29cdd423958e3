//! Shapes of symbols as path data, px.

use crate::number::px;
use std::fmt::Write;

pub(super) type Point = (f64, f64);

pub(super) fn polyline(points: &[Point]) -> String {
    let mut d = String::new();
    for (i, (x, y)) in points.iter().enumerate() {
        let _ = write!(d, "{}{},{}", if i == 0 { 'M' } else { ' ' }, px(*x), px(*y));
    }
    d
}

/// Returns a filled arrow head with its tip at `tip`, pointing along the unit vector `way`.
pub(super) fn arrow_head(tip: Point, way: Point, length: f64) -> String {
    let across = (-way.1, way.0);
    let half = 0.42 * length;
    let foot = (tip.0 - length * way.0, tip.1 - length * way.1);
    let side = |s: f64| (foot.0 + s * half * across.0, foot.1 + s * half * across.1);
    polyline(&[tip, side(1.0), side(-1.0)]) + "z"
}

/// Returns a diagonal cross.
pub(super) fn cross(x: f64, y: f64, half: f64) -> String {
    let half = half * std::f64::consts::FRAC_1_SQRT_2;
    polyline(&[(x - half, y - half), (x + half, y + half)]) + &polyline(&[(x - half, y + half), (x + half, y - half)])
}

/// Returns two strokes across a line along `way`: the symbol for a continued line.
pub(super) fn zigzag(at: Point, way: Point) -> String {
    let across = (-way.1, way.0);
    let stroke = |by: f64| {
        let p = |s: f64| {
            (
                at.0 + by * way.0 + s * (6.0 * across.0 + 2.5 * way.0),
                at.1 + by * way.1 + s * (6.0 * across.1 + 2.5 * way.1),
            )
        };
        polyline(&[p(-1.0), p(1.0)])
    };
    stroke(-2.0) + &stroke(2.0)
}

/// Direction of an axis for a viewer: right, up, towards the viewer.
pub(super) type Seen = (f64, f64, f64);

/// Minimum component towards the viewer with which a rotation is drawn, so that its ring does not collapse to a line.
const MIN_TOWARDS: f64 = 0.36;

/// Returns three quarters of a turn by the right-hand rule about an axis through `centre`, its open quarter behind the
/// axis. Points in px, y down.
pub(super) fn turn(centre: Point, axis: Seen, radius: f64) -> Vec<Point> {
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
