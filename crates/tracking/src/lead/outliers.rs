use super::filter::Filter;
use super::fit::Seen;
use arrayvec::ArrayVec;

/// Number of agreeing gated measurements that restart the estimate.
pub(super) const IN_A_ROW: usize = 3;
/// Number of stored gated measurements: outliers may lie between agreeing ones.
const ROOM: usize = 4;
/// Maximum slope of the seam against the taught path.
pub(super) const STEEPEST: f64 = 0.3;
/// Limit of agreement in standard deviations, as at the measurement gate.
pub(super) const GATE: f64 = 3.0;

/// Maximum bend of a seam between three measurements, mm.
const BENT_MM: f64 = 0.02;

/// Consecutive gated measurements: outliers, or the start of a seam jump.
#[derive(Debug, Clone, Default)]
pub(super) struct Suspects {
    seen: ArrayVec<Seen, ROOM>,
    in_a_row: usize,
}

impl Suspects {
    pub(super) fn clear(&mut self) {
        self.seen.clear();
        self.in_a_row = 0;
    }

    /// Adds a measurement; returns the number in a row.
    pub(super) fn add(&mut self, seen: Seen) -> usize {
        if self.seen.is_full() {
            self.seen.remove(0);
        }
        self.seen.push(seen);
        self.in_a_row += 1;
        self.in_a_row
    }

    /// Returns two earlier measurements and `last` if all three agree and lie on a line. Neighbouring outliers hardly
    /// ever do.
    pub(super) fn agreeing(&self, last: &Seen) -> Option<[Seen; IN_A_ROW]> {
        let others = || self.seen.iter().rev().filter(|s| agree(s, last));
        let fits = |a: &Seen, b: &Seen| agree(a, b) && on_a_line(a, b, last);
        let two = others().enumerate().find_map(|(i, b)| others().skip(i + 1).find(|a| fits(a, b)).map(|a| (a, b)));
        two.map(|(a, b)| [*a, *b, *last])
    }
}

/// Returns whether `b` lies on the line through `a` and `c` within their noise.
fn on_a_line(a: &Seen, b: &Seen, c: &Seen) -> bool {
    let way = c.s - a.s;
    // While the torch is held all three have one position.
    let part = if way.abs() > 1e-3 { ((b.s - a.s) / way).clamp(0.0, 1.0) } else { 0.5 };
    let variance = (1.0 - part).powi(2) / a.weight + 1.0 / b.weight + part * part / c.weight;
    (b.value - a.value.lerp(c.value, part)).abs().max_element() <= GATE * variance.sqrt() + BENT_MM
}

fn agree(a: &Seen, b: &Seen) -> bool {
    let allowed = GATE * (1.0 / a.weight + 1.0 / b.weight).sqrt() + STEEPEST * (a.s - b.s).abs();
    (a.value - b.value).abs().max_element() <= allowed
}

/// Starts a filter at the last of three measurements; two standard deviations of its slope span the maximum slope.
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
        let mut outliers = Suspects::default();
        // Wild values, then three that agree: only the last ones count.
        for (i, wild) in [2.0, -1.5, 0.7, -2.0, 1.0, 1.05].into_iter().enumerate() {
            let seen = seen(0.2 * i as f64, wild);
            assert_eq!(outliers.agreeing(&seen), None, "{wild}");
            assert_eq!(outliers.add(seen), i + 1);
        }
        assert_eq!(outliers.agreeing(&seen(1.2, 1.5)), None);
        assert_eq!(outliers.agreeing(&seen(1.2, 0.9)), None, "near, but not on a line");
        let three = outliers.agreeing(&seen(1.2, 1.1)).unwrap();
        outliers.clear();
        assert_eq!(outliers.agreeing(&seen(1.2, 1.1)), None);
        let filter = begun(&three, 0.5);
        assert!((filter.value.x - 1.05).abs() < 1e-12 && (filter.s - 1.2).abs() < 1e-12);
    }
}
