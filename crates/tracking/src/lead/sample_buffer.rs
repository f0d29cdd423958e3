use glam::DVec2;
use std::collections::VecDeque;

/// The algorithm of DUALBEAM-2013, to compare with: sample i + n, taken while the slide stood at xi_i, gives
/// xi_{i+n} = measured + xi_i, and n samples later the slide goes there.
///
/// It counts samples, so lead and speed must match (L = n v dt), and what is late, missing or wrong goes straight to
/// the slide. At high speed the paper divides each step into parts; with one part the slide steps once a sample.
#[derive(Debug, Clone)]
pub struct SampleBuffer {
    /// xi of the samples to come, the next one first.
    ahead: VecDeque<DVec2>,
    parts: u32,
    done: u32,
    from: DVec2,
    to: DVec2,
}

impl SampleBuffer {
    /// For a lead of `lead_mm` at `speed_mm_s`, a sample every `period_s`, each step in `parts` parts.
    #[must_use]
    pub fn new(lead_mm: f64, speed_mm_s: f64, period_s: f64, parts: u32) -> Self {
        let n = (lead_mm / (speed_mm_s * period_s)).round().clamp(1.0, 1e6) as usize;
        let ahead = VecDeque::from(vec![DVec2::ZERO; n]);
        Self { ahead, parts: parts.max(1), done: 0, from: DVec2::ZERO, to: DVec2::ZERO }
    }

    /// The next sample, with the slide at `slide`; without one the last is taken to go on.
    pub fn sample(&mut self, measured: Option<DVec2>, slide: DVec2) {
        let last = self.ahead.back().copied().unwrap_or(self.to);
        // The sensor rides on the slide.
        self.ahead.push_back(measured.map_or(last, |m| m + slide));
        self.from = self.to;
        self.to = self.ahead.pop_front().unwrap_or(self.to);
        self.done = 0;
    }

    /// Where the slide is to go in the next part of the sample's period.
    pub fn step(&mut self) -> DVec2 {
        self.done = (self.done + 1).min(self.parts);
        self.from.lerp(self.to, f64::from(self.done) / f64::from(self.parts))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// With a slide that is where it is told to be, and lead and speed that match, a seam is followed exactly, sample
    /// by sample.
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
