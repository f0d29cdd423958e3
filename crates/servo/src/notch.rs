//! Notch filter on the speed command (SADDLE-2020), which removes a machine resonance from the loop.

use std::f64::consts::{PI, TAU};

use num_complex::Complex64;

use crate::error::{Error, servo_period, within};

/// A second-order notch, the bilinear image of
/// `(s^2 + depth * B * s + w0^2) / (s^2 + B * s + w0^2)`.
///
/// The centre `w0` and the width `B` are pre-warped, so both are exact in the sampled filter below half the sampling
/// rate. Guarantees: the gain is exactly `depth` at the centre, and exactly 1 at zero frequency and at half the
/// sampling rate. It is `sqrt((1 + depth^2) / 2)` at the two edges, which are `width_hz` apart. Every filter that can
/// be built is stable.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Notch {
    period_s: f64,
    /// Numerator, denominator without its leading 1.
    b: [f64; 3],
    a: [f64; 2],
    state: [f64; 2],
}

impl Notch {
    /// Creates a notch at `frequency_hz`, `width_hz` wide, with the gain `depth` (0 to 1) at its centre, sampled every
    /// `period_s` (s).
    ///
    /// # Errors
    /// [`Error::OutOfRange`] unless frequency and width lie between 0.000001 and 0.999999 of half the
    /// sampling rate and depth in 0 to 1.
    pub fn new(frequency_hz: f64, depth: f64, width_hz: f64, period_s: f64) -> Result<Self, Error> {
        let period_s = servo_period(period_s)?;
        let half_rate = 0.5 / period_s;
        let range = 1e-6 * half_rate..=(1.0 - 1e-6) * half_rate;
        let allowed = "above 0, below half the sampling rate";
        let centre = TAU * within("frequency_hz", frequency_hz, range.clone(), allowed)? * period_s;
        let width = (PI * within("width_hz", width_hz, range, allowed)? * period_s).tan();
        let depth = within("depth", depth, 0.0..=1.0, "0 to 1")?;
        let scale = 1.0 / (1.0 + width);
        let middle = -2.0 * centre.cos() * scale;
        Ok(Self {
            period_s,
            b: [(1.0 + depth * width) * scale, middle, (1.0 - depth * width) * scale],
            a: [middle, (1.0 - width) * scale],
            state: [0.0; 2],
        })
    }

    /// Filters one sample. Transposed direct form II.
    pub fn update(&mut self, input: f64) -> f64 {
        let output = self.b[0] * input + self.state[0];
        self.state[0] = self.b[1] * input - self.a[0] * output + self.state[1];
        self.state[1] = self.b[2] * input - self.a[1] * output;
        output
    }

    /// Clears the state, as after a zero input.
    pub fn reset(&mut self) {
        self.state = [0.0; 2];
    }

    /// Returns the gain at `frequency_hz`: the analytic magnitude of the sampled filter.
    pub fn gain(&self, frequency_hz: f64) -> f64 {
        self.response(Complex64::from_polar(1.0, TAU * frequency_hz * self.period_s)).norm()
    }

    /// Returns the complex response at `z`, the sampled filter's variable: `e^(j w T)` for a frequency `w` (rad/s).
    pub fn response(&self, z: Complex64) -> Complex64 {
        let of = |c: [f64; 3]| (c[0] * z + c[1]) * z + c[2];
        of(self.b) / of([1.0, self.a[0], self.a[1]])
    }

    /// Returns the sampling period (s).
    pub fn period_s(&self) -> f64 {
        self.period_s
    }

    /// Returns the delay of a slow signal by the filter (s).
    ///
    /// Add it to the acceleration feed-forward `kaff`, which compensates lags.
    pub fn delay_s(&self) -> f64 {
        let sum = 1.0 + self.a[0] + self.a[1];
        let late = |one: f64, two: f64| (one + 2.0 * two) / sum;
        self.period_s * (late(self.b[1], self.b[2]) - late(self.a[0], self.a[1]))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PERIOD: f64 = 1e-3;

    fn simulated_gain(mut notch: Notch, frequency_hz: f64) -> f64 {
        let angle = TAU * frequency_hz * PERIOD;
        let (settle, count) = (20_000, 20_000);
        let (mut sine, mut cosine) = (0.0, 0.0);
        for k in 0..settle + count {
            let phase = angle * f64::from(k);
            let output = notch.update(phase.sin());
            if k >= settle {
                sine += output * phase.sin();
                cosine += output * phase.cos();
            }
        }
        sine.hypot(cosine) * 2.0 / f64::from(count)
    }

    #[test]
    fn a_simulated_sine_leaves_with_the_analytic_gain() {
        for (depth, width) in [(0.0, 20.0), (0.1, 30.0), (0.5, 5.0)] {
            let notch = Notch::new(120.0, depth, width, PERIOD).unwrap();
            for frequency in [0.05, 10.0, 100.0, 115.0, 120.0, 125.0, 150.0, 400.0] {
                let difference = simulated_gain(notch, frequency) - notch.gain(frequency);
                assert!(difference.abs() < 1e-6, "{depth} {width} {frequency}: {difference}");
            }
        }
    }

    #[test]
    fn centre_ends_and_edges_are_exact() {
        for frequency in [3.0, 60.0, 210.0, 460.0] {
            for width in [1.0, 40.0] {
                for depth in [0.0, 0.2, 0.9] {
                    let notch = Notch::new(frequency, depth, width, PERIOD).unwrap();
                    assert!((notch.gain(frequency) - depth).abs() < 1e-8);
                    assert!((notch.gain(0.0) - 1.0).abs() < 1e-8);
                    assert!((notch.gain(500.0) - 1.0).abs() < 1e-8);
                }
                // Lower edge: the gain crosses 1/sqrt(2) below the centre.
                let notch = Notch::new(frequency, 0.0, width, PERIOD).unwrap();
                let (mut low, mut high) = (0.0, frequency);
                for _ in 0..60 {
                    let middle = 0.5 * (low + high);
                    if notch.gain(middle) > 0.5_f64.sqrt() { low = middle } else { high = middle }
                }
                assert!((notch.gain(low + width) - 0.5_f64.sqrt()).abs() < 1e-6);
            }
        }
    }

    #[test]
    fn agrees_with_the_analogue_notch_well_below_half_the_rate() {
        let (f0, depth, width) = (50.0, 0.2, 10.0);
        let notch = Notch::new(f0, depth, width, 1e-5).unwrap();
        for f in [1.0, 20.0, 45.0, 50.0, 55.0, 120.0] {
            let tuned: f64 = f0 * f0 - f * f;
            let analogue = tuned.hypot(depth * width * f) / tuned.hypot(width * f);
            assert!((notch.gain(f) - analogue).abs() < 1e-4, "{f}");
        }
    }

    #[test]
    fn a_ramp_leaves_late_by_the_delay() {
        let mut notch = Notch::new(80.0, 0.1, 25.0, PERIOD).unwrap();
        let mut output = 0.0;
        for k in 0..5000 {
            output = notch.update(f64::from(k) * PERIOD);
        }
        assert!((4999.0 * PERIOD - output - notch.delay_s()).abs() < 1e-9);
        // Continuous limit: (1 - depth) B / w0^2.
        let limit = 0.9 * TAU * 25.0 / (TAU * 80.0_f64).powi(2);
        assert!((notch.delay_s() / limit - 1.0).abs() < 0.05);
    }

    #[test]
    fn nonsense_is_refused() {
        for (frequency, depth, width) in [
            (0.0, 0.1, 5.0),
            (500.0, 0.1, 5.0),
            (50.0, -0.1, 5.0),
            (50.0, 1.1, 5.0),
            (50.0, 0.1, 0.0),
            (f64::NAN, 0.1, 5.0),
        ] {
            assert!(Notch::new(frequency, depth, width, PERIOD).is_err());
        }
    }
}
