//! Round numbers along an axis.

use crate::Language;
use crate::domain::Domain;
use crate::number::{format_fixed, format_number, localized};

/// Tick values in steps of 1, 2 or 5 times a power of ten.
#[derive(Debug, Clone, Default)]
pub(crate) struct Ticks {
    pub(crate) values: Vec<f64>,
    step: f64,
    /// The values are decimal logarithms of the labels.
    logarithmic: bool,
}

impl Ticks {
    /// Returns between 3 and 10 ticks inside `domain`, as near to `target` as a round step allows.
    ///
    /// `domain` must be settled. A step always exists: if `n` steps fit into the span, there are `n` or `n + 1` ticks.
    /// Neighbouring steps differ by a factor of at most 2.5.
    pub(crate) fn new(domain: Domain, target: usize) -> Self {
        let power = domain.span().log10().floor() as i32;
        let mut best: Option<(usize, Self)> = None;
        for exponent in power - 2..=power + 1 {
            for mantissa in [1.0, 2.0, 5.0] {
                let ticks = Self::stepped(domain, mantissa, exponent);
                let miss = ticks.values.len().abs_diff(target);
                if (3..=10).contains(&ticks.values.len()) && best.as_ref().is_none_or(|(least, _)| miss < *least) {
                    best = Some((miss, ticks));
                }
            }
        }
        best.map_or_else(
            || Self { values: vec![domain.lo, domain.hi], step: domain.span(), logarithmic: false },
            |(_, ticks)| ticks,
        )
    }

    /// Returns the ticks of step `mantissa * 10^exponent` inside `domain`; may be empty.
    fn stepped(domain: Domain, mantissa: f64, exponent: i32) -> Self {
        // Dividing by a whole power of ten keeps 0.3 from becoming 0.30000000000000004.
        let power = 10f64.powi(exponent.abs());
        let value = |k: f64| if exponent < 0 { k * mantissa / power } else { k * mantissa * power };
        let step = value(1.0);
        let first = (domain.lo / step - 1e-9).ceil();
        let count = (domain.hi / step + 1e-9).floor() - first + 1.0;
        let count = if count > 0.0 { count.min(200.0) as u32 } else { 0 };
        let values = (0..count).map(|k| value(first + f64::from(k)).clamp(domain.lo, domain.hi) + 0.0).collect();
        Self { values, step, logarithmic: false }
    }

    /// Returns the ticks inside `domain` with the smallest round step of at least `least`, for views that share one
    /// scale.
    pub(crate) fn spaced(domain: Domain, least: f64) -> Self {
        let power = least.log10().floor() as i32;
        let at_least = |(m, e): &(f64, i32)| m * 10f64.powi(*e) >= least * (1.0 - 1e-9);
        let (mantissa, exponent) =
            [1.0, 2.0, 5.0].map(|m| (m, power)).into_iter().find(at_least).unwrap_or((1.0, power + 1));
        Self::stepped(domain, mantissa, exponent)
    }

    /// Returns ticks for a domain of decimal logarithms: 1, 2 and 5 times powers of ten. If those are `most` or more,
    /// returns only the powers. The values are logarithms.
    pub(crate) fn decades(domain: Domain, most: usize) -> Self {
        let powers = domain.lo.floor() as i32..=domain.hi.ceil() as i32;
        let ticks = |mantissas: &[f64]| -> Vec<f64> {
            let all = powers.clone().flat_map(|p| mantissas.iter().map(move |m| f64::from(p) + m.log10()));
            all.filter(|v| domain.contains(*v)).collect()
        };
        let fine = ticks(&[1.0, 2.0, 5.0]);
        let values = if fine.len() < most { fine } else { ticks(&[1.0]) };
        Self { values, step: 1.0, logarithmic: true }
    }

    pub(crate) fn labels_in(&self, language: Language) -> Vec<String> {
        self.labels().iter().map(|label| localized(label, language)).collect()
    }

    /// Returns the labels, with equal numbers of decimals; on a logarithmic scale with as many as needed.
    pub(crate) fn labels(&self) -> Vec<String> {
        if self.logarithmic {
            return self.values.iter().map(|v| format_number(10f64.powf(*v), 3)).collect();
        }
        let largest = self.values.iter().fold(0.0f64, |m, v| m.max(v.abs()));
        let decimals = -(self.step.log10() + 1e-9).floor();
        if largest >= 1e7 || decimals > 5.0 {
            let digits = (largest.log10() + 1e-9).floor() + decimals + 1.0;
            let label = |v: &f64| {
                let rounded = if v.abs() < 1e-6 * self.step { 0.0 } else { *v };
                format_number(rounded, digits as usize)
            };
            return self.values.iter().map(label).collect();
        }
        let decimals = decimals.max(0.0) as usize;
        self.values.iter().map(|v| format_fixed(*v, decimals)).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ticks(lo: f64, hi: f64, target: usize) -> Ticks {
        Ticks::new(Domain { lo, hi }, target)
    }

    #[test]
    fn familiar_ranges() {
        assert_eq!(ticks(0.0, 10.0, 6).labels(), ["0", "2", "4", "6", "8", "10"]);
        assert_eq!(ticks(-0.07, 0.31, 4).labels(), ["0.0", "0.1", "0.2", "0.3"]);
        assert_eq!(ticks(0.0, 3.1e-12, 4).labels(), ["0", "1e-12", "2e-12", "3e-12"]);
        assert_eq!(ticks(9.9e8, 1.01e9, 3).labels(), ["990000000", "1e9", "1.01e9"]);
    }

    #[test]
    fn every_range_gets_three_to_ten_distinct_ticks_inside() {
        let mut random = seamwright_testkit::Random::new(20);
        for _ in 0..200_000 {
            let span = 10f64.powf(random.within(-12.0, 12.0));
            // Offsets for which the range is still wider than rounding noise.
            let lo = span * random.within(-0.5, 0.5) * 10f64.powf(random.within(0.0, 5.5));
            let hi = lo + span;
            let target = 3 + random.below(7);
            let t = ticks(lo, hi, target);
            assert!((3..=10).contains(&t.values.len()), "{lo:e}..{hi:e}: {t:?}");
            assert!(t.values.iter().all(|v| (lo..=hi).contains(v)), "{lo:e}..{hi:e}: {t:?}");
            assert!(t.values.is_sorted_by(|a, b| a < b), "{lo:e}..{hi:e}: {t:?}");
            let labels = t.labels();
            assert!(labels.iter().all(|l| l.len() < 20), "{labels:?}");
            assert!(labels.windows(2).all(|w| w[0] != w[1]), "{lo:e}..{hi:e}: {labels:?}");
        }
    }

    #[test]
    fn decades_are_divided_if_there_is_room() {
        assert_eq!(
            Ticks::decades(Domain { lo: 0.1, hi: 2.4 }, 12).labels(),
            ["2", "5", "10", "20", "50", "100", "200"]
        );
        assert_eq!(Ticks::decades(Domain { lo: -2.5, hi: 3.0 }, 9).labels(), ["0.01", "0.1", "1", "10", "100", "1000"]);
    }

    #[test]
    fn spaced_ticks_are_round_and_far_enough_apart() {
        assert_eq!(Ticks::spaced(Domain { lo: -10.0, hi: 130.0 }, 41.0).labels(), ["0", "50", "100"]);
        assert_eq!(Ticks::spaced(Domain { lo: 1.0, hi: 2.0 }, 60.0).labels().len(), 0);
    }
}
