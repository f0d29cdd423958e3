use super::cells::Cells;
use super::profile::ProfilePoint;
use super::rest_to_rest::RestToRest;
use crate::stretch::Stretch;
use serde::{Deserialize, Serialize};

/// A cell of a speed profile: `d2 tau / dt2 = a + w tau`, with `tau` from its start.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
pub(super) struct Cell {
    pub(super) tau: f64,
    end: f64,
    /// Start time and duration, s; kept apart because the difference of two instants loses digits.
    pub(super) t: f64,
    pub(super) time: f64,
    /// Speed and acceleration by `tau` at its start.
    pub(super) v: f64,
    pub(super) a: f64,
    pub(super) w: f64,
    /// True if the tip cruises at the requested speed in the whole cell, see [`Cells::cruises`].
    pub(super) cruises: bool,
    /// Squared speed at its start and end as fractions of the requested one; 0 if no speed is requested.
    pub(super) parts: [f64; 2],
}

impl Cell {
    /// Creates the cell over a stretch of `tau` from time `t` on, with the squared speed and its derivatives at its
    /// start (`profile`), and the requested squared speeds at its ends (`asked`).
    pub(super) fn new(over: Stretch, t: f64, profile: [f64; 3], cruises: bool, asked: [f64; 2]) -> Self {
        let Stretch { from: tau, to: end } = over;
        let [b, d, e] = profile;
        let width = end - tau;
        let b_end = b + width * (d + 0.5 * width * e);
        let v_end = b_end.max(0.0).sqrt();
        let (v, a, w) = (b.max(0.0).sqrt(), 0.5 * d, 0.5 * e);
        let parts = [b / asked[0], b_end / asked[1]];
        Self { tau, end, t, time: crossing(w, width / (v + v_end)), v, a, w, cruises, parts }
    }

    /// Creates cell `i` of a profile with coefficients `c` in `cells`, starting at time `t`.
    pub(super) fn of_spline(cells: &Cells, c: &[f64], i: usize, t: f64) -> Self {
        let w = cells.weights(i);
        let dot = |w: &[f64; 3]| w[0] * c[i] + w[1] * c[i + 1] + w[2] * c[i + 2];
        let cruises = cells.cruises(c, i);
        // With equal coefficients rounding must not change the speed.
        let constant = cruises && (i..i + 3).all(|k| c[k].to_bits() == c[i].to_bits());
        let profile = if constant { [c[i], 0.0, 0.0] } else { [dot(&w.value), dot(&w.first), dot(&w.second)] };
        let asked = cells.asked(i);
        Self::new(cells.stretch(i), t, profile, cruises, [asked[0], asked[asked.len() - 1]])
    }

    /// Speed in `tau` at `tau`: the squared speed is `v^2 + 2 a x + w x^2`.
    pub(super) fn speed(&self, tau: f64) -> f64 {
        let x = tau - self.tau;
        (self.v * self.v + x * (2.0 * self.a + self.w * x)).max(0.0).sqrt()
    }

    /// Time at which `tau` in it is passed with the speed `v`.
    pub(super) fn passed(&self, tau: f64, v: f64) -> f64 {
        if tau > self.tau { self.t + crossing(self.w, (tau - self.tau) / (self.v + v)) } else { self.t }
    }

    /// The profile at the time `t` after the cell's start, with the `map` of its piece; at a border of the map from the
    /// side `before`.
    pub(super) fn point(&self, map: &RestToRest, t: f64, before: bool) -> ProfilePoint {
        let (travelled, v) = self.after(t);
        let (a, j) = (self.a + self.w * travelled, self.w * v);
        let [u, m1, m2, m3] = map.at((self.tau + travelled).min(self.end), before);
        ProfilePoint { s: u, v: m1 * v, a: m2 * v * v + m1 * a, j: m3 * v * v * v + 3.0 * m2 * v * a + m1 * j }
    }

    /// Distance and speed in `tau` at the time `t` (s) after the start of the cell.
    fn after(&self, t: f64) -> (f64, f64) {
        let x = self.w * t * t;
        // sinh(sqrt(x)) / sqrt(x) and (cosh(sqrt(x)) - 1) / x, for either sign of x.
        let (s, c) = if x.abs() < 1e-2 {
            let s = 1.0 + x / 6.0 * (1.0 + x / 20.0 * (1.0 + x / 42.0 * (1.0 + x / 72.0)));
            (s, 0.5 + x / 24.0 * (1.0 + x / 30.0 * (1.0 + x / 56.0 * (1.0 + x / 90.0))))
        } else if x > 0.0 {
            let r = x.sqrt();
            (r.sinh() / r, (r.cosh() - 1.0) / x)
        } else {
            let r = (-x).sqrt();
            (r.sin() / r, (r.cos() - 1.0) / x)
        };
        (t * (self.v * s + self.a * t * c), (self.v * (1.0 + x * c) + self.a * t * s).max(0.0))
    }
}

/// Time over a cell whose width is `mean` times the sum of the speeds at its ends. The acceleration grows by `w` per
/// unit of `tau`: both solutions, `sinh` and `cosh` about the middle, cover `tanh(sqrt(w) t / 2) / sqrt(w)` per unit of
/// that sum.
fn crossing(w: f64, mean: f64) -> f64 {
    let x = w * mean * mean;
    if x.abs() < 1e-4 {
        // atanh(y) / y with y^2 = x.
        2.0 * mean * (1.0 + x * (1.0 / 3.0 + x * (0.2 + x / 7.0)))
    } else if x > 0.0 {
        // Clamped below 1 against rounding, if one speed is tiny compared with the other.
        2.0 * x.sqrt().min(1.0 - f64::EPSILON).atanh() / w.sqrt()
    } else {
        2.0 * (-x).sqrt().atan() / (-w).sqrt()
    }
}
