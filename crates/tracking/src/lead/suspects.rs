use super::filter::Filter;
use super::fit::Seen;
use arrayvec::ArrayVec;

/// As many gated measurements in a row as begin the estimate anew, if they agree.
pub(super) const IN_A_ROW: usize = 3;
/// Steepest seam against the taught path.
pub(super) const STEEPEST: f64 = 0.3;
/// Standard deviations that count as agreement, as at the gate.
pub(super) const GATE: f64 = 3.0;

/// Measurements that were gated, one after the other: outliers, or the seam has jumped.
#[derive(Debug, Clone, Default)]
pub(super) struct Suspects {
    seen: ArrayVec<Seen, IN_A_ROW>,
}

impl Suspects {
    pub(super) fn clear(&mut self) {
        self.seen.clear();
    }

    /// One more. If the last three agree with each other, these.
    pub(super) fn add(&mut self, seen: Seen) -> Option<[Seen; IN_A_ROW]> {
        if self.seen.is_full() {
            self.seen.remove(0);
        }
        self.seen.push(seen);
        let three = <[Seen; IN_A_ROW]>::try_from(self.seen.as_slice()).ok()?;
        let agree = |a: &Seen, b: &Seen| {
            let allowed = GATE * (1.0 / a.weight + 1.0 / b.weight).sqrt() + STEEPEST * (a.s - b.s).abs();
            (a.value - b.value).abs().max_element() <= allowed
        };
        (agree(&three[0], &three[1]) && agree(&three[1], &three[2]) && agree(&three[0], &three[2])).then_some(three)
    }
}

/// A filter that begins with these three: at the last one, as steep as they may be.
pub(super) fn begun(three: &[Seen; IN_A_ROW], t: f64) -> Filter {
    let [a, b, c] = three;
    let variance = 1.0 / c.weight;
    let mean = (a.value * a.weight + b.value * b.weight + c.value * c.weight) / (a.weight + b.weight + c.weight);
    Filter { s: c.s, t, value: mean, slope: glam::DVec2::ZERO, variance: [variance, 0.0, STEEPEST * STEEPEST / 4.0] }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec2;

    fn seen(s: f64, lateral: f64) -> Seen {
        Seen { s, value: DVec2::new(lateral, 0.0), weight: 2500.0 }
    }

    #[test]
    fn three_that_agree_are_the_seam_and_others_are_not() {
        let mut suspects = Suspects::default();
        assert_eq!(suspects.add(seen(1.0, 1.0)), None);
        assert_eq!(suspects.add(seen(1.2, 1.02)), None);
        assert!(suspects.add(seen(1.4, 1.04)).is_some());
        suspects.clear();
        // Wild values, then three that agree: only the last three count.
        for (i, wild) in [2.0, -1.5, 0.7, -2.0, 1.0, 1.05].into_iter().enumerate() {
            assert_eq!(suspects.add(seen(0.2 * i as f64, wild)), None, "{wild}");
        }
        let three = suspects.add(seen(1.2, 1.1)).unwrap();
        let filter = begun(&three, 0.5);
        assert!((filter.value.x - 1.05).abs() < 1e-12 && (filter.s - 1.2).abs() < 1e-12);
    }
}
