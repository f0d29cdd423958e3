/// Maximum drift between the clocks of two computers, as a fraction: quartz oscillators differ by less than 0.01 %.
const DRIFT: f64 = 1e-4;
/// Maximum time by which a mapped time precedes the arrival, s. More is no delay of a packet but another clock.
const MAX_TRANSIT_S: f64 = 0.05;

/// Maps times of a control's clock to ours.
///
/// The earliest packet, relative to the control's clock, had the least delay; so the offset is the minimum over the
/// packets so far, which ages with the drift of the clocks. Mapped times contain the least transit time of a packet,
/// and not its jitter.
#[derive(Debug, Clone, Default)]
pub(super) struct ClockMap {
    /// Offset of our clock, and the last time of the control, s.
    offset: Option<(f64, f64)>,
}

impl ClockMap {
    /// Returns our time of a packet with the control's time `control_s` that arrived at `arrived_s`.
    pub(super) fn map(&mut self, control_s: f64, arrived_s: f64) -> f64 {
        let fresh = arrived_s - control_s;
        let offset = match self.offset {
            Some((offset, last_s)) if control_s >= last_s => fresh.min(offset + DRIFT * (control_s - last_s)),
            _ => fresh,
        };
        let offset = if (0.0..=MAX_TRANSIT_S).contains(&(fresh - offset)) { offset } else { fresh };
        self.offset = Some((offset, control_s));
        control_s + offset
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use seamwright_testkit::Random;

    /// Jitter of up to 5 ms is removed to the least transit, over an hour of a clock that runs 50 ppm fast.
    #[test]
    fn jitter_is_removed() {
        let (mut map, mut random) = (ClockMap::default(), Random::new(5));
        let mut worst = 0.0f64;
        for i in 0..900_000u32 {
            let true_s = 4e-3 * f64::from(i);
            let jitter = if random.one_in(4) { 0.0 } else { 5e-3 * random.within(0.0, 1.0) };
            let mapped = map.map(77.0 + true_s * (1.0 + 5e-5), true_s + 3e-4 + jitter);
            if i > 100 {
                worst = worst.max((mapped - true_s - 3e-4).abs());
            }
        }
        assert!(worst < 1e-4, "{worst}");
    }

    #[test]
    fn another_clock_begins_anew() {
        let mut map = ClockMap::default();
        assert!((map.map(100.0, 5.0) - 5.0).abs() < 1e-12);
        // The control restarts; then its clock jumps ahead.
        assert!((map.map(0.5, 9.0) - 9.0).abs() < 1e-12);
        assert!((map.map(50.0, 9.1) - 9.1).abs() < 1e-12);
        assert!((map.map(50.004, 9.104 + 0.2) - 9.304).abs() < 1e-12);
    }
}
