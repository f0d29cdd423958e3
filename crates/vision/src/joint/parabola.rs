use nalgebra::{Matrix3, Vector3};

/// A parabola through places.
#[derive(Debug, Clone, Copy)]
pub(super) struct Parabola {
    /// Value, slope and half of the second derivative at 0.
    pub(super) terms: [f32; 3],
    /// Variance of the value at 0 for places of weight 1 and variance 1.
    pub(super) variance: f32,
}

impl Parabola {
    /// Of least squares through places (x, y, weight), its last term held near 0 by `stiff`.
    pub(super) fn through(places: impl Iterator<Item = (f32, f32, f32)>, stiff: f32) -> Option<Self> {
        let (mut m, mut r) = ([0.0f64; 5], [0.0f64; 3]);
        for (x, y, w) in places {
            let (x, y) = (f64::from(x), f64::from(y));
            let mut power = f64::from(w);
            for k in 0..5 {
                m[k] += power;
                if k < 3 {
                    r[k] += power * y;
                }
                power *= x;
            }
        }
        let normal = Matrix3::new(m[0], m[1], m[2], m[1], m[2], m[3], m[2], m[3], m[4] + f64::from(stiff));
        let factor = normal.cholesky()?;
        let found = factor.solve(&Vector3::from(r));
        let variance = factor.solve(&Vector3::x())[0];
        Some(Self { terms: [found[0] as f32, found[1] as f32, found[2] as f32], variance: variance as f32 })
    }
}
