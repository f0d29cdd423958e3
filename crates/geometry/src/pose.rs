use glam::DVec3;

/// A point and a direction; the rotation about that direction is not included.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pose {
    /// Position, mm.
    pub point: DVec3,
    /// Unit vector.
    pub direction: DVec3,
}

impl Pose {
    /// The pose moved along its direction by `distance`, mm.
    #[must_use]
    pub fn ahead(self, distance: f64) -> Self {
        Self { point: self.point + distance * self.direction, ..self }
    }
}

/// Angle between two unit vectors, rad, accurate at all angles.
pub fn angle_between(u: DVec3, v: DVec3) -> f64 {
    2.0 * (u - v).length().atan2((u + v).length())
}
