use crate::Error;
use crate::knots::knots;

/// A cubic spline through values at increasing positions: twice continuously differentiable. Level (slope 0) at its
/// ends and constant beyond them, or natural (no curvature at its ends) and straight beyond them, or repeating with a
/// period (de Boor, A Practical Guide to Splines, chapter IV).
///
/// Used for tables, where a jump in the second derivative would be a jump in an axis' acceleration.
#[derive(Debug, Clone, PartialEq)]
pub struct CubicSpline {
    x: Vec<f64>,
    y: Vec<f64>,
    /// Slopes at the knots.
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
        Ok(Self { slope: level_slopes(&x, &y), x, y, period: None })
    }

    /// The natural spline through `points` (position, value): without curvature at the first and last and straight
    /// beyond them, so it is twice continuously differentiable there too. Of all smooth curves through them it is the
    /// one with the least curvature (in the mean square; Holladay, 1957).
    ///
    /// # Errors
    /// As [`CubicSpline::level`].
    pub fn natural(points: &[(f64, f64)]) -> Result<Self, Error> {
        let (x, y) = knots(points, None)?;
        Ok(Self { slope: natural_slopes(&x, &y), x, y, period: None })
    }

    /// The spline through `points` that repeats every `period`; positions must lie within one period.
    ///
    /// # Errors
    /// As [`CubicSpline::level`], and if the points span a period or more.
    pub fn periodic(points: &[(f64, f64)], period: f64) -> Result<Self, Error> {
        let (x, y) = knots(points, Some(period))?;
        Ok(Self { slope: periodic_slopes(&x, &y), x, y, period: Some(period) })
    }

    /// The greatest slope anywhere, up or down.
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

/// Right side of the condition that the second derivative is continuous at knot `i`, and its three coefficients.
fn row(y: &[f64], (before, i, after): (usize, usize, usize), (h0, h1): (f64, f64)) -> ([f64; 3], f64) {
    let right = 3.0 * ((y[i] - y[before]) / (h0 * h0) + (y[after] - y[i]) / (h1 * h1));
    ([1.0 / h0, 2.0 / h0 + 2.0 / h1, 1.0 / h1], right)
}

fn level_slopes(x: &[f64], y: &[f64]) -> Vec<f64> {
    let n = x.len();
    let rows: Vec<_> =
        (1..n.saturating_sub(1)).map(|i| row(y, (i - 1, i, i + 1), (x[i] - x[i - 1], x[i + 1] - x[i]))).collect();
    let mut slopes = vec![0.0; n];
    for (i, slope) in tridiagonal(&rows).into_iter().enumerate() {
        slopes[i + 1] = slope;
    }
    slopes
}

fn natural_slopes(x: &[f64], y: &[f64]) -> Vec<f64> {
    let n = x.len();
    if n == 1 {
        return vec![0.0];
    }
    let steepness = |i: usize| 3.0 * (y[i + 1] - y[i]) / (x[i + 1] - x[i]);
    let mut rows = vec![([0.0, 2.0, 1.0], steepness(0))];
    rows.extend((1..n - 1).map(|i| row(y, (i - 1, i, i + 1), (x[i] - x[i - 1], x[i + 1] - x[i]))));
    rows.push(([1.0, 2.0, 0.0], steepness(n - 2)));
    tridiagonal(&rows)
}

/// Slopes of the closed spline: the cyclic system is the tridiagonal one with a correction of rank one (Sherman and
/// Morrison).
fn periodic_slopes(x: &[f64], y: &[f64]) -> Vec<f64> {
    let n = x.len() - 1;
    if n < 3 {
        // One value, or two: solve the full cyclic system of at most two unknowns by symmetry.
        return closed_by_symmetry(x, y, n);
    }
    let step = |i: usize| x[i + 1] - x[i];
    let mut rows: Vec<_> = (0..n)
        .map(|i| {
            let before = (i + n - 1) % n;
            row(y, (before, i, i + 1), (step(before), step(i)))
        })
        .collect();
    let corner = 1.0 / step(n - 1);
    let shift = -rows[0].0[1];
    rows[0].0[1] -= shift;
    rows[n - 1].0[1] -= corner * corner / shift;
    let plain = tridiagonal(&rows);
    for (i, r) in rows.iter_mut().enumerate() {
        r.1 = if i == 0 {
            shift
        } else if i == n - 1 {
            corner
        } else {
            0.0
        };
    }
    let corrector = tridiagonal(&rows);
    let factor = (plain[0] + corner / shift * plain[n - 1]) / (1.0 + corrector[0] + corner / shift * corrector[n - 1]);
    let mut slopes: Vec<f64> = plain.iter().zip(&corrector).map(|(p, c)| p - factor * c).collect();
    slopes.push(slopes[0]);
    slopes
}

fn closed_by_symmetry(x: &[f64], y: &[f64], n: usize) -> Vec<f64> {
    if n < 2 {
        return vec![0.0; n + 1];
    }
    // Two knots a period: both conditions have the same coefficients and opposite right sides.
    let (h0, h1) = (x[1] - x[0], x[2] - x[1]);
    let right = 3.0 * (y[1] - y[0]) * (1.0 / (h0 * h0) - 1.0 / (h1 * h1));
    let slope = right / (1.0 / h0 + 1.0 / h1) / 3.0;
    vec![slope, slope, slope]
}

/// Solves a tridiagonal system (Thomas' algorithm; the matrices here are diagonally dominant).
fn tridiagonal(rows: &[([f64; 3], f64)]) -> Vec<f64> {
    let n = rows.len();
    let mut above = vec![0.0; n];
    let mut value = vec![0.0; n];
    for (i, ([a, b, c], r)) in rows.iter().enumerate() {
        let (last_above, last) = if i > 0 { (above[i - 1], value[i - 1]) } else { (0.0, 0.0) };
        let pivot = b - if i > 0 { a * last_above } else { 0.0 };
        above[i] = c / pivot;
        value[i] = (r - if i > 0 { a * last } else { 0.0 }) / pivot;
    }
    for i in (0..n.saturating_sub(1)).rev() {
        value[i] -= above[i] * value[i + 1];
    }
    value
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
