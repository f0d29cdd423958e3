use super::free_motion::{Motion, positive};
use glam::{DAffine3, DQuat, DVec3};
use nalgebra::{DMatrix, DVector, SVD};
use std::f64::consts::TAU;

/// Fraction of the largest singular value below which a motion is undetermined: a move of 1 mm at the points' scale
/// would change residuals by a few micrometres, below any probe's resolution.
const UNSEEN: f64 = 2e-3;

/// Minimum spread of the points for rotations, mm.
const MIN_REACH_MM: f64 = 10.0;

/// Standard deviations of a fit, estimated from its residuals; undetermined motions are not included.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Deviation {
    /// The point that they hold for: the middle of the measured points, mm.
    pub at: DVec3,
    /// Of its x, y and z, mm.
    pub shift: DVec3,
    /// Of the turn about the three directions there, rad.
    pub turn: DVec3,
}

/// Small rigid motions in the measuring frame, with turns counted in mm at the distance `reach` from `at`, so that all
/// six numbers (move, turn) have one unit.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Twists {
    pub(crate) at: DVec3,
    pub(crate) reach: f64,
}

impl Twists {
    pub(crate) fn about(points: impl ExactSizeIterator<Item = DVec3> + Clone) -> Self {
        let n = points.len().max(1) as f64;
        let at = points.clone().sum::<DVec3>() / n;
        let spread: f64 = points.map(|p| (p - at).length_squared()).sum();
        Self { at, reach: (spread / n).sqrt().max(MIN_REACH_MM) }
    }

    /// Derivatives of a quantity by the six numbers, from its `gradient` by the position of `point`.
    pub(crate) fn row(&self, point: DVec3, gradient: DVec3) -> [f64; 6] {
        let turn = (point - self.at).cross(gradient) / self.reach;
        [gradient.x, gradient.y, gradient.z, turn.x, turn.y, turn.z]
    }

    pub(crate) fn motion(&self, numbers: &[f64]) -> DAffine3 {
        let shift = DVec3::from_slice(numbers);
        let turn = DQuat::from_scaled_axis(DVec3::from_slice(&numbers[3..]) / self.reach);
        DAffine3::from_translation(self.at + shift) * DAffine3::from_quat(turn) * DAffine3::from_translation(-self.at)
    }
}

/// A system of equations for a step, split into determined and undetermined directions.
pub(crate) struct Seen {
    svd: SVD<f64, nalgebra::Dyn, nalgebra::Dyn>,
    least: f64,
}

impl Seen {
    /// Decomposes a matrix given by rows; `N` is the number of unknowns.
    pub(crate) fn new<const N: usize>(rows: &[[f64; N]]) -> Self {
        // At least as many rows as unknowns, so that the unseen directions come out as well.
        let matrix = DMatrix::from_fn(rows.len().max(N), N, |i, j| rows.get(i).map_or(0.0, |row| row[j]));
        let svd = matrix.svd(true, true);
        let least = UNSEEN * svd.singular_values.max();
        Self { svd, least }
    }

    pub(crate) fn rank(&self) -> usize {
        self.svd.singular_values.iter().filter(|s| **s > self.least).count()
    }

    /// The shortest step that brings `residuals` nearest to zero, damped (Levenberg-Marquardt): `damping` is relative
    /// to the strongest direction.
    pub(crate) fn step(&self, residuals: &[f64], damping: f64) -> Vec<f64> {
        let (Some(u), Some(vt)) = (&self.svd.u, &self.svd.v_t) else { return vec![0.0; self.unknowns()] };
        let r = DVector::from_fn(u.nrows(), |i, _| residuals.get(i).copied().unwrap_or(0.0));
        let damping = damping * self.svd.singular_values.max().powi(2);
        let mut step = DVector::zeros(self.unknowns());
        for (i, &s) in self.svd.singular_values.iter().enumerate().filter(|(_, s)| **s > self.least) {
            let amount = -s / (s * s + damping) * u.column(i).dot(&r);
            step += amount * vt.row(i).transpose();
        }
        step.as_slice().to_vec()
    }

    fn unknowns(&self) -> usize {
        self.svd.singular_values.len()
    }

    /// Standard deviations of the first six unknowns, if there are more residuals than determined directions.
    pub(crate) fn deviation(&self, twists: &Twists, residuals: &[f64]) -> Option<Deviation> {
        let spare = residuals.len().checked_sub(self.rank()).filter(|n| *n > 0)?;
        let variance = residuals.iter().map(|r| r * r).sum::<f64>() / spare as f64;
        let vt = self.svd.v_t.as_ref()?;
        let of = |k: usize| -> f64 {
            let seen = self.svd.singular_values.iter().enumerate().filter(|(_, s)| **s > self.least);
            seen.map(|(i, s)| (vt[(i, k)] / s).powi(2)).sum::<f64>()
        };
        let sigma = |k: usize| (variance * of(k)).sqrt();
        let turn = DVec3::new(sigma(3), sigma(4), sigma(5)) / twists.reach;
        Some(Deviation { at: twists.at, shift: DVec3::new(sigma(0), sigma(1), sigma(2)), turn })
    }

    /// The undetermined motions: first translations, then rotations about axes as near to the points as possible.
    pub(crate) fn free(&self, twists: &Twists) -> Vec<Motion> {
        let Some(vt) = &self.svd.v_t else { return Vec::new() };
        let unseen: Vec<usize> = (0..self.unknowns()).filter(|i| self.svd.singular_values[*i] <= self.least).collect();
        if unseen.is_empty() {
            return Vec::new();
        }
        // Combinations of the undetermined motions, sorted by their share of rotation.
        let turns =
            DMatrix::from_fn(
                unseen.len().max(3),
                unseen.len(),
                |i, j| {
                    if i < 3 { vt[(unseen[j], 3 + i)] } else { 0.0 }
                },
            );
        let turns = turns.svd(false, true);
        let Some(mix) = &turns.v_t else { return Vec::new() };
        let part = |k: usize, from: usize| -> DVec3 {
            let sum = |i: usize| unseen.iter().enumerate().map(|(j, u)| mix[(k, j)] * vt[(*u, from + i)]).sum();
            DVec3::new(sum(0), sum(1), sum(2))
        };
        let (moves, turns): (Vec<usize>, Vec<usize>) =
            (0..unseen.len()).partition(|k| turns.singular_values[*k] < UNSEEN);
        let moves = axes_first(moves.iter().map(|k| part(*k, 0).normalize()).collect());
        let turns: Vec<(DVec3, DVec3)> = turns.iter().map(|k| (part(*k, 0), part(*k, 3) / twists.reach)).collect();
        let mut motions: Vec<Motion> = moves.into_iter().map(|v| Motion::Along(positive(v))).collect();
        // The turns at hand are perpendicular to each other: the ones about the wanted axes are sums of them.
        motions.extend(axes_first(turns.iter().map(|t| t.1.normalize()).collect()).into_iter().map(|direction| {
            let direction = positive(direction);
            let shift: DVec3 = turns.iter().map(|(s, w)| direction.dot(*w) / w.length_squared() * *s).sum();
            let point = twists.at + direction.cross(shift);
            Motion::About { point, direction, pitch: TAU * shift.dot(direction) }
        }));
        motions
    }
}

/// Directions that span the same space as the unit vectors `span`, perpendicular to each other, as near to the frame's
/// axes as possible.
pub(super) fn axes_first(span: Vec<DVec3>) -> Vec<DVec3> {
    let inside = |e: DVec3| span.iter().map(|m| e.dot(*m) * *m).sum::<DVec3>();
    let mut candidates = [DVec3::X, DVec3::Y, DVec3::Z].map(inside);
    candidates.sort_by(|a, b| b.length().total_cmp(&a.length()));
    let mut chosen: Vec<DVec3> = Vec::new();
    for v in candidates {
        let rest = v - chosen.iter().map(|c| v.dot(*c) * *c).sum::<DVec3>();
        // Of the axes not chosen yet, one always has at least 1/sqrt(3) of itself in what is left of the space.
        if chosen.len() < span.len() && rest.length() > 0.3 {
            chosen.push(rest.normalize());
        }
    }
    if chosen.len() == span.len() { chosen } else { span }
}
