/// Numbers with a deviation below this part of their mean are the same: clearances of equal plans differ by 1e-8.
const NOISE: f64 = 1e-6;

/// Mean, variance, minimum and maximum of numbers that come one after the other.
///
/// Method: Welford, Technometrics 4 (1962) 419; stable where the mean is large against the deviation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Moments {
    count: u64,
    mean: f64,
    squares: f64,
    min: f64,
    max: f64,
}

impl Default for Moments {
    fn default() -> Self {
        Self { count: 0, mean: 0.0, squares: 0.0, min: f64::INFINITY, max: f64::NEG_INFINITY }
    }
}

impl Moments {
    /// Adds a number.
    pub fn add(&mut self, value: f64) {
        self.count += 1;
        let before = value - self.mean;
        self.mean += before / self.count as f64;
        self.squares += before * (value - self.mean);
        self.min = self.min.min(value);
        self.max = self.max.max(value);
    }

    /// Number of numbers.
    pub fn count(&self) -> u64 {
        self.count
    }

    /// Mean; 0 without numbers.
    pub fn mean(&self) -> f64 {
        self.mean
    }

    /// Unbiased variance; 0 with fewer than two numbers.
    pub fn variance(&self) -> f64 {
        if self.count < 2 { 0.0 } else { self.squares / (self.count - 1) as f64 }
    }

    /// Standard deviation.
    pub fn deviation(&self) -> f64 {
        self.variance().sqrt()
    }

    /// True if the numbers are the same but for rounding.
    pub fn is_constant(&self) -> bool {
        self.deviation() <= NOISE * self.mean.abs()
    }

    /// Minimum; infinite without numbers.
    pub fn min(&self) -> f64 {
        self.min
    }

    /// Maximum; infinite without numbers.
    pub fn max(&self) -> f64 {
        self.max
    }
}

impl FromIterator<f64> for Moments {
    fn from_iter<I: IntoIterator<Item = f64>>(values: I) -> Self {
        values.into_iter().fold(Self::default(), |mut moments, value| {
            moments.add(value);
            moments
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_large_mean_does_not_hide_a_small_deviation() {
        let moments: Moments = [4.0, 7.0, 13.0, 16.0].into_iter().map(|v| v + 1e9).collect();
        assert!((moments.mean() - 1e9 - 10.0).abs() < 1e-6);
        assert!((moments.variance() - 30.0).abs() < 1e-6);
        assert_eq!((moments.count(), moments.min(), moments.max()), (4, 4.0 + 1e9, 16.0 + 1e9));
    }
}
