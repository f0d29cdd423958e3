use super::super::rotaries;
use crate::chain::Turn;
use arrayvec::ArrayVec;
use glam::{DMat3, DVec3};
use std::f64::consts::PI;

/// Sine of the wrist's angle below which its first and last axis are parallel: the first then keeps its position.
pub(super) const ALIGNED: f64 = 1e-12;
/// Cosine of two axes below which they are perpendicular.
const SQUARE: f64 = 1e-9;

/// Three axes through one point, which give every orientation.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Wrist {
    /// Neighbouring axes are perpendicular: the angles are Euler angles.
    Square(Square),
    /// Any other angle between the axes.
    Oblique([DVec3; 3]),
}

/// Euler angles z, y, z of `from^T R to`.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Square {
    from: DMat3,
    to: DMat3,
    /// Angle of the second axis from its position with the other two aligned, with all axes at zero, rad.
    zero: f64,
}

/// Positions of the three axes, rad.
#[derive(Debug, Clone, Copy)]
pub(super) struct WristAngles {
    pub(super) angles: [f64; 3],
    pub(super) aligned: bool,
}

impl Wrist {
    /// A wrist of axes with directions `[a, b, c]`; none if neighbours are parallel.
    pub(super) fn new([a, b, c]: [DVec3; 3]) -> Option<Self> {
        if a.cross(b).length() < 1e-6 || b.cross(c).length() < 1e-6 {
            return None;
        }
        if a.dot(b).abs() > SQUARE || b.dot(c).abs() > SQUARE {
            return Some(Self::Oblique([a, b, c]));
        }
        let from = DMat3::from_cols(b.cross(a).normalize(), b, a);
        let zero = Turn::along(c.dot(from.x_axis), c.dot(a));
        let to = DMat3::from_cols(zero.of(b, from.x_axis), b, zero.of(b, a));
        Some(Self::Square(Square { from, to, zero: zero.angle() }))
    }

    /// Angles of the axes that turn the flange by `rotation` from its orientation at zero; none if an oblique wrist
    /// cannot. A free first axis is at `near`.
    pub(super) fn solve(&self, rotation: &DMat3, near: f64) -> ArrayVec<WristAngles, 2> {
        match self {
            Self::Square(square) => square.solve(rotation, near),
            Self::Oblique(axes) => oblique(*axes, rotation, near),
        }
    }

    /// Signed angle (rad, -pi to pi) of the second axis from alignment of the other two, at position `second`.
    pub(super) fn bend(&self, second: f64) -> f64 {
        match self {
            Self::Square(square) => {
                let turn = Turn::by(second + square.zero);
                turn.angle()
            }
            Self::Oblique([a, b, c]) => {
                let turned = Turn::by(second).of(*b, *c);
                let angle = a.cross(turned).length().atan2(a.dot(turned));
                angle.copysign(b.dot(a.cross(turned)))
            }
        }
    }
}

impl Square {
    fn solve(&self, rotation: &DMat3, near: f64) -> ArrayVec<WristAngles, 2> {
        let n = self.from.transpose() * (*rotation * self.to);
        let (x, y, cos) = (n.z_axis.x, n.z_axis.y, n.z_axis.z);
        let sine = x.hypot(y);
        let aligned = sine < ALIGNED;
        let first = if aligned { Turn::by(near) } else { Turn::along(y, x) };
        let (s, c) = (first.sin(), first.cos());
        // The rest is a turn about y and one about z.
        let bend = (c * x + s * y).atan2(cos);
        let last = (c * n.x_axis.y - s * n.x_axis.x).atan2(c * n.y_axis.y - s * n.y_axis.x);
        let first = if aligned { near } else { first.angle() };
        let mut found = ArrayVec::new();
        found.push(WristAngles { angles: [first, bend - self.zero, last], aligned });
        if !aligned {
            found.push(WristAngles { angles: [first + PI, -bend - self.zero, last + PI], aligned });
        }
        found
    }
}

fn oblique([a, b, c]: [DVec3; 3], rotation: &DMat3, near: f64) -> ArrayVec<WristAngles, 2> {
    let mut found: ArrayVec<WristAngles, 2> = ArrayVec::new();
    let Ok(pairs) = rotaries::two(a, b, c, *rotation * c) else { return found };
    let across = c.any_orthonormal_vector();
    for (first, second) in pairs {
        let aligned = first.is_none();
        let (first, second) = (first.unwrap_or_else(|| Turn::by(near)), second.unwrap_or(Turn::NONE));
        let last = rotaries::one(c, across, second.back().of(b, first.back().of(a, *rotation * across)));
        let angles = [if aligned { near } else { first.angle() }, second.angle(), last.map_or(0.0, Turn::angle)];
        found.push(WristAngles { angles, aligned });
        if aligned {
            break;
        }
    }
    found
}
