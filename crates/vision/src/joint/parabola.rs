use nalgebra::{Matrix3, Vector3};

/// A parabola through places.
#[derive(Debug, Clone, Copy)]
pub(super) struct Parabola {
    /// Value, slope and half of the second derivative at 0.
    pub(super) terms: [f32; 3],
    /// Variance of the value at 0 for places of weight 1 and variance 1.
    pub(super) variance: f32,
    /// Weighted mean of the squares that are left, and the sum of the weights.
    pub(super) rest: f32,
    pub(super) weights: f32,
}

impl Parabola {
    /// Of least squares through places (x, y, weight), its last term held near 0 by `stiff`.
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
        let normal = Matrix3::new(m[0], m[1], m[2], m[1], m[2], m[3], m[2], m[3], m[4] + f64::from(stiff));
        let factor = normal.cholesky()?;
        let right = Vector3::from(r);
        let found = factor.solve(&right);
        let variance = factor.solve(&Vector3::x())[0];
        let fitted = 2.0 * found.dot(&right) - found.dot(&(normal * found)) + f64::from(stiff) * found[2] * found[2];
        let rest = (squares - fitted).max(0.0) / m[0];
        let [value, slope, bend] = found.map(|t| t as f32).into();
        let (variance, rest, weights) = (variance as f32, rest as f32, m[0] as f32);
        Some(Self { terms: [value, slope, bend], variance, rest, weights })
    }
}
