//! Inverse kinematics, chosen from the arrangement of the axes and not from a name: a closed form if the arrangement
//! has one, Newton's method otherwise.
//!
//! - **Closed form, general.** The torch direction is a product of rotations of a fixed vector: Paden-Kahan subproblems
//!   give the rotary axes (Murray, Li and Sastry, 1994), and a 3 x 3 system the linear ones.
//! - **Closed form, saddle welder** (SADDLE-2020): one rotary axis next to the work and a plane of two linear axes. The
//!   point gives the rotary axis; the direction is met as closely as possible.
//! - **Newton's method** (`numeric.rs`) for all other arrangements, with Levenberg and Marquardt's damping.

mod choice;
mod frame;
mod numeric;
mod plane_on_rotary;
mod rotaries;
mod three_linear;
mod two_linear;

use crate::chain::{AxisSet, Chain, Joints, Screw};
use crate::{Axis, AxisKind};
use arrayvec::ArrayVec;
pub(crate) use choice::spread;
pub(crate) use frame::{Frame, FrameInverse};
use glam::DVec3;
use numeric::Numeric;
use plane_on_rotary::PlaneOnRotary;
use seamwright_geometry::Pose;
use seamwright_message::{Message, Unit, display_by_message};
use std::ops::{Deref, DerefMut};
use three_linear::ThreeLinear;
use two_linear::TwoLinear;

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

/// Selection of branches.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Which {
    /// All.
    All,
    /// The one with the rotary axes nearest to their current positions, and possibly others.
    Nearest,
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
}

impl Branches {
    /// Removes the solution added last: its linear axes are flat.
    fn take_back(&mut self) {
        self.0.pop();
    }

    /// Returns the last `reason` as an error if no branch is left.
    fn any(&self, reason: Option<Unreachable>) -> Result<(), Unreachable> {
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
pub enum Unreachable {
    /// The two rotary axes cannot give the direction.
    Direction {
        /// Angle to the nearest direction, rad.
        by: f64,
    },
    /// The axes cannot reach the point.
    Point {
        /// Distance to the nearest point, mm.
        by: f64,
    },
    /// The linear axes do not span space at these rotary positions.
    Flat,
    /// Every branch takes a linear axis beyond its range.
    OutOfReach {
        /// Distance of the point beyond the reach of the linear axes, mm.
        by: f64,
        /// Name of the axis with the largest excess.
        axis: String,
        /// Its required position, mm.
        value: f64,
        /// Its excess over the limit, mm.
        beyond: f64,
        /// Its limit, mm.
        limit: f64,
    },
    /// Every branch puts an axis beyond its range.
    Range {
        /// Name of the axis.
        axis: String,
        /// Its required position, in the file's unit.
        value: f64,
        /// Its excess over the limit, in the file's unit.
        by: f64,
        /// The limit, in the file's unit.
        limit: f64,
        /// The file's unit: mm or degrees.
        unit: Unit,
    },
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

/// Inverse kinematics of a chain.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Inverse {
    /// Redundant axes, which keep their positions of `near`: a pose has five freedoms, and the chain more axes.
    pub(crate) held: AxisSet,
    form: Form,
}

#[derive(Debug, Clone, PartialEq)]
enum Form {
    ThreeLinear(ThreeLinear),
    PlaneOnRotary(PlaneOnRotary),
    TwoLinear(TwoLinear),
    Numeric(Numeric),
}

impl Inverse {
    /// Chooses from the arrangement of the axes: a closed form if one exists for the chain or for the chain with some
    /// axes held, else Newton's method.
    pub(crate) fn of(chain: &Chain, axes: &[Axis]) -> Self {
        let held = choice::held(chain, axes);
        let active = chain.holding(held, &home(axes));
        Self { held, form: Form::of(&active, axes) }
    }

    /// Chooses the same with the axes of `wanted` among the held ones, if the rest can still reach every pose.
    pub(crate) fn holding(chain: &Chain, axes: &[Axis], wanted: AxisSet) -> Option<Self> {
        let held = choice::held_with(chain, axes, wanted)?;
        let active = chain.holding(held, &home(axes));
        Some(Self { held, form: Form::of(&active, axes) })
    }

    /// True for Newton's method.
    pub(crate) fn is_numeric(&self) -> bool {
        matches!(self.form, Form::Numeric(_))
    }

    /// Code of the form's name.
    pub(crate) fn method(&self) -> &'static str {
        match self.form {
            Form::ThreeLinear(_) => "machine-method-closed",
            Form::PlaneOnRotary(_) => "machine-method-plane-on-rotary",
            Form::TwoLinear(_) => "machine-method-in-plane",
            Form::Numeric(_) => "machine-method-numeric",
        }
    }

    /// Adds every branch, or the one nearest to `near`, to `branches`; held axes keep their positions of `near`.
    pub(crate) fn solve(
        &self,
        chain: &Chain,
        pose: &Pose,
        near: &Joints,
        which: Which,
        branches: &mut Branches,
    ) -> Result<(), Unreachable> {
        if self.held.is_empty() {
            return self.form.solve(chain, pose, near, which, branches);
        }
        self.form.solve(&chain.holding(self.held, near), pose, near, which, branches)?;
        for solution in branches.iter_mut() {
            self.held.iter().for_each(|axis| solution.joints[axis] = near[axis]);
        }
        Ok(())
    }
}

impl Inverse {
    /// Adds the branches that Newton's method finds from each of `starts`; with a closed form, every branch. Held axes
    /// keep their positions of `near`.
    pub(crate) fn solve_from(
        &self,
        chain: &Chain,
        pose: &Pose,
        near: &Joints,
        starts: &[Joints],
        branches: &mut Branches,
    ) -> Result<(), Unreachable> {
        let Form::Numeric(form) = &self.form else { return self.solve(chain, pose, near, Which::All, branches) };
        form.solve_from(&chain.holding(self.held, near), pose, near, starts, branches)?;
        for solution in branches.iter_mut() {
            self.held.iter().for_each(|axis| solution.joints[axis] = near[axis]);
        }
        Ok(())
    }
}

impl Form {
    /// The closed form for the arrangement, or Newton's method. `chain` has no redundant axes.
    fn of(chain: &Chain, axes: &[Axis]) -> Self {
        let of_kind =
            |kind| -> Vec<usize> { (0..chain.screws.len()).filter(|&i| chain.screws[i].kind == kind).collect() };
        let (linear, rotary) = (of_kind(AxisKind::Linear), of_kind(AxisKind::Rotary));
        let closed = match (linear.as_slice(), rotary.as_slice()) {
            (&[a, b, c], rotary) if rotary.len() <= 2 => {
                ThreeLinear::new(chain, [a, b, c], rotary).map(Self::ThreeLinear)
            }
            (&[a, b], []) => TwoLinear::new(chain, [a, b]).map(Self::TwoLinear),
            (&[a, b], rotary) => PlaneOnRotary::new(chain, [a, b], rotary).map(Self::PlaneOnRotary),
            _ => None,
        };
        closed.unwrap_or_else(|| Self::Numeric(Numeric::new(axes)))
    }

    fn solve(
        &self,
        chain: &Chain,
        pose: &Pose,
        near: &Joints,
        which: Which,
        branches: &mut Branches,
    ) -> Result<(), Unreachable> {
        match self {
            Self::ThreeLinear(form) => form.solve(chain, pose, near, which, branches),
            Self::PlaneOnRotary(form) => form.solve(chain, pose, near, which, branches),
            Self::TwoLinear(form) => form.solve(chain, pose, branches),
            Self::Numeric(form) => match which {
                Which::Nearest if form.nearest(chain, pose, near, branches) => Ok(()),
                _ => form.solve(chain, pose, near, branches),
            },
        }
    }
}

/// A limit in the unit of a file, without the rounding of rad to degrees.
fn rounded(limit: f64) -> f64 {
    (limit * 1e9).round() / 1e9
}

/// Home positions of the axes.
fn home(axes: &[Axis]) -> Joints {
    std::array::from_fn(|i| axes.get(i).map_or(0.0, |a| a.home))
}

/// Positions of two linear axes along `a` and `b` that best give the displacement `d`, and the remainder.
pub(crate) fn in_plane(a: DVec3, b: DVec3, d: DVec3) -> (f64, f64, DVec3) {
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
