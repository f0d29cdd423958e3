use crate::error::Error;
use crate::knots::knots;

/// A smooth curve through values at increasing positions that never leaves the range of two neighbouring values:
/// quintic pieces without curvature at the knots, with the slopes of Fritsch and Butland (SIAM J. Sci. Stat. Comput. 5,
/// 1984), at most twice the smaller one beside. Either level at its ends and constant beyond them, or repeating with a
/// period. Twice continuously differentiable, so that an axis that follows it needs no jump in its acceleration.
///
/// Used for values that an operator gives at a few stations of a path: an overshoot between them would be an
/// unrequested angle.
#[derive(Debug, Clone, PartialEq)]
pub struct MonotoneCurve {
    x: Vec<f64>,
    y: Vec<f64>,
    slope: Vec<f64>,
    period: Option<f64>,
}

impl MonotoneCurve {
    /// The curve through `points` (position, value): level at the first and last and constant beyond them, or repeating
    /// every `period`, within which the positions must lie.
    ///
    /// # Errors
    /// [`Error::Knots`] if positions do not increase strictly, span a period or more, or there is no point.
    pub fn new(points: &[(f64, f64)], period: Option<f64>) -> Result<Self, Error> {
        let (x, y) = knots(points, period)?;
        let slope = slopes(&x, &y, period.is_some());
        Ok(Self { x, y, slope, period })
    }

    /// Positions of the knots between which the curve is one cubic.
    pub fn knots(&self) -> &[f64] {
        &self.x
    }

    /// The period, if the curve repeats.
    pub fn period(&self) -> Option<f64> {
        self.period
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
        // Quintic Hermite form with second derivatives zero. Its slope is a weighted sum of the mean slope and those at
        // the ends. The mean's positive weight dominates while the end slopes are at most twice the mean.
        let step = |x: f64| x * x * x * (10.0 + x * (6.0 * x - 15.0));
        let lean = |x: f64| x * (1.0 + x * x * (x * (8.0 - 3.0 * x) - 6.0));
        self.y[i - 1] * step(a) + self.y[i] * step(b) + h * (self.slope[i - 1] * lean(b) - self.slope[i] * lean(a))
    }
}

/// Slopes at the knots: zero where the values turn, else the weighted harmonic mean of the two sides' slopes.
fn slopes(x: &[f64], y: &[f64], periodic: bool) -> Vec<f64> {
    let n = x.len();
    let piece = |i: usize| (x[i + 1] - x[i], (y[i + 1] - y[i]) / (x[i + 1] - x[i]));
    let mean = |(h0, s0): (f64, f64), (h1, s1): (f64, f64)| {
        if s0 * s1 <= 0.0 {
            return 0.0;
        }
        let (w0, w1) = (2.0 * h1 + h0, h1 + 2.0 * h0);
        let mean = (w0 + w1) / (w0 / s0 + w1 / s1);
        mean.signum() * mean.abs().min(2.0 * s0.abs().min(s1.abs()))
    };
    let mut slopes = vec![0.0; n];
    for (i, slope) in slopes.iter_mut().enumerate() {
        if i > 0 && i + 1 < n {
            *slope = mean(piece(i - 1), piece(i));
        } else if periodic && n > 1 {
            *slope = mean(piece(n - 2), piece(0));
        }
    }
    slopes
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn derivative(s: &MonotoneCurve, x: f64) -> f64 {
        (s.at(x + 1e-6) - s.at(x - 1e-6)) / 2e-6
    }

    proptest! {
        #[test]
        fn passes_through_its_points_smoothly_and_never_beyond_them(
            steps in prop::collection::vec((0.01..50.0f64, -80.0..80.0f64), 1..8), repeats in any::<bool>(),
        ) {
            let mut x = 0.0;
            let points: Vec<(f64, f64)> = steps.iter().map(|(d, y)| { x += d; (x, *y) }).collect();
            let curve = MonotoneCurve::new(&points, repeats.then_some(x + 10.0)).unwrap();
            for w in curve.knots().windows(2) {
                let (l, r) = (curve.at(w[0]), curve.at(w[1]));
                for k in 0..=20 {
                    let v = curve.at(w[0] + (w[1] - w[0]) * f64::from(k) / 20.0);
                    prop_assert!(v >= l.min(r) - 1e-9 && v <= l.max(r) + 1e-9);
                }
            }
            for (i, (x, y)) in points.iter().enumerate() {
                prop_assert!((curve.at(*x) - y).abs() < 1e-9);
                let (l, r) = (derivative(&curve, x - 2e-6), derivative(&curve, x + 2e-6));
                prop_assert!((l - r).abs() < 1e-2 * (1.0 + l.abs()) * 200.0 / steps.iter().map(|s| s.0).fold(1.0, f64::min), "{} {} {}", i, l, r);
            }
        }
    }

    #[test]
    fn one_point_is_a_constant_and_two_are_the_quintic_step() {
        for period in [None, Some(10.0)] {
            assert!((MonotoneCurve::new(&[(3.0, 7.0)], period).unwrap().at(100.0) - 7.0).abs() < 1e-15);
        }
        let s = MonotoneCurve::new(&[(0.0, 0.0), (2.0, 1.0)], None).unwrap();
        let x: f64 = 0.3;
        assert!((s.at(2.0 * x) - x.powi(3) * (10.0 - 15.0 * x + 6.0 * x * x)).abs() < 1e-15);
        assert!((s.at(-5.0)).abs() < 1e-15 && (s.at(9.0) - 1.0).abs() < 1e-15);
    }

    #[test]
    fn a_straight_row_stays_straight_inside() {
        let s = MonotoneCurve::new(&[(0.0, 0.0), (1.0, 2.0), (3.0, 6.0), (4.0, 8.0)], None).unwrap();
        assert!((s.at(2.2) - 4.4).abs() < 1e-14);
    }

    #[test]
    fn bad_positions_are_refused() {
        assert_eq!(MonotoneCurve::new(&[(0.0, 1.0), (0.0, 2.0)], None), Err(Error::Knots { index: 1 }));
        assert_eq!(MonotoneCurve::new(&[], None), Err(Error::Knots { index: 0 }));
        assert!(MonotoneCurve::new(&[(0.0, 1.0), (10.0, 2.0)], Some(10.0)).is_err());
    }
}
