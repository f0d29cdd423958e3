/// Spread of a nominally constant distance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spread {
    /// Number of distances. If 0, all other values are NaN.
    pub count: u64,
    /// Reference of the percentages, mm: the wanted step, or for pulse methods the mean.
    pub reference_mm: f64,
    /// Smallest, mm.
    pub min_mm: f64,
    /// Largest, mm.
    pub max_mm: f64,
    /// Mean, mm.
    pub mean_mm: f64,
    /// Smallest less the reference, % of the reference.
    pub min_percent: f64,
    /// Largest less the reference, % of the reference.
    pub max_percent: f64,
    /// Root of the mean square of the difference from the reference, % of the reference.
    pub rms_percent: f64,
}

/// Running count, extremes, mean and sum of squares about it (Welford's method, which does not cancel).
#[derive(Debug, Clone)]
pub(crate) struct Moments {
    count: u64,
    min: f64,
    max: f64,
    mean: f64,
    squares: f64,
}

impl Default for Moments {
    fn default() -> Self {
        Self { count: 0, min: f64::INFINITY, max: f64::NEG_INFINITY, mean: 0.0, squares: 0.0 }
    }
}

impl Moments {
    pub(crate) fn add(&mut self, value: f64) {
        self.count += 1;
        self.min = self.min.min(value);
        self.max = self.max.max(value);
        let off = value - self.mean;
        self.mean += off / self.count as f64;
        self.squares += off * (value - self.mean);
    }

    /// The spread about `wanted`, or about the mean.
    pub(crate) fn spread(&self, wanted: Option<f64>) -> Spread {
        let or_nan = |v: f64| if self.count > 0 { v } else { f64::NAN };
        let mean = or_nan(self.mean);
        let reference = or_nan(wanted.unwrap_or(mean));
        let percent = |mm: f64| 100.0 * mm / reference;
        Spread {
            count: self.count,
            reference_mm: reference,
            min_mm: or_nan(self.min),
            max_mm: or_nan(self.max),
            mean_mm: mean,
            min_percent: percent(or_nan(self.min) - reference),
            max_percent: percent(or_nan(self.max) - reference),
            rms_percent: percent((self.squares / self.count as f64 + (mean - reference).powi(2)).sqrt()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn spread_of_known_values() {
        let mut m = Moments::default();
        [9.0, 10.0, 12.0].into_iter().for_each(|v| m.add(v));
        let s = m.spread(Some(10.0));
        assert_eq!((s.count, s.min_mm, s.max_mm, s.min_percent, s.max_percent), (3, 9.0, 12.0, -10.0, 20.0));
        assert!((s.rms_percent - 10.0 * (5.0f64 / 3.0).sqrt()).abs() < 1e-12);
        let s = m.spread(None);
        assert!((s.reference_mm - 31.0 / 3.0).abs() < 1e-12);
        assert!(Moments::default().spread(Some(1.0)).min_mm.is_nan());
    }
}
