use crate::chain::Screw;
use glam::DVec3;

/// Positions of two linear axes along `a` and `b` that best give the displacement `d`, and the remainder.
pub(crate) fn in_plane(a: DVec3, b: DVec3, d: DVec3) -> (f64, f64, DVec3) {
    let (aa, ab, bb) = (a.dot(a), a.dot(b), b.dot(b));
    let determinant = aa * bb - ab * ab;
    let (ad, bd) = (a.dot(d), b.dot(d));
    let x = (bb * ad - ab * bd) / determinant;
    let y = (aa * bd - ab * ad) / determinant;
    (x, y, d - x * a - y * b)
}

/// True if two directions span a plane.
pub(super) fn independent(a: &Screw, b: &Screw) -> bool {
    a.direction.cross(b.direction).length() > 1e-6
}
