use super::SlideLimits;
use crate::lead::Error;
use glam::{DMat3, DVec3};
use nalgebra::SVector;
use seamwright_geometry::Pose;
use seamwright_machine::{AxisKind, AxisSet, Joints, MAX_AXES, Machine};
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

type Column = SVector<f64, MAX_AXES>;

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
    effort: Column,
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
        Self { machine, effort: Column::from_fn(|i, _| effort(i)), held: AxisSet::default(), by: [0.0; MAX_AXES] }
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
    fn step(&self, q: &Joints, x: &Joints, target: &Pose) -> Option<Column> {
        let here = self.machine.forward(x);
        let solver = self.solver(x)?;
        let way = Column::from_fn(|i, _| -self.effort[i] * (x[i] - q[i]));
        let turn = target.direction - here.direction;
        let pull = Column::from_fn(|i, _| ATTITUDE * solver.columns[i].1.dot(turn)) + way;
        solver.solve(&pull, target.point - here.point)
    }

    /// The conditions of the least step at `x`: a held axis moves nothing, so that no step moves it.
    fn solver(&self, x: &Joints) -> Option<Solver> {
        let mut columns = self.machine.jacobian(x);
        self.held.iter().for_each(|i| columns[i] = (DVec3::ZERO, DVec3::ZERO));
        Solver::new(columns, self.machine.axes.len(), &self.effort)
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
        let mut most =
            SlideLimits { stroke_mm: range_mm, speed: f64::INFINITY, acceleration: f64::INFINITY, jerk: f64::INFINITY };
        let singular =
            Error::Value { key: "correction", value: range_mm, allowed: Message::new("tracking-correction-allowed") };
        for (q, directions) in places {
            let gains = self.gains(&q, directions).ok_or_else(|| singular.clone())?;
            for (axis, gain) in self.machine.axes.iter().zip(gains.iter()).filter(|(_, gain)| **gain > 1e-9) {
                let part = RESERVE * DIRECT / gain;
                most.speed = most.speed.min(part * axis.max_speed);
                most.acceleration = most.acceleration.min(part * axis.max_acceleration);
                most.jerk = most.jerk.min(part * axis.jerk());
            }
        }
        most.check()?;
        Ok(most)
    }

    /// By how much each axis moves at most for 1 mm in both directions at once, mm or rad.
    fn gains(&self, q: &Joints, directions: [DVec3; 2]) -> Option<Column> {
        let solver = self.solver(q)?;
        let [a, b] = directions.map(|direction| solver.solve(&Column::zeros(), direction));
        Some(a?.abs() + b?.abs())
    }
}

/// The conditions of the least step at one place, factorised.
struct Solver {
    columns: [(DVec3, DVec3); MAX_AXES],
    least: Factor,
    /// The inverse of how far the tip goes when it is pulled, by directions.
    stiffness: DMat3,
    /// Movement of the axes for a pull at the tip in each direction.
    by_pull: [Column; 3],
}

impl Solver {
    /// Of axes that move the torch by `columns`; none where they cannot move its tip to all sides.
    fn new(columns: [(DVec3, DVec3); MAX_AXES], axes: usize, effort: &Column) -> Option<Self> {
        let mut least = [[0.0; MAX_AXES]; MAX_AXES];
        for i in 0..axes {
            for k in 0..=i {
                least[i][k] = ATTITUDE * columns[i].1.dot(columns[k].1);
            }
            least[i][i] += effort[i];
        }
        let least = Factor::of(least, axes)?;
        let pull = |axis: usize| least.solve(&Column::from_fn(|i, _| columns[i].0[axis]));
        let by_pull = [pull(0), pull(1), pull(2)];
        let moved = |by: &Column| (0..MAX_AXES).map(|i| by[i] * columns[i].0).sum::<DVec3>();
        let compliance = DMat3::from_cols(moved(&by_pull[0]), moved(&by_pull[1]), moved(&by_pull[2]));
        let largest = compliance.x_axis.length().max(compliance.y_axis.length()).max(compliance.z_axis.length());
        let singular = compliance.determinant().abs() <= 1e-12 * largest.powi(3);
        (!singular).then(|| Self { columns, least, stiffness: compliance.inverse(), by_pull })
    }

    /// The step that is the least against `pull` and moves the tip by `way`.
    fn solve(&self, pull: &Column, way: DVec3) -> Option<Column> {
        let free = self.least.solve(pull);
        let left = way - (0..MAX_AXES).map(|i| free[i] * self.columns[i].0).sum::<DVec3>();
        let force = self.stiffness * left;
        let step = free + self.by_pull[0] * force.x + self.by_pull[1] * force.y + self.by_pull[2] * force.z;
        step.iter().all(|s| s.is_finite()).then_some(step)
    }
}

/// A symmetric positive matrix as the product of a lower triangle and its transpose (Cholesky), for as many rows as the machine
/// has axes: most machines have fewer than half of those there is room for.
struct Factor {
    lower: [[f64; MAX_AXES]; MAX_AXES],
    axes: usize,
}

impl Factor {
    /// Of the lower triangle of a matrix; none if it is not positive.
    fn of(mut lower: [[f64; MAX_AXES]; MAX_AXES], axes: usize) -> Option<Self> {
        for i in 0..axes {
            for k in 0..=i {
                let known: f64 = (0..k).map(|j| lower[i][j] * lower[k][j]).sum();
                let left = lower[i][k] - known;
                // No number is not positive either.
                let good = i != k || left > 0.0;
                lower[i][k] = if i == k { left.sqrt() } else { left / lower[k][k] };
                if !good {
                    return None;
                }
            }
        }
        Some(Self { lower, axes })
    }

    /// The solution for a right side; 0 beyond the axes.
    fn solve(&self, right: &Column) -> Column {
        let (lower, axes) = (&self.lower, self.axes);
        let mut x = Column::zeros();
        for i in 0..axes {
            let known: f64 = (0..i).map(|j| lower[i][j] * x[j]).sum();
            x[i] = (right[i] - known) / lower[i][i];
        }
        for i in (0..axes).rev() {
            let known: f64 = (i + 1..axes).map(|j| lower[j][i] * x[j]).sum();
            x[i] = (x[i] - known) / lower[i][i];
        }
        x
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// For random positive matrices of every size the product with the solution is the right side.
    #[test]
    fn factors_solve() {
        let mut numbers = seamwright_testkit::Random::new(3);
        let mut random = || numbers.within(-1.0, 1.0);
        for axes in (1..=MAX_AXES).cycle().take(200) {
            let root: [[f64; MAX_AXES]; MAX_AXES] = std::array::from_fn(|_| std::array::from_fn(|_| random()));
            let entry = |i: usize, k: usize| {
                (0..axes).map(|j| root[i][j] * root[k][j]).sum::<f64>() + if i == k { 0.1 } else { 0.0 }
            };
            let matrix = std::array::from_fn(|i| std::array::from_fn(|k| if k <= i { entry(i, k) } else { f64::NAN }));
            let right = Column::from_fn(|_, _| random());
            let x = Factor::of(matrix, axes).unwrap().solve(&right);
            for i in 0..axes {
                let product: f64 = (0..axes).map(|k| entry(i, k) * x[k]).sum();
                assert!((product - right[i]).abs() < 1e-9, "{axes}: {product} {}", right[i]);
            }
            assert!(x.iter().skip(axes).all(|x| *x == 0.0));
            let mut negative = matrix;
            negative[axes - 1][axes - 1] = -1.0;
            assert!(Factor::of(negative, axes).is_none());
        }
    }
}
