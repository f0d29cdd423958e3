use super::limits::SlideLimits;
use crate::lead::Error;
use glam::{DMat3, DVec3};
use nalgebra::{SMatrix, SVector};
use seamwright_geometry::Pose;
use seamwright_machine::{AxisKind, AxisLimits, AxisSet, Joints, MAX_AXES, Machine};
use seamwright_message::Message;

/// Part of every axis' speed, acceleration and jerk that plans leave to corrections.
pub const RESERVE: f64 = 0.3;
/// Part of that which corrections are bounded by. The rest is for what a correction that stays adds: a path beside the
/// taught one takes other speeds of the axes.
const DIRECT: f64 = 0.5;
/// Weight of the attitude (rad) against that of the axes' ways (as times, s): large enough that ways decide only where the
/// attitude leaves a choice.
const ATTITUDE: f64 = 1e7;
/// By how much more the ways of axes weigh that are to rest.
const RESTING: f64 = 1e12;
/// Steps of Newton's method a cycle: each begins where the one before has ended, a cycle ago or now.
const STEPS: usize = 2;

/// Carries corrections out with the machine's own axes: the torch is shifted in the work frame and keeps its direction.
///
/// The tip is exactly at its target. Freedom beyond that serves the attitude (least squares); the freedom that remains
/// keeps the axes close to the planned positions, weighted by each axis' speed. So the result depends on position and
/// correction alone, independent of the history. (Newton's method on the Lagrange conditions; the axes' derivatives are
/// those of the machine's own chain.)
#[derive(Debug, Clone)]
pub struct OverAxes<'a> {
    machine: &'a Machine,
    /// 1 / speed^2 of each axis; 1 of axes that have no part in it.
    effort: Joints,
    /// Axes that stand still.
    held: AxisSet,
    /// Movement of the axes by the correction in the cycle before.
    by: Joints,
}

/// The axes cannot shift the torch that way here.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct OutOfReach;

impl<'a> OverAxes<'a> {
    /// For the first head of `machine`.
    #[must_use]
    pub fn new(machine: &'a Machine) -> Self {
        let effort = |i: usize| machine.axes.get(i).map_or(1.0, |axis| axis.max_speed.powi(-2));
        Self { machine, effort: std::array::from_fn(effort), held: AxisSet::default(), by: [0.0; MAX_AXES] }
    }

    /// The same with the linear axes that carry all heads, so that these are shifted alike: their own slides rest.
    #[must_use]
    pub fn carrying_all(machine: &'a Machine) -> Self {
        let mut over = Self::new(machine);
        let own = |i: usize| machine.heads.iter().any(|head| head.slides.has(i));
        for (i, axis) in machine.axes.iter().enumerate() {
            if axis.kind == AxisKind::Rotary || own(i) {
                over.effort[i] *= RESTING;
            }
        }
        over
    }

    /// The same with these axes held: they stay where the plan has them, and the others do what they can.
    #[must_use]
    pub fn holding(self, held: AxisSet) -> Self {
        Self { held, ..self }
    }

    /// Positions at which the torch is `by` (mm, work frame) beside where it is at the planned positions `q`. No
    /// allocation.
    ///
    /// # Errors
    /// [`OutOfReach`] where the axes cannot move the torch to all sides, or an axis would leave its range.
    pub fn shifted(&mut self, q: &Joints, by: DVec3) -> Result<Joints, OutOfReach> {
        let planned = self.machine.forward(q);
        let target = Pose { point: planned.point + by, ..planned };
        let mut x: Joints = std::array::from_fn(|i| q[i] + self.by[i]);
        for _ in 0..STEPS {
            let step = self.step(q, &x, &target).ok_or(OutOfReach)?;
            x.iter_mut().zip(step.iter()).for_each(|(x, step)| *x += step);
        }
        if self.machine.outside(&x).is_some() || x.iter().any(|x| !x.is_finite()) {
            return Err(OutOfReach);
        }
        self.by = std::array::from_fn(|i| x[i] - q[i]);
        Ok(x)
    }

    /// One step from `x`: to the target as it looks from there.
    fn step(&self, q: &Joints, x: &Joints, target: &Pose) -> Option<Joints> {
        let here = self.machine.forward(x);
        let pull = std::array::from_fn(|i| -self.effort[i] * (x[i] - q[i]));
        let step = Step { way: target.point - here.point, turn: target.direction - here.direction, pull };
        self.least(x, [step]).map(|[by]| by)
    }

    /// The least movements of the axes at `x` that make these steps; none where the axes cannot move the tip to all
    /// sides.
    fn least<const K: usize>(&self, x: &Joints, steps: [Step; K]) -> Option<[Joints; K]> {
        let mut columns = self.machine.jacobian(x);
        // A held axis moves nothing, so that no step moves it.
        self.held.iter().for_each(|i| columns[i] = (DVec3::ZERO, DVec3::ZERO));
        match self.machine.axes.len() {
            ..=6 => least::<6, K>(&columns, &self.effort, steps),
            7..=8 => least::<8, K>(&columns, &self.effort, steps),
            _ => least::<MAX_AXES, K>(&columns, &self.effort, steps),
        }
    }

    /// Computes the limits of a correction along a path such that every axis stays within its part of [`RESERVE`].
    /// `places` are planned positions with both directions of corrections (unit vectors, work frame); `range_mm` is the
    /// maximum correction.
    ///
    /// # Errors
    /// An invalid range; [`Error::Value`] where the axes cannot shift the torch.
    pub fn limits(
        &self,
        places: impl Iterator<Item = (Joints, [DVec3; 2])>,
        range_mm: f64,
    ) -> Result<SlideLimits, Error> {
        let mut motion = AxisLimits::NONE;
        let singular =
            Error::Value { key: "correction", value: range_mm, allowed: Message::new("tracking-correction-allowed") };
        for (q, directions) in places {
            let gains = self.gains(&q, directions).ok_or_else(|| singular.clone())?;
            for (axis, gain) in self.machine.axes.iter().zip(gains.iter()).filter(|(_, gain)| **gain > 1e-9) {
                motion = motion.min(axis.limits().scaled(RESERVE * DIRECT / gain));
            }
        }
        let most = SlideLimits { stroke_mm: range_mm, motion };
        most.check()?;
        Ok(most)
    }

    /// By how much each axis moves at most for 1 mm in both directions at once, mm or rad.
    fn gains(&self, q: &Joints, directions: [DVec3; 2]) -> Option<Joints> {
        let steps = directions.map(|way| Step { way, turn: DVec3::ZERO, pull: [0.0; MAX_AXES] });
        let [a, b] = self.least(q, steps)?;
        Some(std::array::from_fn(|i| a[i].abs() + b[i].abs()))
    }
}

struct Step {
    /// How far the tip moves: exactly.
    way: DVec3,
    /// By how much the direction changes: as far as the axes can.
    turn: DVec3,
    /// Positions to which the axes are drawn.
    pull: Joints,
}

/// Solves the conditions of the least steps for the first `N` axes, which move the torch by `columns`.
fn least<const N: usize, const K: usize>(
    columns: &[(DVec3, DVec3); MAX_AXES],
    effort: &Joints,
    steps: [Step; K],
) -> Option<[Joints; K]> {
    let turns = SMatrix::<f64, 3, N>::from_fn(|i, k| columns[k].1[i]);
    let effort = SVector::<f64, N>::from_fn(|i, _| effort[i]);
    let least = (ATTITUDE * turns.transpose() * turns + SMatrix::from_diagonal(&effort)).cholesky()?;
    let by_pull = [0, 1, 2].map(|axis| least.solve(&SVector::<f64, N>::from_fn(|i, _| columns[i].0[axis])));
    let moved = |by: &SVector<f64, N>| (0..N).map(|i| by[i] * columns[i].0).sum::<DVec3>();
    // How far the tip goes when it is pulled, by directions.
    let compliance = DMat3::from_cols(moved(&by_pull[0]), moved(&by_pull[1]), moved(&by_pull[2]));
    let largest = compliance.x_axis.length().max(compliance.y_axis.length()).max(compliance.z_axis.length());
    if compliance.determinant().abs() <= 1e-12 * largest.powi(3) {
        return None;
    }
    let stiffness = compliance.inverse();
    let found = steps.map(|step| {
        let free =
            least.solve(&SVector::<f64, N>::from_fn(|i, _| ATTITUDE * columns[i].1.dot(step.turn) + step.pull[i]));
        let force = stiffness * (step.way - moved(&free));
        let by = free + by_pull[0] * force.x + by_pull[1] * force.y + by_pull[2] * force.z;
        std::array::from_fn(|i| if i < N { by[i] } else { 0.0 })
    });
    found.iter().flatten().all(|by| by.is_finite()).then_some(found)
}
