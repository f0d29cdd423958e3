use crate::Error;

/// A cubic spline through values at increasing positions, either level at its ends and constant beyond them, or
/// repeating with a period. Twice continuously differentiable, but for the second derivative at level ends.
///
/// Used for what an operator gives at a few places along a path and wants to change smoothly between them.
#[derive(Debug, Clone, PartialEq)]
pub struct CubicSpline {
    x: Vec<f64>,
    y: Vec<f64>,
    /// Second derivatives at the knots.
    m: Vec<f64>,
    period: Option<f64>,
}

impl CubicSpline {
    /// The spline through `points` (position, value) with slope 0 at the first and last; constant beyond them.
    ///
    /// # Errors
    /// [`Error::Knots`] if positions do not increase strictly or there is no point.
    pub fn level(points: &[(f64, f64)]) -> Result<Self, Error> {
        Self::build(points, None)
    }

    /// The spline through `points` that repeats every `period`; positions must lie within one period.
    ///
    /// # Errors
    /// As [`CubicSpline::level`], and if the points span a period or more.
    pub fn periodic(points: &[(f64, f64)], period: f64) -> Result<Self, Error> {
        Self::build(points, Some(period))
    }

    fn build(points: &[(f64, f64)], period: Option<f64>) -> Result<Self, Error> {
        if let Some(index) = (1..points.len()).find(|&i| points[i].0 <= points[i - 1].0 || !points[i].0.is_finite()) {
            return Err(Error::Knots { index });
        }
        let (Some(first), Some(last)) = (points.first(), points.last()) else {
            return Err(Error::Knots { index: 0 });
        };
        let mut x: Vec<f64> = points.iter().map(|p| p.0).collect();
        let mut y: Vec<f64> = points.iter().map(|p| p.1).collect();
        if let Some(period) = period {
            if last.0 - first.0 >= period {
                return Err(Error::Knots { index: points.len() - 1 });
            }
            x.push(first.0 + period);
            y.push(first.1);
        }
        let m = second_derivatives(&x, &y, period.is_some());
        Ok(Self { x, y, m, period })
    }

    /// Positions of the knots between which the spline is one cubic.
    pub fn knots(&self) -> &[f64] {
        &self.x
    }

    /// Value at `x`.
    pub fn at(&self, x: f64) -> f64 {
        let (first, last) = (self.x[0], self.x[self.x.len() - 1]);
        let x = match self.period {
            Some(period) => first + (x - first).rem_euclid(period),
            None => x.clamp(first, last),
        };
        if self.x.len() == 1 {
            return self.y[0];
        }
        let i = self.x.partition_point(|k| *k <= x).clamp(1, self.x.len() - 1);
        let h = self.x[i] - self.x[i - 1];
        let (a, b) = ((self.x[i] - x) / h, (x - self.x[i - 1]) / h);
        a * self.y[i - 1]
            + b * self.y[i]
            + ((a * a * a - a) * self.m[i - 1] + (b * b * b - b) * self.m[i]) * h * h / 6.0
    }
}

/// The second derivatives at the knots: a diagonally dominant system (splines here have few knots, so it is dense).
fn second_derivatives(x: &[f64], y: &[f64], periodic: bool) -> Vec<f64> {
    let n = x.len();
    if n < 2 {
        return vec![0.0; n];
    }
    // Unknowns: all knots, but for the last of a periodic spline, which equals the first.
    let unknowns = if periodic { n - 1 } else { n };
    let mut rows = vec![vec![0.0; unknowns + 1]; unknowns];
    for piece in 0..n - 1 {
        let (h, slope) = (x[piece + 1] - x[piece], (y[piece + 1] - y[piece]) / (x[piece + 1] - x[piece]));
        // Each piece adds its part to the condition that the slope is continuous (or 0 at a level end).
        let (a, b) = (piece, (piece + 1) % unknowns);
        rows[a][a] += 2.0 * h;
        rows[a][b] += h;
        rows[a][unknowns] += 6.0 * slope;
        rows[b][b] += 2.0 * h;
        rows[b][a] += h;
        rows[b][unknowns] -= 6.0 * slope;
    }
    let mut m = eliminate(rows);
    if periodic {
        m.push(m[0]);
    }
    m
}

/// Gaussian elimination without pivoting, stable because the rows are diagonally dominant.
fn eliminate(mut rows: Vec<Vec<f64>>) -> Vec<f64> {
    let n = rows.len();
    for k in 0..n {
        let (top, rest) = rows.split_at_mut(k + 1);
        let pivot = &top[k];
        for row in rest {
            let factor = row[k] / pivot[k];
            if factor != 0.0 {
                for j in k..=n {
                    row[j] -= factor * pivot[j];
                }
            }
        }
    }
    let mut x = vec![0.0; n];
    for k in (0..n).rev() {
        let known: f64 = (k + 1..n).map(|j| rows[k][j] * x[j]).sum();
        x[k] = (rows[k][n] - known) / rows[k][k];
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;

    fn derivative(s: &CubicSpline, x: f64) -> f64 {
        (s.at(x + 1e-5) - s.at(x - 1e-5)) / 2e-5
    }

    #[test]
    fn level_spline_passes_through_its_points_with_continuous_slope_and_curvature() {
        let points = [(0.0, 1.0), (1.0, 3.0), (2.5, -1.0), (4.0, 0.5)];
        let s = CubicSpline::level(&points).unwrap();
        for (x, y) in points {
            assert!((s.at(x) - y).abs() < 1e-14);
            assert!((derivative(&s, x - 2e-5) - derivative(&s, x + 2e-5)).abs() < 1e-3);
        }
        let second = |x: f64| (s.at(x + 1e-3) - 2.0 * s.at(x) + s.at(x - 1e-3)) / 1e-6;
        for x in [1.0, 2.5] {
            assert!((second(x - 2e-3) - second(x + 2e-3)).abs() < 0.2);
        }
        assert!(derivative(&s, 0.0).abs() < 1e-3 && derivative(&s, 4.0).abs() < 1e-3);
        assert!((s.at(-5.0) - 1.0).abs() < 1e-15 && (s.at(9.0) - 0.5).abs() < 1e-15);
    }

    #[test]
    fn periodic_spline_approximates_a_sine_to_fourth_order() {
        let error = |n: usize| {
            let step = std::f64::consts::TAU / n as f64;
            let points: Vec<_> = (0..n).map(|i| (i as f64 * step, (i as f64 * step).sin())).collect();
            let s = CubicSpline::periodic(&points, std::f64::consts::TAU).unwrap();
            (0..997).map(|i| f64::from(i) * 0.0217).map(|x| (s.at(x) - x.sin()).abs()).fold(0.0, f64::max)
        };
        assert!(error(16) < 5e-4 && error(32) < error(16) / 12.0);
    }

    #[test]
    fn one_point_is_a_constant_and_two_are_the_cubic_step() {
        assert!((CubicSpline::level(&[(3.0, 7.0)]).unwrap().at(100.0) - 7.0).abs() < 1e-15);
        assert!((CubicSpline::periodic(&[(3.0, 7.0)], 10.0).unwrap().at(100.0) - 7.0).abs() < 1e-15);
        let s = CubicSpline::level(&[(0.0, 0.0), (2.0, 1.0)]).unwrap();
        let x: f64 = 0.3;
        assert!((s.at(2.0 * x) - (3.0 * x * x - 2.0 * x * x * x)).abs() < 1e-15);
    }

    #[test]
    fn two_points_on_a_period_swing_smoothly_between_their_values() {
        let s = CubicSpline::periodic(&[(0.0, -1.0), (5.0, 1.0)], 10.0).unwrap();
        assert!((s.at(2.5)).abs() < 1e-14 && derivative(&s, 0.0).abs() < 1e-9 && derivative(&s, 5.0).abs() < 1e-9);
    }

    #[test]
    fn bad_positions_are_refused() {
        assert_eq!(CubicSpline::level(&[(0.0, 1.0), (0.0, 2.0)]), Err(Error::Knots { index: 1 }));
        assert_eq!(CubicSpline::level(&[]), Err(Error::Knots { index: 0 }));
        assert!(CubicSpline::periodic(&[(0.0, 1.0), (10.0, 2.0)], 10.0).is_err());
    }
}
