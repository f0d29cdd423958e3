//! Frequency responses measured on a running system: stepped sines, fitted by least squares.

use std::f64::consts::TAU;

use num_complex::Complex64;

/// Maximum difference of two successive windows of a settled line, as a part of the response: 0.03 dB, 0.2 degrees.
const SETTLED: f64 = 0.003;
/// Minimum first window, in samples and in cycles.
const FIRST_WINDOW: (usize, f64) = (96, 2.0);
/// Maximum window, in samples, unless the first is longer.
const LONGEST_WINDOW: usize = 1 << 13;
/// Maximum difference between windows attributed to the output's resolution, as a part of the output.
const NOISE: f64 = 0.03;
/// Maximum number of halvings of a sine.
const HALVINGS: u32 = 6;
/// Lines are inserted between neighbours that differ by more than this factor or angle (rad) ...
const REFINE: (f64, f64) = (1.4, 0.4);
/// ... and are further apart than this factor in frequency, up to this many lines in all.
const CLOSEST: f64 = 1.003;
const MAX_LINES: usize = 160;

/// One line of a frequency response.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Line {
    /// Frequency (Hz).
    pub frequency_hz: f64,
    /// Output over input at that frequency.
    pub ratio: Complex64,
}

/// Signals of a system in one servo period.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(crate) struct Signals {
    pub(crate) input: f64,
    pub(crate) output: f64,
    /// Drive of the mechanism: its current.
    pub(crate) effort: f64,
    /// True if a limit or a standstill invalidated the period, so that the sine was too large.
    pub(crate) spoiled: bool,
}

/// Lines to measure, and properties of the system.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Range {
    /// First and last frequency (Hz).
    pub(crate) low: f64,
    pub(crate) high: f64,
    /// Lines per decade, before refinement.
    pub(crate) per_decade: f64,
    pub(crate) period_s: f64,
    pub(crate) resolution: f64,
    /// Negligible differences of the ratio.
    pub(crate) floor: f64,
}

/// A line, with the response to the effort.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct Measured {
    pub(crate) line: Line,
    /// Output over effort.
    pub(crate) per_effort: Complex64,
}

/// Measures `system`, stepped once a period with the excitation's value, over `range`, with more lines where the
/// response changes fast. `amplitude` gives the excitation's amplitude at a frequency. Lines are in order of frequency.
/// Returns `None` if a frequency could not be measured, because limits occurred with every sine.
pub(crate) fn sweep(
    mut system: impl FnMut(f64) -> Signals,
    amplitude: impl Fn(f64) -> f64,
    range: &Range,
) -> Option<Vec<Measured>> {
    let &Range { low, high, per_decade, .. } = range;
    let mut at = |hz: f64| measure(&mut system, amplitude(hz), hz, range);
    let count = ((high / low).log10() * per_decade).ceil().max(2.0);
    let mut lines = Vec::with_capacity(count as usize + 1);
    for i in 0..=count as u32 {
        lines.push(at(low * (high / low).powf(f64::from(i) / count))?);
    }
    let mut i = 0;
    while i + 1 < lines.len() {
        let (a, b): (Measured, Measured) = (lines[i], lines[i + 1]);
        let (fa, fb) = (a.line.frequency_hz, b.line.frequency_hz);
        let matters = a.line.ratio.norm().max(b.line.ratio.norm()) > range.floor;
        let coarse = matters && (differ(a.line.ratio, b.line.ratio) || differ(a.per_effort, b.per_effort));
        if coarse && fb > fa * CLOSEST && lines.len() < MAX_LINES {
            lines.insert(i + 1, at((fa * fb).sqrt())?);
        } else {
            i += 1;
        }
    }
    Some(lines)
}

fn differ(a: Complex64, b: Complex64) -> bool {
    let ratio = b / a;
    let size = ratio.norm();
    !(size < REFINE.0 && size > 1.0 / REFINE.0 && ratio.arg().abs() < REFINE.1)
}

/// Measures one line: windows of doubling length until two agree; the sine is halved if it invalidates the signals.
fn measure(
    system: &mut impl FnMut(f64) -> Signals,
    amplitude: f64,
    frequency_hz: f64,
    range: &Range,
) -> Option<Measured> {
    let &Range { period_s, resolution, floor, .. } = range;
    let first = FIRST_WINDOW.0.max((FIRST_WINDOW.1 / (frequency_hz * period_s)).ceil() as usize);
    let angle = TAU * frequency_hz * period_s;
    let mut size = amplitude;
    for _ in 0..=HALVINGS {
        let (mut length, mut k, mut before) = (first, 0u64, None::<Complex64>);
        loop {
            let mut fit = Fit::default();
            for _ in 0..length {
                let (sine, cosine) = (angle * k as f64).sin_cos();
                fit.add(sine, cosine, &system(size * sine));
                k += 1;
            }
            // The first window may still contain the effect of a larger sine before it.
            if fit.spoiled && before.is_some() {
                break;
            }
            let [input, output, effort] = fit.amplitudes();
            let (ratio, per_effort) = (output / input, output / effort);
            // Rounding to steps is noise of 0.29 steps; a fit over n samples keeps sqrt(2 / n) of it.
            let noise = resolution * 0.29 * (2.0 / length as f64).sqrt();
            let allowed = SETTLED * output.norm() + (2.0 * noise).min(NOISE * output.norm()) + floor * input.norm();
            let agree = before.is_some_and(|b| (ratio - b).norm() * input.norm() <= allowed);
            if !fit.spoiled && (agree || (before.is_some() && 2 * length > LONGEST_WINDOW.max(2 * first))) {
                return Some(Measured { line: Line { frequency_hz, ratio }, per_effort });
            }
            (before, length) = (Some(ratio), 2 * length);
        }
        size *= 0.5;
    }
    None
}

/// Least-squares fit of `a sin + b cos + c` to three signals over one window.
#[derive(Default)]
struct Fit {
    /// Sums of the products of sine, cosine and one.
    count: f64,
    of: [f64; 5],
    with: [[f64; 3]; 3],
    spoiled: bool,
}

impl Fit {
    fn add(&mut self, sine: f64, cosine: f64, signals: &Signals) {
        self.count += 1.0;
        for (sum, value) in self.of.iter_mut().zip([sine, cosine, sine * sine, sine * cosine, cosine * cosine]) {
            *sum += value;
        }
        for (sums, signal) in self.with.iter_mut().zip([signals.input, signals.output, signals.effort]) {
            for (sum, base) in sums.iter_mut().zip([sine, cosine, 1.0]) {
                *sum += signal * base;
            }
        }
        self.spoiled |= signals.spoiled;
    }

    /// Returns the complex amplitude of each signal relative to the sine.
    fn amplitudes(&self) -> [Complex64; 3] {
        let [s, c, ss, sc, cc] = self.of;
        let n = self.count;
        // Two equations remain after the elimination of the constant.
        let (ss, sc, cc) = (ss - s * s / n, sc - s * c / n, cc - c * c / n);
        let determinant = ss * cc - sc * sc;
        self.with.map(|[x, y, one]| {
            let (x, y) = (x - s * one / n, y - c * one / n);
            Complex64::new((x * cc - y * sc) / determinant, (y * ss - x * sc) / determinant)
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn range(low: f64, high: f64, per_decade: f64) -> Range {
        Range { low, high, per_decade, period_s: 1e-3, resolution: 0.0, floor: 0.0 }
    }

    #[test]
    fn a_known_filter_is_measured_exactly() {
        // y_k = 0.9 y_k-1 + 0.1 u_k-1, with an unrelated offset.
        let mut y = 0.0;
        let system = |u: f64| {
            let signals = Signals { input: u + 3.0, output: y - 7.0, effort: 2.0 * u, spoiled: false };
            y = 0.9 * y + 0.1 * u;
            signals
        };
        let lines = sweep(system, |_| 0.5, &range(0.5, 450.0, 10.0)).unwrap();
        assert!(lines.is_sorted_by(|a, b| a.line.frequency_hz < b.line.frequency_hz) && lines.len() > 28);
        for Measured { line, per_effort } in lines {
            let z = Complex64::from_polar(1.0, TAU * line.frequency_hz * 1e-3);
            let exact = 0.1 / (z - 0.9);
            assert!((line.ratio / exact - 1.0).norm() < 2e-4, "{line:?} {exact}");
            assert!((per_effort / exact - 0.5).norm() < 2e-4);
        }
    }

    #[test]
    fn a_narrow_resonance_between_the_lines_is_found() {
        // Two poles at 97 Hz with a damping of 0.5 %.
        let (w, zeta, t) = (TAU * 97.0, 0.005, 1e-3);
        let pole = Complex64::new(-zeta * w, w * (1.0_f64 - zeta * zeta).sqrt()) * t;
        let (a, b) = (2.0 * pole.exp().re, -(2.0 * pole.re).exp());
        let (mut y, mut before) = (0.0, 0.0);
        let system = |u: f64| {
            let signals = Signals { input: u, output: y, effort: u, spoiled: false };
            (y, before) = (a * y + b * before + u, y);
            signals
        };
        let lines = sweep(system, |_| 1.0, &range(10.0, 400.0, 20.0)).unwrap();
        let peak = lines.iter().map(|m| m.line).max_by(|a, b| a.ratio.norm().total_cmp(&b.ratio.norm())).unwrap();
        assert!((peak.frequency_hz / 97.0 - 1.0).abs() < 0.003, "{peak:?}");
        for Measured { line, .. } in lines {
            let z = Complex64::from_polar(1.0, TAU * line.frequency_hz * t);
            let exact = z / (z * z - a * z - b);
            assert!((line.ratio / exact - 1.0).norm() < 0.02, "{line:?} {exact}");
        }
    }

    #[test]
    fn a_sine_that_meets_a_limit_is_halved_and_one_that_always_does_is_given_up() {
        let limited = |limit: f64| {
            move |u: f64| Signals { input: u, output: u.clamp(-limit, limit), effort: u, spoiled: u.abs() > limit }
        };
        let lines = sweep(limited(0.3), |_| 1.0, &range(1.0, 100.0, 5.0)).unwrap();
        assert!(lines.iter().all(|m| (m.line.ratio - 1.0).norm() < 1e-9));
        assert!(sweep(limited(1e-9), |_| 1.0, &range(1.0, 100.0, 5.0)).is_none());
    }
}
