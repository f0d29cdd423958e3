use schemars::JsonSchema;
use serde::Serialize;

/// A probability or another figure with its 95 % confidence interval.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, JsonSchema)]
pub struct Interval {
    /// The estimate.
    pub estimate: f64,
    /// Lower end of the interval.
    pub low: f64,
    /// Upper end of the interval.
    pub high: f64,
}

/// Standard normal quantile of 97.5 %.
pub(crate) const Z95: f64 = 1.959_963_984_540_054;

/// The probability of an event that happened `hits` times in `count` draws, with its 95 % confidence interval.
///
/// Method: score interval of Wilson, JASA 22 (1927) 209; useful also without any hit, as Brown, Cai, DasGupta,
/// Statistical Science 16 (2001) 101 recommend.
pub fn wilson(hits: u64, count: u64) -> Interval {
    if count == 0 {
        return Interval { estimate: 0.0, low: 0.0, high: 1.0 };
    }
    let (n, z2) = (count as f64, Z95 * Z95);
    let p = hits as f64 / n;
    let centre = (p + z2 / (2.0 * n)) / (1.0 + z2 / n);
    let half = Z95 / (1.0 + z2 / n) * (p * (1.0 - p) / n + z2 / (4.0 * n * n)).sqrt();
    // At both ends rounding must not leave the estimate outside.
    let low = if hits == 0 { 0.0 } else { centre - half };
    let high = if hits == count { 1.0 } else { centre + half };
    Interval { estimate: p, low, high }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Values of statsmodels, `proportion_confint(method="wilson")`.
    #[test]
    fn intervals_are_those_of_statsmodels() {
        let of = |hits, count| wilson(hits, count);
        let close = |a: f64, b: f64| (a - b).abs() < 1e-6;
        assert!(close(of(0, 20).high, 0.161_125) && close(of(0, 20).low, 0.0));
        assert!(close(of(10, 20).low, 0.299_298) && close(of(10, 20).high, 0.700_702));
        assert!(close(of(20, 20).low, 0.838_875) && close(of(20, 20).high, 1.0));
    }
}
