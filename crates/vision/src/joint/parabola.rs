/// Minimum determinant relative to its maximum for a parabola ...
const SINGULAR: f64 = 1e-9;
/// ... and for sums in single precision.
const SINGULAR_IN_SINGLE: f64 = 1e-6;
/// Minimum sum of weights for a standard error.
const FEW: f32 = 4.0;

/// A parabola fitted through points.
#[derive(Debug, Clone, Copy)]
pub(super) struct Parabola {
    /// Value, slope and half of the second derivative at 0.
    pub(super) terms: [f32; 3],
    /// Variance of the value at 0 for places of weight 1 and variance 1.
    pub(super) variance: f32,
    /// Weighted mean of the squared residuals, and the sum of the weights.
    pub(super) rest: f32,
    pub(super) weights: f32,
}

/// Weighted sums over points.
#[derive(Debug, Clone, Copy)]
struct Sums {
    /// Weights times x to the powers 0 to 4.
    powers: [f64; 5],
    /// Weights times y times x to the powers 0 to 2.
    products: [f64; 3],
    /// Weights times the square of y.
    squares: f64,
}

impl Parabola {
    /// Fits through points (x, y, weight) by least squares; `stiff` holds the last term near 0.
    pub(super) fn through(places: impl Iterator<Item = (f32, f32, f32)>, stiff: f32) -> Option<Self> {
        let (mut m, mut r, mut squares) = ([0.0f64; 5], [0.0f64; 3], 0.0f64);
        for (x, y, w) in places {
            let (x, y) = (f64::from(x), f64::from(y));
            let w = f64::from(w);
            let (wx, wxx) = (w * x, w * x * x);
            let wy = w * y;
            [w, wx, wxx, wxx * x, wxx * x * x].iter().zip(&mut m).for_each(|(power, m)| *m += power);
            [wy, wy * x, wy * x * x].iter().zip(&mut r).for_each(|(power, r)| *r += power);
            squares += wy * y;
        }
        Self::solve(Sums { powers: m, products: r, squares }, f64::from(stiff), SINGULAR)
    }

    /// Fits from sums over the points: weights times x to the powers 0 to 4, weights times y times x to the powers 0 to
    /// 2, and weights times the square of y.
    #[inline(always)]
    pub(super) fn of(m: [f32; 5], r: [f32; 3], squares: f32, stiff: f32) -> Option<Self> {
        let sums = Sums { powers: m.map(f64::from), products: r.map(f64::from), squares: f64::from(squares) };
        Self::solve(sums, f64::from(stiff), SINGULAR_IN_SINGLE)
    }

    #[inline(always)]
    fn solve(sums: Sums, stiff: f64, singular: f64) -> Option<Self> {
        let Sums { powers: m, products: r, squares } = sums;
        let bend = m[4] + stiff;
        // The inverse is the adjugate divided by the determinant.
        let [a, b, c] = [m[2] * bend - m[3] * m[3], m[2] * m[3] - m[1] * bend, m[1] * m[3] - m[2] * m[2]];
        let [d, e, f] = [m[0] * bend - m[2] * m[2], m[1] * m[2] - m[0] * m[3], m[0] * m[2] - m[1] * m[1]];
        let determinant = m[0] * a + m[1] * b + m[2] * c;
        let is_told = determinant > singular * m[0] * m[2] * bend;
        if !is_told {
            return None;
        }
        let part = 1.0 / determinant;
        let found = [[a, b, c], [b, d, e], [c, e, f]].map(|row| part * (row[0] * r[0] + row[1] * r[1] + row[2] * r[2]));
        let variance = part * a;
        let fitted = found[0] * r[0] + found[1] * r[1] + found[2] * r[2] + stiff * found[2] * found[2];
        let rest = (squares - fitted).max(0.0) / m[0];
        let [value, slope, bend] = found.map(|t| t as f32);
        let (variance, rest, weights) = (variance as f32, rest as f32, m[0] as f32);
        Some(Self { terms: [value, slope, bend], variance, rest, weights })
    }

    /// Returns the standard error of the value at 0; infinite for few points.
    #[inline(always)]
    pub(super) fn error(&self) -> f32 {
        if self.weights > FEW { (self.rest * self.variance).sqrt() } else { f32::INFINITY }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{DMatrix, DVector};
    use seamwright_testkit::Random;

    /// Reference by definition: weighted least squares with the stiffness as a row of its own, solved by singular
    /// values.
    #[test]
    fn it_is_of_least_squares() {
        let mut random = Random::new(7);
        for _ in 0..3000 {
            let (count, from) = (3 + random.below(40), random.within(-30.0, 0.0) as f32);
            let places: Vec<_> = (0..count)
                .map(|k| (from + k as f32, random.within(0.0, 4.0) as f32, random.within(0.1, 1.1) as f32))
                .collect();
            let stiff = random.within(0.0, 200.0) as f32;
            let rows = count + 1;
            let row = |k: usize| places.get(k).map_or((0.0, 0.0, stiff), |(x, y, w)| (*x, *y, *w));
            let root = |k: usize| f64::from(row(k).2).sqrt();
            let matrix = DMatrix::from_fn(rows, 3, |k, power| match k {
                k if k < count => root(k) * f64::from(row(k).0).powi(power as i32),
                k => {
                    if power == 2 {
                        root(k)
                    } else {
                        0.0
                    }
                }
            });
            let right = DVector::from_fn(rows, |k, _| root(k) * f64::from(row(k).1));
            let told = matrix.clone().svd(true, true).solve(&right, 1e-12).unwrap();
            let parabola = Parabola::through(places.iter().copied(), stiff).unwrap();
            let weights: f64 = places.iter().map(|(_, _, w)| f64::from(*w)).sum();
            let off = &right - &matrix * &told;
            let rest = off.rows(0, count).norm_squared() / weights;
            for (found, told) in parabola.terms.iter().zip(told.iter()) {
                assert!((f64::from(*found) - told).abs() < 1e-4 * (1.0 + told.abs()), "{found} {told} of {count}");
            }
            assert!((f64::from(parabola.rest) - rest).abs() < 1e-4 * (1.0 + rest), "{} {rest}", parabola.rest);
            let variance = (matrix.transpose() * &matrix).try_inverse().unwrap()[(0, 0)];
            assert!((f64::from(parabola.variance) / variance - 1.0).abs() < 1e-3, "{} {variance}", parabola.variance);
        }
    }

    #[test]
    fn too_few_places_tell_none() {
        assert!(Parabola::through([].into_iter(), 0.0).is_none());
        assert!(Parabola::through([(3.0, 1.0, 1.0)].into_iter(), 100.0).is_none());
        assert!(Parabola::through([(3.0, 1.0, 1.0), (4.0, 2.0, 1.0)].into_iter(), 0.0).is_none());
        // Far from 0, single precision is not enough for a parabola either.
        let powers: [f32; 5] = std::array::from_fn(|power| (20..25).map(|x| (x as f32).powi(power as i32)).sum());
        assert!(Parabola::of(powers, [5.0, 110.0, 2430.0], 5.0, 0.0).is_none());
    }
}
