use crate::inverse::{Branches, ClosedForm, Solution, Unreachable};
use crate::{Axis, AxisKind, Chain, Io, Joints, MachineFile, RangeViolation, assemble};
use seamwright_document::{Document, DocumentError};
use seamwright_geometry::Pose;
use std::f64::consts::TAU;

/// A machine: its axes and the chain from the work to the torch.
#[derive(Debug, Clone, PartialEq)]
pub struct Machine {
    /// Short name.
    pub name: String,
    /// Title, for people.
    pub title: String,
    /// Axes in machine-file order: tool side first, then work side.
    pub axes: Vec<Axis>,
    /// Period of position loops and set-points, s.
    pub servo_period_s: f64,
    /// Outputs that drive the process.
    pub io: Io,
    /// The chain from the work to the torch.
    pub chain: Chain,
    pub(crate) closed_form: Option<ClosedForm>,
}

impl Machine {
    /// Reads a machine file.
    ///
    /// # Errors
    /// The first thing wrong, with its address.
    pub fn read(file: &str, text: &str) -> Result<Self, DocumentError> {
        assemble::machine(&Document::<MachineFile>::read(file, text)?)
    }

    /// Index of the axis called `name`.
    pub fn axis(&self, name: &str) -> Option<usize> {
        self.axes.iter().position(|a| a.name == name)
    }

    /// Positions after homing.
    pub fn home(&self) -> Joints {
        let mut q = Joints::default();
        for (value, axis) in q.iter_mut().zip(&self.axes) {
            *value = axis.home;
        }
        q
    }

    /// Torch tip and direction in the work frame at positions `q`.
    pub fn forward(&self, q: &Joints) -> Pose {
        self.chain.forward(q)
    }

    /// All branches of positions that bring the torch to `pose`, rotary axes within half a turn of `near`; `near`
    /// also decides what is left free at a singular pose. Ranges are not looked at.
    ///
    /// # Errors
    /// The reason there is none.
    pub fn inverse(&self, pose: &Pose, near: &Joints) -> Result<Branches, Unreachable> {
        let mut branches = Branches::new();
        self.inverse_into(pose, near, &mut branches)?;
        Ok(branches)
    }

    fn inverse_into(&self, pose: &Pose, near: &Joints, branches: &mut Branches) -> Result<(), Unreachable> {
        let form = self.closed_form.as_ref().ok_or(Unreachable::NoClosedForm)?;
        form.solve(&self.chain, pose, near, branches)?;
        for solution in branches.iter_mut() {
            for (axis, (value, near)) in self.axes.iter().zip(solution.joints.iter_mut().zip(near)) {
                *value = axis.turn_near(*value, *near);
            }
        }
        Ok(())
    }

    /// The branch nearest to `near`, measured in parts of each axis' highest speed.
    ///
    /// # Errors
    /// As [`Machine::inverse`].
    pub fn inverse_near(&self, pose: &Pose, near: &Joints) -> Result<Solution, Unreachable> {
        let distance = |s: &Solution| -> f64 {
            let steps = self.axes.iter().zip(s.joints.iter().zip(near));
            steps.map(|(axis, (a, b))| ((a - b) / axis.max_speed).powi(2)).sum()
        };
        let mut branches = Branches::new();
        self.inverse_into(pose, near, &mut branches)?;
        let (mut best, mut least) = (0, f64::INFINITY);
        for (i, solution) in branches.iter().enumerate() {
            let distance = distance(solution);
            if distance < least {
                (best, least) = (i, distance);
            }
        }
        Ok(branches[best])
    }

    /// `q` with rotary axes turned by whole turns into their ranges, where that is possible.
    pub fn turned_into_range(&self, q: &Joints) -> Joints {
        let mut turned = *q;
        for (value, axis) in turned.iter_mut().zip(&self.axes) {
            if let (AxisKind::Rotary, Some((low, high))) = (axis.kind, axis.range) {
                let up = TAU * ((low - *value) / TAU).ceil();
                if *value < low && *value + up <= high {
                    *value += up;
                }
                let down = TAU * ((*value - high) / TAU).ceil();
                if *value > high && *value - down >= low {
                    *value -= down;
                }
            }
        }
        turned
    }

    /// The first axis whose position in `q` is outside its range.
    pub fn outside(&self, q: &Joints) -> Option<RangeViolation> {
        self.axes
            .iter()
            .zip(q)
            .enumerate()
            .find_map(|(axis, (a, &value))| a.outside(value).map(|limit| RangeViolation { axis, value, limit }))
    }
}
