use glam::DVec2;
use std::collections::VecDeque;

/// Tracking algorithm of DUALBEAM-2013, for comparison. Sample i + n, taken with the slide at xi_i, gives xi_{i+n} =
/// measured + xi_i; the slide moves there n samples later.
///
/// It counts samples, so look-ahead distance and speed must match (L = n v dt). Late, missing or wrong samples act
/// directly on the slide. At high speed the paper divides each step into parts; with one part the slide steps once per
/// sample.
#[derive(Debug, Clone)]
pub struct SampleBuffer {
    /// xi of the future samples, the next one first.
    ahead: VecDeque<DVec2>,
    parts: u32,
    done: u32,
    from: DVec2,
    to: DVec2,
}

impl SampleBuffer {
    /// Creates a buffer for look-ahead distance `lead_mm` at `speed_mm_s`, a sample every `period_s`, each step in
    /// `parts` parts.
    #[must_use]
    pub fn new(lead_mm: f64, speed_mm_s: f64, period_s: f64, parts: u32) -> Self {
        let n = (lead_mm / (speed_mm_s * period_s)).round().clamp(1.0, 1e6) as usize;
        let ahead = VecDeque::from(vec![DVec2::ZERO; n]);
        Self { ahead, parts: parts.max(1), done: 0, from: DVec2::ZERO, to: DVec2::ZERO }
    }

    /// Adds the next sample, with the slide at `slide`; a missing sample repeats the last one.
    pub fn sample(&mut self, measured: Option<DVec2>, slide: DVec2) {
        let last = self.ahead.back().copied().unwrap_or(self.to);
        // The slide carries the sensor.
        self.ahead.push_back(measured.map_or(last, |m| m + slide));
        self.from = self.to;
        self.to = self.ahead.pop_front().unwrap_or(self.to);
        self.done = 0;
    }

    /// Returns the slide's set-point for the next part of the sample's period.
    pub fn step(&mut self) -> DVec2 {
        self.done = (self.done + 1).min(self.parts);
        self.from.lerp(self.to, f64::from(self.done) / f64::from(self.parts))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An ideal slide with matching look-ahead distance and speed follows the seam exactly, sample by sample.
    #[test]
    fn an_ideal_slide_follows() {
        let seam = |s: f64| DVec2::new((0.05 * s).sin(), 0.01 * s);
        for parts in [1, 5] {
            let mut buffer = SampleBuffer::new(20.0, 20.0, 0.02, parts);
            let mut slide = DVec2::ZERO;
            for i in 0..400 {
                let s = 0.4 * f64::from(i);
                buffer.sample(Some(seam(s + 20.0) - slide), slide);
                let before = slide;
                for k in 1..=parts {
                    slide = buffer.step();
                    if i > 50 {
                        let part = f64::from(k) / f64::from(parts);
                        assert!(slide.distance(before.lerp(seam(s), part)) < 1e-12);
                    }
                }
            }
        }
    }
}
