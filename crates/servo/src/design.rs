//! Gain and notches from the measured response of a drive.

use std::f64::consts::TAU;

use num_complex::Complex64;

use crate::error::Error;
use crate::margins::phase_crossings;
use crate::notch::Notch;
use crate::sweep::Line;

/// Margins of a design (dB, degrees). They exceed the required ones, because friction, encoder counts and temperature
/// differ from those of the test.
pub(crate) const AIM: (f64, f64) = (8.0, 50.0);
/// Depths and widths (parts of the frequency) of the candidate notches, and shifts of their frequency.
const DEPTHS: [f64; 4] = [0.5, 0.25, 0.12, 0.06];
const WIDTHS: [f64; 4] = [0.3, 0.6, 1.0, 1.6];
const SHIFTS: [f64; 3] = [0.9, 1.0, 1.1];
/// Minimum increase of the gain by a notch.
const WORTH: f64 = 1.15;
/// Interpolated lines per measured line.
const BETWEEN: u32 = 8;
/// Maximum notch frequency, as a part of half the sampling rate.
const HIGHEST: f64 = 0.8;

/// Parameters of a notch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NotchSettings {
    /// Centre (Hz).
    pub frequency_hz: f64,
    /// Gain at the centre, 0 to 1.
    pub depth: f64,
    /// Width (Hz).
    pub width_hz: f64,
}

impl NotchSettings {
    /// Builds the filter, sampled every `period_s` (s).
    ///
    /// # Errors
    /// Those of [`Notch::new`].
    pub fn build(&self, period_s: f64) -> Result<Notch, Error> {
        Notch::new(self.frequency_hz, self.depth, self.width_hz, period_s)
    }
}

/// A proportional gain with the notches that allow it.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Design {
    pub(crate) kp: f64,
    pub(crate) notches: Vec<NotchSettings>,
}

/// Returns the highest gain with the target margins on `drive`, and the frequency that limits it (Hz).
///
/// The Nyquist curve of the loop must stay inside the unit circle in the sector of the phase margin about -180 degrees.
/// It must cross the real axis inside the gain margin. This is sufficient for both margins and for stability, and a
/// lower gain is stable too.
fn highest_gain(drive: &[Line]) -> (f64, f64) {
    let sector = AIM.1.to_radians();
    let reserve = 10.0_f64.powf(AIM.0 / 20.0);
    let inside = drive.iter().filter(|line| (-line.ratio).arg().abs() < sector);
    let sizes = inside.map(|line| (line.frequency_hz, line.ratio.norm()));
    let crossings = phase_crossings(drive).map(|(hz, log)| (hz, log.exp() * reserve));
    let (hz, size) = sizes.chain(crossings).fold((f64::NAN, 0.0), |a, b| if b.1 > a.1 { b } else { a });
    (1.0 / size, hz)
}

/// Interpolates lines between the measured ones, as a resonance may pass through the whole sector between two. The
/// logarithms of magnitude and frequency, and the phase, are linear between lines.
fn dense(drive: &[Line]) -> Vec<Line> {
    let between = |pair: &[Line]| {
        let (a, b) = (pair[0], pair[1]);
        let (step, turn) = (b.frequency_hz / a.frequency_hz, b.ratio / a.ratio);
        let at = move |i: u32| {
            let part = f64::from(i) / f64::from(BETWEEN);
            let ratio = a.ratio * Complex64::from_polar(turn.norm().powf(part), turn.arg() * part);
            Line { frequency_hz: a.frequency_hz * step.powf(part), ratio }
        };
        (0..BETWEEN).map(at)
    };
    drive.windows(2).flat_map(between).chain(drive.last().copied()).collect()
}

fn through(drive: &[Line], notch: &Notch, period_s: f64) -> Vec<Line> {
    let filtered = |line: &Line| {
        let z = Complex64::from_polar(1.0, TAU * line.frequency_hz * period_s);
        Line { ratio: line.ratio * notch.response(z), ..*line }
    };
    drive.iter().map(filtered).collect()
}

/// Designs gain and notches for a drive with the response `drive` from speed command to encoder.
///
/// Notches are tried about the frequency that limits the gain; the best is kept if it raises the gain enough, then a
/// second one is tried. The gain is infinite if nothing limits it.
pub(crate) fn design(drive: &[Line], period_s: f64, places: usize) -> Design {
    let mut response = dense(drive);
    let mut best = Design { kp: highest_gain(&response).0, notches: Vec::new() };
    for _ in 0..places {
        let (kp, binding) = highest_gain(&response);
        let mut found: Option<(f64, NotchSettings, Vec<Line>)> = None;
        for settings in candidates(binding, period_s) {
            let Ok(notch) = settings.build(period_s) else { continue };
            let filtered = through(&response, &notch, period_s);
            let gain = highest_gain(&filtered).0;
            if gain > found.as_ref().map_or(WORTH * kp, |f| f.0) {
                found = Some((gain, settings, filtered));
            }
        }
        let Some((gain, settings, filtered)) = found else { break };
        best.kp = gain;
        best.notches.push(settings);
        response = filtered;
    }
    best
}

fn candidates(binding: f64, period_s: f64) -> impl Iterator<Item = NotchSettings> {
    let most = HIGHEST * 0.5 / period_s;
    let all = SHIFTS.iter().flat_map(|s| DEPTHS.iter().flat_map(move |d| WIDTHS.iter().map(move |w| (s, d, w))));
    let rounded = |v: f64| (v * 10.0).round() / 10.0;
    all.map(move |(shift, depth, width)| {
        // Rounded to the values that are written down.
        let frequency_hz = rounded(binding * shift);
        NotchSettings { frequency_hz, depth: *depth, width_hz: rounded((width * frequency_hz).min(most)) }
    })
    .filter(move |n| n.frequency_hz <= most)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::margins::Margins;

    const PERIOD: f64 = 1e-3;

    /// `1 / s` behind a lag of `lag` (s), times a resonance of the load at `f` (Hz) with damping `zeta`.
    fn drive(lag: f64, f: f64, zeta: f64) -> Vec<Line> {
        let line = |i: u32| {
            let hz = 0.5 * 900.0_f64.powf(f64::from(i) / 600.0);
            let s = Complex64::new(0.0, TAU * hz);
            let w = TAU * f;
            let ratio = (-s * lag).exp() / s * w * w / (s * s + 2.0 * zeta * w * s + w * w);
            Line { frequency_hz: hz, ratio }
        };
        (0..=600).map(line).collect()
    }

    fn margins(drive: &[Line], design: &Design) -> Margins {
        let notched =
            design.notches.iter().fold(drive.to_vec(), |lines, n| through(&lines, &n.build(PERIOD).unwrap(), PERIOD));
        let looped = notched.iter().map(|l| Line { ratio: l.ratio * design.kp, ..*l });
        Margins::of(&looped.collect::<Vec<_>>())
    }

    #[test]
    fn a_dead_time_alone_is_bound_by_the_aim() {
        // K e^(-s D) / s has a phase margin of pi/2 - K D and a gain margin of pi / (2 K D): the aim of 8 dB binds.
        let lines = drive(5e-3, 1e5, 1.0);
        let found = design(&lines, PERIOD, 0);
        assert!((found.kp * 5e-3 - std::f64::consts::FRAC_PI_2 / 10.0_f64.powf(0.4)).abs() < 2e-3, "{found:?}");
        let margins = margins(&lines, &found);
        assert!((margins.gain_margin_db - AIM.0).abs() < 0.02 && margins.phase_margin_deg > AIM.1);
    }

    #[test]
    fn a_notch_makes_up_for_a_resonance() {
        for (f, zeta) in [(40.0, 0.02), (90.0, 0.01), (25.0, 0.1)] {
            let lines = drive(2e-4, f, zeta);
            let (without, with) = (design(&lines, PERIOD, 0), design(&lines, PERIOD, 2));
            // Without, the peak of 1 / (2 zeta) over kp / w has to stay 8 dB under 1.
            let peak = without.kp / (2.0 * zeta * TAU * f * 10.0_f64.powf(-0.4));
            assert!((0.7..1.3).contains(&peak), "{without:?}");
            assert!(with.kp > 3.0 * without.kp && !with.notches.is_empty(), "{with:?} {without:?}");
            assert!((with.notches[0].frequency_hz / f - 1.0).abs() < 0.15, "{with:?}");
            for found in [&without, &with] {
                assert!(margins(&lines, found).reach(AIM.0 - 0.1, AIM.1 - 1.0), "{found:?}");
            }
        }
    }
}
