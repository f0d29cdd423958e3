use glam::DVec3;

/// A point and a direction: where something is and where it points, without its turn about that direction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pose {
    /// Position, mm.
    pub point: DVec3,
    /// Unit vector.
    pub direction: DVec3,
}
