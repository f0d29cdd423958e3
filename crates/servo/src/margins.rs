//! Stability margins of a loop from its measured open-loop response.

use std::f64::consts::{PI, TAU};

use num_complex::Complex64;

use crate::sweep::Line;

/// Stability margins and closed-loop figures from a frequency response.
///
/// They follow from Nyquist's criterion for an open loop that is stable except for integrators. A loop that would
/// become unstable with *less* gain counts as one without margin.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Margins {
    /// Minimum distance of the magnitude from 1 (dB) where the phase crosses -180 degrees. It is negative if the
    /// magnitude is above 1 there, and infinite without a crossing in the sweep.
    pub gain_margin_db: f64,
    /// Frequency of that crossing (Hz); NaN without a crossing.
    pub phase_crossover_hz: f64,
    /// Minimum distance of the phase from -180 degrees where the magnitude crosses 1; infinite without a crossing.
    pub phase_margin_deg: f64,
    /// Frequency of that crossing (Hz); NaN without a crossing.
    pub gain_crossover_hz: f64,
    /// Lowest frequency (Hz) at which the closed loop has fallen to -3 dB, or else the last one measured.
    pub bandwidth_hz: f64,
    /// Maximum magnitude of the closed loop (dB).
    pub peak_db: f64,
}

/// Converts a magnitude to decibels.
pub fn decibels(magnitude: f64) -> f64 {
    20.0 * magnitude.log10()
}

/// Returns the phase of each line (rad), without jumps; the first is between -2 pi and 0.
pub fn unwrapped(lines: &[Line]) -> Vec<f64> {
    let mut last = -PI;
    let phases = lines.iter().map(|line| {
        let phase = line.ratio.arg();
        last = phase + TAU * ((last - phase) / TAU).round();
        last
    });
    phases.collect()
}

/// Finds the crossings of the phase with odd multiples of 180 degrees: frequency (Hz) and logarithm of the magnitude.
pub(crate) fn phase_crossings(lines: &[Line]) -> impl Iterator<Item = (f64, f64)> {
    // At -1 the negated ratio is real and positive, so its angle changes sign.
    lines.windows(2).filter_map(|pair| {
        let [a, b] = [pair[0], pair[1]].map(|line| (-line.ratio).arg());
        (a.min(b) <= 0.0 && a.max(b) >= 0.0 && (b - a).abs() < PI).then(|| {
            let part = if a == 0.0 { 0.0 } else { a / (a - b) };
            between(pair, part)
        })
    })
}

/// Interpolates frequency and logarithm of the magnitude at `part` of the way between two lines.
fn between(pair: &[Line], part: f64) -> (f64, f64) {
    let mix = |a: f64, b: f64| a + part * (b - a);
    let frequency = mix(pair[0].frequency_hz.ln(), pair[1].frequency_hz.ln()).exp();
    (frequency, mix(pair[0].ratio.norm().ln(), pair[1].ratio.norm().ln()))
}

/// Finds the crossings of the magnitude with 1: frequency (Hz) and distance of the phase from -180 degrees (rad).
fn gain_crossings(lines: &[Line]) -> impl Iterator<Item = (f64, f64)> {
    lines.windows(2).filter_map(|pair| {
        let [a, b] = [pair[0], pair[1]].map(|line| line.ratio.norm().ln());
        (a.min(b) <= 0.0 && a.max(b) > 0.0).then(|| {
            let part = a / (a - b);
            let turn = (pair[1].ratio / pair[0].ratio).arg();
            let angle = (-pair[0].ratio).arg() + part * turn;
            (between(pair, part).0, Complex64::from_polar(1.0, angle).arg().abs())
        })
    })
}

impl Margins {
    /// Computes the margins of the loop with the open-loop response `lines`, in order of frequency.
    pub fn of(lines: &[Line]) -> Self {
        let never = (f64::NAN, f64::INFINITY);
        let least = |a: (f64, f64), b: (f64, f64)| if b.1 < a.1 { b } else { a };
        let (phase_crossover_hz, gain) =
            phase_crossings(lines).map(|(hz, log)| (hz, -decibels(log.exp()))).fold(never, least);
        let (gain_crossover_hz, phase) = gain_crossings(lines).fold(never, least);
        let closed: Vec<f64> = lines.iter().map(|l| (l.ratio / (1.0 + l.ratio)).norm()).collect();
        let fallen =
            lines.iter().zip(&closed).find(|(_, size)| **size < 0.5_f64.sqrt()).or(lines.last().zip(Some(&0.0)));
        Self {
            gain_margin_db: gain,
            phase_crossover_hz,
            phase_margin_deg: phase.to_degrees(),
            gain_crossover_hz,
            bandwidth_hz: fallen.map_or(f64::NAN, |(line, _)| line.frequency_hz),
            peak_db: decibels(closed.into_iter().fold(0.0, f64::max)),
        }
    }

    /// Returns true if both margins are at least these (dB, degrees); false if the magnitude never crosses 1.
    pub fn reach(&self, gain_db: f64, phase_deg: f64) -> bool {
        self.gain_crossover_hz.is_finite() && self.gain_margin_db >= gain_db && self.phase_margin_deg >= phase_deg
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lines(range: (f64, f64), loop_: impl Fn(Complex64) -> Complex64) -> Vec<Line> {
        let step = |i: u32| range.0 * (range.1 / range.0).powf(f64::from(i) / 400.0);
        let line = |hz: f64| Line { frequency_hz: hz, ratio: loop_(Complex64::new(0.0, TAU * hz)) };
        (0..=400).map(|i| line(step(i))).collect()
    }

    #[test]
    fn integrator_with_dead_time() {
        // K e^(-s D) / s: crossover at K rad/s with pi/2 - K D left, phase crossover at pi / (2 D) with pi / (2 K D).
        let (k, delay) = (50.0, 8e-3);
        let margins = Margins::of(&lines((1.0, 60.0), |s| k * (-s * delay).exp() / s));
        assert!((margins.phase_margin_deg - (0.5 * PI - k * delay).to_degrees()).abs() < 0.01, "{margins:?}");
        assert!((margins.gain_crossover_hz - k / TAU).abs() < 0.01);
        assert!((margins.gain_margin_db - decibels(PI / (2.0 * k * delay))).abs() < 0.01);
        assert!((margins.phase_crossover_hz - 0.25 / delay).abs() < 0.01);
    }

    #[test]
    fn third_order_lag() {
        // K / (1 + s)^3: phase crossover at sqrt(3) rad/s, where the magnitude is K / 8.
        let margins = Margins::of(&lines((0.01, 3.0), |s| 4.0 / (1.0 + s).powu(3)));
        assert!((margins.gain_margin_db - decibels(2.0)).abs() < 1e-3);
        assert!((margins.phase_crossover_hz * TAU - 3.0_f64.sqrt()).abs() < 1e-3);
        // |1 + jw| = 4^(1/3).
        let w = (4.0_f64.powf(2.0 / 3.0) - 1.0).sqrt();
        assert!((margins.phase_margin_deg - (180.0 - 3.0 * w.atan().to_degrees())).abs() < 0.01);
        assert!(!margins.reach(6.03, 0.0) && margins.reach(6.0, 20.0));
        let unstable = Margins::of(&lines((0.01, 3.0), |s| 10.0 / (1.0 + s).powu(3)));
        assert!((unstable.gain_margin_db + decibels(1.25)).abs() < 1e-3);
    }

    #[test]
    fn a_plain_lag_has_no_phase_crossing() {
        // K / s closed is 1 / (1 + s / K).
        let margins = Margins::of(&lines((0.1, 1000.0), |s| 60.0 / s));
        assert!(margins.gain_margin_db.is_infinite() && margins.phase_crossover_hz.is_nan());
        assert!((margins.phase_margin_deg - 90.0).abs() < 1e-9);
        assert!((margins.bandwidth_hz / (60.0 / TAU) - 1.0).abs() < 0.03);
        assert!(margins.peak_db <= 0.0);
    }

    #[test]
    fn phases_have_no_jumps() {
        let delayed = lines((1.0, 60.0), |s| 50.0 * (-s * 0.03).exp() / s);
        for (line, phase) in delayed.iter().zip(unwrapped(&delayed)) {
            assert!((phase + 0.5 * PI + TAU * line.frequency_hz * 0.03).abs() < 1e-9);
        }
    }
}
