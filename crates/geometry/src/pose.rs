use glam::DVec3;

/// A point and a direction; the rotation about that direction is not included.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pose {
    /// Position, mm.
    pub point: DVec3,
    /// Unit vector.
    pub direction: DVec3,
}
