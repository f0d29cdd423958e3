use crate::axis::AxisKind;
use crate::chain::{Joints, MAX_AXES};
use crate::machine::Machine;
use arrayvec::ArrayVec;
use nalgebra::Matrix6xX;

/// Typical weld speed: the tip moves at 10 mm/s around a bend of 100 mm radius, so that the torch turns at 0.1 rad/s.
pub const TYPICAL_SPEED_MM_S: f64 = 10.0;
/// Typical bend radius: see [`TYPICAL_SPEED_MM_S`].
pub const TYPICAL_RADIUS_MM: f64 = 100.0;

/// Motion of the torch by each axis: three rows of the tip's point, three of the direction.
pub(super) type Columns = Matrix6xX<f64>;

/// Weight of the direction with fewer axes than a pose needs: the point has priority.
const FEW: f64 = 1e-3;

/// Task of one head: its pose, and the axes that decide it.
#[derive(Debug, Clone)]
pub(super) struct Task<'a> {
    /// The machine, with the task's head as the first.
    pub(super) machine: &'a Machine,
    pub(super) axes: ArrayVec<usize, MAX_AXES>,
    /// Freedoms of the tip's point that the axes give in regular configurations.
    freedoms: usize,
    /// True if the rotation about the torch counts too: the axes are those of a six-axis arm.
    with_roll: bool,
}

/// Number of axes of an arm that can bring its flange to any frame.
const ARM_AXES: usize = 6;

impl<'a> Task<'a> {
    pub(super) fn new(machine: &'a Machine) -> Self {
        let head = &machine.heads[0];
        let axes = head.chain.axes().iter().filter(|&axis| !head.free().has(axis)).collect();
        let mut task = Self { machine, axes, freedoms: 0, with_roll: machine.has_free_roll() };
        if !task.axes.is_empty() {
            let rank = |k| task.point_part(&machine.spread(k)).rank(1e-6);
            task.freedoms = (1..=40).map(rank).max().unwrap_or(0);
        }
        task
    }

    /// The task of the six-axis arm that carries the first head's torch, if there is one: to bring its flange to a
    /// whole frame. An arm's singularities are those of all its axes, independent of the axes that a torch's pose
    /// decides.
    pub(super) fn of_arm(machine: &'a Machine) -> Option<Self> {
        let screws = &machine.heads[0].chain.screws;
        let arm = &screws[screws.len().checked_sub(ARM_AXES)?..];
        let is_arm = arm.iter().all(|screw| screw.kind == AxisKind::Rotary);
        let axes = arm.iter().map(|screw| screw.axis).collect();
        is_arm.then_some(Self { machine, axes, freedoms: 3, with_roll: true })
    }

    pub(super) fn is_arm(&self) -> bool {
        self.with_roll
    }

    fn is_few(&self) -> bool {
        self.axes.len() < 5
    }

    /// Change of the tip (mm) and of the direction (as mm at the typical radius) per mm or rad of each axis.
    pub(super) fn columns(&self, q: &Joints) -> Columns {
        let jacobian = self.machine.jacobian(q);
        let frames = self.with_roll.then(|| self.machine.link_frames(q));
        let column = |axis: usize| {
            let screw = frames.as_ref().and_then(|frames| self.machine.links.screw_at(axis, frames));
            let (p, d) = (jacobian[axis].0, TYPICAL_RADIUS_MM * screw.map_or(jacobian[axis].1, |s| s.direction));
            [p.x, p.y, p.z, d.x, d.y, d.z]
        };
        Columns::from_iterator(self.axes.len(), self.axes.iter().flat_map(|&axis| column(axis)))
    }

    /// The columns with rad and mm on one scale: a rad is weighted as the typical radius.
    fn scaled(&self, q: &Joints) -> Columns {
        let mut columns = self.columns(q);
        for (i, mut column) in columns.column_iter_mut().enumerate() {
            column /= self.scale(i);
        }
        columns
    }

    fn scale(&self, i: usize) -> f64 {
        if self.is_rotary(i) { TYPICAL_RADIUS_MM } else { 1.0 }
    }

    fn point_part(&self, q: &Joints) -> Columns {
        let mut columns = self.scaled(q);
        columns.rows_mut(3, 3).fill(0.0);
        columns
    }

    /// Conditioning of a configuration, at most 1. At 0 some motion of the decided axes leaves the torch at rest, or
    /// the tip has lost a direction of motion.
    pub(super) fn conditioning(&self, q: &Joints) -> f64 {
        if self.axes.is_empty() {
            return 1.0;
        }
        let all = self.scaled(q).singular_values().min();
        if self.is_few() { all.min(self.point_conditioning(q)) } else { all }
    }

    /// Conditioning of the tip's point alone: 0 if it has lost a freedom.
    pub(super) fn point_conditioning(&self, q: &Joints) -> f64 {
        match self.freedoms {
            0 => 1.0,
            n => self.point_part(q).singular_values()[n - 1],
        }
    }

    /// Rates of the axes (mm or rad, not scaled) with the smallest motion of the torch.
    pub(super) fn lost(&self, q: &Joints) -> ArrayVec<f64, MAX_AXES> {
        let right = if self.axes.is_empty() { None } else { self.scaled(q).svd(false, true).v_t };
        let last = right.iter().flat_map(|right| right.row(right.nrows() - 1).iter().copied().collect::<Vec<f64>>());
        last.enumerate().map(|(i, x)| x / self.scale(i)).collect()
    }

    /// For each decided axis, the maximum fraction of its maximum speed that the typical weld needs, in any direction.
    pub(super) fn need(&self, q: &Joints) -> ArrayVec<f64, MAX_AXES> {
        let weight = if self.is_few() { FEW } else { 1.0 };
        let mut columns = self.columns(q);
        for (mut column, &axis) in columns.column_iter_mut().zip(&self.axes) {
            column *= self.machine.axes[axis].max_speed;
        }
        columns.rows_mut(3, 3).scale_mut(weight);
        if columns.is_empty() {
            return ArrayVec::new();
        }
        let Ok(inverse) = columns.pseudo_inverse(0.0) else { return ArrayVec::new() };
        let length = |i: usize, from: usize| inverse.fixed_view::<1, 3>(i, from).norm();
        (0..self.axes.len()).map(|i| TYPICAL_SPEED_MM_S * (length(i, 0) + weight * length(i, 3))).collect()
    }

    pub(super) fn is_rotary(&self, i: usize) -> bool {
        self.machine.axes[self.axes[i]].kind == AxisKind::Rotary
    }

    pub(super) fn name(&self, i: usize) -> &str {
        &self.machine.axes[self.axes[i]].name
    }
}
