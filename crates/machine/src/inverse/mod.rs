//! Inverse kinematics, chosen from the arrangement of the axes and not from a name: a closed form if the arrangement
//! has one, Newton's method otherwise.
//!
//! - **Closed form, general.** The torch direction is a product of rotations of a fixed vector: Paden-Kahan subproblems
//!   give the rotary axes (Murray, Li and Sastry, 1994), and a 3 x 3 system the linear ones.
//! - **Closed form, saddle welder** (SADDLE-2020): one rotary axis next to the work and a plane of two linear axes. The
//!   point gives the rotary axis; the direction is met as closely as possible.
//! - **Newton's method** (`numeric.rs`) for all other arrangements, with Levenberg and Marquardt's damping.

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
use crate::chain::{AxisSet, Chain};
pub use branches::{Branches, MAX_BRANCHES, PairFault, Solution, Unreachable};
pub(crate) use branches::{Query, Which};
use choice::home;
pub(crate) use choice::spread;
pub(crate) use frame::{Frame, FrameInverse};
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

    /// Adds the branches that are asked for to `branches`.
    pub(crate) fn solve(&self, query: Query, branches: &mut Branches) -> Result<(), Unreachable> {
        if self.held.is_empty() {
            return self.form.solve(query, branches);
        }
        self.form.solve(Query { chain: &query.chain.holding(self.held, query.near), ..query }, branches)?;
        for solution in branches.iter_mut() {
            self.held.iter().for_each(|axis| solution.joints[axis] = query.near[axis]);
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

    fn solve(&self, query: Query, branches: &mut Branches) -> Result<(), Unreachable> {
        match self {
            Self::ThreeLinear(form) => form.solve(query, branches),
            Self::PlaneOnRotary(form) => form.solve(query, branches),
            Self::TwoLinear(form) => form.solve(query, branches),
            Self::Numeric(form) => form.solve(query, branches),
        }
    }
}
