//! Rotations that carry one direction into another: Paden-Kahan subproblems 1 and 2 for free vectors
//! (Murray, Li, Sastry 1994, section 3.2), in general position.

use crate::chain::Turn;
use glam::DVec3;

/// A smaller part of a unit direction across an axis is rounding: the angle about the axis is free.
pub(crate) const FREE: f64 = 1e-12;

/// The turn about `axis` that brings `from` closest to `to`; none if either is parallel to the axis.
pub(crate) fn one(axis: DVec3, from: DVec3, to: DVec3) -> Option<Turn> {
    let (f, t) = (axis.cross(from), axis.cross(to));
    let free = f.length_squared() < FREE * FREE || t.length_squared() < FREE * FREE;
    (!free).then(|| Turn::along(axis.dot(f.cross(t)), f.dot(t)))
}

/// A pair of turns, the one next to the target first; `None` for a free turn.
pub(crate) type Pair = (Option<Turn>, Option<Turn>);

/// The pairs of turns (q1, q2) with `R(a, q1) R(b, q2) from = to`, for unit vectors.
///
/// Returns both pairs, or the angle (rad) by which the nearest direction misses.
pub(crate) fn two(a: DVec3, b: DVec3, from: DVec3, to: DVec3) -> Result<[Pair; 2], f64> {
    // z = R(b, q2) from = R(a, -q1) to lies on two circles: z = x a + y b + w a x b.
    let across = a.cross(b);
    let sin2 = across.length_squared();
    let cos = a.dot(b);
    let (along_a, along_b) = (a.dot(to), b.dot(from));
    let x = (along_a - cos * along_b) / sin2;
    let y = (along_b - cos * along_a) / sin2;
    let foot = x * a + y * b;
    // 1 - |foot|^2, in the form without cancellation if the foot is nearly a unit vector along a or b.
    let rest = (1.0 - foot.length()) * (1.0 + foot.length());
    // Rounding of the inputs may put the pose slightly beyond the last reachable direction.
    if rest < -1e-12 {
        return Err(nearest_miss(a, b, from, to));
    }
    let w = (rest.max(0.0) / sin2).sqrt();
    Ok([w, -w].map(|w| {
        let z = foot + w * across;
        (one(a, z, to), one(b, from, z))
    }))
}

/// Minimum angle between `to` and the directions that the two rotations can reach.
fn nearest_miss(a: DVec3, b: DVec3, from: DVec3, to: DVec3) -> f64 {
    // R(b, .) from makes an angle with `a` between |angle(a, b) - angle(b, from)| and their sum (reflected at pi).
    let angle = seamwright_geometry::angle_between;
    let (ab, bf, at) = (angle(a, b), angle(b, from), angle(a, to));
    let low = (ab - bf).abs();
    let high = (ab + bf).min(2.0 * std::f64::consts::PI - ab - bf);
    (low - at).max(at - high).max(0.0)
}
