//! Latency of a robot: the time from a set-point sent until a report shows it.
//!
//! **Estimator.** With the set-points `s(t)` as sent, reported positions are modelled as `a(t) = s(t - d) + noise`, all
//! joints with one latency `d`. Linearised about the last estimate `d0`, least squares over the samples of a batch
//! gives `d = d0 - sum(v r) / sum(v v)`, with the residuals `r = a(t) - s(t - d0)` and the speeds `v = s'(t - d0)`
//! (Gauss-Newton). The mean of the last batches is the estimate. Its standard deviation is that of the batches, divided
//! by the root of their number, so it needs no model of the noise, whose samples are correlated.
//!
//! A servo loop of first order lags by its time constant, and for motion that is smooth over that time this is what
//! the estimator finds.

use arrayvec::ArrayVec;
use seamwright_machine::{Joints, MAX_AXES};

/// Samples of a batch: a fifth of a second at 500 Hz.
const BATCH: u32 = 100;
/// Batches of an estimate.
const BATCHES: usize = 16;
/// Minimum number of batches of a measured latency.
const MIN_BATCHES: usize = 4;
/// Speed of all joints together from which a sample counts, rad/s (linear joints: m/s). An encoder's noise of 1e-5 rad
/// is then 2 ms in a sample and 0.2 ms in a batch.
const MIN_SPEED: f64 = 5e-3;
/// Maximum latency, s.
pub(super) const MAX_LATENCY_S: f64 = 0.25;
/// Deviation of a batch from the estimate, s, beyond which the linearisation is poor, or the latency has changed.
const FAR_S: f64 = 0.005;
/// Number of batches in a row, far off to the same side, after which the latency has changed.
const CHANGED: i32 = 3;

/// A measured latency.
#[derive(Debug, Clone, Copy, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct MeasuredLatency {
    /// Latency, s.
    pub mean_s: f64,
    /// Standard deviation of the mean, s.
    pub sigma_s: f64,
    /// Number of reports in motion that it was measured from.
    pub reports: u64,
}

/// Measures the latency of a robot.
#[derive(Debug, Clone)]
pub(super) struct LatencyEstimate {
    latency_s: f64,
    /// Weight of each joint's square: 1 for rad, 1e-6 for mm.
    weights: Joints,
    speed_residual: f64,
    speed_speed: f64,
    samples: u32,
    batches: ArrayVec<f64, BATCHES>,
    /// Batches in a row that are far off; negative below.
    far: i32,
    reports: u64,
}

impl LatencyEstimate {
    /// Starts at `latency_s`; `linear` marks the axes in mm.
    pub(super) fn new(latency_s: f64, linear: impl Fn(usize) -> bool) -> Self {
        Self {
            latency_s,
            weights: std::array::from_fn(|i| if linear(i) { 1e-6 } else { 1.0 }),
            speed_residual: 0.0,
            speed_speed: 0.0,
            samples: 0,
            batches: ArrayVec::new(),
            far: 0,
            reports: 0,
        }
    }

    /// Returns the best estimate, s: the value it started with until there is a better one.
    pub(super) fn latency_s(&self) -> f64 {
        self.latency_s
    }

    /// Returns the latency once it is measured.
    pub(super) fn measured(&self) -> Option<MeasuredLatency> {
        let n = self.batches.len();
        if n < MIN_BATCHES {
            return None;
        }
        let (mean_s, variance) = self.moments();
        Some(MeasuredLatency { mean_s, sigma_s: (variance / n as f64).sqrt(), reports: self.reports })
    }

    /// Mean and sample variance of the batches.
    fn moments(&self) -> (f64, f64) {
        let n = self.batches.len() as f64;
        let mean = self.batches.iter().sum::<f64>() / n;
        let square = self.batches.iter().map(|d| (d - mean).powi(2)).sum::<f64>();
        (mean, square / (n - 1.0).max(1.0))
    }

    /// Adds a report: its positions, and the set-point `latency_s` before it with its speed.
    pub(super) fn add(&mut self, reported: &Joints, set: &Joints, speed: &Joints) {
        let mut sums = (0.0, 0.0);
        for i in 0..MAX_AXES {
            sums.0 += self.weights[i] * speed[i] * (reported[i] - set[i]);
            sums.1 += self.weights[i] * speed[i] * speed[i];
        }
        if !(sums.1 > MIN_SPEED * MIN_SPEED && sums.0.is_finite()) {
            return;
        }
        self.speed_residual += sums.0;
        self.speed_speed += sums.1;
        self.samples += 1;
        self.reports += 1;
        if self.samples >= BATCH {
            self.finish_batch();
        }
    }

    fn finish_batch(&mut self) {
        let found = self.latency_s - self.speed_residual / self.speed_speed;
        let found = found.clamp(0.0, MAX_LATENCY_S);
        (self.speed_residual, self.speed_speed, self.samples) = (0.0, 0.0, 0);
        let off_s = found - self.latency_s;
        self.far = match () {
            () if off_s > FAR_S => self.far.max(0) + 1,
            () if off_s < -FAR_S => self.far.min(0) - 1,
            () => 0,
        };
        if self.far.abs() >= CHANGED || (self.far != 0 && self.batches.is_empty()) {
            // Go there, and measure again.
            self.batches.clear();
            (self.far, self.reports, self.latency_s) = (0, 0, found);
            return;
        }
        if self.batches.is_full() {
            self.batches.remove(0);
        }
        self.batches.push(found);
        self.latency_s = self.moments().0;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_testkit::Random;

    /// Joints that swing at 0.3 to 1.1 Hz, and their speeds.
    fn path(t: f64) -> (Joints, Joints) {
        let (mut q, mut v) = ([0.0; MAX_AXES], [0.0; MAX_AXES]);
        for i in 0..6 {
            let w = 2.0 + f64::from(i as u32);
            (q[i], v[i]) = (0.1 * (w * t).sin(), 0.1 * w * (w * t).cos());
        }
        (q, v)
    }

    /// Constant delays with encoder noise are found within four standard deviations, from any start.
    #[test]
    fn delays_are_found() {
        let mut random = Random::new(11);
        for (case, true_s) in [0.004, 0.034, 0.08, 0.2].into_iter().enumerate() {
            let mut estimate = LatencyEstimate::new(0.02, |_| false);
            for k in 0..2000 {
                let t = 2e-3 * f64::from(k);
                let mut reported = path(t - true_s).0;
                reported.iter_mut().for_each(|q| *q += 2e-5 * random.within(-1.0, 1.0));
                let (set, speed) = path(t - estimate.latency_s());
                estimate.add(&reported, &set, &speed);
            }
            let found = estimate.measured().unwrap();
            assert!(found.sigma_s < 1e-4, "{case}: {found:?}");
            assert!((found.mean_s - true_s).abs() < 4.0 * found.sigma_s + 1e-5, "{case}: {found:?} {true_s}");
        }
    }

    /// A lag of first order is found as its time constant, and a change of the latency is followed.
    #[test]
    fn a_lag_is_found_and_followed() {
        let mut estimate = LatencyEstimate::new(0.0, |_| false);
        let mut robot = path(0.0).0;
        let mut found = Vec::new();
        for k in 0..10_000 {
            let t = 2e-3 * f64::from(k);
            let lag_s = if k < 5000 { 0.03 } else { 0.05 };
            let (goal, _) = path(t);
            robot.iter_mut().zip(goal).for_each(|(q, goal)| *q += (goal - *q) * (1.0 - f64::exp(-2e-3 / lag_s)));
            let (set, speed) = path(t - estimate.latency_s());
            estimate.add(&robot, &set, &speed);
            if k % 5000 == 4999 {
                found.push(estimate.measured().unwrap().mean_s);
            }
        }
        // The step of 2 ms takes effect at once: half a step less. The lag of a sine is atan(w T) / w.
        assert!((found[0] - 0.029).abs() < 0.002 && (found[1] - 0.049).abs() < 0.003, "{found:?}");
    }

    /// Without motion there is nothing to measure.
    #[test]
    fn rest_measures_nothing() {
        let mut estimate = LatencyEstimate::new(0.02, |_| false);
        let mut random = Random::new(3);
        for _ in 0..5000 {
            let noise: Joints = std::array::from_fn(|_| 1e-4 * random.within(-1.0, 1.0));
            estimate.add(&noise, &[0.0; MAX_AXES], &[0.0; MAX_AXES]);
            estimate.add(&[f64::NAN; MAX_AXES], &[0.0; MAX_AXES], &[1.0; MAX_AXES]);
        }
        assert_eq!((estimate.measured(), estimate.latency_s()), (None, 0.02));
    }
}
