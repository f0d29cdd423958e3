//! Process values that change evenly, as steps that a control can be given.

use seamwright_program::{Pass, ProcessValue, Span, Weaving};

/// Number of steps of a ramp or slope.
const STEPS: u32 = 50;
/// Steps of a weave's period.
const SWING_STEPS: u32 = 24;
/// Minimum length of a ramp's steps, mm.
const SHORTEST_MM: f64 = 0.5;
/// Minimum duration of a slope's steps, s.
const SHORTEST_S: f64 = 0.02;

/// Block ends within a span that make its ramps change in small steps, mm.
pub(crate) fn ramp_breaks(span: &Span) -> Vec<f64> {
    if !span.process.values().any(ProcessValue::is_ramp) {
        return Vec::new();
    }
    let (from, to) = (span.from_mm.get(), span.to_mm.get());
    let count = steps((to - from) / SHORTEST_MM);
    (1..count).map(|i| from + (to - from) * f64::from(i) / f64::from(count)).collect()
}

/// Block ends that make the values of a weave's sides change in small steps, mm; empty without such values.
pub(crate) fn weave_breaks(pass: &Pass) -> Vec<f64> {
    let (Some(weave), Some(weaving)) = (&pass.weave, Weaving::new(pass)) else { return Vec::new() };
    if weave.at_sides.is_empty() {
        return Vec::new();
    }
    // All spans have much the same period.
    let time = pass.length() / pass.speed_at(0.0) / weaving.phase(pass.length());
    weaving.cuts(((time / SHORTEST_S / 4.0).floor() as u32).clamp(1, SWING_STEPS / 4) * 4)
}

/// Number of steps that fit if at most `most` are possible.
fn steps(most: f64) -> u32 {
    (most.floor() as u32).clamp(1, STEPS)
}

/// Part of a time in which the torch rests with the arc on.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) struct RestStep {
    /// Duration, s.
    pub(crate) time: f64,
    /// Its middle, from the start of the rest, s.
    pub(crate) middle: f64,
    /// True within a slope.
    pub(crate) slopes: bool,
}

/// A rest of `time` s that starts with a slope of `slopes.0` s and ends with one of `slopes.1` s, in steps.
pub(crate) fn rest_steps(time: f64, slopes: (f64, f64)) -> Vec<RestStep> {
    let parts = [(slopes.0, true), (time - slopes.0 - slopes.1, false), (slopes.1, true)];
    let mut begin = 0.0;
    let mut all = Vec::new();
    for (length, slopes) in parts.into_iter().filter(|(length, _)| *length > 0.0) {
        let count = if slopes { steps(length / SHORTEST_S) } else { 1 };
        let step = length / f64::from(count);
        all.extend((0..count).map(|i| RestStep { time: step, middle: begin + step * (f64::from(i) + 0.5), slopes }));
        begin += length;
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn steps_fill_the_rest() {
        for (time, slopes) in [(1.0, (0.4, 0.0)), (0.8, (0.0, 0.8)), (0.01, (0.01, 0.0)), (2.0, (0.0, 0.0))] {
            let steps = rest_steps(time, slopes);
            assert!((steps.iter().map(|s| s.time).sum::<f64>() - time).abs() < 1e-12);
            let sloping: f64 = steps.iter().filter(|s| s.slopes).map(|s| s.time).sum();
            assert!((sloping - slopes.0 - slopes.1).abs() < 1e-12);
            let mut begin = 0.0;
            for step in steps {
                assert!((step.middle - begin - 0.5 * step.time).abs() < 1e-12);
                begin += step.time;
            }
        }
    }
}
