use crate::error::Error;
use crate::knots::knots;
use crate::slopes::{End, periodic_slopes, slopes};

/// A cubic spline through values at increasing positions: twice continuously differentiable. Level (slope 0) at its
/// ends and constant beyond them, or natural (no curvature at its ends) and straight beyond them, or repeating with a
/// period (de Boor, A Practical Guide to Splines, chapter IV).
///
/// Used for tables, where a jump in the second derivative would be a jump in an axis' acceleration.
#[derive(Debug, Clone, PartialEq)]
pub struct CubicSpline {
    x: Vec<f64>,
    y: Vec<f64>,
    slope: Vec<f64>,
    period: Option<f64>,
}

impl CubicSpline {
    /// The spline through `points` (position, value), level at the first and last and constant beyond them.
    ///
    /// # Errors
    /// [`Error::Knots`] if positions do not increase strictly or there is no point.
    pub fn level(points: &[(f64, f64)]) -> Result<Self, Error> {
        let (x, y) = knots(points, None)?;
        let level = End::Slope(0.0);
        Ok(Self { slope: slopes(&x, &y, &level, &level), x, y, period: None })
    }

    /// The natural spline through `points` (position, value): without curvature at the first and last and straight
    /// beyond them, so it is twice continuously differentiable there too. Of all smooth curves through them it is the
    /// one with the least curvature (in the mean square; Holladay, 1957).
    ///
    /// # Errors
    /// As [`CubicSpline::level`].
    pub fn natural(points: &[(f64, f64)]) -> Result<Self, Error> {
        let (x, y) = knots(points, None)?;
        Ok(Self { slope: slopes(&x, &y, &End::Natural, &End::Natural), x, y, period: None })
    }

    /// The spline through `points` that repeats every `period`; positions must lie within one period.
    ///
    /// # Errors
    /// As [`CubicSpline::level`], and if the points span a period or more.
    pub fn periodic(points: &[(f64, f64)], period: f64) -> Result<Self, Error> {
        let (x, y) = knots(points, Some(period))?;
        Ok(Self { slope: periodic_slopes(&x, &y), x, y, period: Some(period) })
    }

    /// Maximum absolute slope.
    pub fn steepest(&self) -> f64 {
        let piece = |i: usize| {
            let h = self.x[i] - self.x[i - 1];
            let (m0, m1, mean) = (self.slope[i - 1], self.slope[i], (self.y[i] - self.y[i - 1]) / h);
            // The slope is m0 + b t + a t^2 over the part t of the interval.
            let (a, b) = (3.0 * (m0 + m1 - 2.0 * mean), 2.0 * (3.0 * mean - 2.0 * m0 - m1));
            let vertex = -b / (2.0 * a);
            let between = if vertex > 0.0 && vertex < 1.0 { m0 + 0.5 * b * vertex } else { m0 };
            m0.abs().max(m1.abs()).max(between.abs())
        };
        (1..self.x.len()).map(piece).fold(0.0, f64::max)
    }

    /// Value, first and second derivative at `x`.
    pub fn at(&self, x: f64) -> (f64, f64, f64) {
        let n = self.x.len();
        let (first, last) = (self.x[0], self.x[n - 1]);
        let x = match self.period {
            Some(period) => first + (x - first).rem_euclid(period),
            None if n == 1 => return (self.y[0], 0.0, 0.0),
            None if x < first => return (self.y[0] + self.slope[0] * (x - first), self.slope[0], 0.0),
            None if x > last => return (self.y[n - 1] + self.slope[n - 1] * (x - last), self.slope[n - 1], 0.0),
            None => x,
        };
        let i = self.x.partition_point(|k| *k <= x).clamp(1, n - 1);
        let h = self.x[i] - self.x[i - 1];
        let (t, rise) = ((x - self.x[i - 1]) / h, self.y[i] - self.y[i - 1]);
        // Cubic through both values with both slopes, in the part t of the interval.
        let (m0, m1) = (h * self.slope[i - 1], h * self.slope[i]);
        let (c2, c3) = (3.0 * rise - 2.0 * m0 - m1, m0 + m1 - 2.0 * rise);
        let value = self.y[i - 1] + t * (m0 + t * (c2 + t * c3));
        (value, (m0 + t * (2.0 * c2 + 3.0 * t * c3)) / h, (2.0 * c2 + 6.0 * t * c3) / (h * h))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Values, and continuity of both derivatives at every knot.
    fn check(spline: &CubicSpline, points: &[(f64, f64)]) {
        for &(x, y) in points {
            let (l, r) = (spline.at(x - 1e-7), spline.at(x + 1e-7));
            assert!((spline.at(x).0 - y).abs() < 1e-12);
            assert!((l.1 - r.1).abs() < 1e-4 * (1.0 + l.1.abs()), "{x}: {l:?} {r:?}");
            if spline.period.is_some() || (x > points[0].0 && x < points[points.len() - 1].0) {
                assert!((l.2 - r.2).abs() < 1e-4 * (1.0 + l.2.abs()), "{x}: {l:?} {r:?}");
            }
        }
        let steepest = (0..20_000).map(|k| spline.at(points[0].0 + 0.001 * f64::from(k)).1.abs()).fold(0.0, f64::max);
        assert!(steepest <= spline.steepest() * (1.0 + 1e-12), "{steepest} {}", spline.steepest());
        for k in 0..200 {
            let x = points[0].0 + 0.0371 * f64::from(k);
            let h = 1e-6;
            let (l, m, r) = (spline.at(x - h), spline.at(x), spline.at(x + h));
            assert!(((r.0 - l.0) / (2.0 * h) - m.1).abs() < 1e-4 * (1.0 + m.1.abs()));
        }
    }

    #[test]
    fn passes_through_its_points_smoothly() {
        for n in [2, 3, 4, 9] {
            let points: Vec<_> = (0..n)
                .map(|i| {
                    let x = f64::from(i);
                    (x + 0.3 * (1.7 * x).sin(), (2.3 * x).cos())
                })
                .collect();
            let level = CubicSpline::level(&points).unwrap();
            check(&level, &points);
            let last = points[points.len() - 1];
            assert!((level.at(last.0 + 5.0).0 - last.1).abs() < 1e-15 && level.at(last.0).1.abs() < 1e-12);
            let natural = CubicSpline::natural(&points).unwrap();
            check(&natural, &points);
            for (x, inside) in [(points[0].0, 1e-9), (last.0, -1e-9)] {
                let (_, slope, second) = natural.at(x + inside);
                assert!(second.abs() < 1e-6 && (natural.at(x - 1e9 * inside).1 - slope).abs() < 1e-6, "{x}");
            }
            let periodic = CubicSpline::periodic(&points, last.0 - points[0].0 + 0.9).unwrap();
            check(&periodic, &points);
        }
        assert!((CubicSpline::level(&[(2.0, 7.0)]).unwrap().at(-3.0).0 - 7.0).abs() < 1e-15);
        assert!((CubicSpline::periodic(&[(2.0, 7.0)], 1.0).unwrap().at(-3.4).0 - 7.0).abs() < 1e-15);
        assert!(CubicSpline::level(&[(1.0, 0.0), (1.0, 1.0)]).is_err());
        assert!(CubicSpline::periodic(&[(0.0, 0.0), (2.0, 1.0)], 2.0).is_err());
    }

    /// A straight line stays straight, inside and beyond.
    #[test]
    fn natural_splines_keep_lines() {
        let spline = CubicSpline::natural(&[(0.0, 1.0), (0.5, 2.0), (3.0, 7.0), (4.0, 9.0)]).unwrap();
        for x in [-2.0, 0.1, 1.7, 3.9, 8.0] {
            let (y, slope, second) = spline.at(x);
            assert!((y - 1.0 - 2.0 * x).abs() < 1e-13 && (slope - 2.0).abs() < 1e-13 && second.abs() < 1e-12, "{x}");
        }
        assert!((CubicSpline::natural(&[(2.0, 7.0)]).unwrap().at(-3.0).0 - 7.0).abs() < 1e-15);
    }

    /// A fine spline of a sine repeats it to the fourth order.
    #[test]
    fn approximates_to_the_fourth_order() {
        let error = |n: u32| {
            let step = std::f64::consts::TAU / f64::from(n);
            let points: Vec<_> = (0..n).map(|i| (f64::from(i) * step, (f64::from(i) * step).sin())).collect();
            let s = CubicSpline::periodic(&points, std::f64::consts::TAU).unwrap();
            (0..997).map(|k| (s.at(f64::from(k) * 0.01).0 - (f64::from(k) * 0.01).sin()).abs()).fold(0.0, f64::max)
        };
        assert!(error(20) / error(40) > 14.0, "{} {}", error(20), error(40));
    }
}
