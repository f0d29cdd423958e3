use crate::axis::AxisKind;
use arrayvec::ArrayVec;
use glam::{DAffine3, DMat3, DQuat, DVec2, DVec3};
use seamwright_geometry::Pose;

/// Maximum number of axes of a machine.
pub const MAX_AXES: usize = 12;

/// Axis positions in machine-file order, mm or rad; entries beyond the machine's axes are 0.
pub type Joints = [f64; MAX_AXES];

/// A set of axes, by index.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct AxisSet(u16);

impl AxisSet {
    /// The set with `axis` added.
    pub fn with(self, axis: usize) -> Self {
        Self(self.0 | 1 << axis)
    }

    /// True if `axis` is in the set.
    pub fn has(self, axis: usize) -> bool {
        self.0 >> axis & 1 == 1
    }

    /// True if the set is empty.
    pub fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// Axes that are in either set.
    pub fn union(self, other: Self) -> Self {
        Self(self.0 | other.0)
    }

    /// Axes that are in both sets.
    pub fn both(self, other: Self) -> Self {
        Self(self.0 & other.0)
    }

    /// Axes that are in one of two sets only.
    pub fn different(self, other: Self) -> Self {
        Self(self.0 ^ other.0)
    }

    /// The axes, increasing.
    pub fn iter(self) -> impl Iterator<Item = usize> {
        (0..MAX_AXES).filter(move |&a| self.has(a))
    }
}

impl FromIterator<usize> for AxisSet {
    fn from_iter<I: IntoIterator<Item = usize>>(axes: I) -> Self {
        axes.into_iter().fold(Self::default(), Self::with)
    }
}

/// The motion of one axis, seen in the work frame with all axes at zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Screw {
    pub(crate) axis: usize,
    pub(crate) kind: AxisKind,
    /// Unit direction of positive motion or turn of the torch relative to the work.
    pub(crate) direction: DVec3,
    /// A point on a rotary axis.
    pub(crate) at: DVec3,
}

/// The chain from the clamped work to the torch: a product of exponentials (Brockett 1984).
///
/// With all fixed displacements included in each axis' position at zero, the torch in the work frame is `e^(S1 q1)
/// e^(S2 q2) ... pose_at_zero`, the first screw being the one next to the work. A work-side axis enters with its sense
/// reversed, because it moves the work and not the torch.
#[derive(Debug, Clone, PartialEq)]
pub struct Chain {
    pub(crate) screws: ArrayVec<Screw, MAX_AXES>,
    pub(crate) zero: Pose,
    /// Unit direction across the torch at zero: that of its frame's x axis.
    pub(crate) across: DVec3,
}

/// A turn given by the sine and cosine of its angle: the inverse finds these first, and the angle last.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Turn {
    sin: f64,
    cos: f64,
}

impl Turn {
    pub(crate) const NONE: Self = Self { sin: 0.0, cos: 1.0 };

    pub(crate) fn by(angle: f64) -> Self {
        let (sin, cos) = angle.sin_cos();
        Self { sin, cos }
    }

    /// The turn with sine and cosine proportional to `sin` and `cos`, which must not both be 0.
    pub(crate) fn along(sin: f64, cos: f64) -> Self {
        let scale = 1.0 / (sin * sin + cos * cos).sqrt();
        Self { sin: sin * scale, cos: cos * scale }
    }

    /// The angle in (-pi, pi], rad.
    pub(crate) fn angle(self) -> f64 {
        self.sin.atan2(self.cos)
    }

    pub(crate) fn sin(self) -> f64 {
        self.sin
    }

    pub(crate) fn cos(self) -> f64 {
        self.cos
    }

    pub(crate) fn back(self) -> Self {
        Self { sin: -self.sin, ..self }
    }

    /// Cosine of the angle between two turns about the same axis.
    pub(crate) fn cosine_to(self, other: Self) -> f64 {
        self.cos * other.cos + self.sin * other.sin
    }

    /// This turn and then `other` about the same axis.
    pub(crate) fn and(self, other: Self) -> Self {
        Self { sin: self.sin * other.cos + self.cos * other.sin, cos: self.cos * other.cos - self.sin * other.sin }
    }

    /// `v` turned about the unit vector `axis` (Rodrigues' formula).
    pub(crate) fn of(self, axis: DVec3, v: DVec3) -> DVec3 {
        self.cos * v + self.sin * axis.cross(v) + (1.0 - self.cos) * axis.dot(v) * axis
    }

    /// `v` turned from x to y.
    pub(crate) fn of_plane(self, v: DVec2) -> DVec2 {
        self.cos * v + self.sin * v.perp()
    }

    /// The turn about the unit vector `axis` as a matrix.
    pub(crate) fn matrix(self, axis: DVec3) -> DMat3 {
        let (s, part) = (self.sin * axis, (1.0 - self.cos) * axis);
        DMat3::from_cols(
            part.x * axis + DVec3::new(self.cos, s.z, -s.y),
            part.y * axis + DVec3::new(-s.z, self.cos, s.x),
            part.z * axis + DVec3::new(s.y, -s.x, self.cos),
        )
    }
}

/// Turns of the rotary axes, in machine-file order.
pub(crate) type Turns = [Turn; MAX_AXES];

impl Screw {
    pub(crate) fn turn_point(&self, turn: Turn, p: DVec3) -> DVec3 {
        self.at + turn.of(self.direction, p - self.at)
    }
}

impl Chain {
    /// The axes of the chain.
    pub fn axes(&self) -> AxisSet {
        self.screws.iter().map(|s| s.axis).collect()
    }

    /// The chain with the axes of `held` fixed at their positions in `q`: their screws are removed, and their
    /// displacements are included in the zero pose.
    pub(crate) fn holding(&self, held: AxisSet, q: &Joints) -> Self {
        let mut moved = DAffine3::IDENTITY;
        let mut screws = ArrayVec::new();
        for screw in &self.screws {
            let here = Screw {
                direction: moved.transform_vector3(screw.direction),
                at: moved.transform_point3(screw.at),
                ..*screw
            };
            if held.has(screw.axis) {
                moved *= screw.displacement(q[screw.axis]);
            } else {
                screws.push(here);
            }
        }
        let zero = Pose {
            point: moved.transform_point3(self.zero.point),
            direction: moved.transform_vector3(self.zero.direction),
        };
        Self { screws, zero, across: moved.transform_vector3(self.across) }
    }

    /// Torch tip and direction at axis positions `q`, and the direction across the torch.
    pub(crate) fn frame(&self, q: &Joints) -> (Pose, DVec3) {
        let across = self.screws.iter().rev().filter(|s| s.kind == AxisKind::Rotary);
        let across = across.fold(self.across, |v, s| Turn::by(q[s.axis]).of(s.direction, v));
        (self.forward(q), across)
    }

    /// Torch tip and direction (from the torch to the work) in the work frame at axis positions `q`.
    pub fn forward(&self, q: &Joints) -> Pose {
        let mut turns = [Turn::NONE; MAX_AXES];
        for screw in self.screws.iter().filter(|s| s.kind == AxisKind::Rotary) {
            turns[screw.axis] = Turn::by(q[screw.axis]);
        }
        self.forward_turned(q, &turns)
    }

    /// The same with the rotary axes' turns instead of their positions.
    pub(crate) fn forward_turned(&self, q: &Joints, turns: &Turns) -> Pose {
        let mut pose = self.zero;
        for screw in self.screws.iter().rev() {
            match screw.kind {
                AxisKind::Linear => pose.point += q[screw.axis] * screw.direction,
                AxisKind::Rotary => {
                    let turn = turns[screw.axis];
                    pose.point = screw.turn_point(turn, pose.point);
                    pose.direction = turn.of(screw.direction, pose.direction);
                }
            }
        }
        pose
    }

    /// Columns of the Jacobian at `q`, by axis in machine-file order: change of the tip (mm) and of the direction
    /// per mm or rad of the axis.
    pub fn jacobian(&self, q: &Joints) -> [(DVec3, DVec3); MAX_AXES] {
        self.jacobian_at(q, &self.forward(q))
    }

    /// The same if the tip at `q` is known.
    pub(crate) fn jacobian_at(&self, q: &Joints, tip: &Pose) -> [(DVec3, DVec3); MAX_AXES] {
        let mut columns = [(DVec3::ZERO, DVec3::ZERO); MAX_AXES];
        let (mut turn, mut shift) = (DMat3::IDENTITY, DVec3::ZERO);
        for screw in &self.screws {
            let value = q[screw.axis];
            let direction = turn * screw.direction;
            match screw.kind {
                AxisKind::Linear => {
                    columns[screw.axis] = (direction, DVec3::ZERO);
                    shift += value * direction;
                }
                AxisKind::Rotary => {
                    let at = turn * screw.at + shift;
                    columns[screw.axis] = (direction.cross(tip.point - at), direction.cross(tip.direction));
                    turn *= DMat3::from_quat(DQuat::from_axis_angle(screw.direction, value));
                    shift = at - turn * screw.at;
                }
            }
        }
        columns
    }
}
