//! Inverse kinematics, chosen from the arrangement of the axes and not from a name: a closed form if the arrangement
//! has one, Newton's method otherwise.
//!
//! - **Closed form, general.** The torch direction is a product of rotations of a fixed vector: Paden-Kahan subproblems
//!   give the rotary axes (Murray, Li and Sastry, 1994), and a 3 x 3 system the linear ones.
//! - **Closed form, saddle welder** (SADDLE-2020): one rotary axis next to the work and a plane of two linear axes. The
//!   point gives the rotary axis; the direction is met as closely as possible.
//! - **Closed form, six-axis arms** (`arm`): spherical wrist, or three parallel axes.
//! - **Closed form, seven-axis arms** (`arm/seven.rs`): spherical shoulder and wrist.
//! - **Newton's method** (`numeric.rs`) for all other arrangements, with Levenberg and Marquardt's damping.

mod arm;
mod branches;
mod choice;
mod frame;
mod numeric;
mod plane_on_rotary;
mod rotaries;
mod three_linear;
mod two_linear;
mod vectors;

use crate::axis::{Axis, AxisKind};
use crate::chain::{AxisSet, Chain, Joints, MAX_AXES};
use arm::{Arm, SevenAxisArm};
pub use arm::{ArmConfiguration, ArmMargins, Elbow, Shoulder, WristSide};
pub use branches::{Branches, MAX_BRANCHES, PairFault, Solution, Unreachable};
pub(crate) use branches::{Query, Which};
use choice::home;
pub(crate) use choice::spread;
pub(crate) use frame::{Frame, FrameInverse};
use glam::DAffine3;
use numeric::Numeric;
use plane_on_rotary::PlaneOnRotary;
use three_linear::ThreeLinear;
use two_linear::TwoLinear;
pub(crate) use vectors::in_plane;

#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Inverse {
    /// Redundant axes, which keep their positions of `near`: a pose has five freedoms, and the chain more axes.
    pub(crate) held: AxisSet,
    form: Form,
}

#[derive(Debug, Clone, PartialEq)]
enum Form {
    Arm(Box<Arm>),
    SevenAxisArm(Box<SevenAxisArm>),
    ThreeLinear(ThreeLinear),
    PlaneOnRotary(PlaneOnRotary),
    TwoLinear(TwoLinear),
    Numeric(Numeric),
}

impl Inverse {
    /// Chooses from the arrangement of the axes: a closed form if one exists for the chain or for the chain with some
    /// axes held, else Newton's method.
    pub(crate) fn of(chain: &Chain, axes: &[Axis]) -> Self {
        if let Some(arm) = arm(chain, axes) {
            return arm;
        }
        let held = choice::held(chain, axes);
        let active = chain.holding(held, &home(axes));
        Self { held, form: Form::of(&active, axes) }
    }

    /// Chooses the same with the axes of `wanted` among the held ones, if the rest can still reach every pose.
    pub(crate) fn holding(chain: &Chain, axes: &[Axis], wanted: AxisSet) -> Option<Self> {
        if let Some(arm) = arm(chain, axes).filter(|arm| wanted.both(arm.held) == wanted) {
            return Some(arm);
        }
        let held = choice::held_with(chain, axes, wanted)?;
        let active = chain.holding(held, &home(axes));
        Some(Self { held, form: Form::of(&active, axes) })
    }

    pub(crate) fn is_numeric(&self) -> bool {
        matches!(self.form, Form::Numeric(_))
    }

    /// True for an arm whose rotation about the torch is free.
    pub(crate) fn has_free_roll(&self) -> bool {
        matches!(self.form, Form::Arm(_) | Form::SevenAxisArm(_))
    }

    /// Configuration of the arm at positions `q` with the base frame at `base` in the work frame, all axes at zero; none
    /// for other machines.
    pub(crate) fn configuration(&self, q: &Joints, base: &DAffine3) -> Option<ArmConfiguration> {
        match &self.form {
            Form::Arm(arm) => Some(arm.configuration(q, base)),
            Form::SevenAxisArm(arm) => Some(arm.configuration(q)),
            _ => None,
        }
    }

    /// Distances of the arm from its singularities at positions `q`; none for other machines.
    pub(crate) fn margins(&self, q: &Joints) -> Option<ArmMargins> {
        match &self.form {
            Form::Arm(arm) => Some(arm.margins(q)),
            Form::SevenAxisArm(arm) => Some(arm.margins(q)),
            _ => None,
        }
    }

    /// Arm angle (rad) of a seven-axis arm at positions `q`; none for other machines.
    pub(crate) fn arm_angle(&self, q: &Joints) -> Option<f64> {
        match &self.form {
            Form::SevenAxisArm(arm) => Some(arm.arm_angle(q)),
            _ => None,
        }
    }

    /// Code of the form's name.
    pub(crate) fn method(&self) -> &'static str {
        match &self.form {
            Form::Arm(arm) => arm.method(),
            Form::SevenAxisArm(_) => "machine-method-spherical-shoulder",
            Form::ThreeLinear(_) => "machine-method-closed",
            Form::PlaneOnRotary(_) => "machine-method-plane-on-rotary",
            Form::TwoLinear(_) => "machine-method-in-plane",
            Form::Numeric(_) => "machine-method-numeric",
        }
    }

    /// Adds the branches that are asked for to `branches`.
    pub(crate) fn solve(&self, query: Query, branches: &mut Branches) -> Result<(), Unreachable> {
        if self.held.is_empty() {
            return self.form.solve(query, branches);
        }
        let mut kept = self.held;
        match &self.form {
            // Their axes do not depend on the others: these only move the arm's base.
            Form::Arm(arm) => arm.solve(query, branches)?,
            Form::SevenAxisArm(arm) => {
                arm.solve(query, branches)?;
                kept = kept.different([arm.third()].into_iter().collect());
            }
            form => {
                let chain = query.chain.holding(self.held, query.near);
                form.solve(Query { chain: &chain, ..query }, branches)?;
            }
        }
        for solution in branches.iter_mut() {
            kept.iter().for_each(|axis| solution.joints[axis] = query.near[axis]);
        }
        Ok(())
    }
}

/// An arm at the torch's end of `chain`, with all other axes and a seventh of its own held; none if it has no closed form,
/// or if three linear axes carry the torch through space.
fn arm(chain: &Chain, axes: &[Axis]) -> Option<Inverse> {
    let (decided, form) = match Arm::new(chain) {
        Some(arm) => (arm.axes(), Form::Arm(Box::new(arm))),
        None => SevenAxisArm::new(chain).map(|arm| (arm.decided(), Form::SevenAxisArm(Box::new(arm))))?,
    };
    let held = chain.axes().different(decided);
    let strokes = held.iter().filter(|&axis| axes[axis].kind == AxisKind::Linear).count();
    // One entry of the positions stays free for the rotation about the torch.
    (strokes < 3 && axes.len() < MAX_AXES).then_some(Inverse { held, form })
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

    fn solve(&self, query: Query, branches: &mut Branches) -> Result<(), Unreachable> {
        match self {
            Self::Arm(form) => form.solve(query, branches),
            Self::SevenAxisArm(form) => form.solve(query, branches),
            Self::ThreeLinear(form) => form.solve(query, branches),
            Self::PlaneOnRotary(form) => form.solve(query, branches),
            Self::TwoLinear(form) => form.solve(query, branches),
            Self::Numeric(form) => form.solve(query, branches),
        }
    }
}
