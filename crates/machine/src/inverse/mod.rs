//! Inverse kinematics in closed form, chosen from the arrangement of the axes and not from a name.

mod plane_on_rotary;
mod rotaries;
mod three_linear;
mod two_linear;

use crate::AxisKind;
use crate::chain::{Chain, Joints, Screw};
use glam::DVec3;
use plane_on_rotary::PlaneOnRotary;
use seamwright_geometry::Pose;
use std::ops::{Deref, DerefMut};
use thiserror::Error;
use three_linear::ThreeLinear;
use two_linear::TwoLinear;

/// Positions that bring the torch to a pose.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Solution {
    /// Positions in machine-file order, mm or rad.
    pub joints: Joints,
    /// Angle between the direction asked for and the one reached, rad: 0 where the axes can give any direction.
    pub attitude_error: f64,
    /// True if an axis is left free by the pose; it then stands as in `near`.
    pub singular: bool,
}

/// One or two branches of solutions.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Branches {
    solutions: [Solution; 2],
    count: usize,
}

impl Branches {
    pub(crate) fn new() -> Self {
        let none = Solution { joints: Joints::default(), attitude_error: 0.0, singular: false };
        Self { solutions: [none; 2], count: 0 }
    }

    /// Room for one more solution, all zero: filled in place, because copying costs as much as solving.
    fn add(&mut self) -> &mut Solution {
        self.count += 1;
        &mut self.solutions[self.count - 1]
    }
}

impl Deref for Branches {
    type Target = [Solution];
    fn deref(&self) -> &[Solution] {
        &self.solutions[..self.count]
    }
}

impl DerefMut for Branches {
    fn deref_mut(&mut self) -> &mut [Solution] {
        &mut self.solutions[..self.count]
    }
}

/// Why no axis positions reach a pose; lengths in mm, angles in rad.
#[derive(Debug, Clone, Copy, PartialEq, Error)]
pub enum Unreachable {
    /// The two rotary axes cannot give the direction.
    #[error("the rotary axes cannot turn the torch that way; the nearest direction is {:.4} degrees off", by.to_degrees())]
    Direction {
        /// Angle to the nearest direction, rad.
        by: f64,
    },
    /// The axes cannot reach the point.
    #[error("the axes cannot reach the point; it is {by:.4} mm off")]
    Point {
        /// Distance to the nearest point, mm.
        by: f64,
    },
    /// The linear axes do not span space at these rotary positions.
    #[error("the linear axes are parallel to a plane at these rotary positions")]
    Flat,
    /// The machine's axes have an arrangement without a closed form here.
    #[error(
        "this arrangement of axes has no closed-form inverse yet; there is one for three linear axes with up to two rotary ones, two linear axes alone, and two linear axes on a rotary one with or without a tilt across them"
    )]
    NoClosedForm,
}

/// The arrangements that are solved in closed form.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum ClosedForm {
    ThreeLinear(ThreeLinear),
    PlaneOnRotary(PlaneOnRotary),
    TwoLinear(TwoLinear),
}

impl ClosedForm {
    /// The closed form for the chain's arrangement, if there is one.
    pub(crate) fn of(chain: &Chain) -> Option<Self> {
        let of_kind =
            |kind| -> Vec<usize> { (0..chain.screws.len()).filter(|&i| chain.screws[i].kind == kind).collect() };
        let (linear, rotary) = (of_kind(AxisKind::Linear), of_kind(AxisKind::Rotary));
        match (linear.as_slice(), rotary.as_slice()) {
            (&[a, b, c], rotary) if rotary.len() <= 2 => {
                ThreeLinear::new(chain, [a, b, c], rotary).map(Self::ThreeLinear)
            }
            (&[a, b], []) => TwoLinear::new(chain, [a, b]).map(Self::TwoLinear),
            (&[a, b], rotary) => PlaneOnRotary::new(chain, [a, b], rotary).map(Self::PlaneOnRotary),
            _ => None,
        }
    }

    /// Adds every branch to `branches`.
    pub(crate) fn solve(
        &self,
        chain: &Chain,
        pose: &Pose,
        near: &Joints,
        branches: &mut Branches,
    ) -> Result<(), Unreachable> {
        match self {
            Self::ThreeLinear(form) => form.solve(chain, pose, near, branches),
            Self::PlaneOnRotary(form) => form.solve(chain, pose, near, branches),
            Self::TwoLinear(form) => form.solve(chain, pose, branches),
        }
    }
}

/// Angle between two unit vectors, rad, accurate at all angles.
fn angle_between(u: DVec3, v: DVec3) -> f64 {
    2.0 * (u - v).length().atan2((u + v).length())
}

/// Positions of two linear axes along `a` and `b` that best give the displacement `d`, and what is left over.
fn in_plane(a: DVec3, b: DVec3, d: DVec3) -> (f64, f64, DVec3) {
    let (aa, ab, bb) = (a.dot(a), a.dot(b), b.dot(b));
    let determinant = aa * bb - ab * ab;
    let (ad, bd) = (a.dot(d), b.dot(d));
    let x = (bb * ad - ab * bd) / determinant;
    let y = (aa * bd - ab * ad) / determinant;
    (x, y, d - x * a - y * b)
}

/// True if two directions span a plane.
fn independent(a: &Screw, b: &Screw) -> bool {
    a.direction.cross(b.direction).length() > 1e-6
}
