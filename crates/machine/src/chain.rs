use crate::AxisKind;
use glam::{DMat3, DQuat, DVec3};
use seamwright_geometry::Pose;

/// Most axes a machine may have.
pub const MAX_AXES: usize = 12;

/// Axis positions in machine-file order, mm or rad; entries beyond the machine's axes are 0.
pub type Joints = [f64; MAX_AXES];

/// The motion of one axis, seen in the work frame with all axes at zero.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Screw {
    /// Index of the axis in the machine file.
    pub(crate) axis: usize,
    pub(crate) kind: AxisKind,
    /// Unit direction of positive motion or turn of the torch relative to the work.
    pub(crate) direction: DVec3,
    /// A point on a rotary axis.
    pub(crate) at: DVec3,
}

/// The chain from the clamped work to the torch: a product of exponentials (Brockett 1984).
///
/// With all fixed displacements folded into where each axis lies at zero, the torch in the work frame is
/// `e^(S1 q1) e^(S2 q2) ... pose_at_zero`, the first screw being the one next to the work. A work-side axis enters
/// with its sense turned round, because it moves the work and not the torch.
#[derive(Debug, Clone, PartialEq)]
pub struct Chain {
    pub(crate) screws: Vec<Screw>,
    pub(crate) zero: Pose,
}

pub(crate) fn rotate(axis: DVec3, angle: f64, v: DVec3) -> DVec3 {
    // Rodrigues' formula.
    let (sin, cos) = angle.sin_cos();
    cos * v + sin * axis.cross(v) + (1.0 - cos) * axis.dot(v) * axis
}

impl Screw {
    pub(crate) fn move_point(&self, q: f64, p: DVec3) -> DVec3 {
        match self.kind {
            AxisKind::Linear => p + q * self.direction,
            AxisKind::Rotary => self.at + rotate(self.direction, q, p - self.at),
        }
    }

    pub(crate) fn turn_vector(&self, q: f64, v: DVec3) -> DVec3 {
        match self.kind {
            AxisKind::Linear => v,
            AxisKind::Rotary => rotate(self.direction, q, v),
        }
    }
}

impl Chain {
    /// Torch tip and direction (from the torch to the work) in the work frame at axis positions `q`.
    pub fn forward(&self, q: &Joints) -> Pose {
        let mut pose = self.zero;
        for screw in self.screws.iter().rev() {
            let value = q[screw.axis];
            match screw.kind {
                AxisKind::Linear => pose.point += value * screw.direction,
                AxisKind::Rotary => {
                    let (sin, cos) = value.sin_cos();
                    let w = screw.direction;
                    let turn = |v: DVec3| cos * v + sin * w.cross(v) + (1.0 - cos) * w.dot(v) * w;
                    pose.point = screw.at + turn(pose.point - screw.at);
                    pose.direction = turn(pose.direction);
                }
            }
        }
        pose
    }

    /// Columns of the Jacobian at `q`, by axis in machine-file order: change of the tip (mm) and of the direction
    /// per mm or rad of the axis.
    pub fn jacobian(&self, q: &Joints) -> [(DVec3, DVec3); MAX_AXES] {
        let tip = self.forward(q);
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
