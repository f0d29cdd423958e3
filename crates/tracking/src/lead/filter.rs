use glam::DVec2;

/// Kalman filter of the deviation and its slope over path length, \[d, d'\], lateral and height together. The slope
/// performs a random walk with `wander` (1/mm); the measured seam moves over time by `drift` (mm^2/s). Both directions
/// share their variances, because one measurement has one confidence.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Filter {
    pub(super) s: f64,
    pub(super) t: f64,
    pub(super) value: DVec2,
    pub(super) slope: DVec2,
    /// Variance of the value, covariance, and variance of the slope.
    pub(super) variance: [f64; 3],
}

/// Process noise of the seam between measurements.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Noise {
    pub(super) wander: f64,
    pub(super) drift: f64,
}

impl Filter {
    /// Predicts the state at `s` and time `t`, also backwards along the seam.
    pub(super) fn predicted(&self, s: f64, t: f64, noise: &Noise) -> Self {
        let ds = s - self.s;
        let [vv, vs, ss] = self.variance;
        let (q, way) = (noise.wander, ds.abs());
        let drift = noise.drift * (t - self.t).max(0.0);
        let variance = [
            vv + 2.0 * ds * vs + ds * ds * ss + q * way.powi(3) / 3.0 + drift,
            vs + ds * ss + q * ds * way / 2.0,
            ss + q * way,
        ];
        Self { s, t, value: self.value + ds * self.slope, slope: self.slope, variance }
    }

    /// Returns the innovation of a measurement of variance `r` in standard deviations, in the worse direction.
    pub(super) fn surprise(&self, measured: DVec2, r: f64) -> f64 {
        (measured - self.value).abs().max_element() / (self.variance[0] + r).sqrt()
    }

    /// Updates the state with a measurement of variance `r`. An innovation above two standard deviations raises `r`
    /// until it equals two, so that an outlier that passes the gate does not distort the slope.
    pub(super) fn updated(&self, measured: DVec2, r: f64) -> Self {
        let [vv, vs, ss] = self.variance;
        let r = r.max(0.25 * (measured - self.value).abs().max_element().powi(2));
        let s = vv + r;
        let (gain, gain_slope) = (vv / s, vs / s);
        let off = measured - self.value;
        Self {
            value: self.value + gain * off,
            slope: self.slope + gain_slope * off,
            variance: [(1.0 - gain) * vv, (1.0 - gain) * vs, ss - gain_slope * vs],
            ..*self
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::{Matrix2, Vector2};

    const STILL: Noise = Noise { wander: 0.0, drift: 0.0 };

    /// Without process noise the filter equals the least-squares line with the prior as one more measurement.
    #[test]
    fn of_a_straight_seam_it_is_least_squares() {
        let prior = Filter { s: 0.0, t: 0.0, value: DVec2::ZERO, slope: DVec2::ZERO, variance: [4.0, 0.0, 0.25] };
        let mut filter = prior;
        let mut normal = Matrix2::new(1.0 / 4.0, 0.0, 0.0, 1.0 / 0.25);
        let mut right = Vector2::zeros();
        for i in 1..40 {
            let s = 0.7 * f64::from(i) + (2.1 * f64::from(i)).sin() * 0.2;
            let m = DVec2::new(0.3 - 0.02 * s + 0.05 * (5.0 * s).sin(), 0.1 * (3.0 * s).cos());
            let r = 0.1 * (1.5 + (1.3 * s).sin());
            filter = filter.predicted(s, 0.0, &STILL).updated(m, r);
            let basis = Vector2::new(1.0, s);
            normal += basis * basis.transpose() / r;
            right += basis * m.x / r;
            let inverse = normal.try_inverse().unwrap();
            let line = inverse * right;
            assert!((filter.slope.x - line[1]).abs() < 1e-10);
            assert!((filter.value.x - (line[0] + line[1] * s)).abs() < 1e-10);
            let variance = (basis.transpose() * inverse * basis)[(0, 0)];
            assert!(
                (filter.variance[0] - variance).abs() < 1e-10 && (filter.variance[2] - inverse[(1, 1)]).abs() < 1e-10
            );
        }
    }

    /// One long prediction equals many short ones; the variance grows with the cube of the distance and with time.
    #[test]
    fn coasting_adds_up() {
        let noise = Noise { wander: 0.004, drift: 0.01 };
        let start = Filter { s: 5.0, t: 1.0, value: DVec2::ONE, slope: DVec2::X * 0.1, variance: [0.01, 0.002, 0.003] };
        for to in [25.0, -15.0] {
            let once = start.predicted(to, 3.0, &noise);
            let mut steps = start;
            for i in 1..=100 {
                let part = f64::from(i) / 100.0;
                steps = steps.predicted(5.0 + part * (to - 5.0), 1.0 + 2.0 * part, &noise);
            }
            for (a, b) in once.variance.iter().zip(steps.variance) {
                assert!((a - b).abs() < 1e-9, "{once:?} {steps:?}");
            }
            assert!(once.value.distance(steps.value) < 1e-12);
            assert!(once.variance[0] > start.variance[0]);
        }
    }
}
