use crate::wire::LatencyView;

/// Number of limits.
const LIMITS: usize = 16;
/// Upper limits of the classes, ns: 1 us to 100 ms.
const LIMITS_NS: [u64; LIMITS] = [
    1_000,
    2_000,
    5_000,
    10_000,
    20_000,
    50_000,
    100_000,
    200_000,
    500_000,
    1_000_000,
    2_000_000,
    5_000_000,
    10_000_000,
    20_000_000,
    50_000_000,
    100_000_000,
];

/// Histogram of the lateness of cycles, with fixed classes.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(crate) struct LatencyHistogram {
    /// The last one has no upper limit.
    counts: [u64; LIMITS + 1],
    sum_ns: u64,
    most_ns: u64,
}

impl LatencyHistogram {
    /// Adds a cycle that started late by `late_ns`.
    pub(crate) fn add(&mut self, late_ns: u64) {
        self.counts[LIMITS_NS.partition_point(|limit| *limit < late_ns)] += 1;
        self.sum_ns = self.sum_ns.saturating_add(late_ns);
        self.most_ns = self.most_ns.max(late_ns);
    }

    pub(crate) fn view(&self) -> LatencyView {
        LatencyView {
            limits_us: LIMITS_NS.iter().map(|ns| *ns as f64 * 1e-3).collect(),
            counts: self.counts.to_vec(),
            sum_s: self.sum_ns as f64 * 1e-9,
            most_us: self.most_ns as f64 * 1e-3,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_cycle_is_in_the_class_of_its_lateness() {
        let mut histogram = LatencyHistogram::default();
        for late_ns in [0, 1_000, 1_001, 54_000, 100_000_000, 100_000_001, u64::MAX / 4] {
            histogram.add(late_ns);
        }
        let view = histogram.view();
        assert_eq!((view.limits_us[0], view.limits_us[LIMITS - 1]), (1.0, 100_000.0));
        assert_eq!((view.counts[0], view.counts[1], view.counts[6]), (2, 1, 1));
        assert_eq!((view.counts[LIMITS - 1], view.counts[LIMITS]), (1, 2));
        assert_eq!(view.counts.iter().sum::<u64>(), 7);
    }
}
