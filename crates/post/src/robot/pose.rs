use glam::{DAffine3, DQuat, DVec3};

/// Position (mm) and orientation of a frame in another one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RobotPose {
    /// Position, mm.
    pub point: DVec3,
    /// Orientation, a unit quaternion.
    pub turn: DQuat,
}

impl RobotPose {
    /// The frame without a displacement.
    pub const IDENTITY: Self = Self { point: DVec3::ZERO, turn: DQuat::IDENTITY };

    /// The pose of a rigid displacement.
    pub fn of(frame: &DAffine3) -> Self {
        let (_, turn, point) = frame.to_scale_rotation_translation();
        Self { point, turn: turn.normalize() }
    }

    /// The pose moved by a rigid displacement.
    pub(crate) fn moved(&self, by: &DAffine3) -> Self {
        let by = Self::of(by);
        Self { point: by.point + by.turn * self.point, turn: (by.turn * self.turn).normalize() }
    }

    /// Angle to the orientation of `other`, rad.
    pub fn angle_to(&self, other: &Self) -> f64 {
        let between = self.turn.inverse() * other.turn;
        2.0 * between.xyz().length().atan2(between.w.abs())
    }

    /// The pose at the fraction `f` of the straight way to `other`: the point goes evenly along the line, the orientation
    /// evenly about one fixed axis by the shorter way.
    pub fn towards(&self, other: &Self, f: f64) -> Self {
        Self { point: self.point.lerp(other.point, f), turn: shortest(self.turn, other.turn, f) }
    }

    /// True if all numbers are finite.
    pub fn is_finite(&self) -> bool {
        self.point.is_finite() && self.turn.is_finite()
    }
}

/// The orientation at the fraction `f` of the shortest rotation from `a` to `b`.
pub(super) fn shortest(a: DQuat, b: DQuat, f: f64) -> DQuat {
    let between = a.inverse() * b;
    let between = if between.w < 0.0 { -between } else { between };
    let half = between.xyz().length().atan2(between.w);
    let Some(axis) = between.xyz().try_normalize() else { return a };
    (a * DQuat::from_axis_angle(axis, 2.0 * half * f)).normalize()
}
