use crate::redundancy::free_axes::FreeAxes;
use seamwright_machine::{Branches, Joints, Machine, Solution, Target, Unreachable};
use seamwright_program::TorchPath;

/// A machine that follows a torch path: the single source of the axes' positions at a path length. [`FreeAxes`] gives
/// the positions of the axes that the path leaves free.
#[derive(Clone, Copy)]
pub(crate) struct Follower<'a> {
    pub(crate) machine: &'a Machine,
    pub(crate) path: &'a dyn TorchPath,
    pub(crate) free: &'a FreeAxes,
}

impl Follower<'_> {
    /// True if the path gives the axes' positions itself.
    pub(crate) fn is_given(&self) -> bool {
        self.path.axes(0.0).is_some()
    }

    /// Target at `s`, with the rotation about the torch in `q` if it is free.
    fn target(&self, s: f64, q: &Joints) -> Target {
        let first = self.path.pose(s);
        let across = self.free.roll.map(|roll| roll.across(first.direction, q));
        Target { across, ..Target::new(first, self.path.second(s)) }
    }

    /// All branches at `s`, as [`Machine::inverse`].
    pub(crate) fn branches(&self, s: f64, near: &Joints) -> Result<Branches, Unreachable> {
        if let Some(joints) = self.path.axes(s) {
            return Ok(Branches::one(Solution { joints, ..Solution::default() }));
        }
        let near = self.free.at(s, near);
        self.machine.inverse(self.target(s, &near), &near)
    }

    /// The branch at `s` that is nearest to `near`, as [`Machine::inverse_near`].
    pub(crate) fn near(&self, s: f64, near: &Joints) -> Result<Solution, Unreachable> {
        if let Some(joints) = self.path.axes(s) {
            return Ok(Solution { joints, ..Solution::default() });
        }
        let near = self.free.at(s, near);
        self.machine.inverse_near(self.target(s, &near), &near)
    }

    /// The branch at `s` that continues from `near`, as [`Machine::inverse_next`].
    pub(crate) fn next(&self, s: f64, near: &Joints) -> Result<Solution, Unreachable> {
        if let Some(joints) = self.path.axes(s) {
            return Ok(Solution { joints, ..Solution::default() });
        }
        let near = self.free.at(s, near);
        self.machine.inverse_next(self.target(s, &near), &near)
    }

    /// Path lengths inside the path where a derivative of the axes may jump, increasing.
    pub(crate) fn knots(&self) -> Vec<f64> {
        self.with_free(self.path.knots())
    }

    /// Path lengths among them at which the first or second derivative may jump.
    pub(crate) fn bends(&self) -> Vec<f64> {
        self.with_free(self.path.bends())
    }

    fn with_free(&self, mut knots: Vec<f64>) -> Vec<f64> {
        knots.extend(self.free.knots());
        knots.sort_by(f64::total_cmp);
        knots.dedup_by(|a, b| *a - *b < 1e-9);
        knots
    }
}
