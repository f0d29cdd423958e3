use glam::DVec3;

/// A point and a direction; the rotation about that direction is not included.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pose {
    /// Position, mm.
    pub point: DVec3,
    /// Unit vector.
    pub direction: DVec3,
}

/// Angle between two unit vectors, rad, accurate at all angles.
pub fn angle_between(u: DVec3, v: DVec3) -> f64 {
    2.0 * (u - v).length().atan2((u + v).length())
}
