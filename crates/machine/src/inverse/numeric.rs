use super::branches::{Branches, Query, Solution, Unreachable, Which};
use super::choice::spread;
use crate::axis::{Axis, AxisKind};
use crate::chain::{Chain, Joints, MAX_AXES};
use glam::DVec3;
use nalgebra::{SMatrix, SVector};
use seamwright_geometry::{Pose, angle_between};
use std::f64::consts::{PI, TAU};

/// Newton's method with Levenberg and Marquardt's damping, for arrangements without a closed form.
///
/// From a neighbour it finds that branch; to find all branches it starts from positions spread over the axes' ranges.
/// That finds every branch except those with a basin smaller than the spread: a test compares with brute force. With
/// fewer than five axes the point is met exactly if possible, and the direction as closely as possible.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Numeric {
    axes: Vec<Axis>,
}

/// Maximum number of axes solved at once.
const MAX_SOLVED_AXES: usize = 5;
/// Number of starts for all branches.
const STARTS: u32 = 600;
/// Maximum number of steps from one start; most need 4 to 8.
const STEPS: usize = 60;
/// Weight of the direction against the point, mm per rad.
const MM_PER_RAD: f64 = 100.0;
/// The same for axes that cannot give every direction: the point has priority.
const MM_PER_RAD_FEW: f64 = 0.1;
/// Tolerance of a reached pose: mm, and rad for the direction. Newton's last step goes far below.
const REACHED: f64 = 1e-9;
/// Tolerance of equal branches, mm or rad.
const SAME: f64 = 1e-6;

/// Columns of the Jacobian: three of the point, three of the direction as a turn.
type Rows = [f64; 6];

#[derive(Clone, Copy)]
struct Error {
    /// The tip there.
    tip: Pose,
    point: DVec3,
    /// The remaining rotation, as a vector, rad.
    turn: DVec3,
}

impl Error {
    fn square(&self, mm_per_rad: f64) -> f64 {
        self.point.length_squared() + (mm_per_rad * self.turn).length_squared()
    }
}

/// Weight of the direction on this chain, mm per rad.
fn mm_per_rad(chain: &Chain) -> f64 {
    if chain.screws.len() < MAX_SOLVED_AXES { MM_PER_RAD_FEW } else { MM_PER_RAD }
}

impl Numeric {
    pub(crate) fn new(axes: &[Axis]) -> Self {
        Self { axes: axes.to_vec() }
    }

    pub(crate) fn solve(&self, query: Query, branches: &mut Branches) -> Result<(), Unreachable> {
        let Query { chain, pose, near, which, .. } = query;
        if let Which::From(starts) = which {
            return self.solve_each(query, starts.iter().copied(), branches);
        }
        if let Which::Nearest = which {
            let (solution, error) = descend(chain, pose, near);
            if accepted(chain, &error) {
                *branches.add() = solution;
                return Ok(());
            }
        }
        let starts = (0..=STARTS).map(|k| if k == 0 { *near } else { self.start(chain, near, k) });
        self.solve_each(query, starts, branches)
    }

    /// Adds every branch that Newton's method finds from `starts`.
    fn solve_each(
        &self,
        Query { chain, pose, near, .. }: Query,
        starts: impl Iterator<Item = Joints>,
        branches: &mut Branches,
    ) -> Result<(), Unreachable> {
        let mut least = Error { tip: *pose, point: DVec3::INFINITY, turn: DVec3::ZERO };
        for start in starts {
            let (solution, error) = descend(chain, pose, &start);
            if accepted(chain, &error) {
                self.keep(chain, solution, near, branches);
            } else if error.square(1.0) < least.square(1.0) {
                least = error;
            }
        }
        match branches.is_empty() {
            false => Ok(()),
            true if least.point.length() > 1e-6 => Err(Unreachable::Point { by: least.point.length() }),
            true => Err(Unreachable::Direction { by: least.turn.length() }),
        }
    }

    fn start(&self, chain: &Chain, near: &Joints, k: u32) -> Joints {
        let mut q = *near;
        let spread = spread(&self.axes, k);
        chain.screws.iter().for_each(|s| q[s.axis] = spread[s.axis]);
        q
    }

    /// Adds a solution unless an equal one, up to whole turns, is present.
    fn keep(&self, chain: &Chain, mut solution: Solution, near: &Joints, branches: &mut Branches) {
        for screw in &chain.screws {
            let axis = screw.axis;
            solution.joints[axis] = self.axes[axis].turn_near(solution.joints[axis], near[axis]);
        }
        let same = |other: &Solution| {
            chain.screws.iter().all(|s| {
                let d = solution.joints[s.axis] - other.joints[s.axis];
                let d = if s.kind == AxisKind::Rotary { d - TAU * (d / TAU).round() } else { d };
                d.abs() < SAME
            })
        };
        // With a singular Jacobian the solutions are not isolated: one represents all.
        if branches.iter().any(|b| same(b) || (b.singular && solution.singular)) {
            return;
        }
        if branches.len() < crate::inverse::branches::MAX_BRANCHES {
            *branches.add() = solution;
        } else if let Some(worst) = branches.iter_mut().max_by(|a, b| a.attitude_error.total_cmp(&b.attitude_error)) {
            // Too few axes have many local minima of the direction error: keep the smallest.
            if worst.attitude_error > solution.attitude_error {
                *worst = solution;
            }
        }
    }
}

/// True if the error is within tolerance; with too few axes, if that of the point is.
fn accepted(chain: &Chain, error: &Error) -> bool {
    let point = error.point.length() <= REACHED * 1f64.max(1e-3 * chain.zero.point.length());
    point && (error.turn.length() <= REACHED || chain.screws.len() < MAX_SOLVED_AXES)
}

/// Descends from `start` towards the pose; returns the final positions and the remaining error.
fn descend(chain: &Chain, pose: &Pose, start: &Joints) -> (Solution, Error) {
    let mut q = *start;
    let weight = mm_per_rad(chain);
    let mut error = error(chain, pose, &q);
    let mut damping = 1e-3;
    let mut singular = false;
    let mut rows = columns(chain, &q, &error.tip);
    for _ in 0..STEPS {
        let solved = step(chain, &rows, &error, damping);
        singular = solved.1;
        let next = moved(chain, &q, &solved.0);
        let there = self::error(chain, pose, &next);
        let small = chain.screws.iter().all(|s| solved.0[s.axis].abs() < 1e-14 * q[s.axis].abs().max(1.0));
        if there.square(weight) < error.square(weight) {
            (q, error) = (next, there);
            rows = columns(chain, &q, &error.tip);
            damping = if error.square(weight) < 1e-6 { 0.0 } else { damping * 0.1 };
        } else if small || damping > 1e8 || error.square(weight) < 1e-24 {
            break;
        } else {
            damping = damping.max(1e-9) * 10.0;
        }
    }
    if chain.screws.len() < MAX_SOLVED_AXES {
        to_the_point(chain, pose, &mut q, &mut error);
    }
    let attitude_error =
        if chain.screws.len() < MAX_SOLVED_AXES { angle_between(error.tip.direction, pose.direction) } else { 0.0 };
    (Solution { joints: q, attitude_error, singular }, error)
}

/// With too few axes for the direction the point has priority: minimum-length Newton steps on the point alone.
fn to_the_point(chain: &Chain, pose: &Pose, q: &mut Joints, error: &mut Error) {
    if chain.screws.len() < 3 {
        return;
    }
    for _ in 0..4 {
        let rows = columns(chain, q, &error.tip);
        // J^T (J J^T)^-1 e
        let points = SMatrix::<f64, 3, MAX_AXES>::from_fn(|i, k| rows[k][i]);
        let Some(weights) = solve(points * points.transpose(), &error.point.to_array().into()) else { return };
        let moves = points.transpose() * weights;
        let mut step = Joints::default();
        for (screw, by) in chain.screws.iter().zip(&moves) {
            step[screw.axis] = *by;
        }
        let next = moved(chain, q, &step);
        let there = self::error(chain, pose, &next);
        if there.point.length() >= error.point.length() {
            return;
        }
        (*q, *error) = (next, there);
    }
}

fn error(chain: &Chain, pose: &Pose, q: &Joints) -> Error {
    let tip = chain.forward(q);
    let across = tip.direction.cross(pose.direction);
    let sine = across.length();
    let angle = sine.atan2(tip.direction.dot(pose.direction));
    // Opposite directions: any axis across is valid.
    let axis = if sine > 1e-12 { across / sine } else { tip.direction.any_orthonormal_vector() };
    Error { tip, point: pose.point - tip.point, turn: if angle < 1e-12 { across } else { angle * axis } }
}

/// The chain's columns at `q`, with its tip there, in the order of its screws; the direction is weighted to mm.
fn columns(chain: &Chain, q: &Joints, tip: &Pose) -> [Rows; MAX_AXES] {
    let jacobian = chain.jacobian_at(q, tip);
    let weight = mm_per_rad(chain);
    let mut rows = [[0.0; 6]; MAX_AXES];
    for (row, screw) in rows.iter_mut().zip(&chain.screws) {
        let (p, d) = jacobian[screw.axis];
        let turn = weight * tip.direction.cross(d);
        *row = [p.x, p.y, p.z, turn.x, turn.y, turn.z];
    }
    rows
}

/// The step of a damped linear model of the error, and true if the model is rank-deficient.
fn step(chain: &Chain, rows: &[Rows; MAX_AXES], error: &Error, damping: f64) -> (Joints, bool) {
    let n = chain.screws.len().min(MAX_SOLVED_AXES);
    let turn = mm_per_rad(chain) * error.turn;
    let wanted: Rows = [error.point.x, error.point.y, error.point.z, turn.x, turn.y, turn.z];
    let dot = |a: &Rows, b: &Rows| -> f64 { a.iter().zip(b).map(|(x, y)| x * y).sum() };
    // Columns scaled to length 1, so that mm and rad have equal weight.
    let scale: [f64; MAX_SOLVED_AXES] =
        std::array::from_fn(|i| if i < n { dot(&rows[i], &rows[i]).sqrt().max(1e-9) } else { 1.0 });
    let mut normal = SMatrix::<f64, MAX_SOLVED_AXES, MAX_SOLVED_AXES>::identity();
    let mut right = SVector::<f64, MAX_SOLVED_AXES>::zeros();
    for i in 0..n {
        for j in 0..n {
            normal[(i, j)] = dot(&rows[i], &rows[j]) / (scale[i] * scale[j]);
        }
        normal[(i, i)] += damping;
        right[i] = dot(&rows[i], &wanted) / scale[i];
    }
    let solved = solve(normal, &right);
    let mut joints = Joints::default();
    let singular = solved.is_none();
    // Rank-deficient: a damped step.
    let damped = || solve(normal + SMatrix::identity() * 1e-3, &right);
    let solution = solved.or_else(damped).unwrap_or_else(SVector::zeros);
    for (i, screw) in chain.screws.iter().enumerate().take(n) {
        joints[screw.axis] = solution[i] / scale[i];
    }
    (joints, singular)
}

/// `q` moved by a step, rotary axes by at most 0.5 rad.
fn moved(chain: &Chain, q: &Joints, step: &Joints) -> Joints {
    let turn = |s: &crate::chain::Screw| if s.kind == AxisKind::Rotary { step[s.axis].abs() } else { 0.0 };
    let most = chain.screws.iter().map(turn).fold(0.0, f64::max);
    let part = if most > 0.5 { 0.5 / most } else { 1.0 };
    let mut next = *q;
    for screw in &chain.screws {
        let value = q[screw.axis] + part * step[screw.axis];
        // Wraps far rotary positions to one turn.
        let far = screw.kind == AxisKind::Rotary && value.abs() > 4.0 * PI;
        next[screw.axis] = if far { value.rem_euclid(TAU) } else { value };
    }
    next
}

/// Solves a symmetric positive system; none if it is rank-deficient.
fn solve<const N: usize>(matrix: SMatrix<f64, N, N>, right: &SVector<f64, N>) -> Option<SVector<f64, N>> {
    let factor = matrix.cholesky()?;
    let greatest = (0..N).map(|i| matrix[(i, i)]).fold(0.0, f64::max);
    // Pivots are the squares of the factor's diagonal.
    let full_rank = (0..N).all(|i| factor.l_dirty()[(i, i)].powi(2) > 1e-14 * greatest);
    full_rank.then(|| factor.solve(right))
}
