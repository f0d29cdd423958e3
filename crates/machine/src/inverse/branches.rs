//! Solutions of the inverse kinematics, and reasons for a missing one.

use crate::chain::{Chain, Joints};
use arrayvec::ArrayVec;
use glam::DVec3;
use seamwright_geometry::Pose;
use seamwright_message::{Message, Unit, display_by_message};
use std::ops::{Deref, DerefMut};

/// Positions that bring the torch to a pose.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Solution {
    /// Positions in machine-file order, mm or rad.
    pub joints: Joints,
    /// Angle between the requested and the reached direction, rad: 0 if the axes can reach any direction.
    pub attitude_error: f64,
    /// True if the pose leaves an axis free; it then keeps its position of `near`.
    pub singular: bool,
}

/// Maximum number of returned branches.
pub const MAX_BRANCHES: usize = 16;

#[derive(Debug, Clone, Copy)]
pub(crate) enum Which<'a> {
    All,
    /// The one with the rotary axes nearest to their current positions, and possibly others.
    Nearest,
    /// Those that Newton's method finds from these positions; with a closed form, all.
    From(&'a [Joints]),
}

/// A pose that a chain is to reach; held axes, and those that a singular pose leaves free, keep their positions of
/// `near`.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Query<'a> {
    pub(crate) chain: &'a Chain,
    pub(crate) pose: &'a Pose,
    /// Wanted direction across the torch: only arms that leave the rotation about the torch free regard it.
    pub(crate) across: Option<DVec3>,
    /// Wanted arm angle, rad: only seven-axis arms regard it; without it their third axis keeps its position.
    pub(crate) arm_angle: Option<f64>,
    pub(crate) near: &'a Joints,
    pub(crate) which: Which<'a>,
}

/// Branches of solutions, at least one.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Branches(ArrayVec<Solution, MAX_BRANCHES>);

impl Branches {
    /// The single branch `solution`.
    pub fn one(solution: Solution) -> Self {
        Self(std::iter::once(solution).collect())
    }

    /// Adds a zero solution to fill in place, because copying costs as much as solving.
    pub(crate) fn add(&mut self) -> &mut Solution {
        let at = self.0.len().min(MAX_BRANCHES - 1);
        self.0.truncate(at);
        self.0.push(Solution { joints: Joints::default(), attitude_error: 0.0, singular: false });
        &mut self.0[at]
    }

    /// Removes the solution added last: its linear axes are flat.
    pub(super) fn take_back(&mut self) {
        self.0.pop();
    }

    /// Returns the last `reason` as an error if no branch is left.
    pub(super) fn any(&self, reason: Option<Unreachable>) -> Result<(), Unreachable> {
        if self.0.is_empty() { Err(reason.unwrap_or(Unreachable::Flat)) } else { Ok(()) }
    }
}

impl Deref for Branches {
    type Target = [Solution];
    fn deref(&self) -> &[Solution] {
        &self.0
    }
}

impl DerefMut for Branches {
    fn deref_mut(&mut self) -> &mut [Solution] {
        &mut self.0
    }
}

/// Reason why no axis positions reach a pose; lengths in mm, angles in rad.
#[derive(Debug, Clone, PartialEq)]
#[allow(missing_docs, reason = "the fields say what they are")]
pub enum Unreachable {
    /// The two rotary axes cannot give the direction: the angle to the nearest one, rad.
    Direction { by: f64 },
    /// The axes cannot reach the point: the distance to the nearest one, mm.
    Point { by: f64 },
    /// The linear axes do not span space at these rotary positions.
    Flat,
    /// Every branch takes a linear axis beyond its range: the distance of the point beyond the reach, and the axis with
    /// the largest excess, its required position, excess and limit, mm.
    OutOfReach { by: f64, axis: String, value: f64, beyond: f64, limit: f64 },
    /// Every branch puts an axis beyond its range: its required position, excess and limit in the unit of files.
    Range { axis: String, value: f64, by: f64, limit: f64, unit: Unit },
    /// The machine's two heads cannot reach both points.
    Pair(PairFault),
}

/// Reason why two heads cannot be at two poses at once.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum PairFault {
    /// The machine has no suitable axes that carry both heads.
    Axes,
    /// Both torches are at one point.
    SamePoint,
    /// The torches point at each other.
    Opposed,
}

display_by_message!(Unreachable);

impl Unreachable {
    /// Describes the reason.
    pub fn message(&self) -> Message {
        match self {
            Self::Direction { by } => {
                Message::new("machine-unreachable-direction").quantity("angle", by.to_degrees(), Unit::Deg, 4)
            }
            Self::Point { by } => Message::new("machine-unreachable-point").quantity("distance", *by, Unit::Mm, 4),
            Self::Flat => Message::new("machine-unreachable-flat"),
            Self::OutOfReach { by, axis, value, beyond, limit } => Message::new("machine-out-of-reach")
                .quantity("distance", *by, Unit::Mm, 3)
                .axis("axis", axis)
                .quantity("position", *value, Unit::Mm, 6)
                .quantity("excess", *beyond, Unit::Mm, 6)
                .value("limit", rounded(*limit), Unit::Mm),
            Self::Range { axis, value, by, limit, unit } => Message::new("machine-axis-out-of-range")
                .axis("axis", axis)
                .quantity("position", *value, *unit, 6)
                .quantity("excess", *by, *unit, 6)
                .value("limit", rounded(*limit), *unit),
            Self::Pair(fault) => Message::new(match fault {
                PairFault::Axes => "machine-pair-axes",
                PairFault::SamePoint => "machine-pair-same-point",
                PairFault::Opposed => "machine-pair-opposed",
            }),
        }
    }

    /// Distance from reachability, in mm or degrees, to compare reasons of one machine.
    pub(crate) fn by(&self) -> f64 {
        match self {
            Self::Range { by, .. } | Self::OutOfReach { by, .. } => *by,
            // A pose out of reach counts as farther than any out of range.
            Self::Direction { by } => 1e4 + by.to_degrees(),
            Self::Point { by } => 1e4 + by,
            Self::Flat | Self::Pair(_) => f64::INFINITY,
        }
    }
}

/// A limit in the unit of a file, without the rounding of rad to degrees.
fn rounded(limit: f64) -> f64 {
    (limit * 1e9).round() / 1e9
}
