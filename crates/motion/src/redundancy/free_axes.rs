use glam::DVec3;
use seamwright_machine::{Joints, RollReference};

/// The axes that a path leaves free, by path length: each rests or follows a uniform cubic B-spline, so that its second
/// derivative is continuous.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct FreeAxes {
    pub(crate) length: f64,
    pub(crate) still: Vec<(usize, f64)>,
    pub(crate) moving: Vec<(usize, Vec<f64>)>,
    /// Rotation about the torch, if it is free: the entry of the positions that holds it, beyond those of the axes.
    pub(crate) roll: Option<FreeRoll>,
    /// Positions of all axes at the start of the path, if the branch is chosen.
    pub(crate) start: Option<Joints>,
}

/// The rotation about the torch of a six-axis arm as a free coordinate.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct FreeRoll {
    pub(crate) entry: usize,
    pub(crate) reference: RollReference,
}

impl FreeRoll {
    /// Direction across a torch of `direction` at the rotation in `q`.
    pub(crate) fn across(&self, direction: DVec3, q: &Joints) -> DVec3 {
        self.reference.across(direction, q[self.entry])
    }
}

/// Basis of a uniform cubic B-spline at one path length: the first of its four coefficients, and their factors.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Basis {
    pub(crate) first: usize,
    pub(crate) factors: [f64; 4],
}

impl Basis {
    /// At `s` in [0, `length`] of a spline with `intervals` (and three more coefficients).
    pub(crate) fn at(s: f64, length: f64, intervals: usize) -> Self {
        let x = (s / length * intervals as f64).clamp(0.0, intervals as f64);
        let first = (x as usize).min(intervals - 1);
        let t = x - first as f64;
        let back = 1.0 - t;
        let factors = [
            back * back * back / 6.0,
            2.0 / 3.0 - t * t * (1.0 - 0.5 * t),
            2.0 / 3.0 - back * back * (1.0 - 0.5 * back),
            t * t * t / 6.0,
        ];
        Self { first, factors }
    }

    pub(crate) fn of(&self, coefficients: &[f64]) -> f64 {
        self.factors.iter().zip(&coefficients[self.first..]).map(|(b, c)| b * c).sum()
    }
}

impl FreeAxes {
    /// `near` with the free axes at their positions at path length `s` (mm), mm or rad.
    pub fn at(&self, s: f64, near: &Joints) -> Joints {
        let mut q = *near;
        for &(axis, value) in &self.still {
            q[axis] = value;
        }
        if let Some((_, first)) = self.moving.first() {
            let basis = Basis::at(s, self.length, first.len() - 3);
            self.moving.iter().for_each(|(axis, c)| q[*axis] = basis.of(c));
        }
        q
    }

    /// Positions of all axes at the start of the path; none if the path leaves no axis free.
    pub fn start(&self) -> Option<Joints> {
        self.start
    }

    pub(crate) fn has(&self, axis: usize) -> bool {
        self.still.iter().any(|(a, _)| *a == axis) || self.moving.iter().any(|(a, _)| *a == axis)
    }

    /// Inner path lengths at which a third derivative may jump, increasing.
    pub(crate) fn knots(&self) -> Vec<f64> {
        let intervals = self.moving.first().map_or(0, |(_, c)| c.len() - 3);
        (1..intervals).map(|i| self.length * i as f64 / intervals as f64).collect()
    }
}
